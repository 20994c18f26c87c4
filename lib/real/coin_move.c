/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "coin_body.h"

/* The most trials of steps of a call.  Where a trial takes longest, in a slip
 * with losses near flat, it takes as long as 14 textbook steps. */
#define TRIES 11000

/* What a call may be ended by. */
#define STOPS                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES)

/* Sets *b to where the coin has come to; height and velocity are what the mode
 * says. */
static void end_body(coin_body *b, const coin_priv_moving *g,
                     const coin_priv_body *of)
{
    const double uX = g->y[COIN_PRIV_UX], uh = g->y[COIN_PRIV_UH];
    coin_priv_end(g, &b->s, of);
    if (g->mode & COIN_PRIV_RESTS)
        b->s.wX = b->s.wY = b->s.wZ = 0;
    coin_priv_set_rolling(b, of);
    if (g->mode & COIN_PRIV_SLIPS) {
        const coin_priv_sc ph = coin_priv_sincos(b->s.phi);
        const double v0 = of->a * sqrt(of->g_a);
        b->vx += v0 * (uX * ph.c + uh * ph.s);
        b->vz += v0 * (uh * ph.c - uX * ph.s);
    }
    if (g->mode & COIN_PRIV_RESTS)
        b->vx = b->vy = b->vz = 0;
}

/* The status of a mode. */
static int32_t status_of(int mode)
{
    if (mode & COIN_PRIV_RESTS)
        return COIN_RESTS;
    if (mode & COIN_PRIV_AIR)
        return COIN_LIFTS;
    if (mode & COIN_PRIV_SLIPS)
        return COIN_SLIPS;
    return COIN_OK;
}

/* Moves a body that touches the table and may be computed with. */
static int32_t move(coin_body *b, coin_priv_moving *g, const coin_priv_body *of,
                    double t, double *reached)
{
    const int32_t status = coin_priv_go(g);
    *reached = coin_priv_reached(g, t, sqrt(of->g_a));
    if (g->moved) {
        double u[2];
        end_body(b, g, of);
        /* a slip too slow to be told from rolling is none */
        if (g->mode & COIN_PRIV_SLIPS && !coin_priv_body_mode(b, of, u)) {
            coin_priv_set_rolling(b, of);
            g->mode &= ~COIN_PRIV_SLIPS;
        }
    }
    return status < 0 ? status : status_of(g->mode) | status;
}

int32_t coin_move(coin_body *b, const coin_params *p, const coin_table *table,
                  double t, double tol, int32_t stop, double *reached)
{
    coin_priv_body of;
    coin_priv_moving g;
    double u[2], moved = 0;
    if (!b || !p || !table || !coin_priv_tol_suits(tol) || (stop & ~STOPS))
        return COIN_EARG;
    if (coin_priv_check_body(&of, p) != COIN_OK ||
        coin_priv_table_law(&g.law, table, &of) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check_coin_body(b, p, &of);
    if (status != COIN_OK)
        return status;
    const int mode = coin_priv_body_mode(b, &of, u);
    if (g.law.damping > 0 && (mode == COIN_PRIV_SLIPS || mode == COIN_PRIV_AIR))
        return COIN_EPARAMS;
    if (!coin_priv_time_suits(t, sqrt(of.g_a)))
        return COIN_ESTEP;
    coin_priv_begin(&g, &b->s, &of, t, tol);
    g.mode = mode;
    g.y[COIN_PRIV_UX] = u[0];
    g.y[COIN_PRIV_UH] = u[1];
    g.stop = stop;
    g.tries = TRIES;
    if (mode == COIN_PRIV_RESTS) {
        g.moved = t > 0;
        if (g.moved)
            end_body(b, &g, &of);
        status = COIN_RESTS;
    } else if (mode == COIN_PRIV_AIR) { /* flight begins here */
        status = COIN_LIFTS;
    } else {
        status = move(b, &g, &of, t, &moved);
    }
    if (reached)
        *reached = moved;
    return status;
}
