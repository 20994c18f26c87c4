/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/orbits.h"
#include "support/random.h"
#include "support/scene.h"

#include "pieces.h"

#include <math.h>
#include <string.h>

static coin_state at(const coin_orbit *o, double t)
{
    coin_state s;
    check_status(coin_orbit_at(o, t, &s), COIN_OK);
    return s;
}

/* ---------------------------------------------------------- references */
TEST(every_scene_is_where_the_reference_is)
{
    for (size_t i = 0; i < SCENES; ++i) {
        struct scene scene;
        scene_load(&scene, scene_names[i]);
        const coin_state s = scene_state(&scene, 0);
        const coin_orbit o = orbit_of(&s, &scene.params);
        double W = 0;
        for (size_t row = 0; row < scene.rows.rows; ++row) {
            const coin_state truth = scene_state(&scene, row);
            W = fmax(W, fastest_rate(&truth, &scene.params));
        }
        for (size_t row = 0; row < scene.rows.rows; ++row) {
            const coin_state want = scene_state(&scene, row);
            check_note("%s, row %zu", scene.name, row);
            check_pose(&o, scene_at(&scene, row, "t"), W, &want, &scene.params);
        }
    }
}

TEST(random_coins_are_where_the_reference_is)
{
    struct table t;
    table_load(&t, "random.csv");
    check(t.rows == 100);
    for (size_t row = 0; row < t.rows; ++row) {
        const coin_params p = ring(table_at(&t, row, "b"));
        const coin_state s = start_in_row(&t, row);
        const coin_state want = state_in_row(&t, row);
        const coin_orbit o = orbit_of(&s, &p);
        const double W = fmax(fastest_rate(&s, &p), fastest_rate(&want, &p));
        const coin_state now = at(&o, 100);
        check_note("random.csv, row %zu", row);
        check_pose(&o, 100, W, &want, &p);
        /* Rates change by up to W^2 where angles do by W: W is below 10. */
        check_near(now.wX, want.wX, 10 * orbit_error(&o, 100, W));
        check_near(now.wY, want.wY, 10 * orbit_error(&o, 100, W));
        check_near(now.wZ, want.wZ, 10 * orbit_error(&o, 100, W));
    }
}

/* At 1000 and at 1e6 natural units, and as long before the start. */
TEST(far_times_are_as_good_as_doubles_tell)
{
    struct table t;
    table_load(&t, "orbits.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        struct scene scene;
        scene_load(&scene, far_scene(&t, row));
        const coin_state s = scene_state(&scene, 0);
        const coin_orbit o = orbit_of(&s, &scene.params);
        const double when = table_at(&t, row, "t");
        const coin_state want = state_in_row(&t, row);
        const coin_state now = at(&o, when);
        const int near = fabs(when) < 2e3 * natural_time(&scene.params);
        check_note("%s at %g", scene.name, when);
        check_near(states_apart(&now, &want, &scene.params), 0,
                   near ? 1e-12 : 1e-9);
    }
}

/* ---------------------------------------------------------- its own laws */
/* The start comes back, and a part of the way begun elsewhere goes on alike.
 */
TEST(an_orbit_from_a_later_state_goes_on)
{
    struct random r = random_begin(81);
    for (int i = 0; i < 100; ++i) {
        coin_params p;
        coin_state s;
        const coin_orbit o = random_orbit(&r, &p, &s);
        const double T = natural_time(&p);
        const double one = random_between(&r, -10, 10) * T;
        const double two = random_between(&r, -10, 10) * T;
        const coin_state start = at(&o, 0), middle = at(&o, one);
        check_near(states_apart(&start, &s, &p), 0, 64 * U);
        const coin_orbit later = orbit_of(&middle, &p);
        const coin_state end = at(&o, one + two), same = at(&later, two);
        check_near(path_apart(&end, &same, &p), 0,
                   1e-12 * o.conditioning * (1 + 20 * T / o.period));
    }
}

