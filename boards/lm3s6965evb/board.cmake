# The code of this board, its counter (SysTick at 12.5 MHz, 24 bits),
# its display, and that it has a card.
set(INKCELL_BOARD_SOURCES
  common/start_cortex_m.cpp common/lm3s.cpp lm3s6965evb/board.cpp)
set(INKCELL_COUNTER_PICOSECONDS 80000)
set(INKCELL_COUNTER_BITS 24)
set(INKCELL_DISPLAY_WIDTH 128)
set(INKCELL_DISPLAY_HEIGHT 64)
set(INKCELL_DISPLAY_FORMATS grey4)
set(INKCELL_CARD ON)

# The demo: rows of a strip, sizes, and the coding of its font.
set(INKCELL_DEMO_ROWS 8)
set(INKCELL_DEMO_CLOCK_PX 29)
set(INKCELL_DEMO_TEXT_PX 11)
