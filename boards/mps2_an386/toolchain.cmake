# Toolchain for Arm MPS2 with image AN386 (Cortex-M4).
set(INKCELL_BOARD mps2_an386)
set(INKCELL_CPU "-mcpu=cortex-m4 -mthumb -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
