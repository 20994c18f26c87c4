/* SPDX-License-Identifier: MIT */
/* Coins with losses. */
#include "fuzz.h"

#include <math.h>

static int is_sound(const coin_state *s, const coin_params *p,
                    const coin_losses *l)
{
    return s && p && l && coin_state_check(s, p) == COIN_OK &&
           coin_losses_check(l, p) == COIN_OK;
}

/* A settling of 2^20 steps takes half a minute under the sanitizers: a coin
 * moves at most some turns here. */
static double brief(double t, const coin_state *s, const coin_params *p)
{
    const double most = 64 / coin_fastest_rate(s, p);
    return t > most ? most : t;
}

static int32_t settle(coin_state *s, const coin_params *p, const coin_losses *l,
                      double t, double tol, double *reached)
{
    return coin_settle(s, p, l, is_sound(s, p, l) ? brief(t, s, p) : t, tol,
                       reached);
}

static void judge_power(const struct outcome *o)
{
    demand(!(o->result < 0));
}

/* Whether any term takes energy: soft is none. */
static int slows(const coin_losses *l)
{
    return l->damping > 0 || l->dry > 0 || l->viscous > 0 || l->layer > 0 ||
           l->gap > 0 || l->rolling > 0 || l->spin > 0 || l->angular > 0;
}

/* As of coin_advance(); at rest as coin.h says. */
static void judge_settle(const struct outcome *o)
{
    const double reached = reached_by(o, 3, 5);
    const coin_state *s = o->left[0].p;
    const int32_t status = (int32_t)o->result;
    if (status < 0)
        return;
    const double t = brief(o->given[3].d, o->given[0].p, o->given[1].p);
    demand(status == COIN_OK || status == COIN_RESTS || status == COIN_MORE);
    demand(status != COIN_OK || reached == t);
    demand(status != COIN_MORE || reached < t);
    if (status == COIN_RESTS && s->theta == 0)
        demand(s->wX == 0 && s->wY == 0);
    else if (status == COIN_RESTS && slows(o->given[2].p))
        demand(s->wY == 0 && s->wX * s->theta >= 0 && fabs(s->theta) > 1.57);
}

FUNCTION(coin_losses_check, "lp", coin_losses_check(a[0].p, a[1].p),
         BIT(COIN_EARG) | BIT(COIN_EPARAMS), 0, PLAIN)
FUNCTION(coin_losses_power, "spl", coin_losses_power(a[0].p, a[1].p, a[2].p), 0,
         0, 0, judge_power, 1)
FUNCTION(coin_losses_rates, "splR",
         coin_losses_rates(a[0].p, a[1].p, a[2].p, a[3].p), USUAL, 0, PLAIN)
FUNCTION(coin_losses_reaction, "splF",
         coin_losses_reaction(a[0].p, a[1].p, a[2].p, a[3].p), USUAL, 0, PLAIN)
FUNCTION(coin_settle, "SplTer",
         settle(a[0].p, a[1].p, a[2].p, a[3].d, a[4].d, a[5].p), USUAL | STOPS,
         COIN_RESTS | COIN_MORE, BIT(COIN_ERANGE), judge_settle, 0)
