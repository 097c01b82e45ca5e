# The code of this board, its counter (of instructions, 32 bits) and
# its display.
set(INKCELL_BOARD_SOURCES common/start_riscv.S riscv_virt/board.cpp)
set(INKCELL_COUNTER_PICOSECONDS 1000)
set(INKCELL_COUNTER_BITS 32)
set(INKCELL_SERIAL ON)
set(INKCELL_DISPLAY_WIDTH 320)
set(INKCELL_DISPLAY_HEIGHT 240)
set(INKCELL_DISPLAY_FORMATS xrgb8888 rgb565)

# The demo: rows of a strip and sizes.
set(INKCELL_DEMO_ROWS 16)
set(INKCELL_DEMO_CLOCK_PX 90)
set(INKCELL_DEMO_TEXT_PX 18)

# QEMU's options for a display of each format.
set(INKCELL_DISPLAY_DEVICE_xrgb8888 "-device bochs-display,romfile=")
set(INKCELL_DISPLAY_DEVICE_rgb565 "-device VGA,romfile=")
