/* SPDX-License-Identifier: MIT */
#include "vast.h"

#include "check.h"
#include "random.h"

#include <float.h>

coin_state vast_coin(coin_params *p, double heading, double *dt)
{
    const double M = 1e-290, a = 1e294, m = M * a * a;
    const double far = DBL_MAX - 5.5 * a;
    check_status(coin_params_body(p, M, a, 1e-3, m / 4, m / 2), COIN_OK);
    *dt = 0.5 * natural_time(p);
    const coin_state s = {0, heading, 0, -far, far, 0, 0, 0.5 / *dt};
    check_note("heading %g", heading);
    return s;
}
