/* SPDX-License-Identifier: MIT */
/* Prints how many instructions a step takes on this processor, and how deep
 * its stack really went.  Runs under QEMU with -icount, whose clock is the
 * number of instructions; a loop of known length tells how many of them the
 * timer counts as one. */
#include <coinf.h>

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
/* SysTick, without its interrupt: counts down 24 bits. */
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

typedef void work(uint32_t n);

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

static coinf_params quarter_f;
static coin_params quarter;

static void begin_f(coinf_state *s)
{
    const coinf_state start = {0.3f, 0, 0, 0, 0, 0, 5, 40, {0}};
    *s = start;
}

static void begin(coin_state *s)
{
    const coin_state start = {0.3, 0, 0, 0, 0, 0, 5, 40};
    *s = start;
}

static int failed;

static void float_steps(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    while (n-- > 0)
        failed |= coinf_step(&s, &quarter_f, 1e-3f) != COIN_OK;
}

static void float_run(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    failed |= coinf_run(&s, &quarter_f, COIN_RK4, 1e-3f, n, 0) != COIN_OK;
}

static void float_checks(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    while (n-- > 0)
        failed |= coinf_check(&s, &quarter_f, COIN_RK4, 1e-3f, 1) != COIN_OK;
}

static void double_steps(uint32_t n)
{
    coin_state s;
    begin(&s);
    while (n-- > 0)
        failed |= coin_step(&s, &quarter, 1e-3) != COIN_OK;
}

static void double_run(uint32_t n)
{
    coin_state s;
    begin(&s);
    failed |= coin_run(&s, &quarter, COIN_RK4, 1e-3, n, 0) != COIN_OK;
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

/* Bytes of stack below this call that are no longer as they were painted. */
enum { PAINTED = 3072 };

__attribute__((noinline)) static uint32_t paint(int look)
{
    volatile uint32_t below[PAINTED / 4];
    uint32_t i;
    if (!look)
        for (i = 0; i < PAINTED / 4; ++i)
            below[i] = 0x5a5aa5a5;
    for (i = 0; i < PAINTED / 4 && below[i] == 0x5a5aa5a5; ++i)
        ;
    return PAINTED - 4 * i;
}

static uint32_t depth(work *does)
{
    paint(0);
    does(1);
    return paint(1);
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
    static const struct {
        const char *name;
        work *does;
    } of[] = {
        {"coinf_step", float_steps},   {"coinf_run", float_run},
        {"coinf_check", float_checks}, {"coin_step", double_steps},
        {"coin_run", double_run},
    };
    uint32_t spun, i;
    coinf_params_disc(&quarter_f, 0.00567f, 0.01213f, 9.80665f);
    coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    start_clock();
    spun = ticks_of(spin, 200000) - ticks_of(spin, 100000);
    for (i = 0; i < sizeof of / sizeof *of; ++i)
        print(of[i].name, instructions(of[i].does, spun), depth(of[i].does));
    return failed;
}
