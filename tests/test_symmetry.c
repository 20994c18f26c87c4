/* SPDX-License-Identifier: MIT */
/* The symmetries of the motion, by every method.  Those that only change signs
 * or scale by powers of two hold bit for bit, because every operation of a step
 * has the same symmetry. */
#include "support/check.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>

enum { SCENES_TRIED = 200, STEPS = 50 };

/* In natural units. */
#define DT (1.0 / 40)

/* The symplectic methods' limits are a quarter of RK4's. */
static coin_state after(coin_state s, const coin_params *p, int32_t method,
                        double dt)
{
    const double h = method < COIN_SYMPLECTIC2 ? dt : dt / 4;
    check(coin_run(&s, p, method, h, STEPS, NULL) >= 0);
    return s;
}

/* Not only rings: any two moments of inertia that a body may have. */
static coin_params random_body(struct random *r)
{
    coin_params p = random_coin(r);
    p.inertia_X *= random_between(r, 0.5, 3);
    p.inertia_Z = p.inertia_X * random_between(r, 0.1, 2);
    check_status(coin_params_check(&p), COIN_OK);
    return p;
}

/* Equal as numbers: 0 and -0 are. */
static void check_equal(const coin_state *got, const coin_state *want)
{
    check(got->theta == want->theta);
    check(got->phi == want->phi);
    check(got->psi == want->psi);
    check(got->x == want->x);
    check(got->z == want->z);
    check(got->wX == want->wX);
    check(got->wY == want->wY);
    check(got->wZ == want->wZ);
}

/* The signs that a symmetry gives to each member, and to time. */
struct signs {
    double theta, phi, psi, x, z, wX, wY, wZ, t;
};

static coin_state with_signs(const coin_state *s, const struct signs *f)
{
    const coin_state r = {
        f->theta * s->theta, f->phi * s->phi, f->psi * s->psi, f->x * s->x,
        f->z * s->z,         f->wX * s->wX,   f->wY * s->wY,   f->wZ * s->wZ,
    };
    return r;
}

static void check_signs(uint64_t seed, const struct signs *f)
{
    struct random r = random_begin(seed);
    for (int i = 0; i < SCENES_TRIED; ++i) {
        const coin_params p = random_body(&r);
        const coin_state s = random_motion(&r, &p, DT, STEPS);
        const double dt = DT * natural_time(&p);
        const coin_state end = after(s, &p, i % METHODS, dt);
        const coin_state want = with_signs(&end, f);
        const coin_state got =
            after(with_signs(&s, f), &p, i % METHODS, f->t * dt);
        check_equal(&got, &want);
    }
}

TEST(time_reversed_a_motion_runs_back)
{
    const struct signs all_rates = {1, 1, 1, 1, 1, -1, -1, -1, -1};
    const struct signs tilt_alone = {1, -1, -1, -1, 1, -1, 1, 1, -1};
    check_signs(36, &all_rates);
    check_signs(37, &tilt_alone);
}

TEST(mirrored_a_motion_is_a_motion)
{
    const struct signs lean_and_roll = {-1, 1, -1, -1, -1, -1, 1, -1, 1};
    const struct signs heading = {1, -1, -1, -1, 1, 1, -1, -1, 1};
    check_signs(38, &lean_and_roll);
    check_signs(39, &heading);
}

/* Turned by alpha about the vertical, and moved: the path turns with it.  The
 * numbers differ by rounding, amplified along the way by less than 100. */
TEST(turned_and_moved_a_motion_is_the_same)
{
    struct random r = random_begin(41);
    for (int i = 0; i < SCENES_TRIED; ++i) {
        const coin_params p = random_body(&r);
        coin_state s = random_motion(&r, &p, DT, STEPS);
        const double dt = DT * natural_time(&p), a = p.radius;
        const double alpha = random_between(&r, -3, 3);
        coin_state t = s;
        s.x = s.z = 0;
        t.phi += alpha;
        const double x0 = t.x, z0 = t.z;
        s = after(s, &p, i % METHODS, dt);
        t = after(t, &p, i % METHODS, dt);
        const double bound = 100 * STEPS * U;
        check_near(t.theta, s.theta, bound);
        check_near(t.phi - alpha, s.phi, bound);
        check_near(t.psi, s.psi, bound);
        check_near(t.x - x0, s.x * cos(alpha) + s.z * sin(alpha), bound * a);
        check_near(t.z - z0, s.z * cos(alpha) - s.x * sin(alpha), bound * a);
        check(t.wX == s.wX && t.wY == s.wY && t.wZ == s.wZ);
    }
}

/* ------------------------------------------------------------------- units */
struct units {
    double mass, length, time;
};

static coin_params params_in(const coin_params *p, const struct units *u)
{
    const double inertia = u->mass * u->length * u->length;
    const coin_params r = {
        p->mass * u->mass,
        p->radius * u->length,
        p->gravity * (u->length / (u->time * u->time)),
        p->inertia_X * inertia,
        p->inertia_Z * inertia,
        0,
        {0, 0},
    };
    return r;
}

static coin_state state_in(const coin_state *s, const struct units *u)
{
    const coin_state r = {
        s->theta,         s->phi,          s->psi,          s->x * u->length,
        s->z * u->length, s->wX / u->time, s->wY / u->time, s->wZ / u->time,
    };
    return r;
}

TEST(in_units_a_power_of_two_apart_every_bit_is_the_same)
{
    const struct units all[] = {
        {0x1p20, 1, 1},
        {1, 0x1p-30, 1},
        {1, 1, 0x1p12},
        {0x1p-9, 0x1p7, 0x1p-5},
        {0x1p30, 0x1p-30, 0x1p-15},
    };
    struct random r = random_begin(42);
    for (int i = 0; i < SCENES_TRIED; ++i) {
        const struct units *u = &all[i / METHODS % 5];
        const coin_params p = random_body(&r), q = params_in(&p, u);
        const coin_state s = random_motion(&r, &p, DT, STEPS);
        const double dt = DT * natural_time(&p);
        const coin_state end = after(s, &p, i % METHODS, dt),
                         want = state_in(&end, u);
        const coin_state got =
            after(state_in(&s, u), &q, i % METHODS, dt * u->time);
        check_equal(&got, &want);
        const double force = u->mass * u->length / (u->time * u->time);
        coin_force here, there;
        check_status(coin_reaction(&end, &p, &here), COIN_OK);
        check_status(coin_reaction(&want, &q, &there), COIN_OK);
        check(there.normal == here.normal * force);
        check(there.ratio == here.ratio);
        check(coin_energy(&want, &q) ==
              coin_energy(&end, &p) * force * u->length);
    }
}
