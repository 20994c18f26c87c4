/* SPDX-License-Identifier: MIT */
#include "params.h"

int32_t coin_params_cylinder(coin_params *p, double mass, double radius,
                             double thickness, double gravity)
{
    const double M = mass, a = radius, H = thickness;
    const double IX = M * (a * a / 4 + H * H / 12), IZ = M * a * a / 2;
    coin_params made;
    int32_t status =
        p ? coin_params_body(&made, M, a, gravity, IX, IZ) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    made.thickness = H;
    status = coin_params_check(&made);
    if (status == COIN_OK)
        *p = made;
    return status;
}
