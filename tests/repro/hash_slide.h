/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_HASH_SLIDE_H
#define ROLLCOIN_HASH_SLIDE_H

#include "fnv.h"

/* By coin_slide_advance(), thrown from *s without rolling, with losses and
 * without; unit is the natural unit of time. */
static uint64_t hash_slide(const coin_state *s, const coin_params *p,
                           double unit)
{
    const coin_friction f = {0.33, 0.3};
    const double torque = p->mass * p->gravity * p->radius / 1024;
    uint64_t h = FNV_OFFSET;
    int i, lossy;
    for (lossy = 0; lossy < 2; ++lossy) {
        coin_losses l = {0, 0, 0, 0, 0, 0, 0, 0};
        coin_slide d;
        l.dry = torque;
        l.viscous = torque * unit;
        h = hash_status(h, coin_slide_of(&d, s, p));
        d.vx += p->radius / unit / 2;
        for (i = 1; i <= 10; ++i) {
            double reached = 0;
            h = hash_status(h, coin_slide_advance(&d, p, &f, lossy ? &l : NULL,
                                                  1.7 * unit, 1e-9, &reached));
            h = hash_doubles(hash_state(h, &d.s), &d.vx, 1);
            h = hash_doubles(hash_doubles(h, &d.vz, 1), &reached, 1);
        }
    }
    return h;
}

#endif
