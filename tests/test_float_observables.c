/* SPDX-License-Identifier: MIT */
/* The functions of coinf.h that observe a state, against those of coin.h. */
#include "support/check.h"
#include "support/floats.h"
#include "support/random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { VALUES = 16, INPUTS = 13, TRIED = 400 };

/* A function in both precisions; each returns how many numbers it wrote. */
struct pair {
    const char *name;
    int (*exact)(double out[VALUES], const coin_state *, const coin_params *);
    int (*tried)(float out[VALUES], const coinf_state *, const coinf_params *);
};

#define ONE(prefix, number, name, count, ...)                                  \
    static int prefix##name(number out[VALUES], const prefix##state *s,        \
                            const prefix##params *p)                           \
    {                                                                          \
        (void)p;                                                               \
        __VA_ARGS__;                                                           \
        return count;                                                          \
    }
#define PAIR(name, count, arguments)                                           \
    ONE(coin_, double, values_of_##name, count,                                \
        check_status(coin_##name arguments, COIN_OK))                          \
    ONE(coinf_, float, values_of_##name, count,                                \
        check_status(coinf_##name arguments, COIN_OK))
#define NUMBER(name)                                                           \
    ONE(coin_, double, values_of_##name, 1, out[0] = coin_##name(s, p))        \
    ONE(coinf_, float, values_of_##name, 1, out[0] = coinf_##name(s, p))

NUMBER(energy)
NUMBER(fastest_rate)
PAIR(integrals, 2, (s, p, out))
PAIR(reaction, 5, (s, p, (void *)out))
PAIR(rates, 8, (s, p, (void *)out))
PAIR(center, 3, (s, p, out))
PAIR(velocity, 3, (s, p, out))
PAIR(contact, 6, (s, p, out, out + 3))
PAIR(axes, 9, (s, out))
PAIR(quaternion, 4, (s, out))
PAIR(angular_velocity, 3, (s, out))

#define ROW(name)                                                              \
    {                                                                          \
#name, coin_values_of_##name, coinf_values_of_##name                   \
    }
static const struct pair pairs[] = {
    ROW(energy), ROW(fastest_rate), ROW(integrals),        ROW(reaction),
    ROW(rates),  ROW(center),       ROW(velocity),         ROW(contact),
    ROW(axes),   ROW(quaternion),   ROW(angular_velocity),
};

/* The inputs, one changed by a part of it. */
static void change(coin_state *s, coin_params *p, size_t input, double part)
{
    double *const all[INPUTS] = {
        &s->theta,   &s->phi,       &s->psi,       &s->x,    &s->z,
        &s->wX,      &s->wY,        &s->wZ,        &p->mass, &p->radius,
        &p->gravity, &p->inertia_X, &p->inertia_Z,
    };
    *all[input] *= 1 + part;
}

/* What one rounding of each input, and one of the result, can change. */
static void one_rounding(double out[VALUES], const struct pair *f,
                         const coin_state *s, const coin_params *p)
{
    double value[VALUES], other[VALUES];
    const int count = f->exact(value, s, p);
    for (int k = 0; k < count; ++k)
        out[k] = UF * fabs(value[k]);
    for (size_t i = 0; i < INPUTS; ++i) {
        coin_state t = *s;
        coin_params q = *p;
        change(&t, &q, i, i == 12 ? -UF : UF); /* I_Z stays below 2 I_X */
        f->exact(other, &t, &q);
        for (int k = 0; k < count; ++k)
            out[k] += fabs(other[k] - value[k]);
    }
}

/* A well-made formula errs by a few such changes: the worst was 2.5 of them. */
#define CHANGES 5

TEST(each_is_as_exact_as_its_arguments)
{
    struct random r = random_begin(62);
    double worst = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, i % 2 ? 1.5 : 0.7);
        const coinf_params fp = floats_params(&p);
        const coinf_state fs = floats_state(&s);
        const coin_params dp = doubles_params(&fp);
        const coin_state ds = doubles_state(&fs);
        for (size_t k = 0; k < sizeof pairs / sizeof *pairs; ++k) {
            double want[VALUES], bound[VALUES];
            float got[VALUES];
            const int count = pairs[k].exact(want, &ds, &dp);
            check(pairs[k].tried(got, &fs, &fp) == count);
            one_rounding(bound, &pairs[k], &ds, &dp);
            for (int j = 0; j < count; ++j) {
                const double part = fabs(got[j] - want[j]) / (bound[j] + 1e-30);
                check_note("%s, value %d", pairs[k].name, j);
                check_within(part, 0, CHANGES);
                worst = fmax(worst, part);
            }
        }
    }
    printf("    %.2g roundings of the arguments at worst\n", worst);
}

TEST(rates_have_no_remainders)
{
    const coinf_params p = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
    const coinf_state s = {0.5f, 1, 2, 3, 4, 0.1f, 0.8f, 1.2f, {1e-9f}};
    static const float none[8];
    coinf_state rates;
    memset(&rates, 0xa5, sizeof rates);
    check_status(coinf_rates(&s, &p, &rates), COIN_OK);
    check_same(rates.low, none, sizeof none);
}

/* Near flat the distance to pi/2 decides, and a float of pi/2 is 4.4e-8 off:
 * the lean is taken as the number that it is. */
TEST(near_flat_the_rounding_of_half_pi_is_allowed_for)
{
    const coinf_params p = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
    const coin_params dp = doubles_params(&p);
    for (int side = -1; side <= 1; side += 2) {
        const coinf_state s = {
            (float)side * 1.57079f, 0, 0, 0, 0, 0, 1e3f, 1, {0}};
        const coin_state ds = doubles_state(&s);
        float got[2];
        double want[2];
        check_status(coinf_integrals(&s, &p, got), COIN_OK);
        check_status(coin_integrals(&ds, &dp, want), COIN_OK);
        for (int k = 0; k < 2; ++k)
            check_near(got[k], want[k], 40 * UF * fabs(want[k]));
    }
}

TEST(a_coin_is_made_from_a_rotation_and_back)
{
    struct random r = random_begin(63);
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state from = random_state(&r, &p, 1.5);
        const coinf_params fp = floats_params(&p);
        const coinf_state s = floats_state(&from);
        const float scale = (float)random_sized(&r, 0.1, 3);
        float q[4], omega[3];
        coinf_state t = {0, 0, 0, 0, 0, 0, 0, 0, {1, 1, 1, 1, 1, 1, 1, 1}};
        check_status(coinf_quaternion(&s, q), COIN_OK);
        check_status(coinf_angular_velocity(&s, omega), COIN_OK);
        for (int k = 0; k < 4; ++k)
            q[k] *= scale;
        check_status(coinf_state_from_motion(&t, &fp, q, omega, s.x, s.z),
                     COIN_OK);
        const double cth = cos(s.theta), w = 64 * UF / natural_time(&p) / cth;
        check_near(t.theta, s.theta, 8 * UF);
        check_near(t.phi, s.phi, 16 * UF / cth);
        check_near(t.psi, s.psi, 16 * UF / cth);
        check(t.x == s.x && t.z == s.z);
        check_near(t.wX, s.wX, w);
        check_near(t.wY, s.wY, w);
        check_near(t.wZ, s.wZ, w);
        check(t.low[0] == 0 && t.low[1] == 0 && t.low[7] == 0);
    }
}

TEST(half_turns_become_states_too)
{
    const coinf_params p = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
    const coin_params dp = doubles_params(&p);
    const float none[3] = {0};
    const double exactly_none[3] = {0};
    for (int axis = 1; axis < 4; ++axis) {
        float q[4] = {-1e-9f, 0, 0, 0}, back[4];
        double dq[4] = {0};
        coinf_state s;
        coin_state d;
        dq[axis] = q[axis] = 1;
        check_status(coinf_state_from_motion(&s, &p, q, none, 0, 0), COIN_OK);
        check_status(coin_state_from_motion(&d, &dp, dq, exactly_none, 0, 0),
                     COIN_OK);
        check_near(s.theta, d.theta, 4 * UF);
        check_near(s.phi, d.phi, 8 * UF);
        check_near(s.psi, d.psi, 8 * UF);
        check_status(coinf_quaternion(&s, back), COIN_OK);
        check_near(fabsf(back[axis]), 1, 4 * UF);
    }
}

TEST(a_q_of_0_and_a_flat_coin_make_no_state)
{
    const float nothing[4] = {0}, flat[4] = {1, 1, 0, 0}, omega[3] = {0, 0, 0};
    const float turn[4] = {1, 0, 0, 0}, fast[3] = {1e20f, 0, 0};
    const coinf_params p = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
    coinf_state s = {0.1f, 1, 2, 3, 4, 5, 6, 7, {0}};
    const coinf_state before = s;
    check_status(coinf_state_from_motion(&s, &p, nothing, omega, 0, 0),
                 COIN_ESTATE);
    check_status(coinf_state_from_motion(&s, &p, flat, omega, 0, 0),
                 COIN_ESTATE);
    check_status(coinf_state_from_motion(&s, &p, turn, fast, 0, 0),
                 COIN_ESTATE);
    check_status(coinf_state_from_motion(&s, &p, turn, omega, NAN, 0),
                 COIN_ESTATE);
    check_same(&s, &before, sizeof s);
}

TEST(the_validity_bits_are_those_of_doubles)
{
    struct random r = random_begin(64);
    int seen = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, i % 2 ? 1.57 : 0.7);
        s.theta = i % 16 ? s.theta : 1.565; /* nearly flat */
        const coinf_params fp = floats_params(&p);
        const coinf_state fs = floats_state(&s);
        const coin_params dp = doubles_params(&fp);
        const coin_state ds = doubles_state(&fs);
        const float dt = (float)(0.1 * natural_time(&p));
        const int32_t got = coinf_check(&fs, &fp, COIN_RK4, dt, 0.5f);
        check_status(got, coin_check(&ds, &dp, COIN_RK4, dt, 0.5));
        seen |= got;
    }
    check(seen == (COIN_SLIPS | COIN_LIFTS | COIN_COARSE | COIN_NEARLY_FLAT));
}

TEST(the_ratio_is_infinite_without_a_normal_force)
{
    const coinf_state lifts = {0.1f, 0, 0, 0, 0, 3, 0, 0, {0}};
    const coinf_state rolls = {0, 0, 0, 0, 0, 0, 0, 1, {0}};
    coinf_params p;
    coinf_force f;
    check_status(coinf_params_ring(&p, 1, 1, 0, 1), COIN_OK);
    check_status(coinf_reaction(&lifts, &p, &f), COIN_OK);
    check(f.normal <= 0 && isinf(f.ratio));
    check_status(coinf_reaction(&rolls, &p, &f), COIN_OK);
    check(f.normal == 1 && f.ratio == 0);
    check_status(coinf_check(&rolls, &p, COIN_RK4, 0.1f, -1), COIN_EARG);
    check_status(coinf_params_ring(&p, 1, 1, 2, 1), COIN_EPARAMS);
    check_status(coinf_params_ring(&p, 1, 1, -1, 1), COIN_EPARAMS);
}

TEST(an_angular_velocity_that_overflows_is_refused)
{
    const coinf_state s = {
        .theta = 0.7f, .phi = 0.7f, .wX = 3e38f, .wY = 3e38f};
    float omega[3] = {7, 7, 7};
    check_status(coinf_angular_velocity(&s, omega), COIN_ESTATE);
    check(omega[0] == 7 && omega[1] == 7 && omega[2] == 7);
}
