/* SPDX-License-Identifier: MIT */
#include "batch.h"

#include "lanes.h"

/* A group of coins side by side.  Lanes that are left over hold copies of its
 * first coin. */
struct group {
    coin_state *where[COIN_PRIV_LANES], spare[COIN_PRIV_LANES];
    int size;
};

static void gather(struct group *g, coin_state *s, size_t left)
{
    g->size = left < COIN_PRIV_LANES ? (int)left : COIN_PRIV_LANES;
    for (int k = 0; k < g->size; ++k)
        g->where[k] = &s[k];
    for (int k = g->size; k < COIN_PRIV_LANES; ++k) {
        g->spare[k] = *s;
        g->where[k] = &g->spare[k];
    }
}

/* Fewer coins than this go one by one, which takes less time. */
enum { ENOUGH = (COIN_PRIV_LANES + 2) / 4 + 1 };

static void run_group(const struct group *g, coin_priv_lanes_run *run,
                      const coin_params *p, const coin_priv_body *b,
                      int32_t method, double dt, uint64_t steps, int32_t *code)
{
    if (!run || g->size < ENOUGH) {
        for (int k = 0; k < g->size; ++k)
            code[k] = coin_run(g->where[k], p, method, dt, steps, NULL);
        return;
    }
    run(g->where, code, p, b, dt, steps);
}

int32_t coin_batch_run(coin_state *s, size_t count, const coin_params *p,
                       int32_t method, double dt, uint64_t steps,
                       int32_t *status)
{
    coin_priv_body b;
    coin_priv_batch_result r = {0, COIN_OK, COIN_OK};
    struct group g;
    int32_t code[COIN_PRIV_LANES];
    if (!s || !p || !coin_priv_method_is_known(method))
        return COIN_EARG;
    if (coin_priv_check_body(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    /* Coins that do not move stay as they are, each to the bit. */
    const int move =
        count > 0 && steps > 0 && coin_priv_is_finite(dt) && dt != 0;
    coin_priv_lanes_run *const run =
        move ? coin_priv_lanes_run_of(method) : NULL;
    for (size_t i = 0; i < count; i += COIN_PRIV_LANES) {
        gather(&g, &s[i], count - i);
        run_group(&g, run, p, &b, method, dt, steps, code);
        for (int k = 0; k < g.size; ++k)
            coin_priv_note(&r, status, i + (size_t)k, code[k]);
    }
    return r.error != COIN_OK ? r.error : r.warnings;
}
