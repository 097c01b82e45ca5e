# GCC for all RISC-V boards (Debian: gcc-riscv64-unknown-elf, which has no C++
# library: code includes <stdint.h> and <stddef.h> only). A board's
# toolchain.cmake sets INKCELL_BOARD and INKCELL_CPU, then includes this file.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
include(${CMAKE_CURRENT_LIST_DIR}/toolchain_gcc.cmake)
