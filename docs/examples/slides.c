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

static const coin_friction FRICTION = {0.3, 0.27};

static void demand(int32_t status)
{
    if (status != COIN_OK && status != COIN_SLIPS) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
}

static int32_t go_on(coin_slide *d, const coin_params *p, double t)
{
    const int32_t status =
        coin_slide_advance(d, p, &FRICTION, NULL, t, TOL, NULL);

    demand(status);
    return status;
}

static void print_row(double direction, double t, const coin_slide *d,
                      const coin_params *p)
{
    double r[3], v[3], u[2];

    demand(coin_contact(&d->s, p, r, v));
    demand(coin_slide_velocity(d, p, u));
    printf("%g,%.4f,%.4f,%.4f,%.4f\n", direction, t, r[0], r[2],
           hypot(u[0], u[1]));
}

static coin_slide thrown(double direction)
{
    const double speed = 1.8, angle = direction * PI / 180;
    const coin_slide d = {
        {.theta = 0.1, .wZ = 7}, speed * cos(angle), speed * sin(angle)};
    return d;
}

/* The time until a coin that slips at *from rolls, which it does within t. */
static double until_it_rolls(const coin_slide *from, const coin_params *p,
                             double t)
{
    double slips = 0, rolls = t;

    for (int k = 0; k < 30; ++k) {
        const double middle = (slips + rolls) / 2;
        coin_slide d = *from;
        *(go_on(&d, p, middle) == COIN_SLIPS ? &slips : &rolls) = middle;
    }
    return rolls;
}

/* Rows from t until it rolls, or TIME: returns when. */
static double print_slip(double direction, coin_slide *d, const coin_params *p)
{
    for (int k = 0;; ++k) {
        coin_slide next = *d;
        print_row(direction, k * ROW, d, p);
        if (go_on(&next, p, ROW) == COIN_OK) {
            const double rest = until_it_rolls(d, p, ROW);
            go_on(d, p, rest);
            return k * ROW + rest;
        }
        *d = next;
    }
}

static void print_roll(double direction, double t, coin_slide *d,
                       const coin_params *p)
{
    const int rows = (int)ceil((TIME - t) / ROW);

    for (int k = 0; k <= rows; ++k) {
        print_row(direction, t + (TIME - t) * k / rows, d, p);
        go_on(d, p, (TIME - t) / rows);
    }
}

int main(void)
{
    coin_params disc;

    demand(coin_params_disc(&disc, 1, 1, 1));
    printf("direction,t,x,z,slip\n");
    for (int direction = -60; direction <= 60; direction += 30) {
        coin_slide d = thrown(direction);
        const double rolls = print_slip(direction, &d, &disc);
        print_row(direction, rolls, &d, &disc);
        printf("\n\n"); /* gnuplot's end of a curve */
        print_roll(direction, rolls, &d, &disc);
        printf("\n\n");
    }
    return EXIT_SUCCESS;
}
