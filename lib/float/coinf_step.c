/* SPDX-License-Identifier: MIT */
#include "step.h"

int coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                           const coinf_priv_stepper *stepper)
{
    if (!coinf_priv_holds(next, stepper))
        return 0;
    if (fabsf(next->phi) > 2 * COIN_PRIV_HALF_PI)
        coinf_priv_reduce(&next->phi, &next->low[1]);
    if (fabsf(next->psi) > 2 * COIN_PRIV_HALF_PI)
        coinf_priv_reduce(&next->psi, &next->low[2]);
    *s = *next;
    return 1;
}

/* KJ_low, with which KJ + KJ_low is K/(M g a) = (a + I_Z/(M a))/g times GJ.  In
 * a steady motion the terms with KJ and with GJ balance.  An error of the ratio
 * of KJ and GJ makes the heading drift; an error common to both does not. */
static float balance(const coin_priv_field *f, const coin_priv_body *b, float g)
{
    const float sum = b->a + b->IZ / (b->M * b->a), ratio = sum / g;
    const float ratio_low =
        ((sum - ratio * g) - coinf_priv_residue(ratio, g)) / g;
    return (f->GJ * ratio - f->KJ) +
           (coinf_priv_residue(f->GJ, ratio) + f->GJ * ratio_low);
}

int32_t coinf_priv_stepper_of(coinf_priv_stepper *stepper, const coinf_state *s,
                              const coinf_params *p, int32_t method, float dt)
{
    coin_priv_body b;
    const int32_t status = coin_priv_method_is_known(method)
                               ? coin_priv_check(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_holds(dt, &b))
        return COIN_ESTEP;
    const coin_priv_limits limits = coin_priv_limits_of(&b, method, dt);
    stepper->f = coin_priv_field_of(&b, dt);
    stepper->a = b.a;
    stepper->g_a = b.g_a;
    stepper->w2_max = b.w2_max;
    stepper->most2 = limits.most2;
    stepper->coarse2 = limits.coarse2;
    stepper->KJ_low = balance(&stepper->f, &b, p->gravity);
    return COIN_OK;
}

/* The cos theta of the stages is not checked: where that of one is near 0 or
 * below it, the W of the last stage is above the limit. */
int coinf_priv_step_from(coinf_state *s, int32_t *warnings,
                         const coinf_priv_stepper *stepper,
                         const coin_priv_variables *y)
{
    coinf_priv_slope first, rest;
    coin_priv_variables last;
    coinf_priv_slopes(&first, &rest, &last, stepper, y, coinf_priv_slope_at);
    if (!coinf_priv_admit_rate(warnings, stepper, &last))
        return 0;
    coinf_state next = *s;
    coinf_priv_add_change(&next, &first, &rest);
    return coinf_priv_finish_step(s, &next, stepper);
}

int32_t coinf_step(coinf_state *s, const coinf_params *p, float dt)
{
    coinf_priv_stepper stepper;
    int32_t warnings = COIN_OK;
    const int32_t status = coinf_priv_stepper_of(&stepper, s, p, COIN_RK4, dt);
    if (status != COIN_OK || dt == 0)
        return status;
    return coin_priv_step(s, &warnings, &stepper)
               ? warnings
               : coin_priv_refusal(s, stepper.a);
}
