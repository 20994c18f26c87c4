/* SPDX-License-Identifier: MIT */
/* How far a coin turns while it nods once, against the energy it nods with.
 *
 *   cc precession.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * At given integrals the least energy is that of a steady motion, about which
 * a small nod takes 2 pi/sqrt(-lambda^2): Eq. (44).  With great energy the coin
 * passes near flat on both sides, and each pass turns it by the angle of (51),
 * one way or the other. */
#include "leaf.h"

#define PI 3.14159265358979323846

enum { POINTS = 70 };

static void print_curve(double K_Y, double K_Z)
{
    coin_params p;
    coin_state s, steady = {0, 0, 0, 0, 0, 0, K_Y, K_Z};
    double L;

    demand(coin_params_disc(&p, 1, 1, 1));
    lean_to_steady(&steady, &p, push(&steady, &p) > 0 ? 1 : -1);
    demand(coin_stability(&steady, &p, &L));
    const double rate = steady.wY / cos(steady.theta);
    printf("small nods,%g,%g,0,%.9f\n\n\n", K_Y, K_Z, rate * 2 * PI / sqrt(-L));
    for (int k = 0; k <= POINTS; ++k) {
        const double E = pow(10, -4 + 0.1 * k); /* above the least */
        s = steady;
        s.wX = sqrt(2 * E / (p.inertia_X + 1));
        to_turn(&s, &p, 1);
        s.phi = 0;
        one_period(&s, &p);
        printf("nods,%g,%g,%.6e,%.7f\n", K_Y, K_Z, E, s.phi);
    }
    printf("\n\n");
}

int main(void)
{
    printf("curve,K_Y,K_Z,energy,turn\n");
    print_curve(0.8, 0.3);
    print_curve(0.45, 0.3);
    print_curve(-0.35, 1);
    print_curve(-0.2, 0.7);
    return EXIT_SUCCESS;
}
