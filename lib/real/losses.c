/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* What 0 stands for in `soft`, in natural units, and in `flat`, as coin.h says.
 * The softening shifts the motion by its square: it shifts the time of rest of
 * a disc with dry friction after 400 units by 8e-8 of it. */
#define SOFT (1.0 / 1024)
#define FLAT 1e-6

/* The ranges of a coefficient in natural units, and of `flat`, if not 0. */
#define LEAST 1e-12
#define MOST 1e3
#define FLAT_MOST 1e-2

/* Whether x is 0 or in a range. */
static int is_within(double x, double least, double most)
{
    return x == 0 || (x >= least && x <= most);
}

int32_t coin_priv_law_of(coin_priv_law *out, const coin_losses *l,
                         const coin_priv_body *b)
{
    const double w0 = sqrt(b->g_a), force = b->Mga, per = w0 / force;
    const double IX = b->IX / b->m, IZ = b->IZ / b->m;
    const coin_priv_law made = {
        IX,
        IZ,
        {IX + 1, IX},
        {IZ + 1, IZ},
        {1 / (IX + 1), 1 / IX},
        {1 / (IZ + 1), 1 / IZ},
        l->damping,
        l->dry / force,
        l->viscous * per,
        l->layer * per * sqrt(w0),
        l->gap * per,
        l->rolling / force,
        l->spin * per,
        l->angular / w0,
        l->soft > 0 ? l->soft / w0 : SOFT,
        l->flat > 0 ? l->flat : FLAT,
        (double)INFINITY,
        0,
        l->damping + l->dry + l->viscous + l->layer + l->gap + l->rolling +
                l->spin + l->angular !=
            0,
        1,
    };
    const double terms[] = {made.damping, made.dry,     made.viscous,
                            made.layer,   made.gap,     made.rolling,
                            made.spin,    made.angular, made.soft};
    int good = (l->soft >= 0) & is_within(l->flat, LEAST, FLAT_MOST) &
               (l->reserved[0] == 0) & (l->reserved[1] == 0);
    for (size_t i = 0; i < sizeof terms / sizeof *terms; ++i)
        good &= is_within(terms[i], LEAST, MOST);
    *out = made;
    return good ? COIN_OK : COIN_EPARAMS;
}

int32_t coin_losses_check(const coin_losses *l, const coin_params *p)
{
    coin_priv_body b;
    coin_priv_law law;
    if (!l || !p)
        return COIN_EARG;
    if (coin_priv_check_body(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_law_of(&law, l, &b);
}
