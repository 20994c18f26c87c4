/* SPDX-License-Identifier: MIT */
/* A nickel rocks to rest on its edge: its lean in time, and then its rate when
 * it comes to upright, pass by pass.
 *
 *   cc rocking.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * Each pass leaves Housner's ratio of the rate: docs/physics.md, Eq. (128). */
#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TOL 1e-11
#define ROW 5e-3 /* s */
#define TIME 1.5 /* that rows are printed for, s */
#define LEAN 5.0 /* degrees */

static const coin_table table = {.mu_static = 0.4, .mu_kinetic = 0.3};
static coin_params nickel;

static int32_t demand(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
    return status;
}

static coin_body let_go(void)
{
    const coin_state lean = {.theta = LEAN * acos(-1) / 180};
    coin_body b;

    demand(coin_body_from_state(&b, &lean, &nickel));
    return b;
}

static void print_lean(void)
{
    coin_body b = let_go();

    for (int k = 0; k * ROW <= TIME; ++k) {
        printf("lean,%.3f,%.5f\n", k * ROW, b.s.theta * 180 / acos(-1));
        demand(coin_move(&b, &nickel, &table, ROW, TOL, 0, NULL));
    }
}

static void print_passes(void)
{
    coin_body b = let_go();
    double t = 0, moved;
    int32_t status = COIN_OK;

    while (!(status & COIN_RESTS)) {
        status = demand(coin_move(&b, &nickel, &table, INFINITY, TOL,
                                  COIN_TOUCHES, &moved));
        t += moved;
        printf("%s,%.8f,%.6e\n", status & COIN_RESTS ? "rest" : "pass", t,
               fabs(b.s.wX));
    }
}

int main(void)
{
    demand(coin_params_cylinder(&nickel, 0.005, 0.010605, 1.95e-3, 9.80665));
    printf("what,t,value\n");
    print_lean();
    printf("\n\n"); /* gnuplot's end of a curve */
    print_passes();
    return EXIT_SUCCESS;
}
