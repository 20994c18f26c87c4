/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* What 0 stands for in `soft`, in natural units, and in `flat`, as coin.h says.
 * The softening shifts the motion by its square: it shifts the time of rest of
 * a disc with dry friction after 400 units by 8e-8 of it. */
#define SOFT (1.0 / 1024)
#define FLAT 1e-6

/* The ranges of a coefficient in natural units, of dry and rolling, and of
 * `flat`, if not 0. */
#define LEAST 1e-12
#define MOST 1e3
#define SOLID_MOST 1
#define FLAT_MOST 1e-2

/* Whether x is 0 or in a range. */
static int is_within(double x, double least, double most)
{
    return x == 0 || (x >= least && x <= most);
}

/* Whether a coefficient in natural units is in its range. */
static int holds(double x)
{
    return is_within(x, LEAST, MOST);
}

int32_t coin_priv_law_of(coin_priv_law *out, const coin_losses *l,
                         const coin_priv_constants *b)
{
    const double w0 = sqrt(b->g_a), force = b->Mga, per = w0 / force;
    const double IX = b->IX / b->m, IZ = b->IZ / b->m;
    out->half = out->eta = out->pull[0] = out->pull[1] = 0;
    out->plain = 1;
    out->contact = coin_priv_plain_contact;
    out->IX = out->J[1] = IX;
    out->IZ = out->K[1] = IZ;
    out->J[0] = IX + 1;
    out->K[0] = IZ + 1;
    for (int i = 0; i < 2; ++i) {
        out->perJ[i] = 1 / out->J[i];
        out->perK[i] = 1 / out->K[i];
    }
    out->damping = l->damping;
    out->dry = l->dry / force;
    out->viscous = l->viscous * per;
    out->layer = l->layer * per * sqrt(w0);
    out->gap = l->gap * per;
    out->rolling = l->rolling / force;
    out->spin = l->spin * per;
    out->angular = l->angular / w0;
    out->soft = l->soft > 0 ? l->soft / w0 : SOFT;
    out->flat = l->flat > 0 ? l->flat : FLAT;
    out->mu_static = (double)INFINITY;
    out->mu_kinetic = out->restitution = 0;
    out->lossy = l->damping + l->dry + l->viscous + l->layer + l->gap +
                     l->rolling + l->spin + l->angular !=
                 0;
    out->keeps_rolling = 1;
    const int good =
        holds(out->damping) && is_within(out->dry, LEAST, SOLID_MOST) &&
        is_within(out->rolling, LEAST, SOLID_MOST) && holds(out->viscous) &&
        holds(out->layer) && holds(out->gap) && holds(out->spin) &&
        holds(out->angular) && out->soft >= LEAST && out->soft <= MOST &&
        l->soft >= 0 && is_within(l->flat, LEAST, FLAT_MOST) &&
        coin_priv_are_zero(l->reserved, 2);
    return good ? COIN_OK : COIN_EPARAMS;
}

int32_t coin_losses_check(const coin_losses *l, const coin_params *p)
{
    coin_priv_constants b;
    coin_priv_law law;
    if (!l || !p)
        return COIN_EARG;
    if (coin_priv_check_thick(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_law_of(&law, l, &b);
}
