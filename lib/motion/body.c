/* SPDX-License-Identifier: MIT */
#include "body.h"

/* The body is read as an array: all of its members are of type real. */
int32_t PRIV(check_any_body)(PRIV(body) * b, const COIN(params) * p)
{
    const real g = p->gravity, IX = p->inertia_X, IZ = p->inertia_Z;
    *b = PRIV(body_of)(p);
    b->w2_max = PRIV(w2_max)(b);
    const real *const numbers = (const real *)b;
    const real Ma = b->M * b->a;
    const real roll2 = b->Mga / b->K / b->k1; /* critical, squared: (45) */
    real least = PRIV(lesser)(PRIV(lesser)(g, Ma), roll2);
    real sum = g + Ma + roll2;
    for (size_t i = 0; i < sizeof *b / sizeof *numbers; ++i) {
        least = PRIV(lesser)(numbers[i], least);
        sum += numbers[i];
    }
    /* If a number is NaN, so is the sum, and a comparison with it is false. */
    if (!(least >= COIN_PRIV_LEAST && sum <= COIN_PRIV_MOST) ||
        !(IZ <= 2 * IX * (1 + COIN_PRIV_INERTIA_SLACK)) ||
        p->reserved[0] != 0 || p->reserved[1] != 0 || p->reserved[2] != 0)
        return COIN_EPARAMS;
    return COIN_OK;
}

int32_t COIN(params_check)(const COIN(params) * p)
{
    PRIV(body) b;
    return p ? PRIV(check_body)(&b, p) : COIN_EARG;
}

int32_t COIN(params_body)(COIN(params) * p, real mass, real radius,
                          real gravity, real inertia_X, real inertia_Z)
{
    const COIN(params) made = {
        mass, radius, gravity, inertia_X, inertia_Z, {0, 0, 0},
    };
    const int32_t status = p ? COIN(params_check)(&made) : COIN_EARG;
    if (status == COIN_OK)
        *p = made;
    return status;
}

int32_t COIN(params_ring)(COIN(params) * p, real mass, real radius,
                          real inner_radius, real gravity)
{
    const real M = mass, a = radius, b = inner_radius;
    /* a^2 may underflow or overflow although M a^2 does not. */
    const int ordinary =
        a > COIN_PRIV_ORDINARY_LEAST && a < COIN_PRIV_ORDINARY_MOST;
    const real four = ordinary ? M * (a * a + b * b) : M * a * a + M * b * b;
    const real IX = four / 4; /* (29) */
    if (p && !(b >= 0 && b <= a))
        return COIN_EPARAMS;
    return COIN(params_body)(p, M, a, gravity, IX, 2 * IX);
}

int32_t COIN(params_disc)(COIN(params) * p, real mass, real radius,
                          real gravity)
{
    return COIN(params_ring)(p, mass, radius, 0, gravity);
}
