/* SPDX-License-Identifier: MIT */
/* The kinds of number.
 *
 * Code for several kinds of number is written once, for numbers of type
 * `number`, with the names that it has for doubles.  Another kind compiles the
 * same text once more, after names have been defined as macros:
 *
 * Floats.  A file of lib/float includes float/floats.h and then the sources of
 * a folder.  floats.h defines coin_energy as coinf_energy, and so on: the names
 * of coin.h, and of functions that sources share, that floats have too.  Other
 * names can stay, as each source is compiled by itself.
 *
 * Vectors.  A file named *.t.h is a template.  It has no include guard: a
 * source includes it once for each kind that it needs.  A macro, defined before
 * the include and undefined after it, selects the kind:
 *
 *     none               one number
 *     COIN_PRIV_PAIR     a vector of two numbers: coin_pair_sc, ...
 *     COIN_PRIV_ABREAST  as wide as the processor's: coin_lanes_sc, ...
 *
 * vector_names.h lists the names that vectors have too, as macros that depend
 * on COIN_PRIV_NAME.
 *
 * This file defines, for the kind selected:
 *
 *     number   a number, or a vector of numbers
 *     scalar   one number: double or float
 *     integer  an integer, or a vector of integers, as wide as number
 *     K(0.1)   a constant of type scalar
 *
 * Operations and their order, and so the bits, are the same for all kinds of
 * one width. */
#include "pinned.h"

#include "vector.h"

#undef K
#undef COIN_PRIV_NAME
#undef scalar
#undef number
#undef integer
#undef SQRT
#undef FABS
#undef LOG

#ifdef COIN_PRIV_FLOAT
#define scalar float
#define SQRT sqrtf
#define FABS fabsf
#define LOG logf
#else
#define scalar double
#define SQRT sqrt
#define FABS fabs
#define LOG log
#endif

#define K(constant) ((scalar)(constant))

#if defined(COIN_PRIV_ABREAST)
#define COIN_PRIV_NAME(name) coin_lanes_##name
#define number coin_lanes
#define integer coin_lanes_integer
#elif defined(COIN_PRIV_PAIR)
#define COIN_PRIV_NAME(name) coin_pair_##name
#define number coin_pair
#define integer coin_pair_integer
#else
#define COIN_PRIV_NAME(name) coin_priv_##name
#define number scalar
#ifdef COIN_PRIV_FLOAT
#define integer int32_t
#else
#define integer int64_t
#endif
#endif
