/* SPDX-License-Identifier: MIT */
#include "step.h"

#include "../motion/legendre.h"

/* Kick, drift, kick as in lib/step/symplectic.c, computed as changes. */

/* Rates along a drift times h, and their own rates times h^2; x, z are in
 * radii. */
struct rates {
    float phi, psi, x, z, dphi, dpsi, dx, dz;
};

static struct rates rates_of(const coinf_priv_field *f,
                             const coinf_priv_variables *y)
{
    const coinf_priv_pose v = coinf_priv_pose_slopes(f, y);
    const float hwX = f->h * y->wX, hwY = f->h * y->wY, tth = y->tth;
    const float slope_wY = hwY * tth + f->k1 * y->wZ; /* (15) */
    struct rates r = {v.phi, v.psi, v.x, v.z, 0, 0, 0, 0};
    r.dphi = hwX * y->q * (slope_wY + hwY * tth);
    r.dpsi = hwX * (f->k2 * y->wY + slope_wY * tth + hwY * (1 + tth * tth));
    const float along = f->h * y->wZ * v.phi - y->sth * (hwX * hwX);
    const float across = hwX * (hwY - f->k2 * y->wY);
    r.dx = along * y->sph + across * y->cph;
    r.dz = along * y->cph - across * y->sph;
    return r;
}

/* What a step adds, from rates and their rates at both ends: Hermite's rule. */
static float hermite(float f0, float f1, float df0, float df1)
{
    return (f0 + f1) / 2 + (df0 - df1) / 12;
}

static void half_kick(coinf_state *s, const coinf_priv_plan *plan,
                      coinf_priv_variables *y)
{
    const float hdwX =
        coinf_priv_slopes_at(&plan->f, y).wX + coinf_priv_fall_low(plan, y);
    coinf_priv_add_parts(&s->wX, &s->low[5], hdwX / 2, 0); /* (50) */
    y->wX = s->wX;
}

/* Moves wY, wZ and the pair of theta in *y by a turn of the lean, which
 * s->theta already contains.  Returns 0 if the turn is beyond the reach of the
 * series.  What the turn adds to the pair is computed directly, as a difference
 * of sines would cancel.  coinf_priv_turn_adds() needs |turn| <= pi/2: with
 * |dt| W <= 1, Eq. (14) keeps it below 1.2. */
static int shift(coinf_state *s, const coinf_priv_plan *plan,
                 coinf_priv_variables *y, float turn)
{
    const coinf_priv_sc lean = {y->sth, y->cth};
    const coinf_priv_sc by = coinf_priv_turn_adds(lean, turn);
    const coinf_priv_sc th =
        coinf_priv_sine_cosine_with_low(s->theta, s->low[0]);
    const float c2 = y->cth * y->cth;
    float dp, dwZ;
    if (!(fabsf(by.s) * (1 + fabsf(y->sth)) <= COIN_PRIV_SERIES_REACH * c2))
        return 0;
    coinf_priv_legendre_change(&dp, &dwZ, y->wY * y->cth, y->wZ, plan->k1,
                               plan->k2, y->sth, c2, by.s); /* (49) */
    coinf_priv_add_parts(&s->wY, &s->low[6], (dp - y->wY * by.c) / th.c, 0);
    coinf_priv_add_parts(&s->wZ, &s->low[7], dwZ, 0);
    y->wY = s->wY;
    y->wZ = s->wZ;
    y->sth = th.s;
    y->cth = th.c;
    y->q = 1 / th.c;
    y->tth = th.s / th.c;
    return 1;
}

/* The drift of a step: theta first, then the rates, then the rest of the pose
 * by the rates at both ends. */
static int drift(coinf_state *s, const coinf_priv_plan *plan,
                 coinf_priv_variables *y)
{
    const coinf_priv_variables y0 = *y;
    const struct rates r0 = rates_of(&plan->f, &y0);
    const float turn = plan->f.h * y->wX; /* (17) */
    coinf_priv_add_parts(&s->theta, &s->low[0], turn, 0);
    if (!shift(s, plan, y, turn))
        return 0;
    struct rates r1 = rates_of(&plan->f, y);
    coinf_priv_add_parts(&s->phi, &s->low[1],
                         hermite(r0.phi, r1.phi, r0.dphi, r1.dphi), 0);
    coinf_priv_add_parts(&s->psi, &s->low[2],
                         hermite(r0.psi, r1.psi, r0.dpsi, r1.dpsi), 0);
    const coinf_priv_sc ph = coinf_priv_sine_cosine_with_low(s->phi, s->low[1]);
    y->sph = ph.s;
    y->cph = ph.c;
    r1 = rates_of(&plan->f, y);
    coinf_priv_add_parts(&s->x, &s->low[3],
                         plan->a * hermite(r0.x, r1.x, r0.dx, r1.dx), 0);
    coinf_priv_add_parts(&s->z, &s->low[4],
                         plan->a * hermite(r0.z, r1.z, r0.dz, r1.dz), 0);
    return 1;
}

int coinf_priv_step_symplectic2(coinf_state *s, int32_t *warnings,
                                const coinf_priv_plan *plan,
                                const coinf_priv_variables *y0)
{
    coinf_state next = *s;
    coinf_priv_variables y = *y0;
    half_kick(&next, plan, &y);
    if (!drift(&next, plan, &y))
        return 0;
    half_kick(&next, plan, &y);
    return coinf_priv_admit_rate(warnings, plan, &y) &&
           coinf_priv_finish_step(s, &next, plan);
}
