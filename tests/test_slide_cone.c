/* SPDX-License-Identifier: MIT */
/* Coins that roll until they leave the cone of friction, however briefly. */
#include "support/check.h"
#include "support/coins.h"
#include "support/peaks.h"
#include "support/slides.h"

#include <math.h>

enum { NEAR = 15 };

/* The test finds the peak by sampling; a slide looks by other means.  3 of
 * 18,000 slides miss it. */
TEST(a_slide_slips_in_an_excursion_that_hardly_exceeds_mu)
{
    struct random r = random_begin(185);
    const int count = tries_asked(NEAR);
    int all = 0, slip = 0;
    for (int i = 0; i < count; ++i) {
        double t, most, at;
        struct motion m;
        do
            m = motion_with_peak(&r, &t, &most, &at);
        while (m.side < 0 || most > 1);
        for (double tol = 1e-10; tol < 1e-5; tol *= 1e2) {
            check_note("coin %d, tol %g", i, tol);
            const double mu = most / (1 + 1e-4);
            const coin_table f = {.mu_static = mu,
                                  .mu_kinetic = fmin(0.9 * mu, 0.2)};
            slip += slips_as_it_must(&m.p, &m.s, &f, t, tol);
            ++all;
        }
    }
    check_share(slip, all, 0.999);
}

static int32_t slid_on(coin_body *to, const coin_body *from,
                       const coin_params *p, const coin_table *f,
                       const coin_losses *l, double t, double tol)
{
    double reached;
    *to = *from;
    const int32_t status = slide(to, p, f, l, t, tol, &reached);
    check(status < 0 || status == COIN_LIFTS || reached == t);
    return status;
}

static int32_t slid(coin_body *to, const coin_body *from, const coin_params *p,
                    const coin_losses *l, double t, double tol)
{
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.24};
    return slid_on(to, from, p, &f, l, t, tol);
}

/* A time just before a rolling coin slips; 0 if it does not within 3 units. */
static double before_slip(const coin_body *d, const coin_params *p,
                          const coin_losses *l)
{
    coin_body e;
    double low = 0, high = 0;
    while (high < 3 && slid(&e, d, p, l, high, 1e-9) == COIN_OK) {
        low = high;
        high += 0.05;
    }
    if (low == 0 || slid(&e, d, p, l, high, 1e-9) != COIN_SLIPS)
        return 0;
    for (int i = 0; i < 40; ++i) {
        const double mid = (low + high) / 2;
        if (slid(&e, d, p, l, mid, 1e-12) == COIN_OK)
            low = mid;
        else
            high = mid;
    }
    return low;
}

/* The step that would go past the end of the time meets the slip there. */
TEST(a_call_that_ends_just_before_a_slip_is_accurate)
{
    const coin_losses some = {.dry = 0.01, .viscous = 0.02, .spin = 0.005};
    struct random r = random_begin(189);
    int found = 0;
    while (found < 40) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.2);
        const coin_losses *l = found % 2 ? &some : NULL;
        coin_body d, rough, fine;
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        const double last = before_slip(&d, &p, l);
        if (last == 0)
            continue;
        ++found;
        for (double early = 1e-2; early > 1e-6; early /= 3) {
            if (early >= last)
                continue;
            slid(&fine, &d, &p, l, last - early, 1e-12);
            for (double tol = 1e-4; tol > 1e-9; tol /= 10) {
                check_note("early by %g, tol %g", early, tol);
                slid(&rough, &d, &p, l, last - early, tol);
                check(slides_apart(&rough, &fine, &p) < 20 * tol);
            }
        }
    }
}

/* A slip that begins slowly: mu_kinetic is hardly below mu_static.  A coin that
 * would roll on to the end of the call errs by up to 50 tol.  What is allowed
 * is tol for the beginning of the slip, and tol (1 + t) for the motion. */
/* As coin.h says of coin_move(): 98 of 100. */
TEST(a_call_that_ends_as_a_slip_begins_is_accurate)
{
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.2999};
    const int count = tries_asked(12);
    struct random r = random_begin(190);
    int found = 0, all = 0, above = 0;
    while (found < count) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.2);
        coin_body d, rough, fine;
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        const double last = before_slip(&d, &p, NULL);
        if (last == 0)
            continue;
        ++found;
        for (double late = 0.2; late > 1e-4; late /= 3) {
            const double t = last + late;
            const int32_t want = slid_on(&fine, &d, &p, &f, NULL, t, 1e-12);
            for (double tol = 1e-2; tol > 1e-7; tol /= 10) {
                check_note("late by %g, tol %g", late, tol);
                const int32_t got = slid_on(&rough, &d, &p, &f, NULL, t, tol);
                ++all;
                above += got != want ||
                         (want != COIN_LIFTS &&
                          !(slides_apart(&rough, &fine, &p) < tol * (2 + t)));
            }
        }
    }
    check_note("%d of %d above tol (2 + t)", above, all);
    check(above * 50 <= all);
}

/* The part of a step up to a slip has a larger estimate of its error here than
 * the step, which was accepted. */
TEST(a_part_of_an_accepted_step_is_accepted)
{
    const coin_state s = {
        .theta = -0.44503551407829045,
        .wX = 0.69214152233077297,
        .wY = -0.59902687696245338,
        .wZ = -0.26564914597865319,
    };
    const coin_losses l = {
        .dry = 0.002229606176924004,
        .viscous = 0.013680597566117843,
        .spin = 0.019704546954364643,
    };
    const coin_table f = {.mu_static = 0.26322905376873362,
                          .mu_kinetic = 0.13161452688436681};
    const double t = 0.5;
    coin_params p;
    coin_body d;
    double reached;
    check_status(
        coin_params_body(&p, 1, 1, 1, 0.14444757567219141, 0.11944820439138072),
        COIN_OK);
    check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
    check_status(slide(&d, &p, &f, &l, t, 1e-11, &reached), COIN_SLIPS);
    check(reached == t);
}
