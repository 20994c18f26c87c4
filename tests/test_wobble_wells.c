/* SPDX-License-Identifier: MIT */
/* A steady motion lies in a well of the potential, Eq. (48).  Where
 * coin_wobble_at() gives an answer the coin stays in that well. */
#include "support/check.h"

#include <math.h>

/* A circle whose potential has a barrier next to it: the unstable circle of
 * the same integrals, which is where both circles of one wZ come from as
 * lambda^2 leaves 0. */
static coin_params narrow_body(void)
{
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 0.05, 0.1), COIN_OK);
    return p;
}

/* The first wZ from `wZ` on in steps of a part in 1e4 with lambda^2 < L. */
static coin_state narrow_well(const coin_params *p, double L)
{
    coin_state s;
    double lambda2 = 1, wZ = 0.3;
    for (; lambda2 >= L; wZ *= 1.0001) {
        check_status(coin_steady_circle(&s, p, 0.15, wZ, 1), COIN_OK);
        check_status(coin_stability(&s, p, &lambda2), COIN_OK);
    }
    check_near(lambda2, L, 0.01);
    return s;
}

/* How far the lean of a start comes from that of the steady motion in 200
 * units, by the full equations. */
static double excursion(const coin_state *steady, const coin_params *p,
                        coin_state s)
{
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
        check_status(coin_advance(&s, p, 0.1, 1e-10, NULL), COIN_OK);
        most = fmax(most, fabs(s.theta - steady->theta));
    }
    return most;
}

/* Pushes of growing strength: as soon as the full motion leaves the well, and
 * before it, the answer is refused. */
static void what_leaves_the_well_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = narrow_body();
    const double depths[] = {-0.003, -0.03, -0.3};
    int left = 0, kept = 0;
    for (size_t i = 0; i < sizeof depths / sizeof *depths; ++i) {
        const coin_state steady = narrow_well(&p, depths[i]);
        for (double A = 1e-6; A < 0.5; A *= 2) {
            coin_state start = steady, out;
            start.wX = A;
            const double swing = A / sqrt(-depths[i]);
            const int32_t status =
                coin_wobble_at(&steady, &p, &start, 200, &out);
            const double far = excursion(&steady, &p, start);
            check_note("lambda^2 = %g, wX = %g: %g of the swing", depths[i], A,
                       far / swing);
            if (status == COIN_OK)
                check_within(far / swing, 0.7, 1.4);
            kept += status == COIN_OK;
            left += far > 3 * swing;
        }
    }
    check(kept > 12 && left > 0);
}

/* Found by a search: what the linear law leaves out at the beginning has grown
 * as the lean has.  By the full equations the coin is near the table. */
static void what_has_grown_from_a_small_error_is_refused(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 0x1.596b8ebe1100ep-3,
                                  0x1.4489627f1c4f5p-2),
                 COIN_OK);
    const coin_state spin = {0, 0, 0, 0, 0, 0, 0x1.779c1859aee58p-5, 0};
    const coin_state start = {-0x1.dff4cadcbc49ap-6,
                              0,
                              0,
                              0,
                              0,
                              -0x1.af93acb8bd93ep-6,
                              0x1.d1aada33c223fp-4,
                              -0x1.59099e86df6e6p-4};
    coin_state out = start;
    check_status(coin_wobble_at(&spin, &p, &start, -0x1.95b7356ee7e77p+2, &out),
                 COIN_EDOMAIN);
    check_same(&out, &start, sizeof out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(what_leaves_the_well_is_refused),
        TEST(what_has_grown_from_a_small_error_is_refused),
    };
    return RUN_TESTS(tests);
}
