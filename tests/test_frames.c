/* SPDX-License-Identifier: MIT */
/* coin_advance() over times so short that one step will do. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include "advance.h"

#include <math.h>

/* A US quarter as it rolls on the charts of docs/accuracy.md. */
static const coin_state rolling = {.theta = 0.3, .wY = 5, .wZ = 40};

static coin_params quarter(void)
{
    coin_params p;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    return p;
}

TEST(frames_of_a_quarter_are_one_step_each)
{
    const struct {
        int rate;
        double tol;
        int32_t method;
    } of[] = {
        {60, 1e-6, COIN_RK8},  {120, 1e-6, COIN_RK8},  {240, 1e-6, COIN_RK8},
        {240, 1e-9, COIN_RK8}, {1000, 1e-9, COIN_RK8}, {1000, 1e-6, COIN_RK4},
        {240, 1e-3, COIN_RK4},
    };
    const coin_params p = quarter();
    for (size_t k = 0; k < sizeof of / sizeof *of; ++k) {
        const double dt = 1.0 / of[k].rate;
        coin_state s = rolling;
        for (int i = 0; i < of[k].rate; ++i) {
            coin_state by_run = s;
            check_note("frame %d at %d/s, tol %g", i, of[k].rate, of[k].tol);
            check_status(coin_run(&by_run, &p, of[k].method, dt, 1, NULL),
                         COIN_OK);
            check_status(coin_advance(&s, &p, dt, of[k].tol, NULL), COIN_OK);
            check_same(&s, &by_run, sizeof s);
        }
    }
}

/* Which only a coin whose lean and heading turn slowly may take at first. */
TEST(at_1e_9_it_is_one_step_in_tau)
{
    const coin_params p = quarter();
    const coin_priv_lengths lengths = coin_priv_lengths_of(1e-9);
    coin_state s = rolling;
    for (int i = 0; i < 60; ++i) {
        coin_priv_run r;
        coin_priv_sum rem = {1.0 / 60, 0}, far = {1000, 0};
        coin_priv_pace pace = {0, 0};
        check_status(coin_priv_check(&s, &p, &r.b), COIN_OK);
        coin_priv_run_unlimited(&r, &s);
        check_note("frame %d", i);
        check(!coin_priv_one_step_suffices(&r, &lengths, rem.sum));
        check_status(coin_priv_advance_by(&r, &lengths, 2, &pace, &rem),
                     COIN_OK);
        check(fabs(rem.sum) < 1e-3 / 60);
        coin_priv_run_unlimited(&r, &s);
        r.g.y.wY = 1000;
        const double unit = coin_priv_sundman_tau(&r.b, &r.g.y, 1);
        check_status(coin_priv_advance_by(&r, &lengths, 2, &pace, &far),
                     COIN_OK);
        check(pace.tau < 0.6 * lengths.stride * unit);
        check_status(coin_advance(&s, &p, 1.0 / 60, 1e-9, NULL), COIN_OK);
    }
}

/* In these motions, the worst of a search, one step of RK8 errs by 4 to 8 tol
 * per unit: by less than tol for each radian that W turns. */
TEST(fast_spins_err_by_less_than_tol_per_radian)
{
    const struct {
        coin_state s;
        double inner, t, tol;
    } fast[] = {
        {{.theta = -1.290, .wX = -0.286, .wY = 0.362, .wZ = -20},
         0.9,
         0.041,
         1e-6},
        {{.theta = 0.532, .wX = 2.111, .wY = -3.264, .wZ = -55.7},
         1,
         0.0149,
         1e-6},
        {{.theta = 0.653, .wX = 0.996, .wY = -3.803, .wZ = -50},
         0.9,
         0.007,
         1e-9},
    };
    for (size_t i = 0; i < sizeof fast / sizeof *fast; ++i) {
        const coin_params p = ring(fast[i].inner);
        const double t = fast[i].t, tol = fast[i].tol;
        const double W = fastest_rate(&fast[i].s, &p);
        coin_state s = fast[i].s, exact = s, by_one = s;
        check_note("motion %zu", i);
        check_status(coin_run(&exact, &p, COIN_RK8, t / 100, 100, NULL),
                     COIN_OK);
        check_status(coin_run(&by_one, &p, COIN_RK8, t, 1, NULL), COIN_OK);
        check_status(coin_advance(&s, &p, t, tol, NULL), COIN_OK);
        check(path_apart(&by_one, &exact, &p) > 3 * tol * t);
        check_within(path_apart(&s, &exact, &p), 0, tol * t * W);
    }
}