/* Nothing jumps where pieces meet, nor at the turning points: a short step
 * across is what the rates make of it, to the rounding of the angles and to
 * that of both times, 4 u (|t| + period). */
TEST(pieces_join)
{
    struct random r = random_begin(83);
    int seen = 0;
    for (int i = 0; i < 100; ++i) {
        coin_params p;
        coin_state s;
        const coin_orbit o = random_orbit(&r, &p, &s);
        const double unit = 1 / o.private_frame[COIN_PRIV_RATE];
        const double step = 1e-9 * natural_time(&p);
        const int count = (int)o.private_frame[COIN_PRIV_COUNT];
        for (int n = 0; n < count; ++n, ++seen) {
            const double t =
                (o.private_edges[n] - o.private_frame[COIN_PRIV_SINCE]) * unit;
            const double from = t - step, to = t + step;
            const coin_state before = at(&o, from), after = at(&o, to);
            const double late = 4 * U * (fabs(t) + o.period);
            coin_state rates, then;
            check_status(coin_rates(&before, &p, &rates), COIN_OK);
            check_status(coin_rates(&after, &p, &then), COIN_OK);
            double *const mean = (double *)&rates;
            for (int k = 0; k < 8; ++k)
                mean[k] += (((const double *)&then)[k] - mean[k]) / 2;
            check_near(after.theta - before.theta, (to - from) * rates.theta,
                       late * fabs(rates.theta) + 1e-15);
            check_near(after.phi - before.phi, (to - from) * rates.phi,
                       late * fabs(rates.phi) + 8e-15);
            check_near(after.psi - before.psi, (to - from) * rates.psi,
                       late * fabs(rates.psi) + 8e-15);
            check_near((after.x - before.x) / p.radius,
                       (to - from) * rates.x / p.radius,
                       late * fabs(rates.x) / p.radius + 1e-14);
            check_near((after.z - before.z) / p.radius,
                       (to - from) * rates.z / p.radius,
                       late * fabs(rates.z) / p.radius + 1e-14);
        }
    }
    check(seen > 500);
}

/* Reversed rates are reversed time, to the bit: the walk from the start is the
 * same in both directions. */
TEST(reversed_motion_is_reversed_time)
{
    struct random r = random_begin(84);
    for (int i = 0; i < 100; ++i) {
        coin_params p;
        coin_state s;
        const coin_orbit o = random_orbit(&r, &p, &s);
        const double T = natural_time(&p);
        s.wX = -s.wX;
        s.phi = -s.phi;
        s.psi = -s.psi;
        s.x = -s.x;
        const coin_orbit back = orbit_of(&s, &p);
        check_near(back.period, o.period, 8 * U * o.period);
        for (double t = -20 * T; t < 21 * T; t += 10 * T) {
            const coin_state one = at(&o, t);
            coin_state other = at(&back, -t);
            other.wX = -other.wX;
            other.phi = -other.phi;
            other.psi = -other.psi;
            other.x = -other.x;
            check_near(path_apart(&one, &other, &p), 0,
                       1e-13 * o.conditioning * (1 + 20 * T / o.period));
        }
    }
}

/* Twice as large and as heavy, and in other units of time by a power of two:
 * the same bits. */
TEST(units_of_powers_of_two_change_no_bit)
{
    struct random r = random_begin(85);
    for (int i = 0; i < 20; ++i) {
        coin_params p, q;
        check_status(coin_params_ring(&p, 1, 1, 0.5, 1), COIN_OK);
        check_status(coin_params_ring(&q, 4, 2, 1, 32), COIN_OK);
        coin_state s = random_state(&r, &p, 1), S = s;
        S.x *= 2;
        S.z *= 2;
        S.wX *= 4;
        S.wY *= 4;
        S.wZ *= 4;
        const coin_orbit o = orbit_of(&s, &p), O = orbit_of(&S, &q);
        for (double t = -30; t < 31; t += 7) {
            const coin_state one = at(&o, t);
            coin_state other = at(&O, t / 4);
            other.x /= 2;
            other.z /= 2;
            other.wX /= 4;
            other.wY /= 4;
            other.wZ /= 4;
            check_same(&one, &other, sizeof one);
        }
    }
}

