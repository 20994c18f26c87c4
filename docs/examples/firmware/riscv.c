/* SPDX-License-Identifier: MIT */
/* A RISC-V with the timer of the privileged specification where QEMU's board
 * "virt" and many others have it. */
#include "board.h"
#include "start.h"

/* What mtime counts. */
#ifndef BOARD_HZ
#define BOARD_HZ 10000000
#endif

#define MTIMECMP ((volatile uint32_t *)(uintptr_t)0x2004000)
#define MTIME ((volatile uint32_t *)(uintptr_t)0x200bff8)

/* The float unit is off after a reset: mstatus.FS; a fault ends the program. */
__asm__(".option arch, +zicsr\n"
        ".section .vectors, \"ax\"\n"
        ".globl board_vectors\n"
        "board_vectors:\n"
        "    la sp, board_stack\n"
        "    la t0, on_fault\n"
        "    csrw mtvec, t0\n"
        "    li t0, 0x2000\n"
        "    csrs mstatus, t0\n"
        "    call on_start\n"
        ".text");

/* The three of semihosting, uncompressed and in one page. */
__asm__(".section .text.ask_host, \"ax\"\n"
        ".balign 16\n"
        ".globl ask_host\n"
        "ask_host:\n"
        "    .option push\n"
        "    .option norvc\n"
        "    slli zero, zero, 0x1f\n"
        "    ebreak\n"
        "    srai zero, zero, 7\n"
        "    ret\n"
        "    .option pop\n"
        ".text");

void on_start(void);
void on_fault(void);

void on_start(void)
{
    run_main();
}

__attribute__((aligned(4))) void on_fault(void)
{
    leave(99);
}

static uint32_t period, last;

static void wake_at(uint32_t low)
{
    const uint32_t high = MTIME[1] + (low < MTIME[0]);
    MTIMECMP[1] = UINT32_MAX; /* not by a half of the new time */
    MTIMECMP[0] = low;
    MTIMECMP[1] = high;
}

void board_tick(uint32_t per_second)
{
    period = BOARD_HZ / per_second;
    last = MTIME[0];
    __asm__ volatile("csrs mie, %0" : : "r"(0x80)); /* wakes, traps nowhere */
}

uint32_t board_wait(void)
{
    uint32_t passed;
    wake_at(last + period);
    while (MTIME[0] - last < period)
        __asm__ volatile("wfi");
    passed = (MTIME[0] - last) / period;
    last += passed * period;
    return passed;
}
