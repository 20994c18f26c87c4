/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RK4_H
#define ROLLCOIN_RK4_H

#include "rk4.t.h"
#include "run.h"

coin_priv_method coin_priv_rk4;

#endif
