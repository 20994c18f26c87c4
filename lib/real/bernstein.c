/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "bernstein.h"

#include "ends.t.h"

#include <math.h>

enum { MOST = COIN_PRIV_SQUARED, JOINED = COIN_PRIV_JOINED };

/* The most halvings of [0, 1].  Between two zeros that are nearer to each other
 * than 2^-13, a polynomial rises by at most 2^-29 of the largest value of its
 * second derivative. */
enum { HALVINGS = 13 };

/* Binomial coefficients of degree 13, and below those of degree 26. */
static const double binomial[] = {1,    13,   78,  286, 715, 1287, 1716,
                                  1716, 1287, 715, 286, 78,  13,   1};
/* 1/C(n, k), k < terms, for the degrees n that all, some and few terms make. */
static const double share[] = {1.0,       1.0 / 13,   1.0 / 78,  1.0 / 286,
                               1.0 / 715, 1.0 / 1287, 1.0 / 1716};
static const double share_of_some[] = {1.0, 1.0 / 9, 1.0 / 36, 1.0 / 84,
                                       1.0 / 126};
static const double share_of_few[] = {1.0, 1.0 / 5, 1.0 / 10};
static const double binomial_of_squares[] = {
    1,       26,      325,     2600,    14950,   65780,   230230,
    657800,  1562275, 3124550, 5311735, 7726160, 9657700, 10400600,
    9657700, 7726160, 5311735, 3124550, 1562275, 657800,  230230,
    65780,   14950,   2600,    325,     26,      1,
};

/* The first half of the numbers comes from the series at 0, the second from
 * that at 1, where the same sums are made with a step of -h. */
COIN_PRIV_INLINE void join_of(double *b, const coin_priv_ends *ends, double h,
                              double scale, const double *shares, int terms)
{
    const int degree = COIN_PRIV_DEGREE(terms);
    for (int which = 0; which < 2; which += LANES) {
        const lanes step = at_ends(h, -h, which);
        lanes power = at_ends(scale, scale, which), sum[COIN_PRIV_FORCE_TERMS];
#pragma GCC unroll 8
        for (int k = 0; k < terms; ++k) {
            sum[k] = (power * shares[k]) * load(&ends[k].at[which]);
            power *= step;
        }
#pragma GCC unroll 8
        for (int k = 1; k < terms; ++k)
#pragma GCC unroll 8
            for (int i = terms - 1; i >= k; --i)
                sum[i] += sum[i - 1];
#pragma GCC unroll 8
        for (int k = 0; k < terms; ++k) {
            double both[2];
            store(&both[which], sum[k]);
            if (LANES > 1 || which == 0)
                b[k] = both[0];
            if (LANES > 1 || which == 1)
                b[degree - k] = both[1];
        }
    }
}

void coin_priv_join(double *b, const coin_priv_ends *ends, double h,
                    double scale, int terms)
{
    if (terms == COIN_PRIV_FORCE_FEW)
        join_of(b, ends, h, scale, share_of_few, COIN_PRIV_FORCE_FEW);
    else if (terms == COIN_PRIV_FORCE_SOME)
        join_of(b, ends, h, scale, share_of_some, COIN_PRIV_FORCE_SOME);
    else
        join_of(b, ends, h, scale, share, COIN_PRIV_FORCE_TERMS);
}

void coin_priv_cone_polynomial(double *b, const double *x, const double *y,
                               const double *z)
{
    double wx[JOINED + 1], wy[JOINED + 1], wz[JOINED + 1];
    for (int i = 0; i <= JOINED; ++i) {
        wx[i] = binomial[i] * x[i];
        wy[i] = binomial[i] * y[i];
        wz[i] = binomial[i] * z[i];
    }
    for (int k = 0; k <= MOST; ++k) {
        double sum = 0;
        for (int i = k > JOINED ? k - JOINED : 0; i <= JOINED && i <= k; ++i)
            sum += (wx[i] * wx[k - i] + wy[i] * wy[k - i]) - wz[i] * wz[k - i];
        b[k] = sum / binomial_of_squares[k];
    }
}

/* Horner's rule in 1 - x.  `weight` is C(n, k) x^k. */
double coin_priv_bernstein_value(const double *b, int degree, double x)
{
    const double y = 1 - x;
    double sum = b[0] * y, weight = 1;
    for (int k = 1; k < degree; ++k) {
        weight *= x * (degree - k + 1) / k;
        sum = (sum + weight * b[k]) * y;
    }
    return sum + weight * (x / degree) * b[degree];
}

