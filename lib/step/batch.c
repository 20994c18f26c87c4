/* SPDX-License-Identifier: MIT */
#include "lanes.h"

int32_t coin_batch_run(coin_state *s, size_t count, const coin_params *p,
                       int32_t method, double dt, uint64_t steps,
                       int32_t *status)
{
    coin_priv_constants b;
    coin_priv_batch r = {s, count, status, COIN_OK, COIN_OK};
    if ((!s && count > 0) || !p || !coin_priv_method_is_known(method))
        return COIN_EARG;
    if (coin_priv_check_params(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    /* Coins that do not move stay as they are, each to the bit. */
    const int move =
        count > 0 && steps > 0 && coin_priv_time_in_range(dt, &b) && dt != 0;
    if (!move || !coin_priv_run_abreast(&r, &b, method, dt, steps))
        for (size_t i = 0; i < count; ++i)
            coin_priv_note(&r, i, coin_run(&s[i], p, method, dt, steps, NULL));
    return r.error != COIN_OK ? r.error : r.warnings;
}
