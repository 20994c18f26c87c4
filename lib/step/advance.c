/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "advance.h"

/* Moves *r until *rem, the time still to go, is short. */
static int32_t approach(coin_priv_run *r, const coin_priv_lengths *lengths,
                        coin_priv_sum *rem)
{
    coin_priv_pace pace = {0, 0};
    int32_t status = COIN_OK;
    while (status == COIN_OK && rem->sum != 0 &&
           !coin_priv_one_step_suffices(r, lengths, rem->sum))
        status = coin_priv_advance_by(r, lengths, &pace, rem);
    return status;
}

int32_t coin_advance(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    coin_priv_body b;
    if (!coin_priv_tol_is_valid(tol))
        return COIN_EARG;
    int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_holds(t, &b))
        return COIN_ESTEP;
    if (t >= 0 && coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_EFLAT;
    }
    coin_priv_run r;
    coin_priv_sum rem = {t, 0};
    r.b = b;
    coin_priv_run_unlimited(&r, s);
    const coin_priv_lengths lengths = coin_priv_lengths_of(tol);
    status = approach(&r, &lengths, &rem);
    if (r.steps > 0)
        coin_priv_read_lean(&r.g);
    if (status == COIN_OK)
        status = coin_priv_last_step(&r, &lengths, &rem);
    return coin_priv_end_call(s, &r, status, t, &rem, reached);
}