/* The signs of the first and the last number that is not 0, and how often the
 * sign changes between them. */
struct signs {
    int first, last, changes;
};

static struct signs signs_of(const double *b, int degree)
{
    struct signs r = {0, 0, 0};
    for (int k = 0; k <= degree; ++k) {
        const int sign = (b[k] > 0) - (b[k] < 0);
        r.changes += r.last * sign < 0;
        r.first = r.first != 0 ? r.first : sign;
        r.last = sign != 0 ? sign : r.last;
    }
    return r;
}

void coin_priv_halve(double *first, double *b, int degree)
{
    for (int k = 0; k <= degree; ++k) {
        first[k] = b[0];
        for (int i = 0; i < degree - k; ++i)
            b[i] = 0.5 * (b[i] + b[i + 1]);
    }
}

/* coin_priv_halve() for a constant degree, so that the sums stay in registers.
 * It adds neighbours, and multiplies by the powers of 1/2 at the end. */
COIN_PRIV_INLINE void cut_joined(double *first, double *b, int degree)
{
    double sum[JOINED + 1], half = 1;
#pragma GCC unroll 16
    for (int i = 0; i <= degree; ++i)
        sum[i] = b[i];
#pragma GCC unroll 16
    for (int k = 0; k <= degree; ++k) {
        first[k] = half * sum[0];
        b[degree - k] = half * sum[degree - k];
#pragma GCC unroll 16
        for (int i = 0; i < degree - k; ++i)
            sum[i] += sum[i + 1];
        half *= 0.5;
    }
}

void coin_priv_halve_joined(double *first, double *b, int terms)
{
    if (terms == COIN_PRIV_FORCE_FEW)
        cut_joined(first, b, COIN_PRIV_DEGREE(COIN_PRIV_FORCE_FEW));
    else if (terms == COIN_PRIV_FORCE_SOME)
        cut_joined(first, b, COIN_PRIV_DEGREE(COIN_PRIV_FORCE_SOME));
    else
        cut_joined(first, b, JOINED);
}

/* The zero of a polynomial that begins below 0 and ends above; the upper end of
 * the last bracket, whose length 1e-14 is about 50 times rounding.  By false
 * position, which halves the value at an end that stays (Illinois), and every
 * fourth time by halving the bracket. */
static double zero(const double *b, int degree)
{
    double low = 0, high = 1, at_low = b[0], at_high = b[degree];
    int side = 0;
    for (int i = 1; i < 64 && high - low > 1e-14; ++i) {
        const double part = i % 4 ? at_low / (at_low - at_high) : 0.5;
        const double x = low + (high - low) * part;
        const double at = coin_priv_bernstein_value(b, degree, x);
        if (at > 0) {
            at_low *= side > 0 ? 0.5 : 1;
            side = 1;
            high = x;
            at_high = at;
        } else {
            at_high *= side < 0 ? 0.5 : 1;
            side = -1;
            low = x;
            at_low = at;
        }
    }
    return high;
}

/* The parts still to be examined are in a stack, the next one on top.  A part
 * is cut unless it has at most one zero, which lies before its end. */
double coin_priv_first_positive(const double *b, int degree, double from)
{
    double stack[HALVINGS + 1][MOST + 1], widths[HALVINGS + 1] = {1}, at = 0;
    int before = -1;
    for (int k = 0; k <= degree; ++k)
        stack[0][k] = b[k];
    for (int top = 0; top >= 0;) {
        double *const now = stack[top], width = widths[top];
        const struct signs of = signs_of(now, degree);
        const int is_open = of.changes > (now[degree] != 0);
        if (is_open && top < HALVINGS && at + width > from) {
            widths[top] = widths[top + 1] = width / 2;
            coin_priv_halve(stack[++top], now, degree);
            continue;
        }
        double place = -2;
        if (before < 0 && of.first > 0)
            place = at;
        else if (of.first < 0 && of.last > 0)
            place = at + width * zero(now, degree);
        if (place > from)
            return place;
        before = of.last != 0 ? of.last : before;
        at += width;
        --top;
    }
    return 2;
}
