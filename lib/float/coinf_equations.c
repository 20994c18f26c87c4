/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../motion/equations.c"
