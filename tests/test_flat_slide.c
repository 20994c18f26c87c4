/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides, against an integration of friction over its
 * face. */
#include "support/check.h"
#include "support/thrown.h"

#include <flat_slide.h>

#include <fenv.h>
#include <math.h>

#define LAST_LEAN (1.5707963267948966 - 2.220446049250313e-16)

/* The error of time, path, speed and turn in their units: S/mu, S^2/mu, S. */
#define EXACT 1e-10

static coin_body flat(double v, double heading, double w)
{
    const coin_body b = {.s = {.theta = LAST_LEAN, .wZ = w},
                         .y = cos(LAST_LEAN),
                         .vx = v * cos(heading),
                         .vz = v * sin(heading)};
    return b;
}

/* How many steps a slide may try. */
static int tries = 400;

static const double level[2] = {0, 0};

static double pulled(coin_body *b, double IZ, double mu, const double pull[2],
                     double t)
{
    static coin_priv_moving g;
    g.law.IZ = IZ;
    g.law.pull[0] = pull[0];
    g.law.pull[1] = pull[1];
    g.law.mu_kinetic = mu;
    g.tries = tries;
    g.tol = 1e-12;
    coin_priv_coin c = coin_of(b, 0);
    const double moved = coin_priv_slide_flat(&c, &g, t);
    *b = body_of(&c);
    return moved;
}

static double slide(coin_body *b, double IZ, double mu, double t)
{
    return pulled(b, IZ, mu, level, t);
}

TEST(a_slide_is_that_of_friction_all_over_the_face)
{
    static struct table t;
    table_load(&t, "toss/flat_slides.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double IZ = table_at(&t, i, "I_Z"), mu = table_at(&t, i, "mu");
        const double v = table_at(&t, i, "v0"), w = table_at(&t, i, "w0");
        const double S = v + w, time = table_at(&t, i, "time");
        coin_body whole = flat(v, 0, w), half = whole;
        check_note("row %zu", i);
        const double when = slide(&whole, IZ, mu, INFINITY);
        check_near(when, time, EXACT * S / mu);
        check(whole.vx == 0 && whole.s.wZ == 0);
        check_near(whole.s.x, table_at(&t, i, "distance"), EXACT * S * S / mu);
        check_near(whole.s.psi, table_at(&t, i, "turn"), EXACT * S * S / mu);
        check(slide(&half, IZ, mu, time / 2) == time / 2);
        check_near(half.vx, table_at(&t, i, "v_half"), EXACT * S);
        check_near(half.s.wZ, table_at(&t, i, "w_half"), EXACT * S);
        check_near(half.s.x, table_at(&t, i, "distance_half"),
                   EXACT * S * S / mu);
        check_near(half.s.psi, table_at(&t, i, "turn_half"),
                   EXACT * S * S / mu);
    }
}

