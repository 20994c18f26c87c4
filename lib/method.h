/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_METHOD_H
#define ROLLCOIN_METHOD_H

#include "stepper.h"

/* Whether there is such a method: what the others require. */
int coin_priv_method_known(int32_t method);

coin_priv_stepper *coin_priv_method_stepper(int32_t method);

/* |dt| W beyond which a step is coarse, and beyond which it is refused.
 */
double coin_priv_method_coarse(int32_t method);
double coin_priv_method_most(int32_t method);

/* The limits of a run by steps of dt. */
coin_priv_limits coin_priv_limits_of(const coin_priv_body *b, int32_t method,
                                     double dt);

#endif
