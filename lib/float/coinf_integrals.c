/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/integrals.c"
