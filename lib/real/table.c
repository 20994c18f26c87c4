/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

int32_t coin_priv_table_law(coin_priv_law *out, const coin_table *table,
                            const coin_priv_body *b)
{
    const double mu = table->mu_kinetic, e = table->restitution;
    if (coin_priv_law_of(out, &table->losses, b) != COIN_OK)
        return COIN_EPARAMS;
    const double bound = 2 * sqrt(out->IX * (1 + out->IX)); /* (86) */
    /* damping is defined for a coin that rolls only */
    const int rolls = out->damping == 0 || table->mu_static > DBL_MAX;
    const int good = mu >= 0 && mu <= table->mu_static && mu < bound &&
                     e >= 0 && e <= 1 && rolls &&
                     coin_priv_are_zero(table->reserved, 5);
    out->mu_static = table->mu_static;
    out->mu_kinetic = mu;
    out->keeps_rolling = 0;
    return good ? COIN_OK : COIN_EPARAMS;
}

int32_t coin_table_check(const coin_table *table, const coin_params *p)
{
    coin_priv_body b;
    coin_priv_law law;
    if (!table || !p)
        return COIN_EARG;
    if (coin_priv_check_body(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_table_law(&law, table, &b);
}
