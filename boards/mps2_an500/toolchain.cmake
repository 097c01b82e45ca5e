# Toolchain for Arm MPS2 with image AN500 (Cortex-M7).
set(INKCELL_BOARD mps2_an500)
set(INKCELL_CPU "-mcpu=cortex-m7 -mthumb -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
