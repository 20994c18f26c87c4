/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RK8_H
#define ROLLCOIN_RK8_H

#include "run.h"

coin_priv_method coin_priv_rk8;

#endif
