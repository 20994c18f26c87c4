/* SPDX-License-Identifier: MIT */
/* circles.csv: steady circles of all kinds of bodies. */
#ifndef ROLLCOIN_TESTS_STEADIES_H
#define ROLLCOIN_TESTS_STEADIES_H

#include "table.h"

#include <coin.h>

struct circle {
    coin_params params;
    double theta, wZ;
    int32_t branch;
    double wY;        /* nearest double of the true one */
    coin_state state; /* with that wY */
};

struct circle circle_at(const struct table *t, size_t row);

#endif
