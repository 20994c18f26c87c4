/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/orbits.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/steadies.h"

#include "pieces.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --------------------------------------------------------- the reference */
/* 8 u: each half of a period is a sum of pieces, each rounded to its own
 * unit.  Found: 3.4 u. */
TEST(periods_are_those_of_the_reference)
{
    struct table t;
    table_load(&t, "orbits.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        struct scene scene;
        scene_load(&scene, far_scene(&t, row));
        const coin_state s = scene_state(&scene, 0);
        const coin_orbit o = orbit_of(&s, &scene.params);
        const double T = table_at(&t, row, "period");
        check_near(o.period, T, 8 * U * T);
        const double heading = table_at(&t, row, "heading");
        const double roll = table_at(&t, row, "roll");
        check_near(o.heading_per_period, heading, 8 * U * (1 + fabs(heading)));
        check_near(o.roll_per_period, roll, 8 * U * (1 + fabs(roll)));
        check_near(o.theta_min, table_at(&t, row, "theta_min"), 4 * U);
        check_near(o.theta_max, table_at(&t, row, "theta_max"), 4 * U);
    }
}

/* The ring's moments of inertia are not doubles, and its theta follows them.
 */
TEST(pieces_are_few_and_cover_half_a_period)
{
    for (size_t i = 0; i < SCENES; ++i) {
        struct scene scene;
        scene_load(&scene, scene_names[i]);
        const coin_state s = scene_state(&scene, 0);
        const coin_orbit o = orbit_of(&s, &scene.params);
        if (o.period == 0)
            continue;
        const int count = (int)o.private_frame[COIN_PRIV_COUNT];
        check(count >= 2 && count <= 16);
        const double half = o.private_frame[COIN_PRIV_RATE] * o.period / 2;
        for (int n = 0; n < count; ++n)
            check(o.private_edges[n] < o.private_edges[n + 1]);
        check(o.private_edges[0] == 0);
        check_near(o.private_edges[count], half, 2 * U * half);
    }
}

/* --------------------------------------------------------- steady motions */
TEST(a_steady_motion_has_no_period)
{
    struct table t;
    table_load(&t, "circles.csv");
    int seen = 0;
    for (size_t row = 0; row < t.rows; ++row) {
        const struct circle c = circle_at(&t, row);
        double lambda2, center, contact;
        coin_state s = c.state;
        s.phi = 0.7;
        s.psi = 3;
        s.x = 4 * c.params.radius;
        s.z = 5 * c.params.radius;
        check_status(coin_stability(&s, &c.params, &lambda2), COIN_OK);
        const double w2 = c.params.gravity / c.params.radius;
        if (lambda2 > -1e-2 * w2 || fabs(c.theta) > 1.5)
            continue;
        const coin_orbit o = orbit_of(&s, &c.params);
        check_note("circles.csv, row %zu, lambda^2 = %g g/a", row,
                   lambda2 / w2);
        check(o.period == 0 && o.conditioning == 1);
        check(o.heading_per_period == 0 && o.roll_per_period == 0);
        check(o.theta_min == c.theta && o.theta_max == c.theta);
        check(o.drift[0] == 0 && o.drift[1] == 0);
        check_status(coin_steady_radii(&s, &c.params, &center, &contact),
                     COIN_OK);
        check_near(o.radius_min, center, 4 * U * center);
        check(o.radius_max == o.radius_min);
        check_near(hypot(o.center[0] - s.x, o.center[1] - s.z), center,
                   8 * U * (center + s.x + s.z));
        const double T = natural_time(&c.params);
        for (double at = -50 * T; at < 60 * T; at += 30 * T) {
            coin_state one, other;
            check_status(coin_orbit_at(&o, at, &one), COIN_OK);
            check_status(coin_steady_at(&s, &c.params, at, &other), COIN_OK);
            check_near(states_apart(&one, &other, &c.params), 0,
                       1e-13 * (1 + fabs(other.phi) + fabs(other.psi)));
        }
        ++seen;
    }
    check(seen > 20);
}

/* Upright and straight, it has no circle; at rest, its circle is a point. */
TEST(a_straight_roll_has_no_centre)
{
    const coin_params p = disc();
    coin_state s = {0, 0.3, 1, 2, 3, 0, 0, 0.2}, at;
    coin_orbit o = orbit_of(&s, &p); /* unstable, and yet it stays */
    check(isnan(o.center[0]) && isnan(o.center[1]) && isnan(o.radius_min) &&
          isnan(o.radius_max));
    check_status(coin_orbit_at(&o, 100, &at), COIN_OK);
    check(at.psi == 21 && at.phi == s.phi && at.theta == 0);
    s.wZ = 0;
    o = orbit_of(&s, &p);
    check(o.period == 0 && o.center[0] == 2 && o.center[1] == 3 &&
          o.radius_max == 0);
    s.wY = 0.1;
    o = orbit_of(&s, &p);
    check(o.period == 0 && o.center[0] == 2 && o.radius_max == 0);
    check_status(coin_orbit_at(&o, -100, &at), COIN_OK);
    check_near(at.phi, 0.3 - 10, 4 * U * 10);
}