/* Path v^2/(2 mu), turn 3/8 w^2/mu of a disc and w^2/(2 mu) of a hoop. */
TEST(a_pure_slide_and_a_pure_turn_stay_pure)
{
    const double mu = 0.3;
    coin_body b = flat(2, 0, 0);
    check_near(slide(&b, 0.5, mu, INFINITY), 2 / mu, 16 * U * 7);
    check_near(b.s.x, 2 / mu, 16 * U * 7);
    check(b.s.psi == 0 && b.s.z == 0);
    b = flat(0, 0, -2);
    check_near(slide(&b, 0.5, mu, INFINITY), 0.75 * 2 / mu, 16 * U * 5);
    check_near(b.s.psi, -0.75 * 2 / mu, 16 * U * 5);
    check(b.s.x == 0 && b.s.z == 0);
    b = flat(0, 0, -2);
    check(slide(&b, 0.5, mu, 2) == 2);
    check_near(b.s.wZ, -2 + 2 * (4.0 / 3) * mu, 16 * U);
    b = flat(0, 0, 2);
    feclearexcept(FE_ALL_EXCEPT);
    check_near(slide(&b, 1, mu, INFINITY), 2 / mu, 16 * U * 7);
    check(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
}

/* For so long that rounding alone would turn it aside. */
TEST(a_long_slide_stays_straight)
{
    const double mu = 0.01, v = 3000, way = v * v / (2 * mu);
    for (double heading = 0; heading < 6; heading += 0.1) {
        coin_body b = flat(v, heading, 0);
        tries = 1;
        const double t = slide(&b, 0.5, mu, INFINITY);
        tries = 400;
        check_near(t, v / mu, 16 * U * v / mu);
        check_near(b.s.x, way * cos(heading), 8 * U * way);
        check_near(b.s.z, way * sin(heading), 8 * U * way);
    }
}

/* The torque on a ring that turns is 2/3 (1 + b + b^2)/(1 + b); that on a hoop
 * of the middle radius is larger by the part d^2/24 of it, b = 1 - d.  A slow
 * path is braked by v/(w (1 + b)), to the part (v/w)^2. */
TEST(a_ring_next_to_a_hoop_is_braked_as_a_ring)
{
    const double mu = 0.3, d = 4e-6, c = 1 - d, IZ = (1 + c * c) / 2;
    const double time = 2 * IZ / mu * 1.5 * (1 + c) / (1 + c + c * c);
    coin_body b = flat(0, 0, 2);
    check_near(slide(&b, IZ, mu, INFINITY), time, (d * d / 24 + 16 * U) * time);
    check_near(coin_priv_flat_drag(IZ, 1e-6, 1) * (1 + c), 1e-6,
               (d * d + 1e-12) * 1e-6);
}

static double energy(const coin_body *b, double IZ)
{
    return (b->vx * b->vx + b->vz * b->vz + IZ * (b->s.wZ * b->s.wZ)) / 2;
}

/* Rings of any width; v/w from 1e-6 to 1e6. */
TEST(slides_in_parts_end_together_and_never_gain)
{
    struct random r = random_begin(851);
    const int count = tries_asked(200);
    for (int i = 0; i < count; ++i) {
        const double b = 1 - pow(10, random_between(&r, -8, 0));
        const double IZ =
            i % 3 ? (1 + b * b) / 2 : random_between(&r, 0.1, 0.5);
        const double mu = random_between(&r, 0.1, 1);
        const double v = pow(10, random_between(&r, -3, 3));
        const double w = pow(10, random_between(&r, -3, 3)), S = v + w;
        const coin_body start = flat(v, random_between(&r, 0, 6), -w);
        coin_body whole = start, parts = start;
        const double when = slide(&whole, IZ, mu, INFINITY);
        double t = 0;
        check_note("seed 851, slide %d", i);
        for (int k = 0; k < 50 && (parts.vx != 0 || parts.s.wZ != 0); ++k) {
            const double E = energy(&parts, IZ);
            t += slide(&parts, IZ, mu, when / 20);
            check(energy(&parts, IZ) <= E * (1 + 4 * U));
        }
        check((whole.vx == 0) == (whole.s.wZ == 0));
        check(parts.vx == 0 && parts.vz == 0 && parts.s.wZ == 0);
        check_near(t, when, 1e-8 * S / mu);
        check_near(hypot(parts.s.x - whole.s.x, parts.s.z - whole.s.z), 0,
                   1e-8 * S * S / mu);
        check_near(parts.s.psi, whole.s.psi, 1e-8 * S * S / mu);
    }
}

TEST(a_slide_whose_trials_do_not_suffice_goes_on_in_the_next_call)
{
    coin_body whole = flat(1, 0.3, 2), parts = whole;
    const double when = slide(&whole, 0.5, 0.3, INFINITY);
    double t = 0;
    int calls = 0;
    for (tries = 5; parts.s.wZ != 0; ++calls)
        t += slide(&parts, 0.5, 0.3, INFINITY);
    tries = 400;
    check(calls > 4);
    check_near(t, when, EXACT * 3 / 0.3);
    check_near(parts.s.x, whole.s.x, EXACT * 9 / 0.3);
}

TEST(without_friction_it_goes_on)
{
    coin_body b = flat(2, 0, 3);
    check(slide(&b, 0.5, 0, 5) == 5);
    check(b.s.x == 10 && b.s.psi == 15 && b.vx == 2 && b.s.wZ == 3);
}

/* ---------------------------------------------------------- against a pull */
/* The friction and its torque on a disc that turns about a point at d > 0 from
 * its centre, over mu M g and mu M g a, by midpoints in the angle a about that
 * point: along a ray the friction has one direction. */
static void face(long double d, long double by[2])
{
    enum { RAYS = 200 };
    const long double pi = acosl(-1);
    by[0] = by[1] = 0;
    for (int i = 0; i < RAYS; ++i) {
        const long double a = pi * (i + 0.5L) / RAYS;
        const long double S = sinl(a), C = cosl(a);
        if (d < 1) {
            const long double r = d * C + sqrtl(1 - d * d * S * S);
            by[0] += C * r * r;
            by[1] += 2 * r * r * r / 3 - d * (C * r * r);
        } else { /* S/d is the sine of the angle about the point */
            const long double c = sqrtl(1 - S * S / (d * d)), f = 2 * c * C * C;
            by[0] += f;
            by[1] +=
                C * C * (6 * d * d * c * c + 2 * C * C) / (3 * d * c) - d * f;
        }
    }
    by[0] /= RAYS;
    by[1] /= RAYS;
}

/* What slides: a disc with a hole of radius b. */
struct scene {
    double b, mu, pull[2];
};

/* y: vx, vz, w, x, z, turn; w > 0. */
static void face_slopes(long double *d, const long double *y,
                        const struct scene *s)
{
    const long double v = sqrtl(y[0] * y[0] + y[1] * y[1]), b = s->b;
    long double out[2], in[2] = {0, 0};
    face(v / y[2], out);
    if (b > 0)
        face(v / (y[2] * b), in);
    const long double f = (out[0] - b * b * in[0]) / (1 - b * b);
    const long double t = (out[1] - b * b * b * in[1]) / (1 - b * b);
    d[0] = s->pull[0] - s->mu * f * y[0] / v;
    d[1] = s->pull[1] - s->mu * f * y[1] / v;
    d[2] = -s->mu * t * 2 / (1 + b * b);
    for (int i = 0; i < 3; ++i)
        d[3 + i] = y[i];
}

/* Moves by t in `count` steps of the textbook's method of order 4. */
static void integrate(long double *y, const struct scene *s, long double t,
                      int count)
{
    static const long double at[4] = {0, 0.5L, 0.5L, 1};
    static const long double weight[4] = {1, 2, 2, 1};
    const long double h = t / count;
    for (int n = 0; n < count; ++n) {
        long double d[6] = {0}, sum[6] = {0}, to[6];
        for (int k = 0; k < 4; ++k) {
            for (int i = 0; i < 6; ++i)
                to[i] = y[i] + at[k] * h * d[i];
            face_slopes(d, to, s);
            for (int i = 0; i < 6; ++i)
                sum[i] += weight[k] * d[i];
        }
        for (int i = 0; i < 6; ++i)
            y[i] += h / 6 * sum[i];
    }
}

/* Pulls below, between and above coefficients of 0.3 and 0.4; the last but one
 * turns the way back.  They are followed for 2.5 natural units, or for 0.9 of
 * their time.  FINE: three times what the integration errs by, by twice of its
 * steps. */
#define FINE 1e-9
TEST(a_slide_against_a_pull_is_that_of_friction_all_over_the_face)
{
    static const struct scene scenes[] = {
        {0, 0.3, {0.1, 0}},     {0, 0.3, {0.05, -0.2}}, {0.5, 0.3, {-0.1, 0.1}},
        {0, 0.3, {0.25, 0.25}}, {0.5, 0.3, {0, 0.35}},  {0, 0.3, {-0.8, 0.1}},
        {0.5, 0.3, {0.6, 0.8}},
    };
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        const struct scene *const s = &scenes[i];
        const double pull = hypot(s->pull[0], s->pull[1]);
        const double IZ = (1 + s->b * s->b) / 2;
        coin_body b = flat(1.2, 0.4, 1.5), end = b;
        double t = 2.5;
        check_note("scene %zu", i);
        if (pull < s->mu) {
            t = 0.9 * pulled(&end, IZ, s->mu, s->pull, INFINITY);
            check(end.vx == 0 && end.vz == 0 && end.s.wZ == 0);
        }
        long double y[6] = {b.vx, b.vz, b.s.wZ};
        integrate(y, s, t, 500);
        check(pulled(&b, IZ, s->mu, s->pull, t) == t);
        check_near(b.vx, (double)y[0], FINE);
        check_near(b.vz, (double)y[1], FINE);
        check_near(b.s.wZ, (double)y[2], FINE);
        check_near(b.s.x, (double)y[3], FINE);
        check_near(b.s.z, (double)y[4], FINE);
        check_near(b.s.psi, (double)y[5], FINE);
    }
}

