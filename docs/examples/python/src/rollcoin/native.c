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

/* The same of a call that gives a number, which is NaN on bad input. */
#define EACH_NUMBER(name, real, arguments, call, check)                        \
    PUBLIC int32_t name(size_t count, int32_t *status, real *number,           \
                        LISTED arguments);                                     \
    PUBLIC int32_t name(size_t count, int32_t *status, real *number,           \
                        LISTED arguments)                                      \
    {                                                                          \
        int32_t all = COIN_OK;                                                 \
        for (size_t i = 0; i < count; ++i) {                                   \
            number[i] = call;                                                  \
            status[i] = COIN_OK;                                               \
            if (number[i] != number[i]) {                                      \
                const int32_t why = check;                                     \
                status[i] = why < 0 ? why : COIN_EDOMAIN;                      \
            }                                                                  \
            all = joined(all, status[i]);                                      \
        }                                                                      \
        return all;                                                            \
    }

#include "tables.h"
