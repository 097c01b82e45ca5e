# Toolchain for the Arm Versatile/PB (ARM926EJ-S).
set(INKCELL_BOARD versatilepb)
set(INKCELL_CPU "-mcpu=arm926ej-s -marm")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_arm.cmake)
