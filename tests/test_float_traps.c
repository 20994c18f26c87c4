/* SPDX-License-Identifier: MIT */
/* The functions of coinf.h with floating-point exceptions trapped. */
#include "support/check.h"
#include "support/traps.h"

#include <math.h>

static coinf_state out;
static coinf_params made;
static float v[16];

/* ----------------------------------------------------------------- parameters
 */
CALL(coinf_params_disc,
     coinf_params_disc(&made, c->fp.mass, c->fp.radius, c->fp.gravity))
CALL(coinf_params_ring, coinf_params_ring(&made, c->fp.mass, c->fp.radius,
                                          c->fp.radius / 2, c->fp.gravity))
CALL(coinf_params_body,
     coinf_params_body(&made, c->fp.mass, c->fp.radius, c->fp.gravity,
                       c->fp.inertia_X, c->fp.inertia_Z))
CALL(coinf_params_check, coinf_params_check(&c->fp))

/* Once is enough. */
static int32_t call_coinf_selftest(const struct trap_case *c)
{
    return c->s.theta == 0 ? coinf_selftest() : COIN_OK;
}

/* --------------------------------------------------------------- observables
 */
CALL(coinf_state_check, coinf_state_check(&c->fs, &c->fp))
CALL(coinf_angular_velocity, coinf_angular_velocity(&c->fs, v))
CALL(coinf_energy, isnan(coinf_energy(&c->fs, &c->fp)) ? COIN_ESTATE : COIN_OK)
CALL(coinf_fastest_rate,
     isnan(coinf_fastest_rate(&c->fs, &c->fp)) ? COIN_ESTATE : COIN_OK)
CALL(coinf_integrals, coinf_integrals(&c->fs, &c->fp, v))
CALL(coinf_rates, coinf_rates(&c->fs, &c->fp, &out))
CALL(coinf_center, coinf_center(&c->fs, &c->fp, v))
CALL(coinf_velocity, coinf_velocity(&c->fs, &c->fp, v))
CALL(coinf_contact, coinf_contact(&c->fs, &c->fp, v, v + 3))
CALL(coinf_axes, coinf_axes(&c->fs, v))
CALL(coinf_quaternion, coinf_quaternion(&c->fs, v))
CALL(coinf_matrix, coinf_matrix(&c->fs, &c->fp, v))
CALL(coinf_check, coinf_check(&c->fs, &c->fp, COIN_RK4, c->fdt, c->fmu))

static int32_t call_coinf_reaction(const struct trap_case *c)
{
    coinf_force force;
    return coinf_reaction(&c->fs, &c->fp, &force);
}

/* There and back; and of quaternions of any norm. */
static int32_t call_coinf_state_from_motion(const struct trap_case *c)
{
    float q[4], omega[3];
    if (coinf_quaternion(&c->fs, q) != COIN_OK ||
        coinf_angular_velocity(&c->fs, omega) != COIN_OK)
        return COIN_ESTATE;
    for (int i = 0; i < 4; ++i)
        q[i] *= c->fmu > 0 ? 1 : 1e30f;
    return coinf_state_from_motion(&out, &c->fp, q, omega, c->fs.x, c->fs.z);
}

/* --------------------------------------------------------------------- movers
 */
static int32_t call_coinf_step(const struct trap_case *c)
{
    out = c->fs;
    return coinf_step(&out, &c->fp, c->fdt);
}

static int32_t call_coinf_run(const struct trap_case *c)
{
    out = c->fs;
    return coinf_run(&out, &c->fp, COIN_RK4, c->fdt, 130, NULL);
}

static const struct trap_function all[] = {
    ROW(coinf_selftest),
    ROW(coinf_params_disc),
    ROW(coinf_params_ring),
    ROW(coinf_params_body),
    ROW(coinf_params_check),
    ROW(coinf_state_check),
    ROW(coinf_state_from_motion),
    ROW(coinf_angular_velocity),
    ROW(coinf_step),
    ROW(coinf_run),
    ROW(coinf_energy),
    ROW(coinf_fastest_rate),
    ROW(coinf_integrals),
    ROW(coinf_reaction),
    ROW(coinf_rates),
    ROW(coinf_center),
    ROW(coinf_velocity),
    ROW(coinf_contact),
    ROW(coinf_axes),
    ROW(coinf_quaternion),
    ROW(coinf_matrix),
    ROW(coinf_check),
};

TEST(no_call_that_succeeds_traps)
{
    traps_run(all, sizeof all / sizeof *all);
}

TEST(every_function_is_called)
{
    traps_are_complete("coinf_", all, sizeof all / sizeof *all);
}
