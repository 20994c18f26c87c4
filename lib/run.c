/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "lesser.h"
#include "method.h"
#include "state.h"
#include "stepper.h"

#include <math.h>

/* A run under way. */
struct run {
    coin_state start;
    coin_priv_body b;
    coin_priv_carry c;
    coin_priv_limits limits;
    coin_priv_stepper *step;
    double dt;
};

/* Checks everything, then computes what the steps share. */
static int32_t open_run(struct run *r, const coin_state *s,
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
    r->c = coin_priv_carry_of(s);
    const double most = coin_priv_method_most(method) / dt;
    const double coarse = coin_priv_method_coarse(method) / dt;
    r->limits.most2 = coin_priv_lesser(most * most, r->b.w2_max);
    r->limits.coarse2 = coin_priv_lesser(coarse * coarse, r->limits.most2);
    r->limits.warnings = COIN_OK;
    r->dt = dt;
    return COIN_OK;
}

/* Up to n steps; returns how many were done. */
static uint64_t advance(struct run *r, uint64_t n)
{
    if (r->dt == 0)
        return n;
    const uint64_t before = r->c.steps;
    r->step(&r->c, &r->b, &r->limits, r->dt, n);
    return r->c.steps - before;
}

static coin_state state_of(const struct run *r)
{
    return coin_priv_state_of(&r->c, &r->b, &r->start);
}

/* So many steps of an opened run, to *s. */
static int32_t run_to(coin_state *s, struct run *r, uint64_t steps,
                      uint64_t *done)
{
    uint64_t n = advance(r, steps);
    const coin_state end = state_of(r);
    if (coin_priv_check_members(&end) == COIN_OK)
        *s = end;
    else
        n = 0; /* a path so long that x or z overflowed */
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : r->limits.warnings;
}

int32_t coin_run(coin_state *s, const coin_params *p, int32_t method, double dt,
                 uint64_t steps, uint64_t *done)
{
    struct run r;
    const int32_t status = open_run(&r, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    r.step = coin_priv_method_stepper(method);
    return run_to(s, &r, steps, done);
}

/* Names its stepper: a program that calls no coin_run() links no other. */
int32_t coin_step(coin_state *s, const coin_params *p, double dt)
{
    struct run r;
    const int32_t status = open_run(&r, s, p, COIN_RK4, dt);
    if (status != COIN_OK)
        return status;
    r.step = coin_priv_rk4;
    return run_to(s, &r, 1, NULL);
}

int32_t coin_sample(const coin_state *start, const coin_params *p,
                    int32_t method, double dt, uint64_t steps_per_sample,
                    size_t count, coin_state *out, size_t *done)
{
    struct run r;
    const uint64_t n = steps_per_sample;
    const int32_t status = out ? open_run(&r, start, p, method, dt) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    r.step = coin_priv_method_stepper(method);
    size_t k = 0;
    for (; k < count && (k == 0 || advance(&r, n) == n); ++k) {
        const coin_state sample = state_of(&r);
        if (coin_priv_check_members(&sample) != COIN_OK)
            break;
        out[k] = sample;
    }
    if (done)
        *done = k;
    return k < count ? COIN_ESTEP : r.limits.warnings;
}

int32_t coin_lean_run(coin_lean *l, const coin_params *p, int32_t method,
                      double dt, uint64_t steps, uint64_t *done)
{
    struct run r;
    if (!l || (method != COIN_RK4 && method != COIN_RK8))
        return COIN_EARG;
    const coin_state s = {l->theta, 0, 0, 0, 0, l->wX, l->wY, l->wZ};
    const int32_t status = open_run(&r, &s, p, method, dt);
    if (status != COIN_OK)
        return status;
    r.step = method == COIN_RK4 ? coin_priv_rk4_lean : coin_priv_rk8_lean;
    const uint64_t n = advance(&r, steps);
    const coin_state end = state_of(&r);
    l->theta = end.theta;
    l->wX = end.wX;
    l->wY = end.wY;
    l->wZ = end.wZ;
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : r.limits.warnings;
}
