/* SPDX-License-Identifier: MIT */
/* The template for one number, included once. */
#ifndef ROLLCOIN_RK4_H
#define ROLLCOIN_RK4_H

#include "rk4.t.h"

#endif
