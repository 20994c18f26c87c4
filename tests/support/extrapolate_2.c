/* SPDX-License-Identifier: MIT */
/* lib/step/extrapolation.c with 2 lanes whatever the processor has. */

#define LANES 2
#define coin_priv_extrapolate extrapolate_2
#include "extrapolation.c"
