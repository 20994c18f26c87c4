/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/rates.c"
