# What start-up code this board has, its counter (of instructions, 32 bits) and
# its display: "-device bochs-display" for xrgb8888, "-device VGA" for both.
set(INKCELL_BOARD_START start_riscv.S)
set(INKCELL_COUNTER_PICOSECONDS 1000)
set(INKCELL_COUNTER_BITS 32)
set(INKCELL_DISPLAY_WIDTH 320)
set(INKCELL_DISPLAY_HEIGHT 240)
set(INKCELL_DISPLAY_FORMATS xrgb8888 rgb565)
