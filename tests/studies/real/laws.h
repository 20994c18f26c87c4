/* SPDX-License-Identifier: MIT */
/* What the programs of this folder share. */
#ifndef ROLLCOIN_TESTS_REAL_LAWS_H
#define ROLLCOIN_TESTS_REAL_LAWS_H

#include "support/coins.h"
#include "support/losses.h"

#include <stdio.h>

#define HALF_PI 1.5707963267948966

static int failed;

static void claim(int holds, const char *what)
{
    printf("%s %s\n", holds ? "ok  " : "FAIL", what);
    failed |= !holds;
}

#endif
