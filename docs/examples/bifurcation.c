/* SPDX-License-Identifier: MIT */
/* Which steady motions there are, and which of them last.
 *
 *   cc bifurcation.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * First the window of unstable circles: for each rate of roll the lean beyond
 * which slow circles are stable, Eq. (44).  Then the fork of the disc: the
 * leans that are steady at given integrals K_Y and K_Z. */
#include "leaf.h"

enum { RATES = 44 };

static double lambda2(const coin_state *s, const coin_params *p)
{
    double L;

    demand(coin_stability(s, p, &L));
    return L;
}

/* --------------------------------------------------------------- window -- */

/* The lean beyond which slow circles of this rate of roll are stable. */
static double edge(const coin_params *p, double wZ)
{
    double low = 1e-6, high = 0.6;

    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        coin_state s;
        demand(coin_steady_circle(&s, p, middle, wZ, 1));
        *(lambda2(&s, p) > 0 ? &low : &high) = middle;
    }
    return low;
}

/* The rate at which that is greatest: the edge has one summit. */
static double tip(const coin_params *p)
{
    double low = 0.1, high = 0.5;

    for (int k = 0; k < 60; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        *(edge(p, a) < edge(p, b) ? &low : &high) =
            edge(p, a) < edge(p, b) ? a : b;
    }
    return low;
}

static void print_window(double inner)
{
    coin_params p;

    demand(coin_params_ring(&p, 1, 1, inner, 1));
    const double top = tip(&p), last = coin_critical_roll(&p);
    for (int k = 0; k <= RATES; ++k) {
        const double wZ = last * (k + 0.0005) / (RATES + 0.001);
        printf("window %g,%.6f,%.6f\n", inner, wZ, edge(&p, wZ));
    }
    printf("\n\ntip %g,%.9f,%.9f\n\n\n", inner, top, edge(&p, top));
}

/* ----------------------------------------------------------------- fork -- */

/* The steady motions with these integrals, from the greatest lean down. */
static int steady_motions(coin_state found[3], const coin_params *p, double K_Y,
                          double K_Z)
{
    coin_state s = {0, 0, 0, 0, 0, 0, K_Y, K_Z};
    int count = 0;

    while (cos(s.theta) > 0.05)
        lean_by(&s, p, 0.003 * cos(s.theta));
    while (count < 3 && lean_to_steady(&s, p, -1)) {
        found[count++] = s;
        lean_by(&s, p, -1e-3);
    }
    return count;
}

static void print_fork(double K_Y)
{
    coin_params p;

    demand(coin_params_disc(&p, 1, 1, 1));
    for (int k = 0; k <= RATES; ++k) {
        const double K_Z = 0.02 + 0.78 * k / RATES;
        coin_state found[3];
        const int count = steady_motions(found, &p, K_Y, K_Z);
        for (int i = 0; i < count; ++i)
            printf("fork %g,%.6f,%.6f,%.5f\n", K_Y, K_Z, found[i].theta,
                   lambda2(&found[i], &p));
    }
    printf("\n\n");
}

int main(void)
{
    printf("curve,rate,theta,lambda2\n");
    print_window(0);
    print_window(1);
    print_fork(0);
    print_fork(0.05);
    return EXIT_SUCCESS;
}
