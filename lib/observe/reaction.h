/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_REACTION_H
#define ROLLCOIN_REACTION_H

#include "../motion/equations.h"

/* The force of the table on a coin in this stage. */
COIN(force) PRIV(reaction)(const PRIV(body) * b, const PRIV(variables) * y);

#endif
