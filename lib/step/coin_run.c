/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "coin_run.h"

/* Checks everything, then computes what the steps share. */
static int32_t begin(coin_priv_run *r, const coin_state *s,
                     const coin_params *p, int32_t method, double dt)
{
    if (!coin_priv_method_is_known(method))
        return COIN_EARG;
    const int32_t status = coin_priv_check(s, p, &r->b);
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_in_range(dt, &r->b))
        return COIN_ESTEP;
    coin_priv_run_from(r, s, method, dt);
    return COIN_OK;
}

int32_t coin_priv_run_to_end(coin_priv_run *r, int32_t method, uint64_t steps,
                             coin_state *s, uint64_t *done)
{
    const uint64_t before = r->steps;
    uint64_t n = before + coin_priv_run_on(r, method, steps - before);
    const coin_state end = coin_priv_run_state(r);
    const int lost = !coin_priv_state_in_range(&end, &r->b);
    if (!lost)
        coin_priv_copy_state(s, &end);
    else
        n = 0;
    if (done)
        *done = n;
    if (lost)
        return COIN_ERANGE;
    return n < steps ? coin_priv_refusal(s, r->b.a) : coin_priv_warnings(r);
}

int32_t coin_run(coin_state *s, const coin_params *p, int32_t method, double dt,
                 uint64_t steps, uint64_t *done)
{
    coin_priv_run r;
    const int32_t status = begin(&r, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    return coin_priv_run_to_end(&r, method, steps, s, done);
}

int32_t coin_sample(const coin_state *start, const coin_params *p,
                    int32_t method, double dt, uint64_t steps_per_sample,
                    size_t count, coin_state *out, size_t *done)
{
    coin_priv_run r;
    const uint64_t n = steps_per_sample;
    const int32_t status =
        out || count == 0 ? begin(&r, start, p, method, dt) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    size_t k = 0;
    int32_t refused = COIN_OK;
    while (k < count && refused == COIN_OK) {
        const uint64_t made = k > 0 ? coin_priv_run_on(&r, method, n) : n;
        const coin_state sample = coin_priv_run_state(&r);
        if (!coin_priv_state_in_range(&sample, &r.b))
            refused = COIN_ERANGE;
        else if (made < n)
            refused = coin_priv_refusal(&sample, r.b.a);
        else
            coin_priv_copy_state(&out[k++], &sample);
    }
    if (done)
        *done = k;
    return refused != COIN_OK ? refused : coin_priv_warnings(&r);
}
