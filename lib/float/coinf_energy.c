/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/energy.c"
