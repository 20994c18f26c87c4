/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../motion/angles.c"
#include "../motion/body.c"
#include "../motion/legendre.c"
#include "../motion/state.c"
