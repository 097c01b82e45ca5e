# Cortex-M0 code on the M3 board: the M0 board's memory is too small for whole
# fonts, and instructions of the M0 are instructions of the M3.
set(INKCELL_BOARD mps2_an385)
set(INKCELL_CPU "-mcpu=cortex-m0 -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/../../../boards/common/toolchain_arm.cmake)
