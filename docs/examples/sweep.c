/* SPDX-License-Identifier: MIT */
/* A million coins, let go at every lean and in every direction of spin: which
 * fall, and which roll on?
 *
 *   cc sweep.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out 1000 sweep.ppm
 *
 * To the right the lean, upwards the direction of the spin in the coin's plane
 * and axis, wY = W sin, wZ = W cos.  Who rolls on is blue, the paler the more
 * it nods; who falls is red, the darker the sooner. */
#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979324
#define W 1.2 /* in sqrt(g/a) */

/* 24 natural units of time.  A step of 0.05 is coarse for a coin that turns at
 * more than 7 sqrt(g/a): only near the table, at some 10 degrees, does it. */
enum { CALLS = 40, STEPS = 12 };

/* How far a coin has leaned to either side, and in which call it fell. */
typedef struct fate {
    float least, most;
    int fell;
} fate;

/* The middle of the k-th of n parts of a whole, from -1/2 to 1/2. */
static double part(size_t k, size_t n)
{
    return ((double)k + 0.5) / (double)n - 0.5;
}

static void let_go(coin_state *s, fate *f, double lean, double turn)
{
    s->theta = PI * lean;
    s->wY = W * sin(2 * PI * turn);
    s->wZ = W * cos(2 * PI * turn);
    f->least = f->most = (float)s->theta;
}

/* All coins at once; then what became of each. */
static int roll_on(coin_state *coins, fate *fates, int32_t *status,
                   size_t count, const coin_params *p)
{
    for (int call = 1; call <= CALLS; ++call) {
        const int32_t all =
            coin_batch_run(coins, count, p, COIN_RK4, 0.05, STEPS, status);
        if (all == COIN_EARG || all == COIN_EPARAMS)
            return 0;
        for (size_t i = 0; i < count; ++i) {
            fate *f = &fates[i];
            if (status[i] != COIN_OK && !f->fell)
                f->fell = call;
            f->least = fminf(f->least, (float)coins[i].theta);
            f->most = fmaxf(f->most, (float)coins[i].theta);
        }
    }
    return 1;
}

/* A colour between those of a row of four. */
static void paint(unsigned char rgb[3], const unsigned char row[4][3],
                  double part)
{
    const double at = 3 * fmin(fmax(part, 0), 0.9999);
    const int k = (int)at;

    for (int i = 0; i < 3; ++i)
        rgb[i] =
            (unsigned char)(row[k][i] + (at - k) * (row[k + 1][i] - row[k][i]));
}

static size_t draw(FILE *f, const fate *fates, size_t side)
{
    static const unsigned char blue[4][3] = {
        {10, 20, 70}, {0, 114, 178}, {86, 180, 233}, {245, 240, 170}};
    static const unsigned char red[4][3] = {
        {60, 10, 0}, {150, 50, 0}, {213, 94, 0}, {255, 210, 170}};
    size_t fell = 0;

    fprintf(f, "P6\n%zu %zu\n255\n", side, side);
    for (size_t row = side; row-- > 0;)
        for (size_t i = row * side; i < (row + 1) * side; ++i) {
            unsigned char rgb[3];
            if (fates[i].fell)
                paint(rgb, red, sqrt((double)fates[i].fell / CALLS));
            else
                paint(rgb, blue, (fates[i].most - fates[i].least) / PI);
            fell += fates[i].fell > 0;
            fwrite(rgb, 1, 3, f);
        }
    return fell;
}

int main(int argc, char **argv)
{
    const size_t side = argc > 1 ? strtoul(argv[1], NULL, 10) : 0;
    const size_t count = side * side;
    coin_state *coins = calloc(count, sizeof *coins);
    fate *fates = calloc(count, sizeof *fates);
    int32_t *status = calloc(count, sizeof *status);
    FILE *f = argc > 2 ? fopen(argv[2], "wb") : NULL;
    coin_params p;
    int done = 0;

    if (side > 0 && coins && fates && status && f &&
        coin_params_disc(&p, 1, 1, 1) == COIN_OK) {
        for (size_t i = 0; i < count; ++i)
            let_go(&coins[i], &fates[i], part(i % side, side),
                   part(i / side, side));
        done = roll_on(coins, fates, status, count, &p);
    }
    if (done)
        printf("%zu of %zu coins fell\n", draw(f, fates, side), count);
    free(coins);
    free(fates);
    free(status);
    if (!done || fclose(f) != 0) {
        fprintf(stderr, "usage: sweep SIDE PICTURE.ppm\n");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
