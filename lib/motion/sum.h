/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SUM_H
#define ROLLCOIN_SUM_H

#include "sum.t.h"

#endif
