/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "run.h"

void coin_priv_run_from(coin_priv_run *r, const coin_state *s, int32_t method,
                        double dt)
{
    const coin_priv_variables y = coin_priv_variables_inline(s);
    coin_priv_copy_state(&r->start, s);
    r->limits = coin_priv_limits_of(&r->b, method, dt);
    r->limits.x = s->x;
    r->limits.z = s->z;
    r->dt = dt;
    coin_priv_progress_begin(&r->g, &y, s->theta, s->phi, s->psi);
    r->steps = 0;
}

void coin_priv_run_unlimited(coin_priv_run *r, const coin_state *s)
{
    coin_priv_run_from(r, s, COIN_RK4, 0);
}
