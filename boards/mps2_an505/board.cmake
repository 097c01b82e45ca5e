# The start-up code of this board, and its counter: 20 MHz, 32 bits.
set(INKCELL_BOARD_START start_cortex_m.cpp)
set(INKCELL_COUNTER_PICOSECONDS 50000)
set(INKCELL_COUNTER_BITS 32)