/* Of coins that turn up to 20 times as fast as others. */
TEST(short_calls_err_by_less_than_tol_per_radian)
{
    const double tols[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10};
    const int count = tries_asked(1000);
    struct random r = random_begin(95);
    for (int i = 0; i < count; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double w = exp(random_between(&r, 0, 3));
        const double theta = random_between(&r, -1.4, 1.4);
        const coin_state start = {
            .theta = theta,
            .wX = random_between(&r, -w, w) * cos(theta),
            .wY = random_between(&r, -w, w) * cos(theta),
            .wZ = random_between(&r, -w, w),
        };
        const double t = exp(random_between(&r, -7, -1)) / w;
        const double tol = tols[i % 5];
        coin_state s = start, exact = start;
        check_note("motion %d, tol %g, t %g", i, tol, t);
        check_status(coin_advance(&s, &p, t, tol, NULL), COIN_OK);
        check_status(coin_run(&exact, &p, COIN_RK8, t / 100, 100, NULL),
                     COIN_OK);
        const double turned = t * fastest_rate(&start, &p);
        check_within(path_apart(&s, &exact, &p), 0, tol * turned + 4e-15);
    }
}

/* Passes near flat at the end of a call, of 400,000 motions those that one step
 * of RK8, 0.9/W long, could not end. */
TEST(passes_are_right_at_the_coarsest_tol)
{
    const struct {
        coin_state s;
        double t;
    } passes[] = {
        {{.theta = -0.90641127,
          .wX = -5.372436026,
          .wY = 1.042544282,
          .wZ = 1.139288174},
         1.0848},
        {{.theta = 1.382603353,
          .wX = 2.289592124,
          .wY = 0.6548744376,
          .wZ = -5.588421725},
         1.1834},
        {{.theta = 0.155851419,
          .wX = 1.125471385,
          .wY = 4.798349876,
          .wZ = -3.867848746},
         1.30913},
        {{.theta = -0.472456485,
          .wX = 8.489097195,
          .wY = -6.162548604,
          .wZ = -7.097085477},
         0.675617},
    };
    const coin_params p = disc();
    for (size_t i = 0; i < sizeof passes / sizeof *passes; ++i) {
        coin_state s = passes[i].s, exact = s;
        check_note("pass %zu", i);
        check_status(coin_advance(&exact, &p, passes[i].t, 1e-12, NULL),
                     COIN_OK);
        check_status(coin_advance(&s, &p, passes[i].t, 1e-2, NULL), COIN_OK);
        coin_state beside = passes[i].s;
        beside.theta += 1e-6;
        check_status(coin_advance(&beside, &p, passes[i].t, 1e-12, NULL),
                     COIN_OK);
        const double amp = path_apart(&beside, &exact, &p) / 1e-6;
        check_within(path_apart(&s, &exact, &p), 0, 1e-2 * amp);
    }
}

/* Found by a search.  One step of RK8 through all of t would err by 2.2 times
 * the law: t^2 (W^2 + TURN w^2) is above the square of LAST_MOST. */
TEST(a_last_step_keeps_the_law_at_the_coarsest_tol)
{
    const coin_params p = ring(sqrt(0.4432));
    const coin_state start = {
        .theta = 1.48126, .wX = 0.14058, .wY = -0.045052, .wZ = 0.30425};
    const double t = 0.31083, tol = 1e-2;
    const double n = t * sqrt(2 * coin_energy(&start, &p));
    coin_state s = start, exact = start;
    check_status(coin_advance(&exact, &p, t, 1e-12, NULL), COIN_OK);
    check_status(coin_advance(&s, &p, t, tol, NULL), COIN_OK);
    check_within(path_apart(&s, &exact, &p), 0, 2 * tol * (1 + n));
}

/* A minute of frames: the errors of all add up, and the phase drifts. */
TEST(a_minute_of_frames_errs_by_less_than_tol_per_unit)
{
    const int rates[] = {60, 120, 240, 1000};
    const double tols[] = {1e-6, 1e-9};
    const coin_params p = quarter();
    const double units = 60 / natural_time(&p);
    coin_state exact = rolling;
    check_status(coin_advance(&exact, &p, 60, 1e-13, NULL), COIN_OK);
    for (int k = 0; k < 8; ++k) {
        const int rate = rates[k / 2];
        const double tol = tols[k % 2];
        coin_state s = rolling;
        check_note("%d frames a second, tol %g", rate, tol);
        for (int i = 0; i < 60 * rate; ++i)
            check_status(coin_advance(&s, &p, 1.0 / rate, tol, NULL), COIN_OK);
        check_within(path_apart(&s, &exact, &p), 0, tol * units);
    }
}