/* Nudged by little, it swings with the period of Eq. (44); by less than its
 * own rounding, it does not. */
TEST(close_to_steady_the_period_is_that_of_small_swings)
{
    const coin_params p = disc();
    for (double nudge = 1e-3; nudge > 1e-13; nudge /= 10) {
        coin_state s;
        double lambda2;
        check_status(coin_steady_circle(&s, &p, 0.4, 1, 1), COIN_OK);
        check_status(coin_stability(&s, &p, &lambda2), COIN_OK);
        s.wX = nudge;
        const coin_orbit o = orbit_of(&s, &p);
        const double T = 2 * acos(-1) / sqrt(-lambda2);
        check_note("nudged by %g", nudge);
        /* The next term is of second order; wX is rounded to 1e-16. */
        check_near(o.period, T, T * (2 * nudge * nudge + 1e-15 / nudge));
        check_near(o.theta_max - o.theta_min, 2 * nudge / sqrt(-lambda2),
                   2e-16 + 2 * nudge * nudge);
    }
    coin_state s;
    check_status(coin_steady_circle(&s, &p, 0.4, 1, 1), COIN_OK);
    s.wX = 1e-17;
    check(orbit_of(&s, &p).period == 0);
}

/* ------------------------------------------------------------- no orbit */
static void refused(const coin_state *s, const coin_params *p)
{
    coin_orbit o, before;
    memset(&o, 0xa5, sizeof o);
    before = o;
    check_status(coin_orbit_init(&o, s, p), COIN_EDOMAIN);
    check_same(&o, &before, sizeof o);
}

/* Slow upright rolling is the top of a hill.  Started ever nearer to it, the
 * coin takes ever longer, and its period ever more from rounding: a hundred
 * times more for a lean ten times less. */
TEST(near_a_separatrix_there_is_no_orbit)
{
    const coin_params p = disc();
    double last = 1, period = 0; /* found: 18910, 1764000, ... */
    for (double lean = 0.01; lean > 2e-6; lean /= 10) {
        const coin_state s = {lean, 0, 0, 0, 0, 0, 0, 0.3};
        const coin_orbit o = orbit_of(&s, &p);
        check_note("a lean of %g", lean);
        check(o.conditioning > 50 * last && o.period > period);
        last = o.conditioning;
        period = o.period;
    }
    /* Also where products of what is left of it would be 0. */
    for (double lean = 1e-12; lean > 1e-310; lean /= 1e30) {
        const coin_state rests = {lean, 0, 0, 0, 0, 0, 0, 0.3};
        const coin_state moves = {0, 0, 0, 0, 0, lean, 0, 0.3};
        check_note("a lean or rate of %g", lean);
        refused(&rests, &p);
        refused(&moves, &p);
    }
    /* An unstable circle is one by its rounding alone, even if that is none. */
    for (double wZ = 0.2; wZ < 0.5; wZ += 0.003) {
        coin_state steady;
        check_status(coin_steady_circle(&steady, &p, 0.15, wZ, 1), COIN_OK);
        refused(&steady, &p);
    }
}

/* With next to no spin at all there is no way past the table that doubles can
 * follow. */
TEST(on_the_table_there_is_no_orbit)
{
    const coin_params p = disc();
    coin_state s = {0.3, 0, 0, 0, 0, 0, 0, 0};
    refused(&s, &p); /* falls flat */
    for (double spin = 1e-9; spin > 1e-300; spin *= 1e-12) {
        check_note("a spin of %g", spin);
        s.wX = 0;
        s.wY = s.wZ = spin;
        refused(&s, &p);
        s.wX = -0.01; /* coming back from there */
        refused(&s, &p);
    }
}

/* Where 1e-9 rad is left, a lean as a double tells a ten-millionth of that. */
TEST(next_to_the_table_no_swing_is_an_orbit)
{
    const coin_params p = disc();
    for (double far = 1.01e-3; far > 1e-11; far /= 10) {
        coin_state s;
        double lambda2;
        check_status(coin_steady_circle(&s, &p, acos(-1) / 2 - far, 1, 1),
                     COIN_OK);
        check_status(coin_stability(&s, &p, &lambda2), COIN_OK);
        s.wX = 1e-3 * far * sqrt(-lambda2);
        check_note("%g from flat", far);
        if (far < 1e-9) {
            refused(&s, &p);
            continue;
        }
        const double T = 2 * acos(-1) / sqrt(-lambda2);
        check_near(orbit_of(&s, &p).period, T, 2e-6 * T);
    }
    /* Three doubles from flat, it falls to one and rises again. */
    const coin_params hoop = {1, 1, 1, 0.5, 1, 0, {0, 0}};
    const coin_state falls = {1.5707963267948959, 1, 7, 0, 0, 0, -1e-300, 1};
    refused(&falls, &hoop);
}

