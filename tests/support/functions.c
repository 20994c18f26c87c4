/* SPDX-License-Identifier: MIT */
#include "functions.h"

#include <coin.h>

struct function functions[MOST_FUNCTIONS];
size_t function_count;

/* A function, what its pointers are, and its arguments. */
#define FUNCTION(name, kinds, ...)                                             \
    static int32_t call_##name(void *const a[])                                \
    {                                                                          \
        return name(__VA_ARGS__);                                              \
    }                                                                          \
    __attribute__((constructor)) static void add_##name(void)                  \
    {                                                                          \
        functions[function_count++] =                                          \
            (struct function){#name, kinds, call_##name};                      \
    }

static const double high[3] = {0, 9, 0};

FUNCTION(coin_params_disc, "P", a[0], 1, 2, 3)
FUNCTION(coin_params_ring, "P", a[0], 1, 2, 1, 3)
FUNCTION(coin_params_body, "P", a[0], 1, 2, 3, 4, 5)
FUNCTION(coin_params_check, "p", a[0])
FUNCTION(coin_state_check, "sp", a[0], a[1])
FUNCTION(coin_state_from_motion, "opdd", a[0], a[1], a[2], a[3], 1, 2)
FUNCTION(coin_angular_velocity, "so", a[0], a[1])
FUNCTION(coin_step, "Sp", a[0], a[1], 0.01)
FUNCTION(coin_run, "Spn", a[0], a[1], COIN_RK4, 0.01, 3, a[2])
FUNCTION(coin_advance, "Spn", a[0], a[1], 0.01, 1e-6, a[2])
FUNCTION(coin_batch_run, "Sp", a[0], 1, a[1], COIN_RK4, 0.01, 3, NULL)
FUNCTION(coin_sample, "spon", a[0], a[1], COIN_RK4, 0.01, 2, 3, a[2], a[3])
FUNCTION(coin_integrals, "spo", a[0], a[1], a[2])
FUNCTION(coin_reaction, "spo", a[0], a[1], a[2])
FUNCTION(coin_rates, "spo", a[0], a[1], a[2])
FUNCTION(coin_center, "spo", a[0], a[1], a[2])
FUNCTION(coin_velocity, "spo", a[0], a[1], a[2])
FUNCTION(coin_contact, "spoo", a[0], a[1], a[2], a[3])
FUNCTION(coin_axes, "so", a[0], a[1])
FUNCTION(coin_quaternion, "so", a[0], a[1])
FUNCTION(coin_matrix, "spo", a[0], a[1], a[2])
FUNCTION(coin_check, "sp", a[0], a[1], COIN_RK4, 0.01, 1e9)
FUNCTION(coin_steady_roll, "op", a[0], a[1], 1)
FUNCTION(coin_steady_spin, "op", a[0], a[1], 0.5)
FUNCTION(coin_steady_upright_spin, "op", a[0], a[1], 1)
FUNCTION(coin_steady_circle, "op", a[0], a[1], 0.5, 1, 1)
FUNCTION(coin_steady_turn, "op", a[0], a[1], 0.5, 1)
FUNCTION(coin_steady_ride, "op", a[0], a[1], 1, 1)
FUNCTION(coin_steady_radii, "spoo", a[0], a[1], a[2], a[3])
FUNCTION(coin_steady_at, "spo", a[0], a[1], 1, a[2])
FUNCTION(coin_orbit_init, "osp", a[0], a[1], a[2])
FUNCTION(coin_orbit_at, "bo", a[0], 1, a[1])
FUNCTION(coin_stability, "spo", a[0], a[1], a[2])
FUNCTION(coin_losses_check, "lp", a[0], a[1])
FUNCTION(coin_losses_rates, "splo", a[0], a[1], a[2], a[3])
FUNCTION(coin_losses_reaction, "splo", a[0], a[1], a[2], a[3])
FUNCTION(coin_settle, "Spln", a[0], a[1], a[2], 0.1, 1e-6, a[3])
FUNCTION(coin_table_check, "tp", a[0], a[1])
FUNCTION(coin_body_from_state, "osp", a[0], a[1], a[2])
FUNCTION(coin_body_from_motion, "opddd", a[0], a[1], a[2], a[3], high, a[4])
FUNCTION(coin_move, "Gptn", a[0], a[1], a[2], 0.1, 1e-6, 0, a[3])
FUNCTION(coin_body_reaction, "gpto", a[0], a[1], a[2], a[3])
FUNCTION(coin_body_slip, "gpo", a[0], a[1], a[2])
FUNCTION(coin_body_matrix, "gpo", a[0], a[1], a[2])
