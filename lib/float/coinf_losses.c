/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../real/losses.c"
