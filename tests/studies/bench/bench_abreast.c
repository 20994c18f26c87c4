/* SPDX-License-Identifier: MIT */
/* What coin_advance() could gain from a coin in each lane: a prototype of its
 * step with lanes over coins beside the library's, whose lanes are over the
 * columns of one coin; and how many lanes would be busy, when each coin has
 * steps of its own.
 *     bench_abreast BUILD          CSV */
#include "clock.h"
#include "counted.h"
#include "workprec.h"

#include <extrapolation.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef double lanes __attribute__((vector_size(8 * COIN_PRIV_LANES)));

struct variables {
    lanes X, Y, Z, sth, cth, sph, cph;
};
#define EACH_VARIABLE(F) F(X) F(Y) F(Z) F(sth) F(cth) F(sph) F(cph)

struct path {
    lanes psi, x, z, dY, dcth;
};

/* Units as in extrapolation.c, but of each coin. */
struct problem {
    struct variables start;
    lanes G, KJ, XJ, k, Z;
};

static const double double_substep[] = {15, 20, 24, 30, 40, 60, 120};
static const int half_substeps[] = {8, 6, 5, 4, 3, 2, 1};
static const double weight[] = {6.3, -11.7, 7.8, -1.5, 0.08, -6e-4, 4e-7};

static inline void add_slope(struct variables *to, const struct problem *p,
                             const struct variables *y, lanes h2)
{
    const lanes hX = h2 * y->X, hY = h2 * y->Y, hcth = h2 * y->cth;
    const lanes m = y->cth * y->X, n = y->cth * y->Z, e = y->sth * y->Y;
    to->X += (p->G * y->sth) * hcth - hY * (p->KJ * n + p->XJ * e);
    to->Y += hX * (e + n);
    to->Z += (p->k * hY) * m;
    to->sth += hcth * m;
    to->cth -= hcth * (y->sth * y->X);
    to->sph += hY * y->cph;
    to->cph -= hY * y->sph;
}

#define AT_EVEN(v) p->start.v + even.v,
#define AT_ODD(v) p->start.v + odd.v,
#define FIRST(v) (0.5 * h2) * slope->v,
#define TOTAL(v) to->v += w * even.v;

/* One column of all coins, added to what they sum up to. */
static inline void column(int i, const struct problem *p,
                          const struct variables *slope, struct variables *to,
                          struct path *sum)
{
    const lanes none = {0}, h2 = none + double_substep[i], w = none + weight[i];
    struct variables even = {0}, odd = {EACH_VARIABLE(FIRST)};
    for (int k = 0; k < half_substeps[i]; ++k) {
        const struct variables before = {EACH_VARIABLE(AT_EVEN)};
        if (k > 0)
            add_slope(&odd, p, &before, h2);
        const struct variables y = {EACH_VARIABLE(AT_ODD)};
        add_slope(&even, p, &y, h2);
        const lanes dps = w * h2 * ((y.cth * y.Z) * p->Z + y.sth * y.Y);
        sum->psi += dps;
        sum->x -= dps * y.cph;
        sum->z += dps * y.sph;
        sum->dY += w * odd.Y;
        sum->dcth += w * odd.cth;
    }
    EACH_VARIABLE(TOTAL)
}

static void step(const struct problem *p, struct variables *to,
                 struct path *sum)
{
    const lanes none = {0};
    struct variables slope = {0};
    add_slope(&slope, p, &p->start, none + 1);
    for (int i = 0; i < 7; ++i)
        column(i, p, &slope, to, sum);
}

static double step_abreast(double tare)
{
    static struct problem p;
    static struct variables to;
    static struct path sum;
    const lanes none = {0};
    p.start.X = p.start.Y = p.start.Z = none + 1e-3;
    p.start.cth = p.start.cph = none + 1;
    const double begin = clock_ns();
    for (int i = 0; i < 64; ++i) {
        step(&p, &to, &sum);
        __asm__ volatile("" : : "r"(&p), "r"(&to), "r"(&sum) : "memory");
    }
    return (clock_ns() - begin - tare) / (64 * COIN_PRIV_LANES);
}

static coin_params disc;

static double step_alone(double tare)
{
    const coin_state s = {.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2};
    coin_priv_run r;
    coin_priv_check(&s, &disc, &r.b);
    coin_priv_run_unlimited(&r, &s);
    const double begin = clock_ns();
    for (int i = 0; i < 64; ++i) {
        double error = 1;
        coin_priv_extrapolate(&r, 1e-3, &error);
    }
    return (clock_ns() - begin - tare) / 64;
}

static double drawn(double width)
{
    static unsigned long long x = 1;
    x = x * 6364136223846793005ULL + 1442695040888963407ULL;
    return width * ((double)(x >> 11) / 9007199254740992.0 - 0.5);
}

/* The share of lanes at work, where a vector is done when its last coin is. */
static double busy(double spread, double tol)
{
    double all = 0, held = 0;
    for (int group = 0; group < 1000; ++group) {
        unsigned long most = 0;
        for (int k = 0; k < COIN_PRIV_LANES; ++k) {
            coin_state s = {.theta = 0.2 + drawn(2 * spread),
                            .wX = drawn(2 * spread),
                            .wY = 0.8 + drawn(3 * spread),
                            .wZ = 1.2 + drawn(4 * spread)};
            workprec_slopes = 0;
            counted_advance(&s, &disc, 4, tol, NULL);
            all += (double)workprec_slopes;
            most = workprec_slopes > most ? workprec_slopes : most;
        }
        held += (double)(most * COIN_PRIV_LANES);
    }
    return all / held;
}

int main(int argc, char **argv)
{
    const double tare = clock_cost();
    double abreast = INFINITY, alone = INFINITY;
    coin_params_disc(&disc, 1, 1, 1);
    for (int i = 0; i < 4000; ++i) {
        abreast = fmin(abreast, step_abreast(tare));
        alone = fmin(alone, step_alone(tare));
    }
    printf("%s,%d,%.3g,%.3g,%.3g,%.2g,%.2g\n", argc > 1 ? argv[1] : "unnamed",
           COIN_PRIV_LANES, abreast, alone, alone / abreast, busy(0.01, 1e-9),
           busy(1, 1e-9));
    return 0;
}
