/* SPDX-License-Identifier: MIT */
/* What ctypes loads: librollcoin, and its functions over tables.  Compiled
 * with the library in it, from the single header; or, with ROLLCOIN_SYSTEM
 * defined, linked to the one that is installed. */
#if defined(_WIN32)
#define PUBLIC __declspec(dllexport)
#else
#define PUBLIC __attribute__((visibility("default")))
#endif

#ifdef ROLLCOIN_SYSTEM
#include <coinf.h>
#else
#define COIN_API PUBLIC
#define COIN_IMPLEMENTATION
#include "coin.h"
#endif

#define LISTED(...) __VA_ARGS__

/* The first error of all, or else every warning. */
static int32_t joined(int32_t all, int32_t status)
{
    return all < 0 ? all : status < 0 ? status : all | status;
}

/* name(count, status, the arguments of the call, which names row i). */
#define EACH(name, arguments, call)                                            \
    PUBLIC int32_t name(size_t count, int32_t *status, LISTED arguments);      \
    PUBLIC int32_t name(size_t count, int32_t *status, LISTED arguments)       \
    {                                                                          \
        int32_t all = COIN_OK;                                                 \
        for (size_t i = 0; i < count; ++i) {                                   \
            status[i] = call;                                                  \
            all = joined(all, status[i]);                                      \
        }                                                                      \
        return all;                                                            \
    }

/* The same of a function that gives a number, which is NaN on bad input. */
#define EACH_NUMBER(name, real, arguments, passed)                             \
    PUBLIC int32_t each_##name(size_t count, int32_t *status, real *number,    \
                               LISTED arguments);                              \
    PUBLIC int32_t each_##name(size_t count, int32_t *status, real *number,    \
                               LISTED arguments)                               \
    {                                                                          \
        int32_t all = COIN_OK;                                                 \
        for (size_t i = 0; i < count; ++i) {                                   \
            number[i] = name passed;                                           \
            status[i] = COIN_OK;                                               \
            if (number[i] != number[i]) {                                      \
                const int32_t why = why_##name passed;                         \
                status[i] = why < 0 ? why : COIN_EDOMAIN;                      \
            }                                                                  \
            all = joined(all, status[i]);                                      \
        }                                                                      \
        return all;                                                            \
    }

/* Why a number is NaN: the first error in the order of coin.h; for any other
 * reason it is COIN_EDOMAIN. */
#define why_coin_energy        why_thin
#define why_coin_fastest_rate  why_thin
#define why_coinf_energy       coinf_state_check
#define why_coinf_fastest_rate coinf_state_check

/* coin_state_check() also accepts parameters with a thickness. */
static int32_t why_thin(const coin_state *s, const coin_params *p)
{
    double v[3];
    return coin_velocity(s, p, v);
}

static int32_t why_coin_losses_power(const coin_state *s, const coin_params *p,
                                     const coin_losses *l)
{
    coin_state rates;
    return coin_losses_rates(s, p, l, &rates);
}

static int32_t why_coin_time_to_rest(const coin_state *s, const coin_params *p,
                                     const coin_losses *l, double tol)
{
    coin_state copy = *s;
    return coin_settle(&copy, p, l, 0, tol, NULL);
}

static int32_t why_coin_body_energy(const coin_body *b, const coin_params *p)
{
    double v[3];
    return coin_body_contact(b, p, v);
}

#include "tables.h"
