/* SPDX-License-Identifier: MIT */
/* One step of lib/step/extrapolation.c. */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include "extrapolation.h"
#include "state.h"
#include "sundman.h"

#include <math.h>
#include <string.h>

/* coin_priv_extrapolate() with this many lanes:
 * support/extrapolate_*.c. */
typedef int lanes_step(coin_priv_run *r, double tau, double *error);
lanes_step extrapolate_1, extrapolate_2, extrapolate_4;

static coin_priv_run begun(const coin_state *s, const coin_params *p)
{
    coin_priv_run c;
    memset(&c, 0, sizeof c);
    check_status(coin_priv_check(s, p, &c.b), COIN_OK);
    coin_priv_run_unlimited(&c, s);
    return c;
}

/* A step whatever its error. */
static int extrapolate(coin_priv_run *r, double tau)
{
    double error = 1;
    return coin_priv_extrapolate(r, tau, &error);
}

/* The largest difference of what a step moves. */
static double apart(const coin_priv_progress *a, const coin_priv_progress *b)
{
    const double off[] = {
        a->y.wX - b->y.wX,           a->y.wY - b->y.wY,
        a->y.wZ - b->y.wZ,           a->y.sth - b->y.sth,
        a->y.cth - b->y.cth,         a->y.sph - b->y.sph,
        a->y.cph - b->y.cph,         a->added.phi - b->added.phi,
        a->added.psi - b->added.psi, a->added.x - b->added.x,
        a->added.z - b->added.z,     a->added.t - b->added.t,
    };
    double most = 0;
    for (size_t i = 0; i < sizeof off / sizeof *off; ++i)
        most = fmax(most, fabs(off[i]));
    return most;
}

/* Of n steps over the time tau. */
static coin_priv_run moved(const coin_state *s, const coin_params *p,
                           double tau, int n)
{
    coin_priv_run c = begun(s, p);
    for (int i = 0; i < n; ++i)
        check(extrapolate(&c, tau / n));
    return c;
}

/* One step errs by its 15th power: from a length to 1.25 times it the error
 * grows by 1.25^15 = 28.4, or by a power more where two terms nearly cancel. */
TEST(a_step_errs_by_its_fifteenth_power)
{
    struct random r = random_begin(87);
    double sum = 0;
    enum { TRIED = 160 };
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.5);
        const coin_priv_run at = begun(&s, &p);
        const double tau = coin_priv_sundman_tau(&at.b, &at.g.y, 1.2);
        double error[2];
        for (int k = 0; k < 2; ++k) {
            const double H = k == 0 ? tau : 1.25 * tau;
            const coin_priv_run c = moved(&s, &p, H, 1);
            const coin_priv_run fine = moved(&s, &p, H, 8);
            error[k] = apart(&c.g, &fine.g);
        }
        sum += log(error[1] / error[0]) / log(1.25);
    }
    check_within(sum / TRIED, 14.3, 16);
}

/* The estimate of one step is as its 13th power. */
TEST(the_estimate_is_as_the_thirteenth_power)
{
    struct random r = random_begin(91);
    double sum = 0;
    enum { TRIED = 160 };
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.5);
        const coin_priv_run at = begun(&s, &p);
        const double tau = coin_priv_sundman_tau(&at.b, &at.g.y, 0.8);
        double error[2] = {1, 1};
        for (int k = 0; k < 2; ++k) {
            coin_priv_run c = at;
            check(coin_priv_extrapolate(&c, k == 0 ? tau : 1.25 * tau,
                                        &error[k]));
        }
        sum += log(error[1] / error[0]) / log(1.25);
    }
    check_within(sum / TRIED, 12.4, 13.6);
}

/* A step of one run, and 8 steps of an eighth of it of another from the same
 * start; 0 if the step is refused. */
static int step_beside_eighths(coin_priv_run *one, coin_priv_run *exact,
                               double stride, double *error)
{
    const double tau = coin_priv_sundman_tau(&one->b, &one->g.y, stride);
    if (!coin_priv_extrapolate(one, tau, error))
        return 0;
    for (int k = 0; k < 8; ++k)
        check(extrapolate(exact, tau / 8));
    return 1;
}

/* As COIN_PRIV_ACCEPTED says, by 8 steps for one. */
TEST(the_error_is_a_part_of_the_estimate)
{
    struct random r = random_begin(92);
    enum { TRIED = 1000 };
    double most = 0;
    int above = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.5);
        const double stride = random_between(&r, 1, 2.4);
        coin_priv_run one = begun(&s, &p), exact = one;
        double error = 1;
        if (!step_beside_eighths(&one, &exact, stride, &error))
            continue;
        const double off = apart(&one.g, &exact.g) - 64 * U;
        const double part = off / (error * stride * stride);
        above += part > 1.0 / 100;
        most = fmax(most, part);
    }
    check_within(above, TRIED / 5, TRIED * 4 / 5);
    check_within(most, 0.03, 0.3);
}

/* As COIN_PRIV_ACCEPTED says too, where I_Z is small and most of the error is
 * that of psi: hardly any errs by more than a seventh of the estimate. */
