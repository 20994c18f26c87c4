/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../real/gbs.c"