/* --------------------------------------------------------- the annulus */
static double distance_at(const coin_orbit *o, double t)
{
    coin_state at;
    check_status(coin_orbit_at(o, t, &at), COIN_OK);
    return hypot(at.x - o->center[0], at.z - o->center[1]);
}

/* The largest distance of the path from the centre, or with sign = -1 the
 * least: of 1000 points of a period the best, and from its neighbours on by
 * golden section. */
static double extreme_distance(const coin_orbit *o, double sign)
{
    const double step = o->period / 1000, golden = 0.6180339887498949;
    double best = -(double)INFINITY, left = 0;
    for (int k = 0; k < 1000; ++k) {
        const double d = sign * distance_at(o, (k - 350) * step);
        if (d > best) {
            best = d;
            left = (k - 351) * step;
        }
    }
    for (double width = 2 * step; width > 1e-9 * step; width *= golden) {
        const double inner = left + (1 - golden) * width;
        const double outer = left + golden * width;
        const double at_inner = sign * distance_at(o, inner);
        const double at_outer = sign * distance_at(o, outer);
        best = fmax(best, fmax(at_inner, at_outer));
        if (at_outer > at_inner)
            left = inner;
    }
    return sign * best;
}

/* The path stays in it, and comes as near to both edges as a search finds. */
static void check_annulus(const coin_orbit *o)
{
    const double size = o->radius_max;
    const double far = size + hypot(o->center[0], o->center[1]);
    const double low = extreme_distance(o, -1), high = extreme_distance(o, 1);
    const double least = -1e-12 * size - 4 * U * far;
    check_within(low - o->radius_min, least, 1e-6 * size);
    check_within(o->radius_max - high, least, 1e-6 * size);
}

/* Where eight trials of a secant miss an extreme of the distance by 3e-8 to
 * 5e-6 of the radius; where an extreme is at the centre of a piece, and another
 * one near it; where two are near each other; where the path comes as near to
 * the centre as 6e-10 of the radius. */
TEST(the_path_stays_in_an_annulus_that_is_hard_to_find)
{
    static const double cases[][6] = {
        /* I_X, I_Z, theta, wX, wY, wZ */
        {0.25, 0.5, -0.26143363085383164, 1.2838091091618971,
         0.54085847073347004, 1.6175198591432776},
        {0.25, 0.5, 1.4796579893312412, 0.66042304153131637,
         -1.5851849397311057, -0.12411412092587781},
        {0.48913408541132519, 0.97826817082265038, 0.3191923765708149,
         0.25099660685879854, 1.1260566816622495, -1.9594655872809605},
        {0.093886600081958149, 0.020081909670849964, 1.1976294736501769,
         1.0396217109422925, 0.20174696022879912, -0.93185425286609513},
        {0.25, 0.5, 0, 2.8444916019310247, 2.5634755426615854, 0},
        {0.46511784403474404, 0.75251397933448561, -0.26667019484877685, 0,
         -0.13456973030397945, 1.7181072079737776},
        {0.25548981692442485, 0.39728621746914961, -0.32502177857681147,
         -0.45909269002401704, 0.25892000012069127, -0.02262987584526345},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const double *c = cases[i];
        const coin_params p = {1, 1, 1, c[0], c[1], 0, {0, 0}};
        const coin_state s = {
            .theta = c[2], .wX = c[3], .wY = c[4], .wZ = c[5]};
        const coin_orbit o = orbit_of(&s, &p);
        check_note("case %zu", i);
        check_annulus(&o);
    }
}

