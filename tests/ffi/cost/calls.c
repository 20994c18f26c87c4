/* SPDX-License-Identifier: MIT */
/* As many calls of one step as the argument says. */
#include <coin.h>

#include <stdlib.h>

int main(int argc, char **argv)
{
    const long n = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    coin_params p;
    coin_state s = {0.3, 0, 0, 0, 0, 0, 5, 40};
    int32_t status = coin_params_disc(&p, 0.00567, 0.01213, 9.80665);

    for (long i = 0; status >= 0 && i < n; ++i)
        status = coin_run(&s, &p, COIN_RK4, 1e-3, 1, NULL);
    return status < 0;
}
