/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "number.h"
#include "params.h"
#include "precision.h"

int32_t coin_priv_body_of(coin_priv_body *b, const coin_params *p)
{
    const double M = p->mass, a = p->radius, g = p->gravity;
    const double IX = p->inertia_X, IZ = p->inertia_Z;
    const double m = M * a * a, J = IX + m, K = IZ + m, Mga = M * g * a;
    const coin_priv_body body = {
        M,       a,       IX,    IZ,
        m,       J,       K,     M * g,
        Mga,     g / a,   K / J, IX / J,
        Mga / J, IZ / IX, m / K, COIN_PRIV_W2_MAX / (1 + a + M * a + J + K),
    };
    *b = body;
    const double *const numbers = (const double *)b;
    const double roll2 = Mga / K / b->k1; /* critical, squared: (45) */
    double least = coin_priv_lesser(coin_priv_lesser(g, M * a), roll2);
    double sum = g + M * a + roll2;
    for (size_t i = 0; i < sizeof *b / sizeof *numbers; ++i) {
        least = coin_priv_lesser(numbers[i], least);
        sum += numbers[i];
    }
    /* A comparison with NaN, which the sum hands on, is false. */
    if (!(least >= COIN_PRIV_LEAST && sum <= COIN_PRIV_MOST) ||
        !(IZ <= 2 * IX * (1 + COIN_PRIV_INERTIA_SLACK)) ||
        p->reserved[0] != 0 || p->reserved[1] != 0 || p->reserved[2] != 0)
        return COIN_EPARAMS;
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
