/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/fastest_rate.c"
