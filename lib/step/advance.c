/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* As in rk4.c, the step of which is compiled here too: a call of one step in
 * tau and one of RK4 takes 1 % fewer instructions. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("rename-registers")
#endif

#include "../motion/rest.h"

#include "advance.h"

/* Moves *r by *rem, the time still to go. */
static int32_t advance(coin_priv_run *r, const coin_priv_lengths *lengths,
                       coin_priv_sum *rem)
{
    coin_priv_pace pace = {0, 0};
    int32_t status = COIN_OK;
    while (status == COIN_OK &&
           !coin_priv_one_step_suffices(r, lengths, rem->sum))
        status = coin_priv_advance_by(r, lengths, &pace, rem);
    if (r->steps > 0)
        coin_priv_read_lean(&r->g);
    if (status != COIN_OK || rem->sum == 0)
        return status;
    if (!coin_priv_last_step(r, lengths, rem->sum))
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

int32_t coin_advance(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    coin_priv_run r;
    if (!coin_priv_tol_is_valid(tol))
        return COIN_EARG;
    int32_t status = coin_priv_check(s, p, &r.b);
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_holds(t, &r.b))
        return COIN_ESTEP;
    if (t >= 0 && coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_EFLAT;
    }
    coin_priv_sum rem = {t, 0};
    coin_priv_run_unlimited(&r, s);
    const coin_priv_lengths lengths = coin_priv_lengths_of(tol);
    status = advance(&r, &lengths, &rem);
    return coin_priv_end_call(s, &r, status, t, &rem, reached);
}