/* Without turn, and with the pull along the way: v' = pull - mu. */
TEST(a_slide_straight_up_ends_or_comes_back)
{
    const double mu = 0.25, up[2] = {-0.125, 0}, down[2] = {0.5, 0};
    coin_body b = flat(2, 0, 0);
    check_near(pulled(&b, 0.5, mu, up, INFINITY), 2 / 0.375, 16 * U * 6);
    check(b.vx == 0 && b.vz == 0 && b.s.wZ == 0 && b.s.z == 0);
    check_near(b.s.x, 2 / 0.375, 16 * U * 6);
    b = flat(0, 0, 0);
    check(pulled(&b, 0.5, mu, down, 4) == 4);
    check_near(b.vx, 1, 16 * U);
    check_near(b.s.x, 2, 16 * U);
    check(b.vz == 0 && b.s.wZ == 0);
}

/* v sin(angle)/tan(angle/2)^(mu/pull) stays: the angle is that between the
 * way and the pull. */
TEST(a_slide_without_turn_bends_toward_the_pull)
{
    static const double pulls[] = {0.1, 0.35, 2};
    for (size_t i = 0; i < 3; ++i) {
        const double mu = 0.3, pull[2] = {pulls[i], 0};
        coin_body b = flat(1.5, 2, 0);
        double first = 0;
        for (int k = 0; k < 4; ++k) {
            const double v = hypot(b.vx, b.vz), angle = atan2(b.vz, b.vx);
            const double I =
                v * sin(angle) / pow(tan(angle / 2), mu / pulls[i]);
            first = k ? first : I;
            check_note("pull %g, time %d", pulls[i], k);
            check_near(I, first, 1e-10);
            check(pulled(&b, 0.5, mu, pull, 0.8) == 0.8);
        }
        check(b.s.wZ == 0);
    }
}

