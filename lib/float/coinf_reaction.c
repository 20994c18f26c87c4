/* SPDX-License-Identifier: MIT */
#include "floats.h"

#include "../observe/reaction.c"
