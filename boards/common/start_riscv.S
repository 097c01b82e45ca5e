// RISC-V, machine mode: reset and traps. The image begins here.
    .section .vectors, "ax"
    .globl inkcell_reset
    .type inkcell_reset, @function
inkcell_reset:
    la sp, inkcell_stack_top
    la t0, trap
    csrw mtvec, t0
    j inkcell_start

    // If the instruction is the semihosting trap, then there is no debugger to
    // handle it: continue after it with the result -1. It is part of a function
    // call, so t0 and t1 are free.
    .balign 4
trap:
    csrr t0, mepc
    la t1, inkcell_semihosting_trap
    bne t0, t1, 1f
    addi t0, t0, 4
    csrw mepc, t0
    li a0, -1
    mret
1:  mv a0, t0
    la sp, inkcell_stack_top
    j inkcell_fault
