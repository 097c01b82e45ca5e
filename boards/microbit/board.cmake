# The start-up code of this board, and its counter: 16 MHz, 32 bits.
set(INKCELL_BOARD_START start_cortex_m.cpp)
set(INKCELL_COUNTER_PICOSECONDS 62500)
set(INKCELL_COUNTER_BITS 32)