/* --------------------------------------------------------------- limits */
TEST(times_without_a_state_are_refused)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const coin_state wobbling = {0.1, 0, 0, 0, 0, 0, 0, 1};
    const coin_state steady = {0, 0, 0, 0, 0, 0, 0, 1};
    const coin_state start[] = {wobbling, steady};
    const double never[] = {(double)NAN, (double)INFINITY, -(double)INFINITY,
                            1e300, 1.001e15};
    for (int i = 0; i < 2; ++i) {
        const coin_orbit o = orbit_of(&start[i], &p);
        coin_state out, before;
        memset(&out, 0xa5, sizeof out);
        before = out;
        for (size_t k = 0; k < sizeof never / sizeof *never; ++k)
            check_status(coin_orbit_at(&o, never[k], &out), COIN_ESTEP);
        check_status(coin_orbit_at(&o, 1e10, &out), COIN_ERANGE);
        check_status(coin_orbit_at(&o, -1e10, &out), COIN_ERANGE);
        check_status(coin_orbit_at(NULL, 1, &out), COIN_EARG);
        check_status(coin_orbit_at(&o, 1, NULL), COIN_EARG);
        check_same(&out, &before, sizeof out);
        check_status(coin_orbit_at(&o, 9.9e8, &out), COIN_OK);
    }
    /* 2^31 periods are too many even if no angle would leave its range. */
    coin_orbit still = orbit_of(&wobbling, &p);
    memset(still.private_frame + COIN_PRIV_HEADING, 0, 6 * sizeof(double));
    coin_state out;
    check_status(coin_orbit_at(&still, 0x1.fffp30 * still.period, &out),
                 COIN_OK);
    check_status(coin_orbit_at(&still, 0x1.001p31 * still.period, &out),
                 COIN_ESTEP);
    coin_state s = wobbling; /* psi leaves its range within a period */
    s.psi = 2147483646.0;
    const coin_orbit o = orbit_of(&s, &p);
    check_status(coin_orbit_at(&o, 1, &out), COIN_OK);
    check_status(coin_orbit_at(&o, 3, &out), COIN_ERANGE);
}

/* ------------------------------------------------------------ its parts */
/* Begun at a turning point, before and after are mirrors to the bit. */
TEST(a_turning_point_is_a_mirror)
{
    struct random r = random_begin(86);
    for (int i = 0; i < 50; ++i) {
        coin_params p;
        coin_state s;
        random_orbit(&r, &p, &s);
        s.wX = s.phi = s.psi = s.x = s.z = 0;
        coin_orbit o;
        if (coin_orbit_init(&o, &s, &p) != COIN_OK)
            continue;
        check(o.theta_min == s.theta || o.theta_max == s.theta);
        for (int k = 0; k < 20; ++k) {
            const double t = random_between(&r, 0, 0.49) * o.period;
            const coin_state one = at(&o, t), other = at(&o, -t);
            check(one.theta == other.theta && one.wX == -other.wX);
            check(one.wY == other.wY && one.wZ == other.wZ);
            check(one.phi == -other.phi && one.psi == -other.psi);
        }
    }
}

/* All that goes with the number of periods is in parts: that number, below
 * 2^31, times one of the first two is exact. */
