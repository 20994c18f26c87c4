/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "bernstein.h"

#include <math.h>

enum { MOST = COIN_PRIV_SQUARED, JOINED = COIN_PRIV_JOINED };

/* Halvings of [0, 1]: the part between two zeros next to each other rises by
 * 2^-28 of what the polynomial's curvature rises by over the whole. */
enum { HALVINGS = 13 };

/* Binomial coefficients of both degrees. */
static const double binomial[] = {1,    13,   78,  286, 715, 1287, 1716,
                                  1716, 1287, 715, 286, 78,  13,   1};
/* One over the first half of these. */
static const double share[] = {1.0,       1.0 / 13,   1.0 / 78,  1.0 / 286,
                               1.0 / 715, 1.0 / 1287, 1.0 / 1716};
static const double binomial_of_squares[] = {
    1,       26,      325,     2600,    14950,   65780,   230230,
    657800,  1562275, 3124550, 5311735, 7726160, 9657700, 10400600,
    9657700, 7726160, 5311735, 3124550, 1562275, 657800,  230230,
    65780,   14950,   2600,    325,     26,      1,
};

/* The first half of the numbers, from the terms at 0; `step` is 1, or -1 where
 * they are counted from the end. */
COIN_PRIV_INLINE void half_of(double *b, int step, const double *terms,
                              double h)
{
    double power = 1;
    for (int k = 0; k < COIN_PRIV_FORCE_TERMS; ++k) {
        b[step * k] = (power * share[k]) * terms[k];
        power *= h;
    }
#pragma GCC unroll 8
    for (int k = 1; k < COIN_PRIV_FORCE_TERMS; ++k)
#pragma GCC unroll 8
        for (int i = COIN_PRIV_FORCE_ORDER; i >= k; --i)
            b[step * i] += b[step * (i - 1)];
}

void coin_priv_join(double *b, const double *begin, const double *end, double h)
{
    half_of(b, 1, begin, h);
    half_of(b + JOINED, -1, end, -h);
}

void coin_priv_cone(double *b, const double *x, const double *y,
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

/* As Horner's rule: n b_1 x (1 - x)^(n - 1) and so on, the binomials as it
 * goes. */
double coin_priv_value(const double *b, int degree, double x)
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

/* Cuts at 1/2: b becomes the second part, first the first (de Casteljau). */
static void cut(double *first, double *b, int degree)
{
    for (int k = 0; k <= degree; ++k) {
        first[k] = b[0];
        for (int i = 0; i < degree - k; ++i)
            b[i] = 0.5 * (b[i] + b[i + 1]);
    }
}

/* The zero of a polynomial that begins below 0 and ends above, from above: by
 * false position, where an end that stays counts half (Illinois), and now and
 * then by halves. */
static double zero(const double *b, int degree)
{
    double low = 0, high = 1, at_low = b[0], at_high = b[degree];
    int side = 0;
    for (int i = 1; i < 64 && high - low > 1e-14; ++i) {
        const double part = i % 4 ? at_low / (at_low - at_high) : 0.5;
        const double x = low + (high - low) * part;
        const double at = coin_priv_value(b, degree, x);
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

/* The parts still to be looked at lie in a pile, the next one on top.  A part
 * is cut unless its one zero, if any, lies before its end. */
double coin_priv_rise(const double *b, int degree, double from)
{
    double pile[HALVINGS + 1][MOST + 1], widths[HALVINGS + 1] = {1}, at = 0;
    int before = -1;
    for (int k = 0; k <= degree; ++k)
        pile[0][k] = b[k];
    for (int top = 0; top >= 0;) {
        double *const now = pile[top], width = widths[top];
        const struct signs of = signs_of(now, degree);
        const int is_open = of.changes > (now[degree] != 0);
        if (is_open && top < HALVINGS && at + width > from) {
            widths[top] = widths[top + 1] = width / 2;
            cut(pile[++top], now, degree);
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