TEST(the_path_fills_its_annulus)
{
    struct random r = random_begin(71);
    for (int i = 0; i < 60; ++i) {
        coin_params p = disc();
        /* Upright without roll: the path is symmetric about the start, so that
         * an extreme is between two pieces or parts of one. */
        const coin_state upright = {
            .wX = random_between(&r, -3, 3),
            .wY = random_between(&r, -3, 3),
        };
        /* Comes nearest to the centre soon after a turning point; the other one
         * between turning points that one piece holds. */
        coin_state s = {-0.3256, 0, 0, 0, 0, 0, 0.31, 0.0413};
        const coin_params hoop = {1, 1, 1, 0.5, 1, 0, {0, 0}};
        const coin_state small = {
            .theta = -0x1.d694eef2f50ep-2,
            .wX = 0x1.ad27044f18bf7p-8,
            .wY = -0x1.fab115c738caap-4,
            .wZ = 0x1.c70203c4ceabdp+0,
        };
        const coin_orbit o = i == 0   ? orbit_of(&s, &p)
                             : i == 1 ? orbit_of(&small, &hoop)
                             : i > 39 ? orbit_of(&upright, &p)
                                      : random_orbit(&r, &p, &s);
        check_annulus(&o);
    }
}

/* A wobble through upright with K_Y = 0 goes straight on. */
TEST(a_symmetric_wobble_drifts)
{
    const coin_params p = disc();
    const coin_state s = {0, 0.5, 0, 2, 3, 0.1, 0, 1};
    const coin_orbit o = orbit_of(&s, &p);
    check(o.heading_per_period == 0);
    check_near(o.theta_min, -o.theta_max, 4 * U);
    check(isnan(o.center[0]) && isnan(o.center[1]) && isnan(o.radius_min) &&
          isnan(o.radius_max));
    for (int k = -3; k < 1000; k += 111) {
        coin_state at;
        check_status(coin_orbit_at(&o, k * o.period, &at), COIN_OK);
        const double bound = 1e-14 * (3 + abs(k) * hypot(1, o.period));
        check_near(at.x, s.x + k * o.drift[0], bound);
        check_near(at.z, s.z + k * o.drift[1], bound);
    }
    check_near(atan2(o.drift[1], -o.drift[0]), 0.5, 0.2); /* the heading */
}

/* With a heading from which the turning point before lies out of range. */
TEST(it_drifts_from_the_end_of_the_range_as_well)
{
    const coin_params p = disc();
    const double phi = 0x1p31;
    const coin_state s = {0, phi, 0, 0, 0, 0.3, 0, 1};
    const coin_state same = {0, 0, 0, 0, 0, 0.3, 0, 1};
    const coin_orbit o = orbit_of(&s, &p), plain = orbit_of(&same, &p);
    const double c = cos(phi), n = sin(phi);
    const double *d = plain.drift, length = hypot(d[0], d[1]);
    check(plain.period == o.period && length > 3);
    check_near(o.drift[0], d[0] * c + d[1] * n, 8 * U * length);
    check_near(o.drift[1], d[1] * c - d[0] * n, 8 * U * length);
}

/* Any other drifts where Dphi passes a multiple of 2 pi: here 0. */
TEST(a_resonant_motion_drifts)
{
    const coin_params p = disc();
    coin_state s = {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2};
    double low = 1, high = 1.2; /* wY, with heading above and below 0 */
    coin_orbit o;
    while (high - low > 2e-16 * high) {
        s.wY = (low + high) / 2;
        o = orbit_of(&s, &p);
        if (o.heading_per_period > 0)
            low = s.wY;
        else
            high = s.wY;
        if (isnan(o.center[0]))
            break;
    }
    check(isnan(o.center[0]) && isnan(o.radius_max));
    check_near(o.heading_per_period, 0, 2e-15);
    coin_state at;
    check_status(coin_orbit_at(&o, 100 * o.period, &at), COIN_OK);
    check_near(at.x, 100 * o.drift[0], 1e-10);
    check_near(at.z, 100 * o.drift[1], 1e-10);
    check(hypot(at.x, at.z) > 1);
    /* Off the resonance it has a centre, far away. */
    s.wY = s.wY * (1 + 1e-9);
    o = orbit_of(&s, &p);
    check(o.drift[0] == 0 && hypot(o.center[0], o.center[1]) > 1e4);
}

TEST(its_size_is_as_promised)
{
    check(coin_sizeof("coin_orbit") == sizeof(coin_orbit));
    check(sizeof(coin_orbit) == 32768);
}

/* Whether it rolls straight is no matter of the unit of time: a circle, in
 * units of 1e-15 to 1e15 natural rates. */
TEST(a_steady_circle_has_a_centre_in_every_unit)
{
    for (int e = -15; e <= 15; e += 5) {
        const double rate = pow(10, e);
        coin_params p;
        check_note("rates of 1e%d", e);
        check_status(coin_params_disc(&p, 1, 1 / rate, rate), COIN_OK);
        const coin_state s = circle(&p, 0.4, rate, 1);
        const coin_orbit o = orbit_of(&s, &p);
        double center, contact;
        check(o.period == 0);
        check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
        check_near(o.radius_max, center, 4 * U * center);
        check_near(hypot(o.center[0], o.center[1]), center, 4 * U * center);
    }
}
