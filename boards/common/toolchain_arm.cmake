# GCC for all Arm boards (Debian: gcc-arm-none-eabi). A board's toolchain.cmake
# sets INKCELL_BOARD and INKCELL_CPU, then includes this file.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
# Start-up makes cores refuse unaligned access if they can; GCC must then not
# merge neighbouring bytes and half-words into such accesses.
set(INKCELL_CPU "${INKCELL_CPU} -mno-unaligned-access")
include(${CMAKE_CURRENT_LIST_DIR}/toolchain_gcc.cmake)
