/* SPDX-License-Identifier: MIT */
/* turning.h: a coin swings in its lean; where it turns, and what one whole
 * swing does. */
#ifndef EXAMPLE_TURNING_H
#define EXAMPLE_TURNING_H

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program if the library refuses: these pictures ask for nothing that
 * it should. */
static inline void demand(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
}

static inline void roll_on(coin_state *s, const coin_params *p, double t)
{
    demand(coin_advance(s, p, t, 1e-12, NULL));
}

/* Rolls on to where the lean turns: from growing to shrinking for way = 1, from
 * shrinking to growing for -1.  Returns the time.  The lean must not turn twice
 * within a fiftieth of a natural unit. */
static inline double to_turn(coin_state *s, const coin_params *p, int way)
{
    const double step = 0.02 * sqrt(p->radius / p->gravity);
    double t = 0, low = 0, high = step;
    coin_state last = *s, next = *s;

    roll_on(&next, p, step);
    for (; !(way * last.wX > 0 && way * next.wX <= 0); t += step) {
        last = next;
        roll_on(&next, p, step);
    }
    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        next = last;
        roll_on(&next, p, middle);
        *(way * next.wX > 0 ? &low : &high) = middle;
    }
    *s = next;
    return t + low;
}

/* Rolls a coin that starts where its lean turns (wX = 0) through one period of
 * the lean.  Returns the period. */
static inline double one_period(coin_state *s, const coin_params *p)
{
    const double soon = 1e-3 * sqrt(p->radius / p->gravity);

    roll_on(s, p, soon);
    return soon + to_turn(s, p, s->wX > 0 ? -1 : 1);
}

#endif
