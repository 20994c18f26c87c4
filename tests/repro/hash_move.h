/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_HASH_MOVE_H
#define ROLLCOIN_HASH_MOVE_H

#include "fnv.h"

static uint64_t hash_body(uint64_t h, const coin_body *b)
{
    return hash_doubles(hash_state(h, &b->s), &b->y, 4);
}

/* By coin_move(), thrown from *s, along the table without losses and off it
 * with them; unit is the natural unit of time.  Every other call is loose, and
 * the last goes on to where the coin rests, or 20 units. */
static uint64_t hash_move(const coin_state *s, const coin_params *p,
                          double unit)
{
    const double torque = p->mass * p->gravity * p->radius / 1024;
    uint64_t h = FNV_OFFSET;
    int i, lossy;
    for (lossy = 0; lossy < 2; ++lossy) {
        coin_table table = {
            0, 0, 0, {0, 0}, {0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0, 0}}};
        coin_body b;
        table.mu_static = 0.33;
        table.mu_kinetic = 0.3;
        table.losses.dry = lossy * torque;
        table.losses.viscous = lossy * torque * unit;
        table.losses.angular = lossy / (1024 * unit);
        h = hash_status(h, coin_body_from_state(&b, s, p));
        table.restitution = 0.5;
        b.vx += p->radius / unit / 2;
        b.vy += 2 * lossy * p->radius / unit;
        for (i = 1; i <= 11; ++i) {
            double reached = 0;
            h = hash_status(h, coin_move(&b, p, &table,
                                         (i <= 10 ? 1.7 : 20) * unit,
                                         i % 2 ? 1e-9 : 1e-3, 0, &reached));
            h = hash_doubles(hash_body(h, &b), &reached, 1);
        }
    }
    return h;
}

#endif
