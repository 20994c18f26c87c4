/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_METHOD_H
#define ROLLCOIN_METHOD_H

#include <coin.h>

/* Whether there is such a method. */
int coin_priv_method_known(int32_t method);

/* |dt| W beyond which a step is coarse, and beyond which it is refused.
 * Pre: the method is known. */
double coin_priv_method_coarse(int32_t method);
double coin_priv_method_most(int32_t method);

#endif
