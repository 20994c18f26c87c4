/* SPDX-License-Identifier: MIT */
/* The valley that the lean of a coin swings in: its effective potential.
 *
 *   cc potential.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * Coins with the same two linear integrals share one potential V(theta), and
 * differ in the energy with which they swing in it: Eq. (48).  A coin that
 * swings wildly shows it all: V = E - J wX^2/2. */
#include "leaf.h"

static coin_params disc(void)
{
    coin_params p;

    demand(coin_params_disc(&p, 1, 1, 1));
    return p;
}

/* wY and wZ upright are the integrals K_Y and K_Z. */
static coin_state upright(double wX, double K_Y, double K_Z)
{
    const coin_state s = {0, 0, 0, 0, 0, wX, K_Y, K_Z};
    return s;
}

static double potential(const coin_state *s, const coin_params *p)
{
    const double J = p->inertia_X + p->mass * p->radius * p->radius;
    return coin_energy(s, p) - J * s->wX * s->wX / 2;
}

static void print_potential(const char *name, double K_Y, double K_Z)
{
    const coin_params p = disc();
    coin_state s = upright(2.5, K_Y, K_Z);

    to_turn(&s, &p, 1);
    do {
        printf("%s,%.5f,%.6f\n", name, s.theta, potential(&s, &p));
        roll_on(&s, &p, 0.02);
    } while (s.wX < 0);
    printf("\n\n");
}

/* Between which leans a coin of this energy swings. */
static void print_swing(double wX, double K_Y, double K_Z)
{
    const coin_params p = disc();
    coin_state s = upright(wX, K_Y, K_Z);
    const double E = coin_energy(&s, &p);

    to_turn(&s, &p, 1);
    printf("swing,%.12f,%.12f\n", s.theta, E);
    to_turn(&s, &p, -1);
    printf("swing,%.12f,%.12f\n\n\n", s.theta, E);
}

static void print_steady(double K_Y, double K_Z)
{
    const coin_params p = disc();
    coin_state s = upright(0, K_Y, K_Z);

    lean_to_steady(&s, &p, push(&s, &p) > 0 ? 1 : -1);
    printf("steady,%.12f,%.12f\n\n\n", s.theta, coin_energy(&s, &p));
}

int main(void)
{
    const double speeds[] = {0.3, 0.45, 0.57735026918962576, 0.7};

    printf("curve,theta,V\n");
    for (int k = 0; k < 4; ++k) {
        char name[32];
        snprintf(name, sizeof name, "roll %.3f", speeds[k]);
        print_potential(name, 0, speeds[k]);
    }
    print_potential("leaf", 0.35, 1);
    print_steady(0.35, 1);
    print_swing(0.2, 0.35, 1);
    print_swing(0.6, 0.35, 1);
    print_swing(1, 0.35, 1);
    return EXIT_SUCCESS;
}
