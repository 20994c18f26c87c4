/* SPDX-License-Identifier: MIT */
/* Where a coin that slips, or begins to, lifts off. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/slides.h"

#include <math.h>

static const coin_friction rough = {0.55, 0.5};

/* With as much friction as that the coin keeps to the cone nearly until N = 0,
 * and rolls on for a time where its slip would begin.  The force of that slip
 * is far from the one that rolling would take. */
static void a_coin_lifts_off_where_the_force_of_its_slip_is_0(void **unused)
{
    (void)unused;
    const coin_friction high = {1.1, 1.1};
    const coin_params p = disc();
    for (double tol = 1e-2; tol > 1e-11; tol *= 1e-4) {
        const int count = tries_asked(75);
        struct random r = random_begin(178);
        int lifted = 0, pulled = 0;
        for (int i = 0; i < count; ++i) {
            const coin_state s = random_state(&r, &p, 1.2);
            coin_slide d;
            coin_force force, rolls;
            double reached;
            coin_slide_of(&d, &s, &p);
            if (coin_slide_advance(&d, &p, &high, NULL, 3, tol, &reached) !=
                    COIN_ELIFT ||
                reached == 0)
                continue;
            coin_slide_reaction(&d, &p, &high, NULL, &force);
            check_near(force.normal, 0, tol);
            coin_reaction(&d.s, &p, &rolls);
            pulled += rolls.normal < -0.1;
            ++lifted;
        }
        check(lifted > count / 15 && pulled > count / 30);
    }
}

/* Calls that end just before a lift, at a tol so large that the step to it may
 * go past their end.  A longer call tells when the lift is.  Both calls locate
 * it to 1e-3 tol of a step, and a step is below a unit of time. */
static void no_coin_lifts_off_after_the_end_of_a_call(void **unused)
{
    (void)unused;
    const coin_friction high = {1.1, 1.1};
    const coin_params p = disc();
    const double tol = 1e-2;
    const int count = tries_asked(225);
    struct random r = random_begin(191);
    int lifted = 0;
    for (int i = 0; i < count; ++i) {
        const coin_state s = random_state(&r, &p, 1.2);
        coin_slide start, d;
        double when, reached;
        coin_slide_of(&start, &s, &p);
        d = start;
        if (coin_slide_advance(&d, &p, &high, NULL, 3, tol, &when) !=
            COIN_ELIFT)
            continue;
        ++lifted;
        for (double early = 1e-2; early > 1e-7; early /= 1.2) {
            const double t = when * (1 - early);
            d = start;
            const int32_t status =
                coin_slide_advance(&d, &p, &high, NULL, t, tol, &reached);
            check_within(reached, 0, t);
            if (status != COIN_ELIFT)
                continue;
            d = start;
            coin_slide_advance(&d, &p, &high, NULL, t + tol, tol, &reached);
            check_within(reached, 0, t + 2e-3 * tol);
        }
    }
    check(lifted > count / 15);
}

/* Upright but for 0.1, and falling so fast that N is all but 0: there is hardly
 * any friction, and the slip that has begun grows as rolling lets it. */
static void a_coin_lifts_off_in_a_slip_that_has_just_begun(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double N = 1e-5, c = cos(0.1), wX = sqrt((1 - N) / c);
    const coin_slide start = {{.theta = -0.1, .wX = wX}, 0, wX * c - 1e-9};
    for (double tol = 1e-2; tol > 1e-11; tol *= 1e-4) {
        coin_slide d = start;
        coin_force force;
        double reached;
        check_status(coin_slide_advance(&d, &p, &rough, NULL, 1, tol, &reached),
                     COIN_ELIFT);
        coin_slide_reaction(&d, &p, &rough, NULL, &force);
        check_near(force.normal, 0, 1e-12);
        check_near(reached, N / (sin(0.1) * wX * wX * wX), 1e-2 * N);
    }
}

/* Rolling would take a table that pulls, and a slip is pressed: unless the
 * contact cannot slip. */
