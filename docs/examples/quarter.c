/* SPDX-License-Identifier: MIT */
/* A US quarter rolls for a second: the least that a program in C does.
 *
 *   cc quarter.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

int main(void)
{
    coin_params p;
    coin_state s = {.theta = 0.3, .wY = 5, .wZ = 40}; /* rad, rad/s */
    coin_force f;
    int32_t status = coin_params_disc(&p, 0.00567, 0.01213, 9.80665);

    for (int tenth = 1; status >= 0 && tenth <= 10; ++tenth) {
        status = coin_run(&s, &p, COIN_RK8, 1e-2, 10, NULL);
        printf("%.1f s  lean %.9f  centre (%.9f, %.9f) m\n", tenth / 10.0,
               s.theta, s.x, s.z);
    }
    if (status >= 0)
        status = coin_reaction(&s, &p, &f);
    if (status < 0) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        return 1;
    }
    printf("energy %.9f J, F/N %.9f\n", coin_energy(&s, &p), f.ratio);
    return 0;
}
