/* SPDX-License-Identifier: MIT */
#include "functions.h"

#include <coin.h>

static int32_t disc(void *const a[])
{
    return coin_params_disc(a[0], 1, 2, 3);
}
static int32_t ring(void *const a[])
{
    return coin_params_ring(a[0], 1, 2, 1, 3);
}
static int32_t body(void *const a[])
{
    return coin_params_body(a[0], 1, 2, 3, 4, 5);
}
static int32_t params_check(void *const a[])
{
    return coin_params_check(a[0]);
}
static int32_t state_check(void *const a[])
{
    return coin_state_check(a[0], a[1]);
}
static int32_t from_motion(void *const a[])
{
    return coin_state_from_motion(a[0], a[1], a[2], a[3], 1, 2);
}
static int32_t angular_velocity(void *const a[])
{
    return coin_angular_velocity(a[0], a[1]);
}
static int32_t step(void *const a[])
{
    return coin_step(a[0], a[1], 0.01);
}
static int32_t run(void *const a[])
{
    return coin_run(a[0], a[1], COIN_RK4, 0.01, 3, a[2]);
}
static int32_t advance(void *const a[])
{
    return coin_advance(a[0], a[1], 0.01, 1e-6, a[2]);
}
static int32_t batch_run(void *const a[])
{
    return coin_batch_run(a[0], 1, a[1], COIN_RK4, 0.01, 3, NULL);
}
static int32_t sample(void *const a[])
{
    return coin_sample(a[0], a[1], COIN_RK4, 0.01, 2, 3, a[2], a[3]);
}
static int32_t integrals(void *const a[])
{
    return coin_integrals(a[0], a[1], a[2]);
}
static int32_t reaction(void *const a[])
{
    return coin_reaction(a[0], a[1], a[2]);
}
static int32_t rates(void *const a[])
{
    return coin_rates(a[0], a[1], a[2]);
}
static int32_t center(void *const a[])
{
    return coin_center(a[0], a[1], a[2]);
}
static int32_t velocity(void *const a[])
{
    return coin_velocity(a[0], a[1], a[2]);
}
static int32_t contact(void *const a[])
{
    return coin_contact(a[0], a[1], a[2], a[3]);
}
static int32_t axes(void *const a[])
{
    return coin_axes(a[0], a[1]);
}
static int32_t quaternion(void *const a[])
{
    return coin_quaternion(a[0], a[1]);
}
static int32_t matrix(void *const a[])
{
    return coin_matrix(a[0], a[1], a[2]);
}
static int32_t check_model(void *const a[])
{
    return coin_check(a[0], a[1], COIN_RK4, 0.01, 1e9);
}
static int32_t steady_roll(void *const a[])
{
    return coin_steady_roll(a[0], a[1], 1);
}
static int32_t steady_spin(void *const a[])
{
    return coin_steady_spin(a[0], a[1], 0.5);
}
static int32_t upright_spin(void *const a[])
{
    return coin_steady_upright_spin(a[0], a[1], 1);
}
static int32_t steady_circle(void *const a[])
{
    return coin_steady_circle(a[0], a[1], 0.5, 1, 1);
}
static int32_t steady_turn(void *const a[])
{
    return coin_steady_turn(a[0], a[1], 0.5, 1);
}
static int32_t steady_ride(void *const a[])
{
    return coin_steady_ride(a[0], a[1], 1, 1);
}
static int32_t steady_radii(void *const a[])
{
    return coin_steady_radii(a[0], a[1], a[2], a[3]);
}
static int32_t steady_at(void *const a[])
{
    return coin_steady_at(a[0], a[1], 1, a[2]);
}
static int32_t orbit_init(void *const a[])
{
    return coin_orbit_init(a[0], a[1], a[2]);
}
static int32_t orbit_at(void *const a[])
{
    return coin_orbit_at(a[0], 1, a[1]);
}
static int32_t stability(void *const a[])
{
    return coin_stability(a[0], a[1], a[2]);
}

static int32_t losses_check(void *const a[])
{
    return coin_losses_check(a[0], a[1]);
}
static int32_t losses_rates(void *const a[])
{
    return coin_losses_rates(a[0], a[1], a[2], a[3]);
}
static int32_t losses_reaction(void *const a[])
{
    return coin_losses_reaction(a[0], a[1], a[2], a[3]);
}
static int32_t settle(void *const a[])
{
    return coin_settle(a[0], a[1], a[2], 0.1, 1e-6, a[3]);
}
static int32_t table_check(void *const a[])
{
    return coin_table_check(a[0], a[1]);
}
static int32_t body_from_state(void *const a[])
{
    return coin_body_from_state(a[0], a[1], a[2]);
}
static int32_t body_from_motion(void *const a[])
{
    static const double high[3] = {0, 9, 0};
    return coin_body_from_motion(a[0], a[1], a[2], a[3], high, a[4]);
}
static int32_t move(void *const a[])
{
    return coin_move(a[0], a[1], a[2], 0.1, 1e-6, 0, a[3]);
}
static int32_t body_reaction(void *const a[])
{
    return coin_body_reaction(a[0], a[1], a[2], a[3]);
}
static int32_t body_slip(void *const a[])
{
    return coin_body_slip(a[0], a[1], a[2]);
}
static int32_t body_matrix(void *const a[])
{
    return coin_body_matrix(a[0], a[1], a[2]);
}

const struct function functions[] = {
    {"coin_params_disc", "P", disc},
    {"coin_params_ring", "P", ring},
    {"coin_params_body", "P", body},
    {"coin_params_check", "p", params_check},
    {"coin_state_check", "sp", state_check},
    {"coin_state_from_motion", "opdd", from_motion},
    {"coin_angular_velocity", "so", angular_velocity},
    {"coin_step", "Sp", step},
    {"coin_run", "Spn", run},
    {"coin_advance", "Spn", advance},
    {"coin_batch_run", "Sp", batch_run},
    {"coin_sample", "spon", sample},
    {"coin_integrals", "spo", integrals},
    {"coin_reaction", "spo", reaction},
    {"coin_rates", "spo", rates},
    {"coin_center", "spo", center},
    {"coin_velocity", "spo", velocity},
    {"coin_contact", "spoo", contact},
    {"coin_axes", "so", axes},
    {"coin_quaternion", "so", quaternion},
    {"coin_matrix", "spo", matrix},
    {"coin_check", "sp", check_model},
    {"coin_steady_roll", "op", steady_roll},
    {"coin_steady_spin", "op", steady_spin},
    {"coin_steady_upright_spin", "op", upright_spin},
    {"coin_steady_circle", "op", steady_circle},
    {"coin_steady_turn", "op", steady_turn},
    {"coin_steady_ride", "op", steady_ride},
    {"coin_steady_radii", "spoo", steady_radii},
    {"coin_steady_at", "spo", steady_at},
    {"coin_orbit_init", "osp", orbit_init},
    {"coin_orbit_at", "bo", orbit_at},
    {"coin_stability", "spo", stability},
    {"coin_losses_check", "lp", losses_check},
    {"coin_losses_rates", "splo", losses_rates},
    {"coin_losses_reaction", "splo", losses_reaction},
    {"coin_settle", "Spln", settle},
    {"coin_table_check", "tp", table_check},
    {"coin_body_from_state", "osp", body_from_state},
    {"coin_body_from_motion", "opddd", body_from_motion},
    {"coin_move", "Gptn", move},
    {"coin_body_reaction", "gpto", body_reaction},
    {"coin_body_slip", "gpo", body_slip},
    {"coin_body_matrix", "gpo", body_matrix},
};

const size_t function_count = sizeof functions / sizeof *functions;
