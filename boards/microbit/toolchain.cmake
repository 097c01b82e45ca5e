# Toolchain for the BBC micro:bit (nRF51822, Cortex-M0).
set(INKCELL_BOARD microbit)
set(INKCELL_CPU "-mcpu=cortex-m0 -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
