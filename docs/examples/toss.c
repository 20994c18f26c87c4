/* SPDX-License-Identifier: MIT */
/* toss.c: tosses a US quarter until it rests.  The packages for other languages
 * have the same toss in their README. */
#include <coin.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    const char *sides[] = {"nothing", "heads", "tails", "edge"};
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.4};
    coin_body coin = {.s = {.theta = 1, .wX = 90, .wY = 5, .wZ = 5}, /* 1/s */
                      .y = 0.05,                                     /* m */
                      .vx = 0.1,                                     /* m/s */
                      .vy = 1.2};
    coin_params p;
    double reached = 0;

    coin_params_cylinder(&p, 0.00567, 0.01213, 0.00175, 9.80665); /* kg, m */
    table.losses.dry = 1e-2 * p.mass * p.gravity * p.radius;
    if (coin_move(&coin, &p, &table, INFINITY, 1e-6, 0, &reached) < 0)
        return 1;
    printf("%s after %.6f s\n", sides[coin_body_face(&coin, &p)], reached);
}
