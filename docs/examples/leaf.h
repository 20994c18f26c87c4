/* SPDX-License-Identifier: MIT */
/* leaf.h: coins with the same two linear integrals at other leans, and the
 * steady motions among them. */
#ifndef EXAMPLE_LEAF_H
#define EXAMPLE_LEAF_H

#include "turning.h"

/* Moves a coin to the lean theta + h and keeps its two integrals: a step of RK4
 * along the lean.  With wX = 1 its rates are slopes along the lean. */
static inline void lean_by(coin_state *s, const coin_params *p, double h)
{
    const double part[] = {0, h / 2, h / 2, h};
    const double weight[] = {h / 6, h / 3, h / 3, h / 6};
    const coin_state from = *s;
    coin_state slope = {0};

    s->theta += h;
    s->wX = 0;
    for (int k = 0; k < 4; ++k) {
        coin_state at = from;
        at.theta += part[k];
        at.wX = 1;
        at.wY += part[k] * slope.wY;
        at.wZ += part[k] * slope.wZ;
        demand(coin_rates(&at, p, &slope));
        s->wY += weight[k] * slope.wY;
        s->wZ += weight[k] * slope.wZ;
    }
}

/* d(wX)/dt, which is 0 in a steady motion. */
static inline double push(const coin_state *s, const coin_params *p)
{
    coin_state slope;

    demand(coin_rates(s, p, &slope));
    return slope.wX;
}

/* Leans a coin on, to the greater side for way = 1, until its motion is steady.
 * Returns 0 if it lies nearly flat before. */
static inline int lean_to_steady(coin_state *s, const coin_params *p, int way)
{
    coin_state last;
    double low = 0, high;

    do {
        if (cos(s->theta) < 0.01)
            return 0;
        last = *s;
        high = way * 0.003 * cos(s->theta);
        lean_by(s, p, high);
    } while (push(&last, p) * push(s, p) > 0);
    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        *s = last;
        lean_by(s, p, middle);
        *(push(&last, p) * push(s, p) > 0 ? &low : &high) = middle;
    }
    return 1;
}

#endif
