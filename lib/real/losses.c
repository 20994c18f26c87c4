/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "losses.h"

/* The softening rate that 0 stands for, in natural units, as coin.h says.  The
 * softening shifts the motion by its square.  For a disc that rests after 400
 * units of dry friction, this one shifts the time of rest by 8e-8 of it, half
 * by 2e-8 for 3 % more steps, twice by 3e-7 for 2 % fewer. */
#define SOFT K(1.0 / 1024)

int PRIV(lossless)(const COIN(losses) * l)
{
    return l->damping + l->dry + l->viscous + l->layer + l->gap + l->rolling +
               l->spin ==
           0;
}

int32_t PRIV(losses_of)(PRIV(losses) * out, const COIN(losses) * l,
                        const PRIV(body) * b)
{
    const real members[] = {l->damping, l->dry,     l->viscous, l->layer,
                            l->gap,     l->rolling, l->spin,    l->soft};
    const real least = b->IX < b->K ? b->IX : b->K;
    const real most =
        least < 1 ? COIN_PRIV_LOSS_MOST * least : COIN_PRIV_LOSS_MOST;
    for (size_t i = 0; i < sizeof members / sizeof *members; ++i)
        if (!(members[i] >= 0 && members[i] <= most))
            return COIN_EPARAMS;
    const real natural = SQRT(b->g_a);
    const real wanted = l->soft > 0 ? l->soft : SOFT * natural;
    const real faintest = COIN_PRIV_SOFT_LEAST * natural;
    const real soft = wanted > faintest ? wanted : faintest;
    const PRIV(losses) made = {
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

int32_t COIN(losses_check)(const COIN(losses) * l, const COIN(params) * p)
{
    PRIV(body) b;
    PRIV(losses) made;
    if (!l || !p)
        return COIN_EARG;
    if (PRIV(check_body)(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return PRIV(losses_of)(&made, l, &b);
}
