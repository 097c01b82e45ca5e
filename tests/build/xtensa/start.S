# The reset vector of QEMU's machine `sim`; its stack; the exit code of main() by
# its semihosting, and write() of the console.
    .section .reset, "ax"
    .global _start
_start:
    j 1f
    .align 4
    .literal_position
1:  movi a2, 0x10
    wsr.ps a2
    rsync
    movi a1, stack_top
    call0 main
    mov a3, a2
    movi a2, 1
    simcall

    .text
    .align 4
    .global sim_call
sim_call:
    simcall
    ret
