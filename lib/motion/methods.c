/* SPDX-License-Identifier: MIT */
#include "methods.h"

/* No pointers in the table: they would need relocation, and with it writable
 * data in the shared library. */
static const struct method {
    char name[12];
    int32_t order;
} methods[] = {
    {"rk4", 4},
    {"rk8", 8},
    {"symplectic2", 2},
    {"symplectic4", 4},
};

const char *coin_method_name(int32_t method)
{
    return coin_priv_method_is_known(method) ? methods[method].name : NULL;
}

int32_t coin_method_order(int32_t method)
{
    return coin_priv_method_is_known(method) ? methods[method].order
                                             : COIN_EARG;
}
