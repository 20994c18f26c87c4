/* SPDX-License-Identifier: MIT */
/* Includes the template rk4.t.h for one number.  The guard is for the single
 * header, which joins the two sources that need it. */
#ifndef ROLLCOIN_RK4_H
#define ROLLCOIN_RK4_H

#include "rk4.t.h"

#endif