/* Below mu both speeds end; E - pull.r falls in each part of any slide. */
TEST(slides_against_any_pull_lose_energy_and_end_below_mu)
{
    struct random r = random_begin(852);
    const int count = tries_asked(100);
    int ended = 0;
    for (int i = 0; i < count; ++i) {
        const double c = random_between(&r, 0, 0.999), IZ = (1 + c * c) / 2;
        const double mu = random_between(&r, 0.1, 1);
        const double size = mu * random_between(&r, 0, 2);
        const double way = random_between(&r, 0, 6.3);
        const double pull[2] = {size * cos(way), size * sin(way)};
        const double v = pow(10, random_between(&r, -3, 1));
        const double w = pow(10, random_between(&r, -3, 1));
        coin_body b = flat(v, 0, w);
        check_note("seed 852, slide %d", i);
        for (int k = 0; k < 20; ++k) {
            const coin_body was = b;
            (void)pulled(&b, IZ, mu, pull, (v + w) / mu / 20);
            const double gained = energy(&b, IZ) - energy(&was, IZ);
            const double fell =
                pull[0] * (b.s.x - was.s.x) + pull[1] * (b.s.z - was.s.z);
            check(gained <= fell + 1e-10 * (v + w) * (v + w));
            if (b.vx == 0 && b.vz == 0 && b.s.wZ == 0)
                break;
        }
        if (size < 0.95 * mu) {
            (void)pulled(&b, IZ, mu, pull, INFINITY);
            check(b.vx == 0 && b.vz == 0 && b.s.wZ == 0);
            ++ended;
        }
    }
    check(ended > 0 && ended < count);
}

/* Two slides of one coin at most keep their distance, in the norm of the
 * energy: (113). */
