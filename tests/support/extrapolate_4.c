/* SPDX-License-Identifier: MIT */
/* lib/step/extrapolation.c with 4 lanes whatever the processor has. */
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#define LANES 4
#define coin_priv_extrapolate extrapolate_4
#include "extrapolation.c"
