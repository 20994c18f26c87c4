/* SPDX-License-Identifier: MIT */
/* The functions of coin.h and coinf.h with floating-point exceptions trapped.
 */
#include "support/check.h"
#include "support/traps.h"

#include <math.h>

static coin_state out;
static coin_params made;
static coin_orbit orbit;
static double v[16];

/* Functions that return no status succeed. */
static int32_t done(double value)
{
    v[0] = value;
    return COIN_OK;
}

static coin_state *copy(const coin_state *s)
{
    out = *s;
    return &out;
}

/* ----------------------------------------------------- constants, parameters
 */
CALL(coin_version, done(coin_version()))
CALL(coin_version_string, done(coin_version_string()[0]))
CALL(coin_status_string, done(coin_status_string(-3)[0]))
CALL(coin_sizeof, done(coin_sizeof("coin_state")))
CALL(coin_params_disc,
     coin_params_disc(&made, c->p.mass, c->p.radius, c->p.gravity))
CALL(coin_params_ring, coin_params_ring(&made, c->p.mass, c->p.radius,
                                        c->p.radius / 2, c->p.gravity))
CALL(coin_params_body,
     coin_params_body(&made, c->p.mass, c->p.radius, c->p.gravity,
                      c->p.inertia_X, c->p.inertia_Z))
CALL(coin_params_check, coin_params_check(&c->p))
CALL(coin_method_name, done(coin_method_name(1)[0]))
CALL(coin_critical_roll, done(coin_critical_roll(&c->p)))
CALL(coin_critical_spin, done(coin_critical_spin(&c->p)))

/* Once is enough. */
CALLS(coin_selftest)
{
    return c->s.wZ == 1 ? coin_selftest() : COIN_OK;
}

/* --------------------------------------------------------------- observables
 */
CALL(coin_state_check, coin_state_check(&c->s, &c->p))
CALL(coin_angular_velocity, coin_angular_velocity(&c->s, v))
CALL(coin_energy, isnan(coin_energy(&c->s, &c->p)) ? COIN_ESTATE : COIN_OK)
CALL(coin_fastest_rate,
     isnan(coin_fastest_rate(&c->s, &c->p)) ? COIN_ESTATE : COIN_OK)
CALL(coin_integrals, coin_integrals(&c->s, &c->p, v))
CALL(coin_rates, coin_rates(&c->s, &c->p, &out))
CALL(coin_center, coin_center(&c->s, &c->p, v))
CALL(coin_velocity, coin_velocity(&c->s, &c->p, v))
CALL(coin_contact, coin_contact(&c->s, &c->p, v, v + 3))
CALL(coin_axes, coin_axes(&c->s, v))
CALL(coin_quaternion, coin_quaternion(&c->s, v))
CALL(coin_matrix, coin_matrix(&c->s, &c->p, v))

CALLS(coin_reaction)
{
    coin_force force;
    return coin_reaction(&c->s, &c->p, &force);
}

CALLS(coin_check)
{
    return coin_check(&c->s, &c->p, COIN_RK8, c->dt, c->mu);
}

/* There and back; and of quaternions of any norm. */
CALLS(coin_state_from_motion)
{
    double q[4], omega[3];
    if (coin_quaternion(&c->s, q) != COIN_OK ||
        coin_angular_velocity(&c->s, omega) != COIN_OK)
        return COIN_ESTATE;
    for (int i = 0; i < 4; ++i)
        q[i] *= c->mu > 0 ? 1 : 1e200;
    return coin_state_from_motion(&out, &c->p, q, omega, c->s.x, c->s.z);
}

/* ------------------------------------------------------------------- movers */
CALLS(coin_step)
{
    return coin_step(copy(&c->s), &c->p, c->dt);
}

static int32_t run(const struct trap_case *c, int32_t method)
{
    return coin_run(copy(&c->s), &c->p, method, c->dt, 70, NULL);
}
CALL(coin_run_rk4, run(c, COIN_RK4))
CALL(coin_run_rk8, run(c, COIN_RK8))
CALL(coin_run_symplectic2, run(c, COIN_SYMPLECTIC2))
CALL(coin_run_symplectic4, run(c, COIN_SYMPLECTIC4))

static int32_t batch(const struct trap_case *c, int32_t method)
{
    coin_state s[9]; /* the widest vector and a coin by itself */
    for (int i = 0; i < 9; ++i)
        s[i] = c->s;
    const uint64_t n = method == COIN_RK4 ? 70 : 7; /* a block, or less */
    return coin_batch_run(s, 9, &c->p, method, c->dt, n, NULL);
}
CALL(coin_batch_run_rk4, batch(c, COIN_RK4))
CALL(coin_batch_run_rk8, batch(c, COIN_RK8))

CALLS(coin_sample)
{
    coin_state s[3];
    return coin_sample(&c->s, &c->p, COIN_RK4, c->dt, 5, 3, s, NULL);
}

/* So short that the call comes to an end: no more than ten radians of any of
 * its rates, near flat too. */
