/* SPDX-License-Identifier: MIT */
/* A disc thrown along the table in five directions, with a backward spin: it
 * slips, curves, turns back and begins to roll.
 *
 *   cc slides.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * In natural units, M = a = g = 1.  A row is a moment: the direction in degrees
 * from the coin's plane, the time, the point of contact, and the slip speed.
 * The first block of a direction slips, the second rolls. */
#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define TOL 1e-10
#define TIME 14.0
#define ROW 0.4 /* between two rows */

static const coin_table TABLE = {.mu_static = 0.3, .mu_kinetic = 0.27};

static void demand(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
}

static int32_t go_on(coin_body *d, const coin_params *p, double t, int32_t stop,
                     double *moved)
{
    const int32_t status = coin_move(d, p, &TABLE, t, TOL, stop, moved);

    demand(status);
    return status;
}

static void print_row(double direction, double t, const coin_body *d,
                      const coin_params *p)
{
    double r[3], v[3], u[3];

    demand(coin_contact(&d->s, p, r, v));
    demand(coin_body_contact(d, p, u));
    printf("%g,%.4f,%.4f,%.4f,%.4f\n", direction, t, r[0], r[2],
           hypot(u[0], u[2]));
}

static coin_body thrown(double direction, const coin_params *p)
{
    const double speed = 1.8, angle = direction * PI / 180;
    const coin_state s = {.theta = 0.1, .wZ = 7};
    coin_body d;

    demand(coin_body_from_state(&d, &s, p));
    d.vx = speed * cos(angle);
    d.vz = speed * sin(angle);
    return d;
}

/* Rows until it rolls: returns when. */
static double print_slip(double direction, coin_body *d, const coin_params *p)
{
    double t = 0, moved;
    int32_t status = COIN_SLIPS;

    while (status & COIN_SLIPS) {
        print_row(direction, t, d, p);
        status = go_on(d, p, ROW, COIN_ROLLS, &moved);
        t += moved;
    }
    return t;
}

static void print_roll(double direction, double t, coin_body *d,
                       const coin_params *p)
{
    const int rows = (int)ceil((TIME - t) / ROW);

    for (int k = 0; k <= rows; ++k) {
        print_row(direction, t + (TIME - t) * k / rows, d, p);
        go_on(d, p, (TIME - t) / rows, 0, NULL);
    }
}

int main(void)
{
    coin_params disc;

    demand(coin_params_disc(&disc, 1, 1, 1));
    printf("direction,t,x,z,slip\n");
    for (int direction = -60; direction <= 60; direction += 30) {
        coin_body d = thrown(direction, &disc);
        const double rolls = print_slip(direction, &d, &disc);
        print_row(direction, rolls, &d, &disc);
        printf("\n\n"); /* gnuplot's end of a curve */
        print_roll(direction, rolls, &d, &disc);
        printf("\n\n");
    }
    return EXIT_SUCCESS;
}
