/* SPDX-License-Identifier: MIT */
#ifndef PLAIN_H
#define PLAIN_H

#include "peers/rates.h"

/* Classical RK4 on the right-hand side that peers get, which what was measured
 * elsewhere is measured in. */
void plain_run(double y[8], const struct peer_body *b, double dt,
               unsigned long steps);

#endif
