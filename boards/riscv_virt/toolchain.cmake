# Toolchain for QEMU's RISC-V virt machine (rv32imc).
set(INKCELL_BOARD riscv_virt)
set(INKCELL_CPU "-march=rv32imc -misa-spec=2.2 -mabi=ilp32")
include(${CMAKE_CURRENT_LIST_DIR}/../common/toolchain_riscv.cmake)
