# The code of this board, its counter (SysTick at 12.5 MHz, 24 bits)
# and its display.
set(INKCELL_BOARD_SOURCES
  common/start_cortex_m.cpp common/lm3s.cpp lm3s811evb/board.cpp)
set(INKCELL_COUNTER_PICOSECONDS 80000)
set(INKCELL_COUNTER_BITS 24)
set(INKCELL_DISPLAY_WIDTH 96)
set(INKCELL_DISPLAY_HEIGHT 16)
set(INKCELL_DISPLAY_FORMATS mono_pages)

# The demo: rows of a strip and sizes.
set(INKCELL_DEMO_ROWS 8)
set(INKCELL_DEMO_CLOCK_PX 16)
set(INKCELL_DEMO_TEXT_PX 13)
# Turned text and particles do not fit its 64 KB of flash.
set(INKCELL_DEMO_MOTIONS clock)
