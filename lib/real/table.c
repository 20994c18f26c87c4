/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* The largest size of a pull, in g. */
#define PULL_MOST 100

/* Sets what a thickness and a pull change; per: 1/g. */
static void add_thickness(coin_priv_law *l, double half, const double pull[2],
                          double per)
{
    l->contact = coin_priv_thick_contact;
    l->half = half;
    l->pull[0] = pull[0] * per;
    l->pull[1] = pull[1] * per;
    l->J[0] += half * half;
    l->perJ[0] = 1 / l->J[0];
    l->perK[0] = 1 / (l->K[0] + half * half * (l->IZ / l->IX));
}

int32_t coin_priv_table_law(coin_priv_law *out, const coin_table *table,
                            const coin_priv_constants *b, double half)
{
    const double mu = table->mu_kinetic, e = table->restitution;

    if (coin_priv_law_of(out, &table->losses, b) != COIN_OK)
        return COIN_EPARAMS;
    out->plain = half == 0 && table->pull[0] == 0 && table->pull[1] == 0;
    if (!out->plain)
        add_thickness(out, half, table->pull, b->M / b->Mg);
    const double k = half == 0 ? out->IX : out->IX / (1 + half * half);
    const double bound = 2 * sqrt(k * (1 + k)); /* (86) */
    /* damping is defined for a coin that is held to the table */
    const int good = mu >= 0 && mu <= table->mu_static && mu < bound &&
                     e >= 0 && e <= 1 && out->damping == 0 &&
                     coin_priv_pull(out) <= PULL_MOST &&
                     coin_priv_are_zero(table->reserved, 3);
    out->mu_static = table->mu_static;
    out->mu_kinetic = mu;
    out->restitution = e;
    out->keeps_rolling = 0;
    return good ? COIN_OK : COIN_EPARAMS;
}

int32_t coin_table_check(const coin_table *table, const coin_params *p)
{
    coin_priv_constants b;
    coin_priv_law law;
    if (!table || !p)
        return COIN_EARG;
    if (coin_priv_check_thick(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_table_law(&law, table, &b, coin_priv_half_of(p));
}
