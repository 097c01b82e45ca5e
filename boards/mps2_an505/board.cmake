# The code of this board, its Secure addresses, and its counter: 20 MHz, 32 bits.
set(INKCELL_BOARD_SOURCES common/start_cortex_m.cpp common/mps2.cpp)
set(INKCELL_UART 0x50200000)
set(INKCELL_TIMER 0x50000000)
set(INKCELL_COUNTER_PICOSECONDS 50000)
set(INKCELL_COUNTER_BITS 32)
