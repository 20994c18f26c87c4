/* SPDX-License-Identifier: MIT */
/* No step of a rolling coin leaves the cone of friction unseen. */
#include "cone.h"

#include "support/check.h"
#include "support/coins.h"
#include "support/slides.h"

#include <math.h>
#include <stdio.h>

/* The largest F/N of a rolling coin within a time, where it is; 0 if N <= 0
 * before, or if the largest is at an end.  By short steps, then by thirds. */
static double largest_ratio(const coin_state *start, const coin_params *p,
                            double t, double *when)
{
    enum { LOOKS = 400 };
    coin_state s = *start, best = *start;
    coin_force f;
    double most = 0;
    int at = 0;
    for (int i = 0; i <= LOOKS; ++i) {
        coin_reaction(&s, p, &f);
        if (isinf(f.ratio))
            return 0;
        if (f.ratio > most) {
            most = f.ratio;
            at = i;
        }
        if (coin_advance(&s, p, t / LOOKS, 1e-13, NULL) != COIN_OK)
            return 0;
    }
    if (at == 0 || at == LOOKS)
        return 0;
    double low = (at - 1) * t / LOOKS, high = (at + 1) * t / LOOKS;
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3;
        double ratio[2];
        for (int k = 0; k < 2; ++k) {
            best = *start;
            coin_advance(&best, p, low + (k + 1) * third, 1e-13, NULL);
            coin_reaction(&best, p, &f);
            ratio[k] = f.ratio;
        }
        if (ratio[0] < ratio[1])
            low += third;
        else
            high -= third;
        most = fmax(most, fmax(ratio[0], ratio[1]));
    }
    *when = low;
    return most;
}

/* Their largest F/N lies where the interpolation of a step misses it: by more
 * than a millionth of it in cone.c at tol = 1e-7, and by 1e-4 of it in
 * cone_by_ends.c at tol = 1e-9. */
static const coin_state missed[] = {
    {.theta = -0.31780486523710139,
     .wX = -0.91812444742281762,
     .wY = 0.4796022495986918,
     .wZ = -0.78394759095349276},
    {.theta = -0.022350328805363917,
     .wX = -0.30737023316950385,
     .wY = 0.10902287667631105,
     .wZ = 1.8179989668970493},
};
enum { MISSED = sizeof missed / sizeof *missed };

/* With mu_static a millionth below the largest F/N of the motion it slips, with
 * one a millionth above it does not; and by tol more, as the motion may err. */
static void a_millionth_above_the_cone_is_found_wherever_it_lies(void **unused)
{
    (void)unused;
    const double tols[] = {1e-2, 1e-4, 1e-7, 1e-9};
    const int count = tries_asked(12);
    struct random r = random_begin(181);
    int found = 0, tries = 0;
    while (found < count && ++tries < 20 * count) {
        const int named = tries <= MISSED;
        const coin_params p = named || tries % 2 ? disc() : ring(0.9);
        const coin_state s =
            named ? missed[tries - 1] : random_state(&r, &p, 1.2);
        const double t = 4;
        double when;
        const double most = largest_ratio(&s, &p, t, &when);
        if (!(most > 0.01 && most < 1))
            continue;
        ++found;
        for (int k = 0; k < 4; ++k) {
            coin_friction f = {most * (1 - 1e-6 - tols[k]), most / 2};
            coin_slide e;
            coin_slide_of(&e, &s, &p);
            const double E = coin_slide_energy(&e, &p);
            check_note("motion %d, tol %g, F/N %g at %g", tries, tols[k], most,
                       when);
            check_slips(&p, &s, &f, t, tols[k]);
            f.mu_static = most * (1 + 1e-6 + tols[k]);
            check_status(coin_slide_advance(&e, &p, &f, NULL, t, tols[k], NULL),
                         COIN_OK);
            check_near(coin_slide_energy(&e, &p), E, 10 * tols[k]);
        }
    }
    check(found == count);
}

/* A slip that begins grows against its friction, (84): its acceleration by
 * Newton and Euler, of bodies down to a 1,000th of a hoop's inertia. */
static void a_slip_begins_where_its_friction_lets_it_grow(void **unused)
{
    (void)unused;
    struct random r = random_begin(182);
    int began = 0;
    for (int i = 0; i < 30000; ++i) {
        const double k = pow(10, random_between(&r, -3, 0));
        coin_params p;
        coin_force f;
        coin_slide d;
        check_status(
            coin_params_body(&p, 1, 1, 1, k, k * random_between(&r, 0.2, 1.9)),
            COIN_OK);
        const double bound = 2 * sqrt(k * (1 + k));
        const double mu = bound * random_between(&r, 0, 0.9);
        const coin_friction equal = {mu, mu};
        const coin_state s = random_state(&r, &p, 1.4);
        coin_slide_of(&d, &s, &p);
        check_status(coin_slide_reaction(&d, &p, &equal, NULL, &f), COIN_OK);
        if (coin_slide_advance(&d, &p, &equal, NULL, 0, 1e-9, NULL) !=
                COIN_SLIPS ||
            !(f.normal > 0))
            continue;
        const double sth = sin(s.theta), cth = cos(s.theta);
        const double sph = sin(s.phi), cph = cos(s.phi);
        const double FX = f.R[0] * cph - f.R[2] * sph;
        const double Fh = f.R[0] * sph + f.R[2] * cph;
        const double turn = s.wY / cth;
        const double dwX =
            (f.normal * sth - Fh * cth -
             s.wY * (p.inertia_Z * s.wZ + p.inertia_X * s.wY * sth / cth)) /
            p.inertia_X;
        const double uX = FX - turn * cth * s.wX + FX / p.inertia_Z;
        const double uh = Fh - turn * s.wZ + sth * s.wX * s.wX - cth * dwX;
        const double size = hypot(uX, uh) * hypot(FX, Fh);
        const double terms = hypot(FX, Fh) * (1 + fabs(turn)) * (9 + 9 / k);
        check_note("body %d", i);
        check_near(uX * Fh - uh * FX, 0, 1e-9 * size + 64 * U * terms);
        check(uX * FX + uh * Fh < 64 * U * terms);
        ++began;
    }
    check(began > 9000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_slip_begins_where_its_friction_lets_it_grow),
        TEST(a_millionth_above_the_cone_is_found_wherever_it_lies),
    };
    return RUN_TESTS(tests);
}
