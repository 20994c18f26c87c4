/* SPDX-License-Identifier: MIT */
#include "far.h"

#include "check.h"
#include "random.h"

coin_state far_coin(coin_params *p, double heading, double *dt)
{
    const double a = 0x1p-7, far = (1e9 - 5.7) * a;
    check_status(coin_params_disc(p, 0.01, a, 10), COIN_OK);
    *dt = 0.5 * natural_time(p);
    const coin_state s = {0, heading, 0, -far, far, 0, 0, 0.5 / *dt};
    check_note("heading %g", heading);
    return s;
}
