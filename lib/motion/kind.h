/* SPDX-License-Identifier: MIT */
/* The template mechanism.
 *
 * What exists for several kinds of number is written once, for a type `real`.
 * A source of lib/ is compiled for doubles as it stands, and for floats by a
 * file of lib/float that defines COIN_PRIV_FLOAT and includes it.  A file named
 * *.t.h has no include guard: it is included once for each kind that a source
 * needs.  COIN_PRIV_PAIR, defined before it, selects vectors of two numbers,
 * COIN_PRIV_ABREAST vectors as wide as the processor's; without either, real is
 * one number.
 *
 *     real          a number, or a vector of numbers
 *     scalar        one number: double or float
 *     whole         an integer, or a vector of integers, as wide as real
 *     K(0.1)        a constant of type scalar
 *     COIN(step)    a public name: coin_step or coinf_step
 *     PRIV(body)    an internal name of this kind of number
 *
 * Operations and their order, and so the bits, are the same for all kinds of
 * one width. */
#include "pinned.h"

#include "vector.h"

#undef K
#undef COIN
#undef PRIV
#undef scalar
#undef real
#undef whole
#undef unsigned_whole
#undef SQRT
#undef FABS
#undef LOG

#define K(constant) ((scalar)(constant))

#ifdef COIN_PRIV_FLOAT
#define COIN(name) coinf_##name
#define scalar float
#define SQRT sqrtf
#define FABS fabsf
#define LOG logf
#ifdef COIN_PRIV_ABREAST
#define PRIV(name) coinf_lanes_##name
#define real coinf_lanes
#define whole coinf_lanes_whole
#else
#define PRIV(name) coinf_priv_##name
#define real float
#define whole int32_t
#define unsigned_whole uint32_t
#endif

#else
#define COIN(name) coin_##name
#define scalar double
#define SQRT sqrt
#define FABS fabs
#define LOG log
#if defined(COIN_PRIV_ABREAST)
#define PRIV(name) coin_lanes_##name
#define real coin_lanes
#define whole coin_lanes_whole
#elif defined(COIN_PRIV_PAIR)
#define PRIV(name) coin_pair_##name
#define real coin_pair
#define whole coin_pair_whole
#else
#define PRIV(name) coin_priv_##name
#define real double
#define whole int64_t
#define unsigned_whole uint64_t
#endif
#endif
