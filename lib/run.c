/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "number.h"
#include "run.h"
#include "state.h"

#include <math.h>

int32_t coin_priv_run_open(coin_priv_run *r, const coin_state *s,
                           const coin_params *p, int32_t method, double dt)
{
    const int32_t status = coin_priv_method_known(method)
                               ? coin_priv_check(s, p, &r->b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(dt - dt == 0))
        return COIN_ESTEP;
    r->start = *s;
    coin_priv_carry_begin(&r->c, s);
    r->limits = coin_priv_limits_of(&r->b, method, dt);
    r->dt = dt;
    return COIN_OK;
}

uint64_t coin_priv_run_on(coin_priv_run *r, uint64_t n)
{
    if (r->dt == 0)
        return n;
    const uint64_t before = r->c.steps;
    r->step(&r->c, &r->b, &r->limits, r->dt, n);
    return r->c.steps - before;
}

coin_state coin_priv_run_state(const coin_priv_run *r)
{
    return coin_priv_state_of(&r->c, &r->b, &r->start);
}

int32_t coin_priv_run_close(const coin_priv_run *r, uint64_t steps,
                            coin_state *s, uint64_t *done)
{
    const coin_state end = coin_priv_run_state(r);
    uint64_t n = r->dt == 0 ? steps : r->c.steps;
    if (coin_priv_check_members(&end) == COIN_OK)
        coin_priv_copy(s, &end, sizeof end);
    else
        n = 0; /* a path so long that x or z overflowed */
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : r->limits.warnings;
}

int32_t coin_run(coin_state *s, const coin_params *p, int32_t method, double dt,
                 uint64_t steps, uint64_t *done)
{
    coin_priv_run r;
    const int32_t status = coin_priv_run_open(&r, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    r.step = coin_priv_method_stepper(method);
    coin_priv_run_on(&r, steps);
    return coin_priv_run_close(&r, steps, s, done);
}

int32_t coin_sample(const coin_state *start, const coin_params *p,
                    int32_t method, double dt, uint64_t steps_per_sample,
                    size_t count, coin_state *out, size_t *done)
{
    coin_priv_run r;
    const uint64_t n = steps_per_sample;
    const int32_t status =
        out ? coin_priv_run_open(&r, start, p, method, dt) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    r.step = coin_priv_method_stepper(method);
    size_t k = 0;
    for (; k < count && (k == 0 || coin_priv_run_on(&r, n) == n); ++k) {
        const coin_state sample = coin_priv_run_state(&r);
        if (coin_priv_check_members(&sample) != COIN_OK)
            break;
        coin_priv_copy(&out[k], &sample, sizeof sample);
    }
    if (done)
        *done = k;
    return k < count ? COIN_ESTEP : r.limits.warnings;
}

int32_t coin_lean_run(coin_lean *l, const coin_params *p, int32_t method,
                      double dt, uint64_t steps, uint64_t *done)
{
    coin_priv_run r;
    if (!l || (method != COIN_RK4 && method != COIN_RK8))
        return COIN_EARG;
    const coin_state s = {l->theta, 0, 0, 0, 0, l->wX, l->wY, l->wZ};
    const int32_t status = coin_priv_run_open(&r, &s, p, method, dt);
    if (status != COIN_OK)
        return status;
    r.step = method == COIN_RK4 ? coin_priv_rk4_lean : coin_priv_rk8_lean;
    const uint64_t n = coin_priv_run_on(&r, steps);
    const coin_state end = coin_priv_run_state(&r);
    l->theta = end.theta;
    l->wX = end.wX;
    l->wY = end.wY;
    l->wZ = end.wZ;
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : r.limits.warnings;
}
