/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "move.h"
#include "settle.h"

/* The most trials of steps of a call: a choice.  Lives of coins take some
 * thousands. */
#define TRIES (1 << 20)

/* Where cos theta is less than this, a coin without losses lies flat: a pass as
 * near would take less time than a double resolves. */
#define NO_FLAT 1e-30

int32_t coin_priv_settle(coin_state *s, const coin_params *p,
                         const coin_losses *l, double t, double tol, int *tries,
                         double *reached)
{
    coin_priv_constants b;
    coin_priv_moving g;
    if (!s || !p || !l || !coin_priv_tol_in_range(tol))
        return COIN_EARG;
    if (coin_priv_check_params(&b, p) != COIN_OK ||
        coin_priv_law_of(&g.law, l, &b) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    const double w0 = sqrt(b.g_a), time = t * w0;
    if (!coin_priv_duration_in_range(t, w0))
        return COIN_ESTEP;
    if (coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_RESTS;
    }
    if (!g.law.lossy)
        g.law.flat = NO_FLAT;
    const double no_slip[2] = {0, 0};
    coin_state natural = *s;
    coin_priv_scale(&natural, 1 / b.a, 1 / w0);
    coin_priv_set_state(&g.c, &natural, 0);
    coin_priv_begin_call(&g, time, tol, *tries);
    coin_priv_begin(&g, 0, no_slip);
    status = coin_priv_go(&g);
    *tries = g.tries;
    if (g.changed) {
        coin_priv_get_state(s, &g.c);
        coin_priv_scale(s, b.a, w0);
    }
    if (g.mode & COIN_PRIV_RESTS) {
        s->wX = copysign(s->wX, s->theta);
        s->wY = 0;
        status = COIN_RESTS;
    }
    if (reached)
        *reached = coin_priv_reached(&g, time, t, w0);
    return status == COIN_OK ? g.found : status;
}

int32_t coin_settle(coin_state *s, const coin_params *p, const coin_losses *l,
                    double t, double tol, double *reached)
{
    int tries = TRIES;
    return coin_priv_settle(s, p, l, t, tol, &tries, reached);
}
