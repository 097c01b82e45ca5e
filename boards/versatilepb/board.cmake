# What start-up code this board has, and its display. Its timers, 1 MHz, are too
# slow to count instructions.
set(INKCELL_BOARD_START start_arm9.S)
set(INKCELL_DISPLAY_WIDTH 320)
set(INKCELL_DISPLAY_HEIGHT 240)
set(INKCELL_DISPLAY_FORMATS rgb565)