static double some_time(const struct trap_case *c)
{
    const double wX = c->s.wX, wY = c->s.wY, wZ = c->s.wZ;
    const double cth = cos(c->s.theta);
    const double w = sqrt((wX * wX + wY * wY) / (cth * cth) + wZ * wZ +
                          c->p.gravity / (c->p.radius * cth));
    return fmin(c->t, 10 / w);
}

CALL(coin_advance, coin_advance(copy(&c->s), &c->p, some_time(c), 1e-6, NULL))
CALL(coin_orbit_init, coin_orbit_init(&orbit, &c->s, &c->p))

CALLS(coin_orbit_at)
{
    const int32_t status = coin_orbit_init(&orbit, &c->s, &c->p);
    return status == COIN_OK ? coin_orbit_at(&orbit, c->t, &out) : status;
}

/* -------------------------------------------------------------------- losses
 */
/* Some of each: a hundredth of the weight's torque, and less on a body of so
 * little inertia that it would take many steps. */
static coin_losses losses(const struct trap_case *c)
{
    const double a = c->p.radius, w0 = sqrt(c->p.gravity / a);
    const double m = c->p.mass * a * a;
    const double torque = 1e-2 * fmin(m, 4 * c->p.inertia_X) * w0 * w0;
    const coin_losses l = {.damping = 1e-2,
                           .dry = torque,
                           .viscous = torque / w0,
                           .layer = torque / (w0 * sqrt(w0)),
                           .gap = torque / w0,
                           .rolling = torque,
                           .spin = torque / w0,
                           .angular = 1e-2 * w0,
                           .flat = 1e-3};
    return l;
}

#define WITH_LOSSES(name, expression)                                          \
    CALLS(name)                                                                \
    {                                                                          \
        coin_losses l = losses(c);                                             \
        return expression;                                                     \
    }
WITH_LOSSES(coin_losses_check, coin_losses_check(&l, &c->p))
WITH_LOSSES(coin_losses_power,
            isnan(coin_losses_power(&c->s, &c->p, &l)) ? COIN_ESTATE : COIN_OK)
WITH_LOSSES(coin_losses_rates, coin_losses_rates(&c->s, &c->p, &l, &out))
WITH_LOSSES(coin_settle,
            coin_settle(copy(&c->s), &c->p, &l, some_time(c), 1e-6, NULL))
/* What settles a coin to rest, once or up to a hundred times: in one case of
 * 72, none of them upright, which never rests. */
#define NOW_AND_THEN(c, call) ((c)->index % 72 != 71 ? COIN_OK : (call))

WITH_LOSSES(coin_time_to_rest,
            NOW_AND_THEN(c, isnan(coin_time_to_rest(&c->s, &c->p, &l))
                                ? COIN_ESTATE
                                : COIN_OK))
WITH_LOSSES(coin_losses_fit,
            NOW_AND_THEN(c, coin_losses_fit(&l, &c->s, &c->p,
                                            some_time(c) > 0 ? c->t : 1)))

CALLS(coin_losses_reaction)
{
    const coin_losses l = losses(c);
    coin_force force;
    return coin_losses_reaction(&c->s, &c->p, &l, &force);
}

/* -------------------------------------------------------------------- bodies
 */
/* Rolls if dt is negative, else it slips; if t is small it flies. */
static coin_body body(const struct trap_case *c)
{
    coin_body b;
    double v0 = sqrt(c->p.gravity * c->p.radius);
    if (coin_body_from_state(&b, &c->s, &c->p) != COIN_OK) {
        const coin_body none = {c->s, 0, 0, 0, 0, {0, 0, 0, 0}};
        return none;
    }
    b.vx += c->dt < 0 ? 0 : 0.3 * v0;
    b.y += fabs(c->t) < 1e-6 ? c->p.radius : 0;
    return b;
}

#define WITH_BODY(name, expression)                                            \
    CALLS(name)                                                                \
    {                                                                          \
        coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.25};                 \
        coin_body b = body(c);                                                 \
        coin_force force;                                                      \
        double m[16], q[4] = {0.3, 0.1, 0.2, 0.4};                             \
        const double omega[3] = {c->s.wX, c->s.wY, c->s.wZ};                   \
        const double r[3] = {c->s.x, b.y, c->s.z}, w[3] = {b.vx, 0, b.vz};     \
        if (c->t < 0)                                                          \
            f.losses = losses(c);                                              \
        f.losses.damping = 0;                                                  \
        (void)force, (void)m, (void)q, (void)omega, (void)r, (void)w, (void)f; \
        return expression;                                                     \
    }
WITH_BODY(coin_table_check, coin_table_check(&f, &c->p))
WITH_BODY(coin_body_from_state, coin_body_from_state(&b, &c->s, &c->p))
WITH_BODY(coin_body_from_motion,
          coin_body_from_motion(&b, &c->p, q, omega, r, w))
WITH_BODY(coin_move, coin_move(&b, &c->p, &f, fabs(some_time(c)), 1e-6,
                               c->mu > 0.5 ? COIN_SLIPS | COIN_ROLLS : 0, NULL))
WITH_BODY(coin_body_energy,
          isnan(coin_body_energy(&b, &c->p)) ? COIN_ESTATE : COIN_OK)
