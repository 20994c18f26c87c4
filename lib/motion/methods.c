/* SPDX-License-Identifier: MIT */
#include "methods.h"

/* No pointers in the table: they would need relocation, and with it writable
 * data in the shared library. */
#define NAME(method, name, coarse, refusal) #name,
static const char names[][12] = {COIN_PRIV_METHODS(NAME)};

const char *coin_method_name(int32_t method)
{
    return coin_priv_method_is_known(method) ? names[method] : NULL;
}
