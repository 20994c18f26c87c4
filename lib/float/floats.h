/* SPDX-License-Identifier: MIT */
/* Makes a source of lib/ one for floats: included before it.
 *
 * A coinf_X.c that consists of one include is the float twin of X.c: the same
 * text, compiled for floats (motion/kind.h).  coinf_priv_name() is then
 * coin_priv_name() of that text, written PRIV(name).
 *
 * A coinf_X.c with code of its own does in another way what X.c does.  What it
 * shares with other files has a name that no double has.  Its static functions
 * may have the names of those in X.c that do the same part of the work. */
#ifndef ROLLCOIN_FLOATS_H
#define ROLLCOIN_FLOATS_H

#define COIN_PRIV_FLOAT

#include <coinf.h>

#endif
