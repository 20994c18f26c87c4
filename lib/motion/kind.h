/* SPDX-License-Identifier: MIT */
/* The template mechanism.
 *
 * Code for several kinds of number is written once, for a type `real`.  A
 * source X.c is compiled for doubles as it stands.  If floats need it too, a
 * file coinf_X.c of lib/float defines COIN_PRIV_FLOAT and includes X.c.
 *
 * A file named *.t.h is a template.  It has no include guard: a source includes
 * it once for each kind that it needs.  A macro, defined before the include and
 * undefined after it, selects the kind:
 *
 *     none               one number
 *     COIN_PRIV_PAIR     a vector of two numbers
 *     COIN_PRIV_ABREAST  a vector as wide as the processor's
 *
 * This file gives these names their meaning for the kind selected:
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
#define PRIV(name) coinf_priv_##name
#define real float
#define whole int32_t
#define unsigned_whole uint32_t

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
