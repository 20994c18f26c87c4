/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "number.h"

/* No pointers in the table: they would need relocation, and with it writable
 * data in the shared library. */
static const struct method {
    char name[12];
    int32_t order;
    double coarse, most;
} methods[] = {
    {"rk4", 4, 0.35, 1.2},
    {"rk8", 8, 1.0, 1.2},
    {"symplectic2", 2, 0.08, 1.0},
    {"symplectic4", 4, 0.16, 1.4},
};

enum { METHODS = sizeof methods / sizeof *methods };

int coin_priv_method_known(int32_t method)
{
    return method >= 0 && method < METHODS;
}

coin_priv_stepper *coin_priv_method_stepper(int32_t method)
{
    switch (method) {
    case COIN_RK4:
        return coin_priv_rk4;
    case COIN_RK8:
        return coin_priv_rk8;
    case COIN_SYMPLECTIC2:
        return coin_priv_symplectic2;
    default:
        return coin_priv_symplectic4;
    }
}

double coin_priv_method_coarse(int32_t method)
{
    return methods[method].coarse;
}

double coin_priv_method_most(int32_t method)
{
    return methods[method].most;
}

coin_priv_limits coin_priv_limits_of(const coin_priv_body *b, int32_t method,
                                     double dt)
{
    const double coarse = coin_priv_method_coarse(method) / dt;
    const double most = coin_priv_method_most(method) / dt;
    const double most2 = coin_priv_lesser(most * most, b->w2_max);
    const coin_priv_limits limits = {
        coin_priv_lesser(coarse * coarse, most2),
        most2,
        COIN_OK,
    };
    return limits;
}

const char *coin_method_name(int32_t method)
{
    return coin_priv_method_known(method) ? methods[method].name : NULL;
}

int32_t coin_method_order(int32_t method)
{
    return coin_priv_method_known(method) ? methods[method].order : COIN_EARG;
}
