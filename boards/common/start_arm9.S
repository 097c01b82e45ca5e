// ARM926 and its like: vector table at address 0, reset and faults. Everything
// runs in supervisor mode, which is where the core starts.
    .section .vectors, "ax"
    .arm
    .balign 4
    ldr pc, =inkcell_reset
    b fault             // undefined instruction
    b trap              // supervisor call
    b fault             // instruction from nowhere
    b abort             // access to nowhere, or unaligned
    b fault
    b fault             // interrupt
    b fault
    .pool

    .section .text.inkcell_reset, "ax"
    .globl inkcell_reset
    .type inkcell_reset, %function
inkcell_reset:
    // System control: refuse unaligned access (bit 1).
    mrc p15, 0, r0, c1, c0, 0
    orr r0, r0, #2
    mcr p15, 0, r0, c1, c0, 0
    ldr sp, =inkcell_stack_top
    b inkcell_start

    // The only supervisor call is semihosting's. It got here, so there is no
    // debugger: the result is -1.
trap:
    mvn r0, #0
    movs pc, lr

abort:
    sub lr, lr, #4
fault:
    sub r0, lr, #4
    msr cpsr_c, #0xd3   // supervisor mode, no interrupts
    ldr sp, =inkcell_stack_top
    b inkcell_fault
    .pool
