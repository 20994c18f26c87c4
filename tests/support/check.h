/* SPDX-License-Identifier: MIT */
/* Asserts for numbers, statuses and bytes.
 *
 * cmocka's own assert on floating-point numbers casts to float.  These print
 * the value, the value wanted, their difference and its bound, and a note that
 * tells the scene, the row or the random case. */
#ifndef ROLLCOIN_TESTS_CHECK_H
#define ROLLCOIN_TESTS_CHECK_H

#include <coin.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Half the distance between 1 and the next double. */
#define U 0x1p-53

/* Sets the note that is printed if a check after it fails. */
__attribute__((format(printf, 1, 2))) void check_note(const char *format, ...);

/* A cmocka setup: clears the note of the test before. */
int check_begin(void **unused);

/* Skips the test where long double has no more digits than double, as below
 * valgrind: its reference values would not be accurate enough. */
void check_long_double(void);

/* Skips a test of a million steps unless ROLLCOIN_LONG is set. */
void check_million(void);

/* Defines a test, which runs because it is there:
 *     TEST(a_claim) { ... }  */
#define TEST(claim)                                                            \
    static void claim(void **unused);                                          \
    __attribute__((constructor)) static void add_##claim(void)                 \
    {                                                                          \
        test_add(__FILE__, #claim, claim);                                     \
    }                                                                          \
    static void claim(__attribute__((unused)) void **unused)

void test_add(const char *file, const char *claim, void (*test)(void **unused));

/* Defines what runs once, before the tests of its file:
 *     FIRST(name) { ... }  */
#define FIRST(name)                                                            \
    static void name(void **unused);                                           \
    __attribute__((constructor)) static void add_##name(void)                  \
    {                                                                          \
        test_add(__FILE__, NULL, name);                                        \
    }                                                                          \
    static void name(__attribute__((unused)) void **unused)

#define check(condition)                                                       \
    check_that((condition) ? 1 : 0, #condition, __FILE__, __LINE__)
void check_that(int holds, const char *what, const char *file, int line);

/* |got - want| <= bound; false for NaN. */
#define check_near(got, want, bound)                                           \
    check_near_at(got, want, bound, #got, __FILE__, __LINE__)
void check_near_at(double got, double want, double bound, const char *what,
                   const char *file, int line);

/* lowest <= got <= highest; false for NaN. */
#define check_within(got, lowest, highest)                                     \
    check_within_at(got, lowest, highest, #got, __FILE__, __LINE__)
void check_within_at(double got, double lowest, double highest,
                     const char *what, const char *file, int line);

/* As large a share of n random cases, but for chance: of the samples of a true
 * share 9,999 in 10,000 pass. */
#define check_share(got, n, share)                                             \
    check_share_at(got, n, share, #got, __FILE__, __LINE__)
void check_share_at(int got, int n, double share, const char *what,
                    const char *file, int line);

/* got is within `units` u times `terms` of a reference value, of which `want`
 * is the nearest double.  The rounding of the reference, u |want|, is added to
 * the difference, so that the bound is proved for the true value. */
#define check_terms(got, want, units, terms)                                   \
    check_terms_at(got, want, units, terms, #got, __FILE__, __LINE__)
void check_terms_at(double got, double want, double units, double terms,
                    const char *what, const char *file, int line);

#define check_status(got, want)                                                \
    check_status_at(got, want, #got, __FILE__, __LINE__)
void check_status_at(int32_t got, int32_t want, const char *what,
                     const char *file, int line);

/* Bit for bit. */
#define check_same(got, want, size)                                            \
    check_same_at(got, want, size, #got, __FILE__, __LINE__)
void check_same_at(const void *got, const void *want, size_t size,
                   const char *what, const char *file, int line);

#endif
