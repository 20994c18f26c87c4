/* SPDX-License-Identifier: MIT */
#include "spread.h"

#include "check.h"

#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

struct spread spread_of(double *x, size_t count)
{
    check(count > 0);
    qsort(x, count, sizeof *x, ascending);
    const struct spread s = {x[count / 2], x[count * 9 / 10], x[count - 1]};
    return s;
}
