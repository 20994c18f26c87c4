/* SPDX-License-Identifier: MIT */
/* A control loop with a coin in it, 1000 rounds per second: each moves the coin
 * by a millisecond and sets a tray's motors from it, so that the rim touches
 * the tray where it did.  A watchdog looks after it: if the model does not hold
 * any more, a step was too coarse, or a round took too long, the motors stop,
 * and the reason is told.  Single precision, nothing allocated. */
#include "board.h"

#include <coinf.h>
#include <stdio.h>

enum { ROUNDS_PER_SECOND = 1000, ROUNDS = 500, LATE = 1 << 8 };

static const float dt = 1.0f / ROUNDS_PER_SECOND;
static const float grip = 0.4f; /* the tray's friction coefficient */

/* The motors of this example: metres per second along x and z. */
static float motors[2];

/* One round; 0, or what is wrong: < 0 an error, > 0 bits. */
static int32_t one_round(coinf_state *s, const coinf_params *p)
{
    float contact[3], velocity[3];
    const int32_t moved = coinf_step(s, p, dt);
    const int32_t holds =
        moved < 0 ? moved : coinf_check(s, p, COIN_RK4, dt, grip);
    const int32_t seen = coinf_contact(s, p, contact, velocity);
    if (holds < 0 || seen < 0)
        return holds < 0 ? holds : seen;
    motors[0] = -velocity[0];
    motors[1] = -velocity[2];
    return moved | holds;
}

static char *append(char *to, const char *text)
{
    while (*text)
        *to++ = *text++;
    return to;
}

static char *append_number(char *to, uint32_t n)
{
    char digits[10];
    int count = 0;
    do
        digits[count++] = (char)('0' + n % 10);
    while ((n /= 10) > 0);
    while (count > 0)
        *to++ = digits[--count];
    return to;
}

static void report(int32_t rounds, int32_t wrong)
{
    static const struct {
        int32_t bit;
        const char *name;
    } bits[] = {
        {COIN_SLIPS, " slips"},   {COIN_LIFTS, " lifts"},
        {COIN_COARSE, " coarse"}, {COIN_NEARLY_FLAT, " nearly flat"},
        {LATE, " late"},
    };
    char line[96], *end = append_number(line, (uint32_t)rounds);
    end = append(end, " rounds:");
    for (int i = 0; i < 5; ++i)
        if (wrong > 0 && (wrong & bits[i].bit))
            end = append(end, bits[i].name);
    if (wrong <= 0)
        end = append(end, wrong == 0 ? " well" : " error");
    *end = 0;
    puts(line);
}

/* Rolls until the watchdog bites, or all rounds are done. */
static void launch(coinf_state s, const coinf_params *p)
{
    int32_t wrong = 0, rounds = 0;
    board_tick(ROUNDS_PER_SECOND);
    while (wrong == 0 && rounds < ROUNDS) {
        if (board_wait() != 1)
            wrong = LATE;
        else
            wrong = one_round(&s, p);
        rounds += wrong == 0;
    }
    motors[0] = motors[1] = 0;
    report(rounds, wrong);
}

int main(void)
{
    static const coinf_state rolling = {0.3f, 0, 0, 0, 0, 0, 5, 40, {0}};
    static const coinf_state falling = {0.3f, 0, 0, 0, 0, 0, 1, 2, {0}};
    static const coinf_state racing = {0.1f, 0, 0, 0, 0, 0, 0, 400, {0}};
    coinf_params quarter;
    if (coinf_selftest() != COIN_OK ||
        coinf_params_disc(&quarter, 0.00567f, 0.01213f, 9.80665f) != COIN_OK)
        return 1;
    launch(rolling, &quarter);
    launch(falling, &quarter);
    launch(racing, &quarter);
    return 0;
}
