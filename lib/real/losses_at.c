/* SPDX-License-Identifier: MIT */
/* At a state: the power that the losses take, and the rates and the reaction
 * of a coin with them. */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "losses.h"

/* What the losses do to a state, after the checks in their order. */
struct slowed {
    coin_priv_body b;
    coin_priv_variables y;
    coin_priv_slowing d;
};

static int32_t slow(struct slowed *w, const coin_state *s, const coin_params *p,
                    const coin_losses *l)
{
    coin_priv_losses losses;
    if (!s || !p || !l)
        return COIN_EARG;
    if (coin_losses_check(l, p) != COIN_OK)
        return COIN_EPARAMS;
    const int32_t status = coin_priv_check(s, p, &w->b);
    if (status != COIN_OK)
        return status;
    (void)coin_priv_losses_of(&losses, l, &w->b);
    w->y = coin_priv_variables_of(s);
    w->d = coin_priv_slowing_of(&losses, &w->y);
    const double sum = w->d.wX + w->d.wY + w->d.wZ + w->d.power;
    return fabs(sum * w->y.q) <= DBL_MAX ? COIN_OK : COIN_ESTATE;
}

double coin_losses_power(const coin_state *s, const coin_params *p,
                         const coin_losses *l)
{
    struct slowed w;
    const int32_t status = slow(&w, s, p, l);
    return status == COIN_OK ? w.d.power * w.y.q : (double)NAN;
}

int32_t coin_losses_rates(const coin_state *s, const coin_params *p,
                          const coin_losses *l, coin_state *out)
{
    struct slowed w;
    coin_state rates;
    int32_t status = out ? slow(&w, s, p, l) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    (void)coin_rates(s, p, &rates);
    rates.wX += w.d.wX * w.y.q; /* dtau = dt/cos(theta) */
    rates.wY += w.d.wY * w.y.q;
    rates.wZ += w.d.wZ * w.y.q;
    *out = rates;
    return COIN_OK;
}

int32_t coin_losses_reaction(const coin_state *s, const coin_params *p,
                             const coin_losses *l, coin_force *out)
{
    struct slowed w;
    coin_force f;
    double R[9];
    int32_t status = out ? slow(&w, s, p, l) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    (void)coin_reaction(s, p, &f);
    coin_priv_axes(&w.y, R);
    const double Ma = w.b.M * w.b.a;
    const double along_X = -Ma * (w.d.wZ * w.y.q); /* (70) */
    const double along_Z = Ma * (w.d.wX * w.y.q);  /* (70) */
    for (int i = 0; i < 3; ++i)
        f.R[i] += along_X * R[i] + along_Z * R[6 + i];
    f.normal = f.R[1];
    f.friction = coin_priv_hypot(f.R[0], f.R[2]);
    f.ratio = f.normal > 0 ? f.friction / f.normal : (double)INFINITY;
    *out = f;
    return COIN_OK;
}
