/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* As in rk4.c, the step of which is compiled here too. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("rename-registers")
#endif

#include "../motion/state.h"

#include "advance.h"
#include "rk4.h"
#include "rk8.h"

/* One step in t over the time left.  Returns whether it was made. */
static int last_step(coin_priv_run *r, const coin_priv_lengths *lengths,
                     double rem)
{
    const uint64_t before = r->steps;
    if (coin_priv_left2(r, rem) <= lengths->rk4_2) {
        const coin_priv_rk4_fields k = coin_priv_rk4_fields_of(&r->b, rem);
        coin_priv_step_end end;
        coin_priv_variables next;
        coin_priv_rk4_step(&end, &next, &r->g.y, &k);
        return coin_priv_accept_step(r, &next, &end.adds);
    }
    r->dt = rem;
    coin_priv_rk8(r, 1);
    return r->steps > before;
}

/* Moves *r by *rem, the time still to go.  It makes no more steps in tau after
 * those of the number `last`. */
static int32_t advance(coin_priv_run *r, const coin_priv_lengths *lengths,
                       uint64_t last, coin_priv_sum *rem)
{
    coin_priv_pace pace = {0, 0};
    int32_t status = COIN_OK;
    while (status == COIN_OK &&
           !coin_priv_one_step_suffices(r, lengths, rem->sum))
        status = coin_priv_advance_by(r, lengths, last, &pace, rem);
    if (r->steps > 0)
        coin_priv_read_lean(&r->g);
    if (status != COIN_OK || rem->sum == 0)
        return status;
    if (!last_step(r, lengths, rem->sum))
        return COIN_ERANGE;
    rem->sum = 0;
    return COIN_OK;
}

/* Ends a call that was to move *s by the time t, of which *rem is left.  If a
 * rate has left its range, *s stays as it was and *reached becomes 0, as in a
 * run. */
static int32_t end_call(coin_state *s, const coin_priv_run *r, int32_t status,
                        double t, const coin_priv_sum *rem, double *reached)
{
    const coin_state end = coin_priv_run_state(r);
    const int lost = !coin_priv_state_in_range(&end, &r->b);
    if (!lost)
        coin_priv_copy_state(s, &end);
    /* The low part of *rem counts where t is far longer. */
    const double passed = rem->sum == 0 ? t : (t - rem->sum) - rem->low;
    if (reached)
        *reached = lost ? 0 : passed;
    return lost ? COIN_ERANGE : status;
}

int32_t coin_advance(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    coin_priv_run r;
    if (!(tol >= 1e-13 && tol <= 1e-2))
        return COIN_EARG;
    int32_t status = coin_priv_check(s, p, &r.b);
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_in_range(t, &r.b))
        return COIN_ESTEP;
    if (t >= 0 && coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_EFLAT;
    }
    const coin_priv_lengths lengths = coin_priv_lengths_of(tol);
    uint64_t last = COIN_PRIV_STEPS_MAX;
    coin_priv_sum rem;
    do {
        rem.sum = t;
        rem.low = 0;
        coin_priv_run_unlimited(&r, s);
        const int32_t ends = advance(&r, &lengths, last, &rem);
        status = status == COIN_OK ? ends : status;
        /* Refused beyond t, it ends a step before: the steps are made again. */
        last = r.steps - 1;
    } while (status != COIN_OK && (rem.sum < 0) != (t < 0));
    return end_call(s, &r, status, t, &rem, reached);
}
