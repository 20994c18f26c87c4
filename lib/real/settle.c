/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"

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
    coin_priv_body b;
    coin_priv_moving g;
    if (!s || !p || !l || !coin_priv_tol_suits(tol))
        return COIN_EARG;
    if (coin_priv_check_body(&b, p) != COIN_OK ||
        coin_priv_law_of(&g.law, l, &b) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    const double w0 = sqrt(b.g_a), no_slip[2] = {0, 0};
    if (!coin_priv_time_suits(t, w0))
        return COIN_ESTEP;
    if (coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_RESTS;
    }
    if (!g.law.lossy)
        g.law.flat = NO_FLAT;
    coin_state natural = *s;
    coin_priv_scale(&natural, 1 / b.a, 1 / w0);
    const coin_priv_variables v = coin_priv_variables_of(&natural);
    coin_priv_begin(&g, &natural, &v, 0, no_slip, t * w0, tol);
    g.tries = *tries;
    status = coin_priv_go(&g, 0, 0);
    *tries = g.tries;
    if (g.changed) {
        coin_priv_end(&g, &natural);
        coin_priv_scale(&natural, b.a, w0);
        *s = natural;
    }
    if (g.mode & COIN_PRIV_RESTS) {
        status = COIN_RESTS;
        s->wX = copysign(s->wX, s->theta);
        s->wY = 0;
    }
    if (reached)
        *reached = coin_priv_reached(&g.pose[4], g.time, t, w0);
    return status;
}

int32_t coin_settle(coin_state *s, const coin_params *p, const coin_losses *l,
                    double t, double tol, double *reached)
{
    int tries = TRIES;
    return coin_priv_settle(s, p, l, t, tol, &tries, reached);
}
