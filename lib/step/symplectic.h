/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SYMPLECTIC_H
#define ROLLCOIN_SYMPLECTIC_H

#include "run.h"

coin_priv_method coin_priv_symplectic2, coin_priv_symplectic4;

#endif
