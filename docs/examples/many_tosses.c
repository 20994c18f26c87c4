/* SPDX-License-Identifier: MIT */
/* Many tosses of a quarter, by threads in all processors: how many show heads.
 *
 *   cc -fopenmp many_tosses.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out 100000
 *
 * A toss depends on its number alone: whichever thread makes it, it has the
 * same bits.  A compiler without OpenMP makes one toss after the other. */
#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    char *rest = NULL;
    const long count = argc == 2 ? strtol(argv[1], &rest, 10) : 0;
    long heads = 0, failed = 0;
    coin_params p;
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.5};

    if (count < 1 || *rest) {
        fprintf(stderr, "usage: many_tosses COUNT, a whole number from 1 on\n");
        return EXIT_FAILURE;
    }
    coin_params_disc(&p, 0.00567, 0.01213, 9.80665); /* kg, m, m/s^2 */
    table.losses.dry = 5e-3 * p.mass * p.gravity * p.radius;
#pragma omp parallel for schedule(dynamic) reduction(+ : heads, failed)
    for (long i = 0; i < count; ++i) {
        coin_body b = {.s = {.theta = 1, .wX = 200 + (double)i / 100, .wZ = 5},
                       .y = 0.5,
                       .vy = 2}; /* tails up, m and rad/s */
        int32_t status = 0;
        while (status >= 0 && !(status & COIN_RESTS))
            status = coin_move(&b, &p, &table, INFINITY, 1e-6, 0, NULL);
        failed += status < 0;
        heads += status >= 0 && b.s.theta < 0;
    }
    printf("%ld of %ld show heads\n", heads, count);
    if (failed > 0)
        fprintf(stderr, "many_tosses: %ld failed\n", failed);
    return failed > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
