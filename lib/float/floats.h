/* SPDX-License-Identifier: MIT */
/* Makes a source of lib/ one for floats: included before it. */
#ifndef ROLLCOIN_FLOATS_H
#define ROLLCOIN_FLOATS_H

#define COIN_PRIV_FLOAT

#include <coinf.h>

#endif
