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

static double slide(coin_body *b, double IZ, double mu, double t)
{
    static coin_priv_moving g;
    g.law.IZ = IZ;
    g.law.mu_kinetic = mu;
    g.tries = tries;
    return coin_priv_slide_flat(b, &g, t);
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