WITH_BODY(coin_body_reaction, coin_body_reaction(&b, &c->p, &f, &force))
WITH_BODY(coin_body_slip, coin_body_slip(&b, &c->p, v))
WITH_BODY(coin_body_matrix, coin_body_matrix(&b, &c->p, m))

/* ----------------------------------------------------------- steady motions */
CALL(coin_steady_roll, coin_steady_roll(&out, &c->p, c->s.wZ))
CALL(coin_steady_spin, coin_steady_spin(&out, &c->p, c->s.theta))
CALL(coin_steady_upright_spin, coin_steady_upright_spin(&out, &c->p, c->s.wY))
CALL(coin_steady_circle,
     coin_steady_circle(&out, &c->p, c->s.theta, c->s.wZ, c->dt > 0 ? 1 : -1))

CALL(coin_steady_turn, coin_steady_turn(&out, &c->p, c->s.theta, fabs(c->s.x)))
CALL(coin_steady_ride,
     coin_steady_ride(&out, &c->p, fabs(c->s.wZ) * c->p.radius, c->p.radius))

/* The circle of this lean and roll, if there is one. */
static coin_state steady(const struct trap_case *c)
{
    coin_state s = c->s;
    (void)coin_steady_circle(&s, &c->p, s.theta, s.wZ, 1);
    return s;
}

CALLS(coin_steady_radii)
{
    const coin_state s = steady(c);
    return coin_steady_radii(&s, &c->p, &v[0], &v[1]);
}

CALLS(coin_steady_at)
{
    const coin_state s = steady(c);
    return coin_steady_at(&s, &c->p, c->t, &out);
}

CALLS(coin_stability)
{
    const coin_state s = steady(c);
    return coin_stability(&s, &c->p, v);
}

/* ------------------------------------------------------------------- floats */
static coinf_state fout;
static coinf_params fmade;
static float fv[16];

CALL(coinf_params_disc,
     coinf_params_disc(&fmade, c->fp.mass, c->fp.radius, c->fp.gravity))
CALL(coinf_params_ring, coinf_params_ring(&fmade, c->fp.mass, c->fp.radius,
                                          c->fp.radius / 2, c->fp.gravity))
CALL(coinf_params_body,
     coinf_params_body(&fmade, c->fp.mass, c->fp.radius, c->fp.gravity,
                       c->fp.inertia_X, c->fp.inertia_Z))
CALL(coinf_params_check, coinf_params_check(&c->fp))

/* Once is enough. */
CALLS(coinf_selftest)
{
    return c->s.theta == 0 ? coinf_selftest() : COIN_OK;
}

/* --------------------------------------------------------------- observables
 */
CALL(coinf_state_check, coinf_state_check(&c->fs, &c->fp))
CALL(coinf_angular_velocity, coinf_angular_velocity(&c->fs, fv))
CALL(coinf_energy, isnan(coinf_energy(&c->fs, &c->fp)) ? COIN_ESTATE : COIN_OK)
CALL(coinf_fastest_rate,
     isnan(coinf_fastest_rate(&c->fs, &c->fp)) ? COIN_ESTATE : COIN_OK)
CALL(coinf_integrals, coinf_integrals(&c->fs, &c->fp, fv))
CALL(coinf_rates, coinf_rates(&c->fs, &c->fp, &fout))
CALL(coinf_center, coinf_center(&c->fs, &c->fp, fv))
CALL(coinf_velocity, coinf_velocity(&c->fs, &c->fp, fv))
CALL(coinf_contact, coinf_contact(&c->fs, &c->fp, fv, fv + 3))
CALL(coinf_axes, coinf_axes(&c->fs, fv))
CALL(coinf_quaternion, coinf_quaternion(&c->fs, fv))
CALL(coinf_matrix, coinf_matrix(&c->fs, &c->fp, fv))
CALL(coinf_check, coinf_check(&c->fs, &c->fp, COIN_RK4, c->fdt, c->fmu))

CALLS(coinf_reaction)
{
    coinf_force force;
    return coinf_reaction(&c->fs, &c->fp, &force);
}

/* There and back; and of quaternions of any norm. */
CALLS(coinf_state_from_motion)
{
    float q[4], omega[3];
    if (coinf_quaternion(&c->fs, q) != COIN_OK ||
        coinf_angular_velocity(&c->fs, omega) != COIN_OK)
        return COIN_ESTATE;
    for (int i = 0; i < 4; ++i)
        q[i] *= c->fmu > 0 ? 1 : 1e30f;
    return coinf_state_from_motion(&fout, &c->fp, q, omega, c->fs.x, c->fs.z);
}

/* --------------------------------------------------------------------- movers
 */
CALLS(coinf_step)
{
    fout = c->fs;
    return coinf_step(&fout, &c->fp, c->fdt);
}

CALLS(coinf_run)
{
    fout = c->fs;
    return coinf_run(&fout, &c->fp, COIN_RK4, c->fdt, 130, NULL);
}

TEST(no_call_that_succeeds_traps)
{
    traps_run();
}

TEST(every_function_is_called)
{
    traps_are_complete();
}
