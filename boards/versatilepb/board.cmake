# The code of this board, and its display. Its timers, 1 MHz, are too
# slow to count instructions.
set(INKCELL_BOARD_SOURCES common/start_arm9.S versatilepb/board.cpp)
set(INKCELL_SERIAL ON)
set(INKCELL_DISPLAY_WIDTH 320)
set(INKCELL_DISPLAY_HEIGHT 240)
set(INKCELL_DISPLAY_FORMATS rgb565)

# The demo: rows of a strip, sizes, and the coding of its font.
set(INKCELL_DEMO_ROWS 16)
set(INKCELL_DEMO_CLOCK_PX 90)
set(INKCELL_DEMO_TEXT_PX 18)
set(INKCELL_DEMO_CODING field)
