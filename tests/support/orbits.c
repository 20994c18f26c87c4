/* SPDX-License-Identifier: MIT */
#include "orbits.h"

#include "check.h"

coin_orbit orbit_of(const coin_state *s, const coin_params *p)
{
    coin_orbit o;
    check_status(coin_orbit_init(&o, s, p), COIN_OK);
    return o;
}

coin_orbit random_orbit(struct random *r, coin_params *p, coin_state *s)
{
    coin_orbit o;
    for (int tries = 0; tries < 10; ++tries) {
        *p = random_coin(r);
        *s = random_state(r, p, 1);
        if (coin_orbit_init(&o, s, p) == COIN_OK)
            return o;
    }
    check(0);
    return o;
}
