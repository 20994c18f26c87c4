/* SPDX-License-Identifier: MIT */
/* A US quarter, thrown along the table: it slips until it rolls.
 *
 *   cc thrown.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

int main(void)
{
    const coin_table table = {.mu_static = 0.35, .mu_kinetic = 0.3};
    const coin_state upright = {.theta = 0};
    coin_params p;
    coin_body b;
    double t;

    coin_params_disc(&p, 0.00567, 0.01213, 9.80665); /* kg, m, m/s^2 */
    coin_body_from_state(&b, &upright, &p);
    b.vx = 0.5; /* m/s, without spin */
    const int32_t status = coin_move(&b, &p, &table, 2, 1e-9, COIN_ROLLS, &t);
    if (status != COIN_ROLLS) {
        printf("%s\n", coin_status_string(status));
        return 1;
    }
    printf("rolls after %.4f s, at %.3f m/s\n", t, b.vx);
    return 0;
}
