/* SPDX-License-Identifier: MIT */
/* The public functions of coin.h and coinf.h under one set of names, so that
 * one text judges both. */
#ifndef ROLLCOIN_ADVERSARY_API_HPP
#define ROLLCOIN_ADVERSARY_API_HPP

#include <coin.h>
#include <coinf.h>

#include <cfloat>

#define TWINS(PREFIX)                                                          \
    using params = PREFIX##_params;                                            \
    using state = PREFIX##_state;                                              \
    using force = PREFIX##_force;                                              \
    static constexpr auto disc = PREFIX##_params_disc;                         \
    static constexpr auto ring = PREFIX##_params_ring;                         \
    static constexpr auto from_motion = PREFIX##_state_from_motion;            \
    static constexpr auto angular_velocity = PREFIX##_angular_velocity;        \
    static constexpr auto step = PREFIX##_step;                                \
    static constexpr auto run = PREFIX##_run;                                  \
    static constexpr auto energy = PREFIX##_energy;                            \
    static constexpr auto fastest_rate = PREFIX##_fastest_rate;                \
    static constexpr auto integrals = PREFIX##_integrals;                      \
    static constexpr auto reaction = PREFIX##_reaction;                        \
    static constexpr auto rates = PREFIX##_rates;                              \
    static constexpr auto center = PREFIX##_center;                            \
    static constexpr auto velocity = PREFIX##_velocity;                        \
    static constexpr auto contact = PREFIX##_contact;                          \
    static constexpr auto axes = PREFIX##_axes;                                \
    static constexpr auto quaternion = PREFIX##_quaternion;                    \
    static constexpr auto matrix = PREFIX##_matrix;                            \
    static constexpr auto check = PREFIX##_check

struct doubles {
    using real = double;
    static constexpr double u = 0x1p-53, least = DBL_TRUE_MIN, normal = DBL_MIN;
    TWINS(coin);
    static double low(const state &, int)
    {
        return 0;
    }
};

struct floats {
    using real = float;
    static constexpr double u = 0x1p-24, least = FLT_TRUE_MIN, normal = FLT_MIN;
    TWINS(coinf);
    static double low(const state &s, int i)
    {
        return s.low[i];
    }
};

#endif
