/* SPDX-License-Identifier: MIT */
/* A US quarter, thrown along the table: it slips until it rolls.
 *
 *   cc thrown.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

int main(void)
{
    const coin_friction f = {0.35, 0.3}; /* static, kinetic */
    coin_params p;
    coin_slide d = {.vx = 0.5}; /* upright, 0.5 m/s, no spin */
    int32_t status;
    double t = 0, moved = 0;

    coin_params_disc(&p, 0.00567, 0.01213, 9.80665); /* kg, m, m/s^2 */
    do {
        status = coin_slide_advance(&d, &p, &f, NULL, 1e-4, 1e-9, &moved);
        t += moved;
        if (status == COIN_ESTEP && moved > 0)
            status = COIN_SLIPS; /* a call takes 2^20 steps at most: go on */
    } while (status == COIN_SLIPS && t < 2);
    if (status == COIN_ELIFT)
        printf("lifts off after %.4f s\n", t); /* now for another model */
    else if (status < 0)
        printf("%s\n", coin_status_string(status));
    else
        printf("%s after %.4f s, at %.3f m/s\n",
               status == COIN_OK      ? "rolls"
               : status == COIN_SLIPS ? "still slips"
                                      : "lies flat",
               t, d.vx);
    return status == COIN_OK ? 0 : 1;
}
