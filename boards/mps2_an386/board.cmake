# The code of this board, its addresses, and its counter: 25 MHz, 32 bits.
set(INKCELL_BOARD_SOURCES common/start_cortex_m.cpp common/mps2.cpp)
set(INKCELL_UART 0x40004000)
set(INKCELL_TIMER 0x40000000)
set(INKCELL_COUNTER_PICOSECONDS 40000)
set(INKCELL_COUNTER_BITS 32)
