/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "run.h"
#include "state.h"

/* What to add to KJ so that it is K/(M g a) = (a + I_Z/(M a))/g times GJ.  The
 * two hold each other in balance in a steady motion: an error of their ratio
 * turns the heading steadily, an error of both does not. */
static float balance(const coinf_priv_field *f, const coinf_priv_body *b,
                     float g)
{
    const float sum = b->a + b->IZ / (b->M * b->a), ratio = sum / g;
    const float ratio_low =
        ((sum - ratio * g) - coinf_priv_residue(ratio, g)) / g;
    return (f->GJ * ratio - f->KJ) +
           (coinf_priv_residue(f->GJ, ratio) + f->GJ * ratio_low);
}

int32_t coinf_priv_prepare(coinf_priv_plan *plan, const coinf_state *s,
                           const coinf_params *p, int32_t method, float dt)
{
    coinf_priv_body b;
    const int32_t status = coinf_priv_method_known(method)
                               ? coinf_priv_check(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(dt - dt == 0))
        return COIN_ESTEP;
    const float most = coinf_priv_method_most(method) / dt;
    const float coarse = coinf_priv_method_coarse(method) / dt;
    plan->f = coinf_priv_field_of(&b, dt);
    plan->a = b.a;
    plan->g_a = b.g_a;
    plan->k1 = b.k1;
    plan->k2 = b.k2;
    plan->most2 = coinf_priv_lesser(most * most, b.w2_max);
    plan->coarse2 = coinf_priv_lesser(coarse * coarse, plan->most2);
    plan->warnings = COIN_OK;
    plan->KJ_low = balance(&plan->f, &b, p->gravity);
    return COIN_OK;
}

/* One step; 0 if it would not be sound. */
static inline int step(coinf_state *s, coinf_priv_plan *plan,
                       coinf_priv_stepper *method)
{
    coinf_priv_stage y;
    coinf_priv_stage_at(&y, s);
    return coinf_priv_within(plan, &y) && method(s, plan, &y);
}

int32_t coinf_run(coinf_state *s, const coinf_params *p, int32_t method,
                  float dt, uint64_t steps, uint64_t *done)
{
    coinf_priv_plan plan;
    const int32_t status = coinf_priv_prepare(&plan, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    coinf_priv_stepper *const stepper =
        method == COIN_RK4 ? coinf_priv_rk4 : coinf_priv_symplectic2;
    uint64_t n = dt == 0 ? steps : 0;
    while (n < steps && step(s, &plan, stepper))
        ++n;
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : plan.warnings;
}

int32_t coinf_step(coinf_state *s, const coinf_params *p, float dt)
{
    coinf_priv_plan plan;
    const int32_t status = coinf_priv_prepare(&plan, s, p, COIN_RK4, dt);
    if (status != COIN_OK || dt == 0)
        return status;
    return step(s, &plan, coinf_priv_rk4) ? plan.warnings : COIN_ESTEP;
}

int32_t coinf_lean_run(coinf_lean *l, const coinf_params *p, int32_t method,
                       float dt, uint64_t steps, uint64_t *done)
{
    if (!l || method != COIN_RK4)
        return COIN_EARG;
    const float *low = l->low;
    coinf_state s = {
        l->theta, 0,     0,
        0,        0,     l->wX,
        l->wY,    l->wZ, {low[0], 0, 0, 0, 0, low[1], low[2], low[3]},
    };
    const int32_t status = coinf_run(&s, p, method, dt, steps, done);
    if (status < 0 && status != COIN_ESTEP)
        return status;
    l->theta = s.theta;
    l->wX = s.wX;
    l->wY = s.wY;
    l->wZ = s.wZ;
    l->low[0] = s.low[0];
    l->low[1] = s.low[5];
    l->low[2] = s.low[6];
    l->low[3] = s.low[7];
    return status;
}