static void a_coin_slips_where_only_rolling_would_lift_it(void **unused)
{
    (void)unused;
    const coin_friction high = {1.1, 1.1}, low = {0.3, 0.25};
    const coin_friction endless = {INFINITY, 1.1};
    struct random r = random_begin(179);
    int slip = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = disc();
        const coin_state s = random_state(&r, &p, 1.2);
        coin_slide d;
        coin_force rolls, slips;
        coin_slide_of(&d, &s, &p);
        coin_reaction(&s, &p, &rolls);
        if (rolls.normal > 0)
            continue;
        check_status(coin_slide_advance(&d, &p, &endless, NULL, 1, 1e-9, NULL),
                     COIN_ELIFT);
        coin_slide_reaction(&d, &p, &high, NULL, &slips);
        const int32_t want = slips.normal > 0 ? COIN_SLIPS : COIN_ELIFT;
        check_status(coin_slide_advance(&d, &p, &high, NULL, 0, 1e-9, NULL),
                     want);
        /* The sign of that force is of the coin, and not of its friction. */
        check_status(coin_slide_advance(&d, &p, &low, NULL, 0, 1e-9, NULL),
                     want);
        if (want == COIN_SLIPS) {
            check_near(slips.ratio, 1.1, 1e-12);
            ++slip;
        }
    }
    check(slip > 20);
}

/* A coin that is upright and tips at that rate needs no friction, and a table
 * that pulls: the slip that would begin has no direction. */
static void a_force_that_pulls_straight_down_is_returned(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_state s = {.wX = 1.0625};
    coin_slide d;
    coin_force f;
    check_status(coin_slide_of(&d, &s, &p), COIN_OK);
    check_status(coin_slide_reaction(&d, &p, &rough, NULL, &f), COIN_OK);
    check(f.normal == 1 - 1.0625 * 1.0625 && f.friction == 0);
    check(f.R[0] == 0 && f.R[1] == f.normal && f.R[2] == 0 && isinf(f.ratio));
}

/* With mu_static infinite no contact slips, one that the losses hold near flat
 * neither: it lifts off, in one call and in many. */
static void a_held_coin_that_cannot_slip_lifts_off(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction glued = {(double)INFINITY, 0.3};
    const coin_losses l = {.dry = 1};
    const coin_state s = {.theta = 1.5507949932215062,
                          .wX = -0.2,
                          .wY = 0.056,
                          .wZ = -2.799439943988797};
    const double calls[] = {5, 1e-3};
    for (int k = 0; k < 2; ++k) {
        double t = 0, reached;
        int32_t status;
        coin_slide d;
        coin_force force;
        coin_slide_of(&d, &s, &p);
        do {
            status = coin_slide_advance(&d, &p, &glued, &l, calls[k], 1e-9,
                                        &reached);
            t += reached;
        } while (status == COIN_OK);
        check_status(status, COIN_ELIFT);
        check_near(t, 0.02956688, 1e-7);
        check_status(coin_losses_reaction(&d.s, &p, &l, &force), COIN_OK);
        check_near(force.normal, 0, 1e-9);
        /* At once, if it turns faster. */
        d.s = s;
        d.s.wY *= 1.2;
        d.s.wZ *= 1.2;
        coin_slide_of(&d, &d.s, &p);
        check_status(coin_slide_advance(&d, &p, &glued, &l, 1, 1e-9, &reached),
                     COIN_ELIFT);
        check(reached == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_coin_lifts_off_where_the_force_of_its_slip_is_0),
        TEST(no_coin_lifts_off_after_the_end_of_a_call),
        TEST(a_coin_lifts_off_in_a_slip_that_has_just_begun),
        TEST(a_force_that_pulls_straight_down_is_returned),
        TEST(a_coin_slips_where_only_rolling_would_lift_it),
        TEST(a_held_coin_that_cannot_slip_lifts_off),
    };
    return RUN_TESTS(tests);
}
