/* SPDX-License-Identifier: MIT */
/* A user's file, C99 or C++, that takes the library in: what follows the header
 * is compiled as the user's flags say, and no name of the library is in the
 * way of the user's own. */
#define COIN_API static
#define COIN_IMPLEMENTATION
#include <coin.h>

#define B 2
#define LAST 3
#define TEXT(x) x

struct row {
    double drift;
};

double fusible(double a, double b, double c);
double fusible(double a, double b, double c)
{
    return a * b + c;
}

static double advance(struct row *step, double larger)
{
    return step->drift += fusible(larger, B, TEXT(LAST));
}

int main(void)
{
    struct row steady = {1};
    coin_params p;
    coin_state s = {0.3, 0, 0, 0, 0, 0, 5, 40};

    return coin_params_disc(&p, 0.00567, 0.01213, 9.80665) < 0 ||
           coin_run(&s, &p, COIN_RK8, 1.0 / 60, 60, NULL) < 0 ||
           coin_selftest() != COIN_OK || coinf_selftest() != COIN_OK ||
           advance(&steady, 0.5) != 5;
}
