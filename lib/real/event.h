/* SPDX-License-Identifier: MIT */
/* The first moment of a stretch of motion at which a real coin would slip or
 * lift off, or is nearly flat. */
#ifndef ROLLCOIN_EVENT_H
#define ROLLCOIN_EVENT_H

#include "cone_by_series.h"

/* A moment of a stretch. */
typedef struct coin_priv_moment {
    double x;          /* the part of the stretch that has passed, 0 to 1 */
    coin_priv_run run; /* added.t is the time since the stretch began */
    int32_t bits;      /* those that hold */
} coin_priv_moment;

/* The bits looked for that hold in a state, where the force is *at.
 * coin_check() is called only if one of them may hold. */
int32_t coin_priv_bits_at(const coin_priv_search *f, const coin_state *s,
                          const coin_priv_force_series *at);

/* Sets *out to the first event of a stretch at whose begin no bit holds, within
 * tol of the time at which the event begins; returns 0 if there is none.  On
 * entry w->force is the force on the stretch before, of which one term is
 * enough.  On return it is the force on this stretch. */
int coin_priv_first_event(coin_priv_moment *out, const coin_priv_search *f,
                          coin_priv_stretch *w);

#endif
