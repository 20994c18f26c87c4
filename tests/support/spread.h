/* SPDX-License-Identifier: MIT */
/* The distribution of the errors of many random cases. */
#ifndef ROLLCOIN_TESTS_SPREAD_H
#define ROLLCOIN_TESTS_SPREAD_H

#include <stddef.h>

struct spread {
    double median, nine_tenths, worst;
};

/* Sorts x.  Fails the test without a case. */
struct spread spread_of(double *x, size_t count);

#endif
