# Shared by the toolchain files of all boards: flags, and QEMU to run programs.
set(INKCELL_BOARD ${INKCELL_BOARD} CACHE STRING "Folder below boards/")

# Test programs cannot be linked before a board is chosen.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(_inkcell_flags "${INKCELL_CPU} -ffreestanding -ffunction-sections \
-fdata-sections")
set(CMAKE_C_FLAGS_INIT "${_inkcell_flags}")
set(CMAKE_ASM_FLAGS_INIT "${INKCELL_CPU}")
set(CMAKE_CXX_FLAGS_INIT "${_inkcell_flags} -fno-exceptions -fno-rtti \
-fno-threadsafe-statics")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections")
set(CMAKE_C_STANDARD_LIBRARIES "-lgcc")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lgcc")
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)

# CMake's default for Release is -O3, which firmware does not use. MinSizeRel is
# -Os.
foreach(_language C CXX)
  set(CMAKE_${_language}_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
endforeach()

# CTest then runs firmware like a program of the host.
set(CMAKE_CROSSCOMPILING_EMULATOR
  "${CMAKE_CURRENT_LIST_DIR}/qemu_run.sh;${INKCELL_BOARD}")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