TEST(slides_come_closer_to_each_other)
{
    struct random r = random_begin(853);
    const int count = tries_asked(100);
    for (int i = 0; i < count; ++i) {
        const double mu = random_between(&r, 0.1, 1), pull[2] = {0.2, -0.1};
        const double IZ = random_between(&r, 0.3, 0.99);
        coin_body a = flat(random_between(&r, 0, 2), random_between(&r, 0, 6),
                           random_between(&r, -2, 2));
        coin_body b = flat(random_between(&r, 0, 2), random_between(&r, 0, 6),
                           random_between(&r, -2, 2));
        double apart = INFINITY;
        check_note("seed 853, slide %d", i);
        for (int k = 0; k < 5; ++k) {
            const coin_body d = {
                .s.wZ = a.s.wZ - b.s.wZ, .vx = a.vx - b.vx, .vz = a.vz - b.vz};
            const double now = sqrt(2 * energy(&d, IZ));
            check(now <= apart + 1e-10);
            apart = now;
            (void)pulled(&a, IZ, mu, pull, 0.3);
            (void)pulled(&b, IZ, mu, pull, 0.3);
        }
    }
}

static const double a = 0.012, g = 9.81, M = 0.006;

static coin_body at_rest_on_its_face(void)
{
    coin_body b = {.s = {.theta = LAST_LEAN, .phi = 1}};
    b.y = a * cos(LAST_LEAN);
    return b;
}

TEST(a_coin_at_rest_on_its_face_slides_where_the_pull_exceeds_mu_static)
{
    coin_params p;
    check_status(coin_params_disc(&p, M, a, g), COIN_OK);
    for (int over = 0; over < 2; ++over) {
        const double pull = over ? 0.41 * g : 0.39 * g, c = 0.6, s = 0.8;
        const coin_table f = {
            .mu_static = 0.4, .mu_kinetic = 0.3, .pull = {pull * c, pull * s}};
        const double slope = over ? pull - 0.3 * g : 0, t = 0.5;
        const double hold = over ? 0.3 * g : pull;
        coin_body b = at_rest_on_its_face();
        double moved;
        coin_force force;
        check_note("over %d", over);
        check_status(coin_body_reaction(&b, &p, &f, &force), COIN_OK);
        check_near(force.R[0], -M * hold * c, 8 * U * M * g);
        check_near(force.R[2], -M * hold * s, 8 * U * M * g);
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, &moved),
                     over ? COIN_SLIPS : COIN_RESTS);
        check_status(coin_move(&b, &p, &f, t, 1e-9, 0, &moved),
                     over ? COIN_SLIPS : COIN_RESTS);
        check(moved == (over ? t : 0));
        check_near(b.vx, slope * c * t, 16 * U);
        check_near(b.vz, slope * s * t, 16 * U);
        check_near(b.s.x, slope * c * t * t / 2, 16 * U);
        check_near(b.s.z, slope * s * t * t / 2, 16 * U);
        check(b.s.wZ == 0);
    }
}

/* It slides up, stops, and comes back, in one call and in many. */
TEST(a_coin_that_slides_up_comes_back_where_nothing_holds_it)
{
    const coin_table f = {
        .mu_static = 0.3, .mu_kinetic = 0.25, .pull = {0.5 * g, 0}};
    const double up = 1 / (0.75 * g), path = up / 2;
    const double back = 1 - up, there = 0.125 * g * back * back - path;
    coin_params p;
    check_status(coin_params_disc(&p, M, a, g), COIN_OK);
    for (int parts = 1; parts < 40; parts += 19) {
        coin_body b = at_rest_on_its_face();
        b.vx = -1;
        for (int k = 0; k < parts; ++k)
            check_status(coin_move(&b, &p, &f, 1.0 / parts, 1e-9, 0, NULL),
                         COIN_SLIPS);
        check_near(b.vx, 0.25 * g * back, 1e-13);
        check_near(b.s.x, there, 1e-13);
    }
}

TEST(a_slide_that_never_ends_leaves_the_range)
{
    const coin_table f = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .pull = {0.1 * g, 0.3 * g}};
    coin_params p;
    double moved = 0;
    check_status(coin_params_disc(&p, M, a, g), COIN_OK);
    coin_body b = at_rest_on_its_face();
    b.vx = 0.5;
    b.s.wZ = 20;
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, 0, &moved), COIN_ERANGE);
    check(moved > 100 && isfinite(moved) && b.vz > 10);
    const coin_body last = b;
    check_status(coin_move(&b, &p, &f, 0, 1e-6, 0, &moved), COIN_SLIPS);
    check_same(&b, &last, sizeof b);
}
