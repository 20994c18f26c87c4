/* SPDX-License-Identifier: MIT */
/* Any Cortex-M: vectors, start-up, and SysTick as the timer. */
#include "board.h"
#include "start.h"

/* The processor's clock; SysTick counts it. */
#ifndef BOARD_HZ
#define BOARD_HZ 25000000
#endif

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define SYST_CSR REGISTER(0xe000e010) /* control */
#define SYST_RVR REGISTER(0xe000e014) /* counts down from here */
#define SYST_CVR REGISTER(0xe000e018) /* to 0 */
#define CPACR REGISTER(0xe000ed88)

__attribute__((naked)) void ask_host(uintptr_t what, const void *with)
{
    (void)what;
    (void)with;
    __asm__("bkpt 0xab\n bx lr");
}

static volatile uint32_t ticks;

static void on_start(void)
{
#if defined(__ARM_FP)
    CPACR = CPACR | 0xf00000; /* the float unit is off after a reset */
    __asm__ volatile("dsb\n isb");
#endif
    run_main();
}

static void on_fault(void)
{
    leave(99);
}

static void on_tick(void)
{
    ticks = ticks + 1;
}

extern uint32_t board_stack[]; /* its top, by board.ld */

typedef void handler(void);

/* Stack, reset, NMI, four faults; SVCall, PendSV and SysTick are 11, 14, 15. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    handler *of[15];
} vectors = {
    board_stack,
    {on_start, on_fault, on_fault, on_fault, on_fault, on_fault, 0, 0, 0, 0,
     on_fault, 0, 0, on_fault, on_tick},
};

void board_tick(uint32_t per_second)
{
    SYST_CSR = 0;
    SYST_RVR = BOARD_HZ / per_second - 1;
    SYST_CVR = 0;
    ticks = 0;
    SYST_CSR = 7; /* the processor's clock, interrupt, on */
}

uint32_t board_wait(void)
{
    uint32_t passed;
    /* A tick between the test and the sleep wakes it all the same. */
    __asm__ volatile("cpsid i" ::: "memory");
    while (ticks == 0)
        __asm__ volatile("wfi\n cpsie i\n nop\n cpsid i" ::: "memory");
    passed = ticks;
    ticks = 0;
    __asm__ volatile("cpsie i" ::: "memory");
    return passed;
}