TEST(products_with_a_number_of_periods_are_exact)
{
    const int of[] = {COIN_PRIV_PERIOD, COIN_PRIV_HEADING, COIN_PRIV_ROLL,
                      COIN_PRIV_TURN};
    const double k = 0x1p31 - 1;
    struct random r = random_begin(87);
    for (int i = 0; i < 50; ++i) {
        coin_params p;
        coin_state s;
        const coin_orbit o = random_orbit(&r, &p, &s);
        for (int n = 0; n < 4; ++n)
            for (int m = 0; m < 2; ++m) {
                const double part = o.private_frame[of[n] + m];
                check(fma(k, part, -(k * part)) == 0);
            }
        /* In turns: what they leave of the heading, in units of 2 pi in two
         * parts, subtracted exactly but for the last terms. */
        const double *turn = o.private_frame + COIN_PRIV_TURN;
        const double high = 2 * COIN_PRIV_HALF_PI,
                     low = 2 * COIN_PRIV_HALF_PI_LOW;
        const double H = o.heading_per_period;
        const double whole = round(H / (2 * high));
        double rest = fma(-2 * high, whole, H);
        for (int m = 0; m < 3; ++m)
            rest = fma(-2 * high, turn[m], rest);
        rest -= 2 * low * (whole + turn[0]);
        check_near(rest, 0, 1e-20 * (1 + fabs(H)));
    }
}

/* ------------------------------ bytes that coin_orbit_init() did not write */
static coin_orbit wobbling(void)
{
    const coin_state s = {0.1, 0, 0, 0, 0, 0, 0, 1};
    const coin_params p = disc();
    return orbit_of(&s, &p);
}

/* Whatever its bytes, an orbit is not read beyond its end. */
TEST(bytes_that_are_no_orbit_do_no_harm)
{
    const coin_orbit o = wobbling();
    const double bad[] = {0, -1, 43, 1e9, (double)NAN};
    coin_state out, before;
    memset(&out, 0xa5, sizeof out);
    before = out;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        coin_orbit other = o;
        other.private_frame[COIN_PRIV_COUNT] = bad[i];
        check_note("%g pieces", bad[i]);
        check_status(coin_orbit_at(&other, 1, &out), COIN_EARG);
        check_same(&out, &before, sizeof out);
    }
    coin_orbit noise;
    memset(&noise, 0xff, sizeof noise); /* all NaN */
    check_status(coin_orbit_at(&noise, 1, &out), COIN_EARG);
    noise.period = 0;
    check_status(coin_orbit_at(&noise, 1, &out), COIN_EARG);
    noise.private_frame[0] = o.private_frame[0];
    check_status(coin_orbit_at(&noise, 1, &out), COIN_ESTEP);
    noise = o; /* all pieces but the last one have no length */
    memset(noise.private_edges, 0, sizeof noise.private_edges);
    noise.private_frame[COIN_PRIV_COUNT] = 20;
    noise.private_terms[19 * COIN_PRIV_PIECE] = 0.25; /* of the last one */
    check_status(coin_orbit_at(&noise, 1, &out), COIN_OK);
    check(out.theta == 0.25);
}

/* The tag is that of the version: one release, major, minor or patch, later it
 * is another. */
TEST(an_orbit_of_another_version_is_refused)
{
    const int later[] = {1, 1 << 8, 1 << 16};
    const coin_orbit o = wobbling();
    const double version = coin_version(), all = 1 << 24;
    check(o.private_frame[0] == 2.2073158e-107 * (all + version));
    for (int i = 0; i < 3; ++i) {
        coin_orbit other = o;
        coin_state out, before;
        memset(&out, 0xa5, sizeof out);
        before = out;
        other.private_frame[0] *= (all + version + later[i]) / (all + version);
        check_status(coin_orbit_at(&other, 1, &out), COIN_EARG);
        check_same(&out, &before, sizeof out);
    }
}

/* A later version may give reserved members a meaning, if they are 0 today. */
TEST(spare_members_are_zero)
{
    static const coin_orbit zero;
    const coin_orbit o = wobbling();
    check_same(o.reserved, zero.reserved, sizeof o.reserved);
    check_same(o.private_spare, zero.private_spare, sizeof o.private_spare);
}
