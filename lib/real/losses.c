/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "losses.h"

/* The largest member of coin_losses, also over a moment of inertia: far above
 * any coin's, and so far below overflow that a step's rates stay finite. */
#define LOSS_MOST 1e60

/* The least softening rate, in natural units.  Its square shifts the motion by
 * less than rounding, so that a smaller one would only cost steps. */
#define SOFT_LEAST (1.0 / 1073741824)

/* The softening rate that 0 stands for, in natural units. */
#define SOFT (1.0 / 1024)

int coin_priv_lossless(const coin_losses *l)
{
    return l->damping + l->dry + l->viscous + l->layer + l->gap + l->rolling +
               l->spin ==
           0;
}

int32_t coin_priv_losses_of(coin_priv_losses *out, const coin_losses *l,
                            const coin_priv_body *b)
{
    const double members[] = {l->damping, l->dry,     l->viscous, l->layer,
                              l->gap,     l->rolling, l->spin,    l->soft};
    const double least = b->IX < b->K ? b->IX : b->K;
    const double most = least < 1 ? LOSS_MOST * least : LOSS_MOST;
    for (size_t i = 0; i < sizeof members / sizeof *members; ++i)
        if (!(members[i] >= 0 && members[i] <= most))
            return COIN_EPARAMS;
    const double natural = sqrt(b->g_a);
    const double wanted = l->soft > 0 ? l->soft : SOFT * natural;
    const double soft =
        wanted > SOFT_LEAST * natural ? wanted : SOFT_LEAST * natural;
    const coin_priv_losses made = {
        l->damping,
        l->dry,
        l->viscous,
        l->layer,
        l->gap,
        l->rolling,
        l->spin,
        soft * soft,
        b->IX,
        b->J,
        b->K,
        l->dry + l->rolling,
        l->viscous + l->layer + l->gap,
    };
    *out = made;
    return COIN_OK;
}

int32_t coin_losses_check(const coin_losses *l, const coin_params *p)
{
    coin_priv_body b;
    coin_priv_losses made;
    if (!l || !p)
        return COIN_EARG;
    if (coin_priv_check_body(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_losses_of(&made, l, &b);
}

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
    w->d = coin_priv_slow(&losses, &w->y);
    const double sum = w->d.wX + w->d.wY + w->d.wZ + w->d.power;
    return (sum - sum) * w->y.q == 0 ? COIN_OK : COIN_ESTATE;
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
