/* SPDX-License-Identifier: MIT */
/* toss.c: docs/examples/js/toss.mjs in C. */
#include <coin.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.4};
    coin_params p;
    coin_body b = {{1, 0, 0, 0, 0, 90, 5, 5}, 0.05, 0.1, 1.2, 0, {0, 0, 0, 0}};
    double reached = 0;

    coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
    table.losses.dry = 1e-2 * 0.00567 * 9.80665 * 0.01213;
    const int32_t status =
        coin_move(&b, &p, &table, INFINITY, 1e-6, 0, &reached);
    printf("%s after %.6f s: %s\n", b.s.theta < 0 ? "heads" : "tails", reached,
           coin_status_string(status));
    return status < 0;
}
