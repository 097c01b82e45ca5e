# Toolchain for Arm MPS2 with image AN505 (Cortex-M33).
set(INKCELL_BOARD mps2_an505)
set(INKCELL_CPU "-mcpu=cortex-m33 -mthumb -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
