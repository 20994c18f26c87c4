/* SPDX-License-Identifier: MIT */
#include "step.h"

int32_t coinf_run(coinf_state *s, const coinf_params *p, int32_t method,
                  float dt, uint64_t steps, uint64_t *done)
{
    coinf_priv_stepper stepper;
    int32_t warnings = COIN_OK;
    const int32_t status = coinf_priv_stepper_of(&stepper, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    uint64_t n = dt == 0 ? steps : 0;
    while (n < steps && coin_priv_step(s, &warnings, &stepper))
        ++n;
    if (done)
        *done = n;
    return n < steps ? coin_priv_refusal(s, stepper.a) : warnings;
}
