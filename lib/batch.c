/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "lanes.h"
#include "march.h"
#include "method.h"
#include "outcome.h"
#include "run.h"
#include "state.h"

/* Coins that go abreast. */
struct rank {
    coin_priv_run run[COIN_PRIV_LANES];
    size_t index[COIN_PRIV_LANES];
    int size;
    coin_priv_abreast *step; /* null if each goes alone */
};

/* Where coins stand and how high each has to stay: above it a step needs no
 * closer look.  2, which nothing is above, for one that does need it.  Whether
 * enough need none: to go abreast for a quarter of the places gains nothing. */
static int line_up(struct rank *r, coin_priv_moment **at, double *high)
{
    int sure = 0;
    for (int k = 0; k < COIN_PRIV_LANES; ++k) {
        coin_priv_run *run = &r->run[k];
        coin_priv_carry *c = &run->c;
        at[k] = &c->at;
        high[k] = coin_priv_high(&run->b, run->limits.coarse2, &c->at.y);
        if (!(c->at.y.cth > high[k]) ||
            !coin_priv_angles_hold(&c->at, c->psi.sum, COIN_PRIV_ROOM))
            high[k] = 2;
        sure += k < r->size && high[k] < 2;
    }
    return sure > (COIN_PRIV_LANES + 2) / 4;
}

/* Block by block from one settling to the next, as each would go alone.  Who
 * did not stay high goes the block again, alone. */
static void go(struct rank *r, uint64_t steps)
{
    coin_priv_moment *at[COIN_PRIV_LANES];
    double high[COIN_PRIV_LANES];
    int sound[COIN_PRIV_LANES];
    for (uint64_t done = 0; done < steps;) {
        const uint64_t left = steps - done;
        const uint64_t block =
            left < COIN_PRIV_SETTLE ? left : COIN_PRIV_SETTLE;
        const int enough = line_up(r, at, high);
        if (enough)
            r->step(at, sound, high, &r->run->b, r->run->dt, block);
        for (int k = 0; k < r->size; ++k) {
            coin_priv_run *run = &r->run[k];
            coin_priv_carry *c = &run->c;
            if (c->steps < done)
                continue; /* it has failed */
            if (!enough || !sound[k]) {
                coin_priv_run_on(run, block);
                continue;
            }
            c->steps += block;
            if (block == COIN_PRIV_SETTLE)
                coin_priv_settle(c, &c->at);
        }
        done += block;
    }
}

/* Moves the coins in line, and empties it.  Places that nobody took go along
 * with the first. */
static void dismiss(struct rank *r, coin_state *s, uint64_t steps,
                    int32_t *status, coin_priv_outcome *o)
{
    for (int k = r->size; k < COIN_PRIV_LANES; ++k)
        r->run[k] = r->run[0];
    if (r->step && r->run->dt != 0)
        go(r, steps);
    else
        for (int k = 0; k < r->size; ++k)
            coin_priv_run_on(&r->run[k], steps);
    for (int k = 0; k < r->size; ++k) {
        const size_t i = r->index[k];
        coin_priv_note(o, status, i,
                       coin_priv_run_close(&r->run[k], steps, &s[i], NULL));
    }
    r->size = 0;
}

int32_t coin_batch_run(coin_state *s, size_t count, const coin_params *p,
                       int32_t method, double dt, uint64_t steps,
                       int32_t *status)
{
    struct rank r;
    coin_priv_outcome o = {0, COIN_OK, COIN_OK};
    const int32_t params = coin_params_check(p);
    if (!s || !coin_priv_method_known(method))
        return COIN_EARG;
    if (params != COIN_OK)
        return params;
    r.size = 0;
    r.step = coin_priv_method_abreast(method);
    for (size_t i = 0; i < count; ++i) {
        const int32_t code =
            coin_priv_run_open(&r.run[r.size], &s[i], p, method, dt);
        if (code == COIN_OK) {
            r.run[r.size].step = coin_priv_method_stepper(method);
            r.index[r.size++] = i;
        } else {
            coin_priv_note(&o, status, i, code);
        }
        if (r.size == COIN_PRIV_LANES)
            dismiss(&r, s, steps, status, &o);
    }
    if (r.size > 0)
        dismiss(&r, s, steps, status, &o);
    return o.error != COIN_OK ? o.error : o.warnings;
}
