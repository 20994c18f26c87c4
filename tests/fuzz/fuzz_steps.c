/* SPDX-License-Identifier: MIT */
/* Fixed steps. */
#include "fuzz.h"

#include <string.h>

/* The progress of a call: all of it, or none because the step is no number, or
 * so much. */
static uint64_t progress(const struct outcome *o, double dt, uint64_t asked,
                         uint64_t done)
{
    if (o->result >= 0) {
        demand(done == asked);
        return asked;
    }
    if ((o->result != COIN_ESTEP && o->result != COIN_ERANGE) ||
        !(dt * dt * (o->world->p.gravity / o->world->p.radius) <= 1e30)) {
        demand(done == UINT64_C(0xa5a5a5a5a5a5a5a5));
        return 0;
    }
    demand(done < asked);
    return done;
}

/* A run that ends early is one of so many steps. */
static void judge_run(const struct outcome *o)
{
    const union argument *a = o->given;
    coin_state s = o->world->s;
    uint64_t done, again;
    memcpy(&done, o->left[5].p, sizeof done);
    done = progress(o, a[3].d, a[4].u, done);
    if (done > 0)
        demand(coin_run(&s, &o->world->p, a[2].i, a[3].d, done, &again) >= 0);
    demand(same(&s, o->left[0].p, sizeof s));
}

/* A step by itself is a run of one, to the bit, with its status, or changes
 * nothing. */
static void judge_step(const struct outcome *o)
{
    coin_state s = o->world->s;
    const int32_t status =
        coin_run(&s, &o->world->p, COIN_RK4, o->given[2].d, 1, NULL);
    demand(o->result == COIN_EARG || status == o->result);
    if (o->result < 0)
        s = o->world->s;
    demand(same(&s, o->left[0].p, sizeof s));
}

/* Each coin as by a run of its own, those beyond untouched; the first error, or
 * all warnings. */
static void judge_batch_run(const struct outcome *o)
{
    const union argument *a = o->given;
    coin_state s[SAMPLES];
    int32_t status[SAMPLES], error = COIN_OK, warnings = COIN_OK;
    if (o->result == COIN_EARG || o->result == COIN_EPARAMS)
        return;
    memcpy(s, a[0].p, sizeof s);
    memcpy(status, a[6].p, sizeof status);
    for (size_t k = 0; k < a[1].u; ++k) {
        status[k] = coin_run(&s[k], &o->world->p, a[3].i, a[4].d, a[5].u, NULL);
        if (status[k] > 0)
            warnings |= status[k];
        else if (error == COIN_OK)
            error = status[k];
    }
    demand(o->result == (error != COIN_OK ? error : warnings));
    demand(same(s, o->left[0].p, sizeof s));
    demand(same(status, o->left[6].p, sizeof status));
}

/* Each sample has the bits of a run; those beyond are untouched. */
static void judge_sample(const struct outcome *o)
{
    const union argument *a = o->given;
    const unsigned char *out = o->left[6].p, *fresh = a[6].p;
    const coin_params *p = &o->world->p;
    uint64_t done;
    size_t count;
    memcpy(&count, o->left[7].p, sizeof count);
    count = progress(o, a[3].d, a[5].u, count);
    for (size_t k = 0; k < count; ++k) {
        coin_state s = o->world->s;
        demand(coin_run(&s, p, a[2].i, a[3].d, k * a[4].u, &done) >= 0);
        demand(same(&s, out + k * sizeof s, sizeof s));
        demand(coin_state_check(&s, p) == COIN_OK);
    }
    const size_t written = count * sizeof(coin_state);
    demand(same(out + written, fresh + written,
                SAMPLES * sizeof(coin_state) - written));
}

#define STEPS (USUAL | STOPS)

FUNCTION(coin_step, "Spt", coin_step(a[0].p, a[1].p, a[2].d), STEPS,
         COIN_COARSE, 0, judge_step, 0)
FUNCTION(coin_run, "Spitun",
         coin_run(a[0].p, a[1].p, a[2].i, a[3].d, a[4].u, a[5].p), STEPS,
         COIN_COARSE, STOPS, judge_run, 0)
FUNCTION(coin_batch_run, "XcpituZ",
         coin_batch_run(a[0].p, a[1].u, a[2].p, a[3].i, a[4].d, a[5].u, a[6].p),
         STEPS, COIN_COARSE, STOPS | BIT(COIN_ESTATE), judge_batch_run, 0)
FUNCTION(coin_sample, "spitucAz",
         coin_sample(a[0].p, a[1].p, a[2].i, a[3].d, a[4].u, a[5].u, a[6].p,
                     a[7].p),
         STEPS, COIN_COARSE, STOPS, judge_sample, 0)
