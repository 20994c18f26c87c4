/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "coin_body.h"

/* The most trials of steps of a call: a choice, by which it takes 20 ms at most
 * on a processor of 3 GHz.  Where a trial takes longest, in a slip with losses
 * near flat, it takes as long as 14 textbook steps.  With half of them a call
 * that uses them up takes two. */
#define TRIES 11000

/* What a call may be ended by. */
#define STOPS                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES |  \
     COIN_DECIDED)

static int has_pull(const coin_table *table)
{
    return table->pull[0] != 0 || table->pull[1] != 0;
}

int32_t coin_move(coin_body *b, const coin_params *p, const coin_table *table,
                  double t, double tol, int32_t stop, double *reached)
{
    coin_priv_constants of;
    coin_priv_moving g;
    if (!b || !p || !table || !coin_priv_tol_in_range(tol) || (stop & ~STOPS) ||
        (stop & COIN_DECIDED && has_pull(table)))
        return COIN_EARG;
    const double half = coin_priv_half_of(p);
    if (coin_priv_check_thick(&of, p) != COIN_OK ||
        coin_priv_table_law(&g.law, table, &of, half) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_coin_of(&g.c, b, &of, half);
    if (status != COIN_OK)
        return status;
    const double w0 = sqrt(of.g_a), time = t * w0;
    if (!coin_priv_duration_in_range(t, w0))
        return COIN_ESTEP;
    coin_priv_begin_call(&g, time, tol, TRIES);
    g.stop = stop;
    status = coin_priv_go_on(&g);
    if (g.changed) {
        coin_priv_body_of(b, &g.c, &of);
        if (status >= 0 && !(status & COIN_LIFTS))
            coin_priv_set_on_table(b, of.a, half, g.law.eta,
                                   status & COIN_SLIPS);
    }
    if (reached)
        *reached = coin_priv_reached(&g, time, t, w0);
    return status;
}