TEST(the_estimate_sees_how_far_a_body_rolls)
{
    const coin_params p = {1, 1, 1, 0.5, 5e-4, 0, {0, 0}};
    struct random r = random_begin(94);
    enum { TRIED = 8000 };
    int above = 0, made = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_state s = {.theta = random_between(&r, -1.5, 1.5),
                              .wX = random_between(&r, -1, 1),
                              .wY = random_between(&r, -1, 1),
                              .wZ = random_between(&r, 5, 10)};
        const double stride = random_between(&r, 1.4, 2.4);
        coin_priv_run one = begun(&s, &p), exact = one;
        double error = 1e-3;
        if (!step_beside_eighths(&one, &exact, stride, &error))
            continue;
        const double off = fabs(one.g.added.psi - exact.g.added.psi);
        above += off - 640 * U > error * stride * stride / 7;
        ++made;
    }
    check(made > TRIED / 2);
    check(above <= TRIED / 1000);
}

/* The bounces of a coin next to flat are alike, whatever their height d: their
 * estimates differ by less than the part d. */
TEST(low_bounces_have_one_estimate)
{
    const coin_params p = ring(0.5);
    double error[3] = {1, 1, 1};
    for (int k = 0; k < 3; ++k) {
        const double d = pow(10, -3 - k);
        const coin_state s = {.theta = COIN_PRIV_HALF_PI - d,
                              .wX = 0.3 * sqrt(d)};
        coin_priv_run c = begun(&s, &p);
        check(coin_priv_extrapolate(
            &c, coin_priv_sundman_tau(&c.b, &c.g.y, 1.8), &error[k]));
        check_note("height %g", d);
        check_near(error[k], error[0], 1e-3 * error[0]);
    }
}

/* A low bounce is right to this part of its height, where the estimate of cos
 * theta alone is 0 by chance too. */
TEST(the_height_of_low_bounces_is_a_part_of_the_estimate)
{
    struct random r = random_begin(93);
    double most = 0;
    for (int i = 0; i < 3000; ++i) {
        const double d = pow(10, random_between(&r, -6, -3));
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = {
            .theta = COIN_PRIV_HALF_PI - d,
            .wX = random_between(&r, -2, 2) * sqrt(d),
        };
        const double stride = random_between(&r, 1.4, 2.2);
        coin_priv_run one = begun(&s, &p), exact = one;
        double error = 1;
        if (!step_beside_eighths(&one, &exact, stride, &error))
            continue;
        const double off = fabs(one.g.y.cth / exact.g.y.cth - 1) - 64 * U;
        most = fmax(most, off / (error * stride * stride));
    }
    check_within(most, 0.1, 1);
}

TEST(a_step_beyond_the_error_allowed_is_not_made)
{
    const coin_params p = ring(0.5);
    const coin_state s = {.theta = 0.5, .wX = 0.3, .wY = 1, .wZ = 1};
    const coin_priv_run start = begun(&s, &p);
    coin_priv_run c = start;
    double error = 1;
    check(coin_priv_extrapolate(&c, 1, &error));
    const double estimate = error;
    c = start;
    check(coin_priv_extrapolate(&c, 1, &error));
    c = start;
    error = estimate * (1 - U);
    check(!coin_priv_extrapolate(&c, 1, &error));
    check(error == estimate);
    check_same(&c, &start, sizeof c);
    error = 1;
    (void)coin_priv_extrapolate(&c, 1000, &error);
    check(error == 1);
    /* It ends above the table, and errs by far more than a radian. */
    c.g.y.wY = 7.59375;
    c.g.y.wZ = 1.5;
    check(!coin_priv_extrapolate(&c, 1.37371, &error));
    check(error == 1);
}

TEST(any_number_of_lanes_gives_the_same_bits)
{
    lanes_step *const by[] = {extrapolate_1, extrapolate_2, extrapolate_4};
    struct random r = random_begin(89);
    int done = 0;
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.57);
        const coin_priv_run start = begun(&s, &p);
        const double tau = coin_priv_sundman_tau(&start.b, &start.g.y,
                                                 random_between(&r, -3, 3));
        coin_priv_run want = start;
        double error = 1;
        const int sound = coin_priv_extrapolate(&want, tau, &error);
        for (int k = 0; k < 3; ++k) {
            coin_priv_run c = start;
            double by_lanes = 1;
            check(by[k](&c, tau, &by_lanes) == sound);
            check(by_lanes == error);
            check_same(&c, &want, sizeof c);
        }
        done += sound;
    }
    check(done > 400);
}

/* A step in tau of any size leads to a state above the table or nowhere. */
TEST(a_step_is_sound_or_not_done)
{
    struct random r = random_begin(90);
    int done = 0, refused = 0;
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.57);
        coin_priv_run c = begun(&s, &p);
        const coin_priv_run before = c;
        if (extrapolate(&c, random_between(&r, -6, 6))) {
            check(c.g.y.cth > 0 && c.steps == 1);
            ++done;
        } else {
            check_same(&c, &before, sizeof c);
            ++refused;
        }
    }
    check(done > 500 && refused > 100);
}
