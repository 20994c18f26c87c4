/* SPDX-License-Identifier: MIT */
#include "batch_float.h"

/* Coins collected to be stepped side by side, and what they share. */
struct group {
    coinf_priv_plan plan;
    coinf_priv_group_run *run; /* null if each goes alone */
    size_t index[COINF_PRIV_LANES];
    int size;
};

/* Moves the coins of a group, and empties it. */
static void run_group(struct group *r, coinf_state *s, uint64_t steps,
                      int32_t *status, coinf_priv_batch_result *o)
{
    coinf_state *coin[COINF_PRIV_LANES];
    int32_t code[COINF_PRIV_LANES];
    for (int k = 0; k < r->size; ++k)
        coin[k] = &s[r->index[k]];
    r->run(coin, code, r->size, &r->plan, steps);
    for (int k = 0; k < r->size; ++k)
        coinf_priv_note(o, status, r->index[k], code[k]);
    r->size = 0;
}

int32_t coinf_batch_run(coinf_state *s, size_t count, const coinf_params *p,
                        int32_t method, float dt, uint64_t steps,
                        int32_t *status)
{
    const coinf_state rest = {0, 0, 0, 0, 0, 0, 0, 0, {0, 0, 0, 0, 0, 0, 0, 0}};
    struct group r;
    coinf_priv_body b;
    coinf_priv_batch_result o = {0, COIN_OK, COIN_OK};
    /* r.plan does not depend on a state: any valid one will do here. */
    if (!s || !p || !coinf_priv_method_is_known(method))
        return COIN_EARG;
    const float h = count == 0 ? 0 : steps == 0 ? 0 * dt : dt;
    const int32_t shared = coinf_priv_plan_of(&r.plan, &rest, p, method, h);
    if (shared != COIN_OK && shared != COIN_ESTEP)
        return shared;
    coinf_priv_check_body(&b, p);
    r.size = 0;
    r.run =
        shared == COIN_OK && dt != 0 ? coinf_priv_group_run_of(method) : NULL;
    for (size_t i = 0; i < count; ++i) {
        const int32_t code = r.run
                                 ? coinf_priv_check_state(&s[i], &b)
                                 : coinf_run(&s[i], p, method, dt, steps, NULL);
        if (r.run && code == COIN_OK)
            r.index[r.size++] = i;
        else
            coinf_priv_note(&o, status, i, code);
        if (r.size == COINF_PRIV_LANES)
            run_group(&r, s, steps, status, &o);
    }
    if (r.size > 0)
        run_group(&r, s, steps, status, &o);
    return o.error != COIN_OK ? o.error : o.warnings;
}
