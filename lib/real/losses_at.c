/* SPDX-License-Identifier: MIT */
/* At a state of a coin that rolls: the power that the losses take, and the
 * rates and the reaction of a coin with them. */
#include "../motion/pinned.h"

#include "../motion/equations.h"

#include "law.h"

/* What the losses do to a state: what they add to d/dt of the rates, in natural
 * units, and the power. */
struct slowed {
    coin_priv_constants b;
    coin_priv_variables y;
    double dwX, dwY, dwZ, power;
};

/* The power of (69) by t, in natural units. */
static double power_of(const coin_priv_law *l, const double *y)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double wZ = y[COIN_PRIV_WZ], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double u = coin_priv_roll_speed(y), about = wY * c - wZ * s;
    const double IX = l->IX, IZ = l->IZ;
    const double all = l->J[0] * wX * wX + IX * wY * wY + l->K[0] * wZ * wZ;
    const double own = IX * (wX * wX + wY * wY) + IZ * wZ * wZ;
    return u * u * coin_priv_grip(l, u, c) / c +
           l->damping * fabs(u) * all / c + l->spin * about * about +
           l->angular * own; /* (69) */
}

static int32_t slow(struct slowed *w, const coin_state *s, const coin_params *p,
                    const coin_losses *l)
{
    coin_priv_law law;
    if (!s || !p || !l)
        return COIN_EARG;
    if (coin_priv_check_params(&w->b, p) != COIN_OK ||
        coin_priv_law_of(&law, l, &w->b) != COIN_OK)
        return COIN_EPARAMS;
    const int32_t status = coin_priv_check(s, p, &w->b);
    if (status != COIN_OK)
        return status;
    const coin_priv_variables v = w->y = coin_priv_variables_of(s);
    const double per = 1 / sqrt(w->b.g_a);
    const double y[COIN_PRIV_SIZE] = {
        per * v.wX, per * v.wY, per * v.wZ, v.sth, v.cth, 0, 0, v.sph, v.cph,
    };
    const coin_priv_slowing d = coin_priv_slowing_of(&law, y, 0);
    w->dwX = d.wX * v.q; /* dtau = dt/cos(theta) */
    w->dwY = d.wY * v.q;
    w->dwZ = d.wZ * v.q;
    w->power = power_of(&law, y);
    return COIN_OK;
}

double coin_losses_power(const coin_state *s, const coin_params *p,
                         const coin_losses *l)
{
    struct slowed w;
    const int32_t status = slow(&w, s, p, l);
    return status == COIN_OK ? w.b.Mga * sqrt(w.b.g_a) * w.power : (double)NAN;
}

int32_t coin_losses_rates(const coin_state *s, const coin_params *p,
                          const coin_losses *l, coin_state *out)
{
    struct slowed w;
    coin_state rates;
    const int32_t status = out ? slow(&w, s, p, l) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    (void)coin_rates(s, p, &rates);
    rates.wX += w.b.g_a * w.dwX;
    rates.wY += w.b.g_a * w.dwY;
    rates.wZ += w.b.g_a * w.dwZ;
    *out = rates;
    return COIN_OK;
}

int32_t coin_losses_reaction(const coin_state *s, const coin_params *p,
                             const coin_losses *l, coin_force *out)
{
    struct slowed w;
    coin_force f;
    double R[9];
    const int32_t status = out ? slow(&w, s, p, l) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    (void)coin_reaction(s, p, &f);
    coin_priv_axes(&w.y, R);
    for (int i = 0; i < 3; ++i)
        f.R[i] += w.b.Mg * (w.dwX * R[6 + i] - w.dwZ * R[i]); /* (70) */
    f.normal = f.R[1];
    f.friction = coin_priv_hypot(f.R[0], f.R[2]);
    f.ratio = f.normal > 0 ? f.friction / f.normal : (double)INFINITY;
    *out = f;
    return COIN_OK;
}
