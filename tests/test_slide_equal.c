/* SPDX-License-Identifier: MIT */
/* Slips that begin with little acceleration, or none: mu_static exceeds
 * mu_kinetic by 4e-4 of it, or not at all. */
#include "support/check.h"
#include "support/coins.h"
#include "support/newton.h"
#include "support/slides.h"

#include <math.h>

/* The time of a launch, in natural units. */
#define TIME 2.0

/* A falling coin amplifies errors as exp(t sqrt(4/5)). */
#define GROWTH 6.0

/* The steps of the truth.  Halved, its error is less than the difference. */
#define STEPS 0.04

static const double tols[] = {1e-4, 1e-8, 1e-10};

/* A launch, and where Newton's and Euler's laws take it. */
struct launch {
    coin_params p;
    coin_table f;
    coin_body from, truth;
    int mode;
    double reached, error;
};

/* A coin that rolls, and slips soon. */
static struct launch random_roll(struct random *r)
{
    struct launch l = {0};
    const double mu = random_between(r, 0.1, 0.5);
    l.p = r->drawn % 2 ? disc() : ring(random_between(r, 0, 1));
    l.f = (coin_table){.mu_static = mu * (r->drawn / 2 % 2 ? 1 + 4e-4 : 1),
                       .mu_kinetic = mu};
    const coin_state s = {
        .theta = random_between(r, -0.8, 0.8),
        .wX = random_between(r, -1, 1),
        .wY = random_between(r, -1, 1),
        .wZ = random_between(r, -1, 1),
    };
    check_note("launch %u of ROLLCOIN_SEED=%llu", ++r->drawn,
               (unsigned long long)r->seed);
    check_status(coin_body_from_state(&l.from, &s, &l.p), COIN_OK);
    return l;
}

/* Whether a slip begins on the way, and the truth is known. */
static int slips_later(struct launch *l)
{
    coin_body coarse = l->from;
    coin_force f;
    double reached;
    coin_reaction(&l->from.s, &l->p, &f);
    if (!(f.ratio < l->f.mu_static))
        return 0;
    const int mode = newton(&coarse, &l->p, &l->f, TIME, STEPS, &reached);
    if (mode > NEWTON_LIFTS)
        return 0;
    l->truth = l->from;
    l->mode = newton(&l->truth, &l->p, &l->f, TIME, STEPS / 2, &l->reached);
    const double lost =
        slide_energy(&l->from, &l->p) - slide_energy(&l->truth, &l->p);
    l->error = fmax(slides_apart(&coarse, &l->truth, &l->p),
                    fabs(reached - l->reached));
    return l->mode == mode && (mode == NEWTON_LIFTS || lost > 1e-6);
}

TEST(nearly_equal_coefficients_agree_with_newton_and_euler)
{
    const int32_t want[] = {COIN_OK, COIN_SLIPS, COIN_LIFTS};
    const int count = tries_asked(6);
    struct random r = random_begin(211);
    int found = 0;
    while (found < count && r.drawn < 30 * (unsigned)count) {
        struct launch l = random_roll(&r);
        if (!slips_later(&l))
            continue;
        ++found;
        for (int k = 0; k < 3; ++k) {
            coin_body d = l.from;
            double reached;
            check_status(slide(&d, &l.p, &l.f, NULL, TIME, tols[k], &reached),
                         want[l.mode]);
            const double most = GROWTH * tols[k] * (1 + TIME) + l.error + 1e-12;
            check_within(slides_apart(&d, &l.truth, &l.p), 0, most);
            check_near(reached, l.reached, most);
        }
    }
    check(found == count);
}
