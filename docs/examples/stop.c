/* SPDX-License-Identifier: MIT */
/* A US quarter, spun, until it lies flat.
 *
 *   cc stop.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

int main(void)
{
    coin_losses l = {.viscous = 1e-9}; /* the law; its size comes next */
    coin_params p;
    coin_state s;
    double when;

    coin_params_disc(&p, 0.00567, 0.01213, 9.80665); /* kg, m, m/s^2 */
    coin_steady_spin(&s, &p, 1.0);                   /* rad, 0 is upright */
    coin_losses_fit(&l, &s, &p, 8.0);                /* flat after 8 s */
    if (coin_settle(&s, &p, &l, 60.0, 1e-6, &when) != COIN_RESTS)
        return 1;
    printf("flat after %.2f s, rolled by %.0f radians\n", when, s.psi);
    return 0;
}
