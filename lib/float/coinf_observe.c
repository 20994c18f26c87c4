/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/check.c"
#include "../observe/energy.c"
#include "../observe/integrals.c"
#include "../observe/pose.c"
#include "../observe/rates.c"
#include "../observe/reaction.c"
