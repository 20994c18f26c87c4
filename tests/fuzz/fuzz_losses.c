/* SPDX-License-Identifier: MIT */
/* Coins with losses. */
#include "fuzz.h"

#include <math.h>

CALL(coin_losses_check, (a[0].p, a[1].p))
CALL(coin_losses_power, (a[0].p, a[1].p, a[2].p))
CALL(coin_losses_rates, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coin_losses_reaction, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coin_settle, (a[0].p, a[1].p, a[2].p, a[3].d, a[4].d, a[5].p))

/* Whether a coin of sound arguments comes to rest soon.  Others take seconds.
 */
static int is_brief(const coin_state *s, const coin_params *p,
                    const coin_losses *l)
{
    if (!s || !p || !l || coin_state_check(s, p) != COIN_OK ||
        coin_losses_check(l, p) != COIN_OK)
        return 1;
    const double T = p->mass * p->gravity * p->radius;
    const double w2 = p->gravity / p->radius;
    return l->dry > 0.02 * T && l->dry < T &&
           s->wX * s->wX + s->wY * s->wY + s->wZ * s->wZ < 100 * w2;
}

static double time_to_rest(const coin_state *s, const coin_params *p,
                           const coin_losses *l)
{
    return is_brief(s, p, l) ? coin_time_to_rest(s, p, l) : (double)NAN;
}

static int32_t losses_fit(coin_losses *l, const coin_state *s,
                          const coin_params *p, double time)
{
    return is_brief(s, p, l) ? coin_losses_fit(l, s, p, time) : COIN_EDOMAIN;
}
CALL_AS(coin_time_to_rest, time_to_rest, (a[0].p, a[1].p, a[2].p))
CALL_AS(coin_losses_fit, losses_fit, (a[0].p, a[1].p, a[2].p, a[3].d))

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
    demand(o->result != COIN_OK || reached == o->given[3].d);
    if (o->result == COIN_RESTS && slows(o->given[2].p))
        demand(s->wY == 0 && s->wX * s->theta >= 0 && fabs(s->theta) > 1.57);
}

#define NEAR_STEADY (USUAL | BIT(COIN_EDOMAIN))

const struct function fuzz_functions[] = {
    ROW(coin_losses_check, "lp", BIT(COIN_EARG) | BIT(COIN_EPARAMS), 0, PLAIN),
    ROW(coin_losses_power, "spl", 0, 0, 0, judge_power, 1),
    ROW(coin_losses_rates, "splR", USUAL, 0, PLAIN),
    ROW(coin_losses_reaction, "splF", USUAL, 0, PLAIN),
    ROW(coin_settle, "SplTer", USUAL | STOPS, COIN_RESTS, STOPS, judge_settle,
        0),
    ROW(coin_time_to_rest, "spl", 0, 0, 0, judge_power, 2),
    ROW(coin_losses_fit, "LEpT", NEAR_STEADY, 0, PLAIN),
};

END_OF_TABLE;
