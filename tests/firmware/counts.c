/* SPDX-License-Identifier: MIT */
/* Prints how many instructions a step takes on this processor, and how deep
 * its stack really went.  Runs under QEMU with -icount, whose clock is the
 * number of instructions; a loop of known length tells how many of them the
 * timer counts as one. */
#include "works.h"

#include <stdio.h>

#if defined(__riscv)
static uint32_t now(void)
{
    uint32_t n;
    __asm__ volatile(".option arch, +zicsr\n csrr %0, minstret" : "=r"(n));
    return n;
}

static void start_clock(void)
{
}

#define LOOP "1: addi %0, %0, -1\n bnez %0, 1b"
#else
/* SysTick, without its interrupt: counts down 24 bits, which last for 670
 * million instructions at least. */
#define SYSTICK ((volatile uint32_t *)0xe000e010)

static uint32_t now(void)
{
    return SYSTICK[2];
}

static void start_clock(void)
{
    SYSTICK[1] = 0xffffff;
    SYSTICK[2] = 0;
    SYSTICK[0] = 5;
}

#define LOOP "1: subs %0, #1\n bne 1b"
#endif

static uint32_t ticks_of(work *does, uint32_t n)
{
    const uint32_t begin = now();
    does(n);
#if defined(__riscv)
    return now() - begin;
#else
    return (begin - now()) & 0xffffff;
#endif
}

/* Two instructions each time. */
static void spin(uint32_t n)
{
    __asm__ volatile(LOOP : "+l"(n) : : "cc");
}

/* Instructions of each of FEW + 1 to MANY; a multiple of 64 between them, since
 * a run of doubles does something of its own every 64 steps. */
enum { FEW = 64, MANY = FEW + 8 * 64 };

static uint32_t instructions(work *does, uint32_t spun)
{
    const uint32_t few = ticks_of(does, FEW), many = ticks_of(does, MANY);
    const uint64_t n = (uint64_t)(many - few) * 2 * 100000;
    return (uint32_t)((n / spun + (MANY - FEW) / 2) / (MANY - FEW));
}

static void print(const char *name, uint32_t count, uint32_t bytes)
{
    char line[64];
    int n = 0, from;
    uint32_t numbers[2], i;
    numbers[0] = count;
    numbers[1] = bytes;
    while (*name)
        line[n++] = *name++;
    for (i = 0; i < 2; ++i) {
        char digits[12];
        from = 0;
        do
            digits[from++] = (char)('0' + numbers[i] % 10);
        while ((numbers[i] /= 10) > 0);
        for (line[n++] = ' '; from > 0;)
            line[n++] = digits[--from];
    }
    line[n] = 0;
    puts(line);
}

int main(void)
{
    uint32_t spun, i;
    prepare_works();
    start_clock();
    spun = ticks_of(spin, 200000) - ticks_of(spin, 100000);
    for (i = 0; i < WORKS; ++i)
        print(works[i].name, instructions(works[i].does, spun),
              depth(works[i].does));
    return failed;
}
