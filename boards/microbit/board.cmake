# The code of this board, and its counter: 16 MHz, 32 bits.
set(INKCELL_BOARD_SOURCES common/start_cortex_m.cpp microbit/board.cpp)
set(INKCELL_COUNTER_PICOSECONDS 62500)
set(INKCELL_COUNTER_BITS 32)
