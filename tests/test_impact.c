/* SPDX-License-Identifier: MIT */
/* An impact, against the 9 x 9 system of Newton and Euler, and by what no
 * impact may do. */
#include "support/check.h"
#include "support/thrown.h"

#include <math.h>

static void hit(coin_body *b, double IX, double IZ, const coin_priv_bounce *law)
{
    coin_priv_coin c = coin_of(b, 0);
    coin_priv_impact(&c, 0, IX, IZ, law);
    b->s.wX = c.wX;
    b->s.wY = c.wY;
    b->s.wZ = c.wZ;
    b->vx = c.vx;
    b->vy = c.vy;
    b->vz = c.vz;
}

TEST(an_impact_is_that_of_newton_and_euler)
{
    static struct table t;
    table_load(&t, "toss/impacts.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        coin_body b = body_in_row(&t, i, "");
        const coin_priv_bounce law = {table_at(&t, i, "e"),
                                      table_at(&t, i, "mu_static"),
                                      table_at(&t, i, "mu_kinetic")};
        hit(&b, table_at(&t, i, "I_X"), table_at(&t, i, "I_Z"), &law);
        const double got[] = {b.s.wX, b.s.wY, b.s.wZ, b.vx, b.vy, b.vz};
        static const char *const names[] = {"wX1", "wY1", "wZ1",
                                            "vx1", "vy1", "vz1"};
        check_note("row %zu", i);
        for (int k = 0; k < 6; ++k)
            check_near(got[k], table_at(&t, i, names[k]), 1e-14);
    }
}

static double energy(const coin_body *b, double IX, double IZ)
{
    const coin_state *s = &b->s;
    return (b->vx * b->vx + b->vy * b->vy + b->vz * b->vz +
            IX * (s->wX * s->wX + s->wY * s->wY) + IZ * s->wZ * s->wZ) /
           2;
}

/* The velocity of the lowest point along e_X and e_h. */
static void rim(const coin_body *b, double u[2])
{
    const double s = sin(b->s.phi), c = cos(b->s.phi);
    u[0] = b->vx * c - b->vz * s + b->s.wZ;
    u[1] = b->vx * s + b->vz * c - b->s.wX * cos(b->s.theta);
}

/* The angular momentum about the lowest point along e_X, e_Y, e_Z: I omega + r
 * x v, r = e_Y. */
static void momentum(const coin_body *b, double IX, double IZ, double L[3])
{
    const double sp = sin(b->s.phi), cp = cos(b->s.phi);
    const double s = sin(b->s.theta), c = cos(b->s.theta);
    const double along = b->vx * sp + b->vz * cp;
    L[0] = IX * b->s.wX + (c * along - s * b->vy);
    L[1] = IX * b->s.wY;
    L[2] = IZ * b->s.wZ - (b->vx * cp - b->vz * sp);
}

/* A body just before an impact. */
static coin_body falling(struct random *r, double *speed)
{
    coin_body b = random_throw(r, 0, pow(10, random_between(r, -2, 2)));
    if (random_between(r, 0, 1) < 0.3)
        b.s.theta = copysign(
            1.5707963267948966 - pow(10, random_between(r, -15, 0)), b.s.theta);
    b.y = cos(b.s.theta);
    *speed = pow(10, random_between(r, -4, 1));
    b.vy = -*speed - b.s.wX * sin(b.s.theta);
    return b;
}

TEST(no_impact_gains_energy_or_turns_about_its_contact)
{
    struct random r = random_begin(841);
    const int count = tries_asked(125000);
    int stuck = 0;
    for (int i = 0; i < count; ++i) {
        const double IX = pow(10, random_between(&r, -3, 3));
        const double IZ = IX * random_between(&r, 1e-3, 2);
        const double bound = 2 * sqrt(IX * (1 + IX));
        const double mu = random_between(&r, 0, fmin(bound, 3));
        const coin_priv_bounce law = {random_between(&r, 0, 1),
                                      i % 5 ? mu * 1.2 : INFINITY, mu};
        double down, u[2], L[3], kept[3];
        const coin_body b = falling(&r, &down);
        coin_body to = b;
        hit(&to, IX, IZ, &law);
        const double E = energy(&b, IX, IZ);
        const double fast = 1 + fabs(b.s.wX) + fabs(b.s.wZ) + fabs(b.vx) +
                            fabs(b.vy) + fabs(b.vz);
        check_note("seed 841, impact %d, e %g, mu %g", i, law.restitution, mu);
        check(energy(&to, IX, IZ) <= E * (1 + 16 * U));
        const coin_priv_coin after = coin_of(&to, 0);
        check_near(coin_priv_rim_of(&after, 0).y, law.restitution * down,
                   64 * U * fast * (1 + 1 / IX));
        momentum(&b, IX, IZ, L);
        momentum(&to, IX, IZ, kept);
        for (int k = 0; k < 3; ++k)
            check_near(kept[k], L[k], 64 * U * fast * (1 + IX));
        check(to.s.wY == b.s.wY && to.s.x == b.s.x && to.y == b.y);
        /* the impulse lies in the cone of static friction */
        const double p = to.vy - b.vy;
        const double slides = hypot(to.vx - b.vx, to.vz - b.vz);
        const double rounding = 64 * U * fast * (1 + 1 / IX);
        check(isinf(law.mu_static) ||
              slides <= law.mu_static * (p + rounding) + rounding);
        rim(&to, u);
        stuck += i % 5 == 0;
    }
    check(stuck > 0);
}

/* The lowest point comes to rest: the velocities of rolling with the angular
 * momentum about the contact. */
TEST(one_that_neither_slips_nor_bounces_rolls)
{
    struct random r = random_begin(842);
    const coin_priv_bounce law = {0, INFINITY, 0.3};
    for (int i = 0; i < 5000; ++i) {
        const coin_params p = random_body(&r);
        const double IX = p.inertia_X, IZ = p.inertia_Z;
        double down, v[3], R[9];
        coin_body b = falling(&r, &down);
        const coin_body before = b;
        if (cos(b.s.theta) < 0.07)
            continue;
        hit(&b, IX, IZ, &law);
        check_status(coin_axes(&before.s, R), COIN_OK);
        const double vX = before.vx * R[0] + before.vz * R[2];
        const double vZ =
            before.vx * R[6] + before.vy * R[7] + before.vz * R[8];
        const double size = 1 + 20 * (1 + fabs(before.s.wX) +
                                      fabs(before.s.wZ) + fabs(before.vy));
        check_note("seed 842, impact %d", i);
        check_near(b.s.wX, before.s.wX + (vZ - before.s.wX) / (1 + IX),
                   16 * U * size / IX);
        check_near(b.s.wZ, before.s.wZ - (vX + before.s.wZ) / (1 + IZ),
                   16 * U * size / IX);
        check_status(coin_velocity(&b.s, &p, v), COIN_OK);
        check_near(b.vx, v[0], 16 * U * size / IX);
        check_near(b.vy, v[1], 2 * U * fabs(b.s.wX));
        check_near(b.vz, v[2], 16 * U * size / IX);
    }
}
