/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"
#include "support/scene.h"

#include <math.h>

static coin_state at(const coin_state *s, const coin_params *p, double t)
{
    coin_state out;
    check_status(coin_steady_at(s, p, t, &out), COIN_OK);
    return out;
}

/* 4 u of the angles turned since the start, and the reference's own rounding;
 * the path is at most two radii of its circle wide. */
TEST(a_steady_motion_is_where_the_reference_is)
{
    static const char *const steady[] = {"spin", "circle"};
    for (int i = 0; i < 2; ++i) {
        struct scene scene;
        scene_load(&scene, steady[i]);
        const coin_state start = scene_state(&scene, 0);
        const double speed = fabs(start.wY) / cos(start.theta);
        const double spin = speed + fabs(start.wZ);
        for (size_t row = 0; row < scene.rows.rows; ++row) {
            const double t = scene_at(&scene, row, "t");
            const coin_state s = at(&start, &scene.params, t);
            const double bound = 4 * U * (1 + spin * t);
            check_near(scene_error(&scene, row, &s), 0,
                       bound * (1 + start.wZ / start.wY));
        }
    }
}

/* Straight rolling moves along -x by radius |wZ| t, turned by the heading. */
TEST(straight_rolling_is_a_straight_line)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 2, 3), COIN_OK);
    coin_state s;
    check_status(coin_steady_roll(&s, &p, 5), COIN_OK);
    s.phi = 0.5;
    s.psi = 1;
    s.x = 3;
    s.z = 4;
    const coin_state far = at(&s, &p, 1e6);
    check_near(far.psi, 1 + 5e6, 0);
    check_near(far.x, 3 - 1e7 * cos(0.5), 4 * U * 1e7);
    check_near(far.z, 4 + 1e7 * sin(0.5), 4 * U * 1e7);
    check(far.phi == 0.5 && far.wZ == 5 && far.theta == 0);
}

/* So does a circle of nearly no curvature: nothing cancels. */
TEST(a_huge_circle_begins_straight)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const coin_state s = circle(&p, 1e-9, 1, 1), end = at(&s, &p, 10);
    check_near(end.x, -10, 8 * U * 10);
    check_near(end.z, s.wY * 50, 1e-12 * s.wY * 50);
}

/* The heading is added to what is turned as angles, not as numbers: a start
 * turned by a thousand million radians loses none of its path.  The turn is
 * that of the table's frame; both its sine and cosine by libm. */
TEST(a_huge_heading_costs_the_path_nothing)
{
    struct random r = random_begin(26);
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int i = 0; i < 300; ++i) {
        coin_state s = circle(&p, random_between(&r, 0.1, 1.4),
                              random_between(&r, 0.3, 2), 1);
        const double t = random_between(&r, -3, 3);
        const coin_state plain = at(&s, &p, t);
        s.phi = random_between(&r, -2e9, 2e9);
        const coin_state far = at(&s, &p, t);
        const double c = cos(s.phi), d = sin(s.phi);
        const double turned = 1 + fabs(t) * s.wY / cos(s.theta);
        const double bound = 4 * U * fabs(s.wZ * t) * (1 + turned);
        check_near(far.x, c * plain.x + d * plain.z, bound);
        check_near(far.z, c * plain.z - d * plain.x, bound);
    }
}

/* There and back, and in two parts. */
TEST(times_add_up)
{
    struct random r = random_begin(25);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = random_coin(&r);
        const double unit = natural_time(&p);
        coin_state s = circle(&p, random_sized(&r, 1e-3, 1.4),
                              random_between(&r, -2, 2) / unit, 1);
        s.phi = random_between(&r, -3, 3);
        const double t = random_between(&r, -20, 20) * unit;
        const coin_state half = at(&s, &p, t), whole = at(&s, &p, 2 * t);
        const coin_state twice = at(&half, &p, t), back = at(&half, &p, -t);
        const double turned =
            3 + fabs(t) * (fabs(s.wY) / cos(s.theta) * 2 + fabs(s.wZ));
        const double path = fabs(s.wZ * t) * turned;
        check_near(path_apart(&twice, &whole, &p), 0, 8 * U * (turned + path));
        check_near(path_apart(&back, &s, &p), 0, 8 * U * (turned + path));
    }
}

TEST(what_is_not_steady_or_leaves_its_range_is_refused)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    coin_state s = circle(&p, 0.4, 1, 1), out = s;
    check_status(coin_steady_at(&s, &p, (double)INFINITY, &out), COIN_ESTEP);
    check_status(coin_steady_at(&s, &p, (double)NAN, &out), COIN_ESTEP);
    check_status(coin_steady_at(&s, &p, 1.001e15, &out), COIN_ESTEP);
    check_status(coin_steady_at(&s, &p, 1e10, &out), COIN_ERANGE);
    check_same(&out, &s, sizeof s);
    s.wX = 1e-3;
    check_status(coin_steady_at(&s, &p, 1, &out), COIN_EDOMAIN);
    check_status(coin_steady_at(&s, &p, (double)NAN, &out), COIN_ESTEP);
    s.wX = 5e-10;
    check_status(coin_steady_at(&s, &p, 1, &out), COIN_OK);
    check(out.wX == 0);
}
