# Toolchain for Arm MPS2 with image AN385 (Cortex-M3).
set(INKCELL_BOARD mps2_an385)
set(INKCELL_CPU "-mcpu=cortex-m3 -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
