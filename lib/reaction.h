/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_REACTION_H
#define ROLLCOIN_REACTION_H

#include "stage.h"

/* The force of the table on a coin in this stage. */
coin_force coin_priv_reaction(const coin_priv_body *b,
                              const coin_priv_stage *y);

#endif
