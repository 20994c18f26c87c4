/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "precision.h"

#include "number.t.h"

#endif
