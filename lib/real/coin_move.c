/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "thrown.h"

/* The most trials of steps of a call: a choice, by which it takes 20 ms at most
 * on a processor of 3 GHz.  Where a trial takes longest, in a slip with losses
 * near flat, it takes as long as 14 textbook steps.  With half of them a call
 * that uses them up takes two. */
#define TRIES 11000

/* What a call may be ended by. */
#define STOPS                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES)

/* Sets height and velocity of a body on the table to what its other members,
 * which have been rounded, say. */
static void set_on_table(coin_body *b, const coin_priv_attitude *at, double a,
                         int slips)
{
    const double vx = b->vx, vz = b->vz;
    coin_priv_set_rolling(b, at, a);
    if (slips) {
        b->vx = vx;
        b->vz = vz;
    }
}

int32_t coin_move(coin_body *b, const coin_params *p, const coin_table *table,
                  double t, double tol, int32_t stop, double *reached)
{
    coin_priv_body of;
    coin_priv_thrown w;
    double u[2];
    if (!b || !p || !table || !coin_priv_tol_suits(tol) || (stop & ~STOPS))
        return COIN_EARG;
    if (coin_priv_check_body(&of, p) != COIN_OK ||
        coin_priv_table_law(&w.g.law, table, &of) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_natural_body(&w.b, &w.at, b, &of);
    if (status != COIN_OK)
        return status;
    if (w.g.law.damping > 0 &&
        coin_priv_body_mode(&w.b, &w.at, u) & (COIN_PRIV_SLIPS | COIN_PRIV_AIR))
        return COIN_EPARAMS;
    const double w0 = sqrt(of.g_a);
    if (!coin_priv_time_suits(t, w0))
        return COIN_ESTEP;
    w.restitution = table->restitution;
    w.time = t * w0;
    w.tol = tol;
    w.moved.sum = w.moved.low = 0;
    w.stop = stop;
    w.event = w.changed = 0;
    w.g.tries = TRIES;
    status = coin_priv_go_on(&w);
    if (w.changed) {
        *b = w.b;
        coin_priv_scale_body(b, of.a, w0);
        if (status >= 0 && !(status & (COIN_LIFTS | COIN_RESTS)))
            set_on_table(b, &w.at, of.a, status & COIN_SLIPS);
    }
    if (reached)
        *reached = coin_priv_reached(&w.moved, w.time, t, w0);
    return status;
}
