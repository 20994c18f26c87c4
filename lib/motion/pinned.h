/* SPDX-License-Identifier: MIT */
/* One bit pattern on every platform: every source has this before its code.
 *
 * The Makefile passes -ffp-contract=off.  These guards protect builds with
 * other flags.  They cannot see clang's -ffp-contract=fast and -fno-honor-nans.
 * coin_selftest() reports these at run time. */
#ifndef ROLLCOIN_PINNED_H
#define ROLLCOIN_PINNED_H

#include <float.h>

/* Where only finite numbers count, NaN would pass for one in range. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) ||                 \
    defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST) ||                     \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "librollcoin needs IEEE arithmetic as written: no fast-math, no -Ofast"
#endif

/* 16 means the same for float and double; gcc has it with AVX512-FP16. */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "librollcoin needs FLT_EVAL_METHOD 0: on i386 -msse2 -mfpmath=sse"
#endif

/* A fused multiply-add rounds once where two operations round twice.  gcc 12's
 * vectorizer fuses a b - c, d e + f in pairs even with contraction off. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && !defined(__TINYC__)
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize",               \
                     "no-tree-loop-vectorize")
/* gcc would turn the loop of coin_priv_copy_state() into memcpy(), whose wide
 * moves that function avoids. */
#pragma GCC optimize("no-tree-loop-distribute-patterns")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

/* COIN_PRIV_INLINE inlines a part of a step, whatever its size.
 * COIN_PRIV_RARELY moves code that rarely runs out of the way.
 *
 * COIN_PRIV_SMALL is defined for processors on which each operation of doubles
 * is a call, and may be defined by the user.  The parts of a step of doubles
 * that are marked COIN_PRIV_INLINE_UNLESS_SMALL are then functions.  Each of
 * them is in the code once, and its stack is free when it returns. */
#if defined(__GNUC__)
#define COIN_PRIV_INLINE static inline __attribute__((always_inline))
#define COIN_PRIV_NOINLINE static __attribute__((noinline, unused))
#define COIN_PRIV_RARELY(condition) __builtin_expect(!!(condition), 0)
#else
#define COIN_PRIV_INLINE static inline
#define COIN_PRIV_NOINLINE static
#define COIN_PRIV_RARELY(condition) (condition)
#endif

#if defined(__arm__) && (!defined(__ARM_FP) || !(__ARM_FP & 8))
#define COIN_PRIV_SMALL
#elif defined(__riscv) && (!defined(__riscv_flen) || __riscv_flen < 64)
#define COIN_PRIV_SMALL
#endif
#if defined(COIN_PRIV_SMALL) && !defined(COIN_PRIV_FLOAT)
#define COIN_PRIV_INLINE_UNLESS_SMALL COIN_PRIV_NOINLINE
#else
#define COIN_PRIV_INLINE_UNLESS_SMALL COIN_PRIV_INLINE
#endif

#endif
