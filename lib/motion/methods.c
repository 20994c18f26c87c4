/* SPDX-License-Identifier: MIT */
#include "methods.h"

/* No pointers in the table: they would need relocation, and with it writable
 * data in the shared library. */
static const char names[][12] = {"rk4", "rk8", "symplectic2", "symplectic4"};

const char *coin_method_name(int32_t method)
{
    return coin_priv_method_is_known(method) ? names[method] : NULL;
}
