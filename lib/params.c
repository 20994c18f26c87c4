/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "params.h"

/* Numbers in here can be multiplied by each other's ratios, and by the 1/cos
 * of the flattest lean, and stay normal: 1e-300 and 1e300 leave 2^26. */
#define LEAST 1e-300
#define MOST 1e300

/* 1/cos^2 theta is below this for every |theta| < pi/2 that a double holds. */
#define SECANT2_MAX 1e32

int32_t coin_priv_body_of(coin_priv_body *b, const coin_params *p)
{
    const double M = p->mass, a = p->radius, g = p->gravity;
    const double IX = p->inertia_X, IZ = p->inertia_Z;
    const double m = M * a * a, J = IX + m, K = IZ + m, Mga = M * g * a;
    const coin_priv_body body = {
        M,       a,       IX,    IZ,
        m,       J,       K,     M * g,
        Mga,     g / a,   K / J, IX / J,
        Mga / J, IZ / IX, m / K, MOST / SECANT2_MAX / (1 + a + M * a + J + K),
    };
    const double roll2 = Mga / K / body.k1; /* critical rate, squared: (45) */
    const double limited[] = {
        M,       a,       g,       IX,          IZ,       M * a,   body.Mg,
        m,       J,       K,       Mga,         body.g_a, body.KJ, body.XJ,
        body.GJ, body.k1, body.k2, body.w2_max, roll2,
    };
    int good = IZ <= 2 * IX * (1 + 1e-12);
    for (size_t i = 0; i < sizeof limited / sizeof *limited; ++i)
        good &= limited[i] >= LEAST && limited[i] <= MOST;
    for (size_t i = 0; i < 3; ++i)
        good &= p->reserved[i] == 0;
    if (!good)
        return COIN_EPARAMS;
    *b = body;
    return COIN_OK;
}

int32_t coin_params_check(const coin_params *p)
{
    coin_priv_body b;
    return p ? coin_priv_body_of(&b, p) : COIN_EARG;
}

int32_t coin_params_body(coin_params *p, double mass, double radius,
                         double gravity, double inertia_X, double inertia_Z)
{
    const coin_params made = {
        mass, radius, gravity, inertia_X, inertia_Z, {0, 0, 0},
    };
    const int32_t status = p ? coin_params_check(&made) : COIN_EARG;
    if (status == COIN_OK)
        *p = made;
    return status;
}

int32_t coin_params_ring(coin_params *p, double mass, double radius,
                         double inner_radius, double gravity)
{
    const double M = mass, a = radius, b = inner_radius;
    const double IX = M * (a * a + b * b) / 4; /* (29) */
    if (p && !(b >= 0 && b <= a))
        return COIN_EPARAMS;
    return coin_params_body(p, M, a, gravity, IX, 2 * IX);
}

int32_t coin_params_disc(coin_params *p, double mass, double radius,
                         double gravity)
{
    return coin_params_ring(p, mass, radius, 0, gravity);
}
