/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../motion/angles.c"
#include "../motion/equations.c"
#include "../motion/legendre.c"
#include "../motion/params.c"
#include "../motion/state.c"
