/* SPDX-License-Identifier: MIT */
/* lib/step/extrapolation.c with 1 lane whatever the processor has. */

#define LANES 1
#define coin_priv_extrapolate_within extrapolate_1
#include "extrapolation.c"
