/* SPDX-License-Identifier: MIT */
/* Coins with losses until they rest: thousands of steps a call. */
#include "fuzz.h"

#include <math.h>

static int is_sound(const coin_state *s, const coin_params *p,
                    const coin_losses *l)
{
    return s && p && l && coin_state_check(s, p) == COIN_OK &&
           coin_losses_check(l, p) == COIN_OK;
}

/* A hundredth of the losses, and dry friction that brings the coin to rest. */
static coin_losses slowing(const coin_losses *l, const coin_params *p)
{
    const coin_losses more = {
        .damping = l->damping / 100,
        .dry = 0.1 * p->mass * p->gravity * p->radius,
        .viscous = l->viscous / 100,
        .layer = l->layer / 100,
        .gap = l->gap / 100,
        .rolling = l->rolling / 100,
        .spin = l->spin / 100,
        .angular = l->angular / 100,
        .soft = l->soft,
        .flat = l->flat,
    };
    return more;
}

/* The coin, but no faster than a few natural units, and not upright, where one
 * that stands would stand for ever. */
static coin_state slow(const coin_state *s, const coin_params *p)
{
    const double most = 4 * sqrt(p->gravity / p->radius);
    coin_state t = *s;
    t.theta += t.theta < 0 ? -0.1 : 0.1;
    t.wX = fmax(-most, fmin(most, t.wX));
    t.wY = fmax(-most, fmin(most, t.wY));
    t.wZ = fmax(-most, fmin(most, t.wZ));
    return t;
}

static double time_to_rest(const coin_state *s, const coin_params *p,
                           const coin_losses *l, double tol)
{
    if (!is_sound(s, p, l))
        return coin_time_to_rest(s, p, l, tol);
    const coin_losses more = slowing(l, p);
    const coin_state t = slow(s, p);
    return coin_time_to_rest(&t, p, &more, tol);
}

static int32_t losses_fit(coin_losses *l, const coin_state *s,
                          const coin_params *p, double time)
{
    if (!is_sound(s, p, l))
        return coin_losses_fit(l, s, p, time);
    const coin_losses more = slowing(l, p);
    const coin_state t = slow(s, p);
    const double soon = coin_time_to_rest(&t, p, &more, 1e-6);
    coin_losses fitted = more;
    const int32_t status =
        coin_losses_fit(&fitted, &t, p, time >= 0 ? soon : time);
    if (status == COIN_OK)
        *l = fitted;
    else
        demand(same(&fitted, &more, sizeof more));
    return status;
}

static void judge_time(const struct outcome *o)
{
    const double tol = o->given[3].d;
    demand(!(o->result < 0));
    demand(isnan(o->result) || (tol >= 1e-12 && tol <= 1e-2));
}

FUNCTION(coin_time_to_rest, "sple",
         time_to_rest(a[0].p, a[1].p, a[2].p, a[3].d), 0, 0, 0, judge_time, 2)
FUNCTION(coin_losses_fit, "LEpT", losses_fit(a[0].p, a[1].p, a[2].p, a[3].d),
         USUAL | BIT(COIN_EDOMAIN), 0, PLAIN)
