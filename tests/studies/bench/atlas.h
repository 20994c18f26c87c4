/* SPDX-License-Identifier: MIT */
/* The maps of docs/limits.md: what becomes of a coin under every step, or
 * every tolerance, over families of scenes. */
#ifndef ATLAS_H
#define ATLAS_H

#include "workprec.h"

#ifdef __cplusplus
extern "C" {
#endif

/* As CSV: a line for each family, solver and scene, a letter for each step.
 * Arguments ask for less:
 *     [FAMILY]                             the maps of one family
 *     FAMILY X SOLVER SETTING [TIME]       one run, in words */
int atlas(const solver *list, int count, int argc, char **argv);

#ifdef __cplusplus
}
#endif

#endif
