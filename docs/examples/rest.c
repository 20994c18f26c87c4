/* SPDX-License-Identifier: MIT */
/* How a spinning coin comes to rest, by each law of resistance.
 *
 *   cc rest.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * First a disc that loses little, in natural units, whose end shows the laws of
 * Eq. (75).  Then a US quarter, spun at 60 degrees; its losses are such that it
 * lies flat after 8 s.  A row is a moment so long before rest. */
#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define TOL 1e-11

enum { LAWS = 6, POINTS = 20, PER_DECADE = 5 };

static const struct {
    const char *name;
    coin_losses losses; /* of the disc */
} LAW[LAWS] = {
    {"dry", {.dry = 2e-6}},         {"viscous", {.viscous = 2e-7}},
    {"layer", {.layer = 1e-7}},     {"gap", {.gap = 2e-8}},
    {"rolling", {.rolling = 1e-3}}, {"damping", {.damping = 1e-3}},
};

static void demand(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
}

/* The turn is that of the face about the vertical, the rate that of the contact
 * along the rim. */
static void print_row(const char *body, const char *law, double left,
                      const coin_state *s, const coin_params *p,
                      const coin_losses *l)
{
    coin_state rates;
    double w[3];

    demand(coin_losses_rates(s, p, l, &rates));
    demand(coin_angular_velocity(s, w));
    printf("%s %s,%.3e,%.3e,%.3e,%.3e\n", body, law, left, PI / 2 - s->theta,
           w[1], rates.psi);
}

static void print_life(const char *body, const char *law, coin_state s,
                       const coin_params *p, const coin_losses *l)
{
    coin_state end = s;
    double rest, t = 0;

    demand(coin_settle(&end, p, l, 1e9, TOL, &rest));
    for (int k = 0; k <= POINTS; ++k) {
        const double left = rest * pow(10, -(double)k / PER_DECADE);
        demand(coin_settle(&s, p, l, rest - left - t, TOL, NULL));
        t = rest - left;
        print_row(body, law, left, &s, p, l);
    }
    printf("\n\n"); /* gnuplot's end of a curve */
}

/* A spin whose wX lets Eq. (39) hold while the losses slow wY and wZ: without a
 * swing. */
static coin_state spun(const coin_params *p, const coin_losses *l, double lean)
{
    const double m = p->mass * p->radius * p->radius, IX = p->inertia_X;
    const double K = p->inertia_Z + m, T = tan(lean), c = cos(lean);
    coin_state s, rates;

    demand(coin_steady_spin(&s, p, lean));
    demand(coin_losses_rates(&s, p, l, &rates));
    const double FY = 2 * IX * T * s.wY, FZ = K * s.wY; /* of (39) */
    const double Ftheta =
        IX * s.wY * s.wY / (c * c) - p->mass * p->gravity * p->radius * c;
    s.wX = -(FY * rates.wY + FZ * rates.wZ) /
           (Ftheta + FY * s.wY * T + FZ * m / K * s.wY);
    return s;
}

int main(void)
{
    coin_params disc, quarter;

    demand(coin_params_disc(&disc, 1, 1, 1));
    demand(coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665));
    printf("coin,left,angle,turn,rate\n");
    for (int k = 0; k < LAWS; ++k)
        print_life("disc", LAW[k].name,
                   spun(&disc, &LAW[k].losses, PI / 2 - 0.1), &disc,
                   &LAW[k].losses);
    for (int k = 0; k < LAWS; ++k) {
        coin_losses l = LAW[k].losses;
        coin_state s;
        /* Its size is found below; here it must be in range. */
        l.rolling *= quarter.mass * quarter.gravity * quarter.radius;
        demand(coin_steady_spin(&s, &quarter, PI / 3));
        demand(coin_losses_fit(&l, &s, &quarter, 8));
        s = spun(&quarter, &l, PI / 3); /* which moves the time of rolling */
        demand(coin_losses_fit(&l, &s, &quarter, 8));
        print_life("quarter", LAW[k].name, s, &quarter, &l);
    }
    return EXIT_SUCCESS;
}
