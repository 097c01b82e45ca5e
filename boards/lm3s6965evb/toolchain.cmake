# Toolchain for the Stellaris LM3S6965 evaluation board (Cortex-M3).
set(INKCELL_BOARD lm3s6965evb)
set(INKCELL_CPU "-mcpu=cortex-m3 -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
