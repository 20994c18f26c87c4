/* SPDX-License-Identifier: MIT */
#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char note[256];

void check_note(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(note, sizeof note, format, arguments);
    va_end(arguments);
}

int check_begin(void **unused)
{
    (void)unused;
    note[0] = 0;
    return 0;
}

static void fail_at(const char *file, int line)
{
    if (note[0])
        print_error("    at %s\n", note);
    _fail(file, line);
}

void check_million(void)
{
    if (!getenv("ROLLCOIN_LONG"))
        skip();
}

void check_that(int holds, const char *what, const char *file, int line)
{
    if (holds)
        return;
    print_error("does not hold: %s\n", what);
    fail_at(file, line);
}

void check_long_double(void)
{
    volatile long double one = 1, little = 1e-18L;
    if (one + little == one)
        skip();
}

void check_near_at(double got, double want, double bound, const char *what,
                   const char *file, int line)
{
    if (fabs(got - want) <= bound)
        return;
    print_error("%s\n    got %.17g, want %.17g: off by %.3g, bound %.3g\n",
                what, got, want, got - want, bound);
    fail_at(file, line);
}

void check_within_at(double got, double lowest, double highest,
                     const char *what, const char *file, int line)
{
    if (got >= lowest && got <= highest)
        return;
    print_error("%s\n    got %.17g, not within %.6g ... %.6g\n", what, got,
                lowest, highest);
    fail_at(file, line);
}

/* How probable k of n cases are. */
static double binomial(int k, int n, double share)
{
    const double ways = lgamma(n + 1) - lgamma(k + 1) - lgamma(n - k + 1);
    return exp(ways + k * log(share) + (n - k) * log1p(-share));
}

void check_share_at(int got, int n, double share, const char *what,
                    const char *file, int line)
{
    int least = 0;
    for (double fewer = 0; least <= n; ++least) {
        fewer += binomial(least, n, share);
        if (fewer > 1e-4)
            break;
    }
    if (got >= least)
        return;
    print_error("%s\n    got %d of %d, which of a share of %g should be %d\n",
                what, got, n, share, least);
    fail_at(file, line);
}

void check_terms_at(double got, double want, double units, double terms,
                    const char *what, const char *file, int line)
{
    const double error = fabs(got - want) + U * fabs(want);
    if (error <= units * U * terms || (got == 0 && want == 0))
        return;
    print_error("%s\n    got %.17g, want %.17g: off by %.3g, which is %.3g u "
                "of the terms %.3g; allowed %g u\n",
                what, got, want, got - want, error / (U * terms), terms, units);
    fail_at(file, line);
}

void check_status_at(int32_t got, int32_t want, const char *what,
                     const char *file, int line)
{
    if (got == want)
        return;
    print_error("%s\n    got %d (%s), want %d (%s)\n", what, (int)got,
                coin_status_string(got), (int)want, coin_status_string(want));
    fail_at(file, line);
}

void check_same_at(const void *got, const void *want, size_t size,
                   const char *what, const char *file, int line)
{
    const unsigned char *g = got, *w = want;
    size_t i = 0;
    if (memcmp(got, want, size) == 0)
        return;
    while (g[i] == w[i])
        ++i;
    print_error("%s\n    byte %zu of %zu differs: %02x, not %02x\n", what, i,
                size, g[i], w[i]);
    fail_at(file, line);
}
