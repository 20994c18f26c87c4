/* SPDX-License-Identifier: MIT */
/* lib/step/extrapolation.c with 1 lane whatever the processor has. */

#define LANES 1
#define coin_priv_extrapolate extrapolate_1
#include "extrapolation.c"
