/* SPDX-License-Identifier: MIT */
/* coin_move() that stops where a rolling coin slips, against orbits, which take
 * no steps: a fine search for the largest F/N of a motion. */
#include "support/check.h"
#include "support/peaks.h"

#include <math.h>

/* The status of a coin that stops where it slips.  A coin whose force leaves
 * the cone may lift off instead. */
static int32_t until_it_slips(const struct motion *m, double mu, double t,
                              double tol, double *reached)
{
    const coin_table f = {.mu_static = mu, .mu_kinetic = fmin(mu, 0.2)};
    coin_body b;
    check_status(coin_body_from_state(&b, &m->s, &m->p), COIN_OK);
    *reached = 0;
    int32_t status = coin_move(&b, &m->p, &f, 0, tol, 0, NULL);
    if (status == COIN_OK)
        status =
            coin_move(&b, &m->p, &f, t, tol, COIN_SLIPS | COIN_LIFTS, reached);
    return status == COIN_LIFTS ? COIN_SLIPS : status;
}

static struct motion forward_motion(struct random *r, double *t, double *most,
                                    double *at)
{
    struct motion m;
    do
        m = motion_with_peak(r, t, most, at);
    while (m.side < 0);
    return m;
}

/* Of 4,800 random ones 8 were not found at once, 7 of them at 1e-5. */
TEST(an_excursion_of_1e_4_of_mu_is_found)
{
    const double tols[] = {1e-5, 1e-7, 1e-9};
    const int count = tries_asked(40);
    struct random r = random_begin(141);
    int found = 0;
    for (int i = 0; i < count; ++i) {
        double t, most, at, reached;
        const struct motion m = forward_motion(&r, &t, &most, &at);
        const double tol = tols[i % 3];
        check_note("coin %d of seed 141, tol %g", i, tol);
        const int32_t status =
            until_it_slips(&m, most / (1 + 1e-4), t, tol, &reached);
        found += status > 0 && status & COIN_SLIPS &&
                 reached < at + (1e-2 + tol * (1 + t / m.unit)) * m.unit;
    }
    check_share(found, count, 0.998);
}

TEST(friction_that_suffices_is_not_exceeded)
{
    const int count = tries_asked(40);
    struct random r = random_begin(142);
    for (int i = 0; i < count; ++i) {
        double t, most, at, reached;
        const struct motion m = forward_motion(&r, &t, &most, &at);
        check_note("coin %d of seed 142", i);
        check_status(until_it_slips(&m, most * (1 + 1e-6), t, 1e-10, &reached),
                     COIN_OK);
        check(reached == t);
    }
}

/* A state that is 1e-6 units earlier does not slip, whether the excursion is
 * long or takes a small part of a step.  One of a thousand may be
 * missed. */
TEST(the_moment_is_the_first)
{
    const int count = tries_asked(40);
    struct random r = random_begin(143);
    int first = 0;
    for (int i = 0; i < count; ++i) {
        double t, most, at, when;
        const struct motion m = forward_motion(&r, &t, &most, &at);
        const double mu = most * (i % 2 ? 0.98 : 1 - 1e-4);
        check_note("coin %d of seed 143", i);
        const int32_t status = until_it_slips(&m, mu, t, 1e-10, &when);
        check(status >= 0);
        if (!(status & COIN_SLIPS))
            continue;
        if (when > 0)
            check(motion_ratio(&m, when + 1e-6 * m.unit) > mu);
        double before;
        first +=
            when == 0 || motion_largest(&m, when - 1e-6 * m.unit, &before) < mu;
    }
    check_share(first, count, 0.999);
}
