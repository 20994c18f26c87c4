/* SPDX-License-Identifier: MIT */
/* The slopes of a coin that slips, against Euler's equations. */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include "contact.h"

#include <math.h>

/* A coin of M = a = g = 1 with a moment of spin, on a table. */
static coin_priv_contact table_for(const coin_params *p, double spin)
{
    const coin_friction f = {0.55, 0.5};
    const coin_losses l = {.spin = spin};
    coin_priv_contact t;
    check_status(coin_priv_contact_of(&t, p, &f, &l), COIN_OK);
    return t;
}

static coin_priv_slip random_slip(struct random *r, double lean)
{
    const coin_priv_slip y = {
        .wX = random_between(r, -1, 1),
        .wY = random_between(r, -1, 1),
        .wZ = random_between(r, -1, 1),
        .sth = sin(lean),
        .cth = cos(lean),
        .uX = random_between(r, -1, 1),
        .uh = random_between(r, -1, 1),
        .cph = 1,
    };
    return y;
}

/* Euler's equations of the body whose axes are e_X, e_Y, e_Z: they turn with it
 * where psi' = 0.  Torques are those of the force at -e_Y, of spin about the
 * vertical c e_Y - s e_Z, and one along tan(theta) e_Y + e_Z, of any size,
 * which holds psi' = 0 and has no part about the vertical. */
static void a_held_contact_turns_as_euler_says(void **unused)
{
    (void)unused;
    struct random r = random_begin(221);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double IX = p.inertia_X, IZ = p.inertia_Z;
        const double spin = random_between(&r, 0, 0.1);
        const double side = i % 2 ? 1 : -1;
        coin_priv_contact t = table_for(&p, spin);
        coin_priv_slip y = random_slip(&r, side * random_between(&r, 1, 1.57));
        const double s = y.sth, c = y.cth, turn = random_between(&r, -1, 1);
        coin_priv_slip d;
        y.wY = c * turn;
        y.wZ = -s * turn;
        t.psi_held = 1;
        const double u = hypot(y.uX, y.uh);
        const coin_priv_direction n = {y.uX / u, y.uh / u};
        const coin_priv_push F = coin_priv_kinetic(&t, &y, n);
        coin_priv_slopes_under(&d, &t, &y, &F);
        check_note("case %d", i);
        check_near(-s * d.wX - c * y.wX * y.wX, F.N - 1, 64 * U);
        check_near(IX * d.wX - (IX - IZ) * y.wY * y.wZ, F.N * s - F.h * c,
                   64 * U);
        check_near(c * (IX * d.wY - (IZ - IX) * y.wZ * y.wX) - s * IZ * d.wZ,
                   -s * F.X - spin * turn, 64 * U);
        check_near(c * d.wZ + s * d.wY + y.wX * (c * y.wY - s * y.wZ), 0,
                   64 * U);
        check(d.psi == 0 && d.t == 1);
        check_near(d.phi, turn, 4 * U);
    }
}

/* (83): dt = cos(theta) u/(u + sqrt(g a)) dsigma, so that the direction, which
 * relaxes as 1/u in time, has a bounded slope. */
static void slopes_of_a_slip_are_bounded_however_slow_it_is(void **unused)
{
    (void)unused;
    struct random r = random_begin(222);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_priv_contact t = table_for(&p, 0);
        const double size = pow(10, -i / 8);
        coin_priv_slip y = random_slip(&r, random_between(&r, -1.2, 1.2)), d;
        y.uX *= size;
        y.uh *= size;
        const double u = hypot(y.uX, y.uh);
        coin_priv_slip_slopes((double *)&d, (const double *)&y, &t);
        check_near(d.t / (y.cth * u / (u + 1)), 1, 8 * U);
        /* A force is below 10, and moves the slip of a disc 5 times as much;
         * the turn of the frame is below 10. */
        check(fabs(y.uX * d.uh - y.uh * d.uX) < 100 * u * u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_held_contact_turns_as_euler_says),
        TEST(slopes_of_a_slip_are_bounded_however_slow_it_is),
    };
    return RUN_TESTS(tests);
}
