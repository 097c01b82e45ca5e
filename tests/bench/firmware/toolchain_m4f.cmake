# Cortex-M4 with its floating-point unit, for engines that compute with it.
set(INKCELL_BOARD mps2_an386)
set(INKCELL_CPU
  "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
include(${CMAKE_CURRENT_LIST_DIR}/../../../boards/common/toolchain_arm.cmake)
