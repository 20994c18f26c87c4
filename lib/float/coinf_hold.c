/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../real/hold.c"
