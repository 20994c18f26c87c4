/* SPDX-License-Identifier: MIT */
#include "difference.h"

#include "check.h"
#include "random.h"

enum { STEPS = 8 };

/* The values after `points` intervals of h; before, if negative. */
static void values_at(const coin_state *s, const coin_params *p,
                      values_of *values, int points, double h,
                      double out[OBSERVABLE_MAX])
{
    coin_state moved = *s;
    const double dt = points < 0 ? -h / STEPS : h / STEPS;
    const uint64_t n = (uint64_t)(points < 0 ? -points : points) * STEPS;
    check_status(coin_run(&moved, p, COIN_RK4, dt, n, NULL), COIN_OK);
    values(&moved, p, out);
}

void difference_along(const coin_state *s, const coin_params *p,
                      values_of *values, size_t count,
                      double out[OBSERVABLE_MAX])
{
    static const double weights[] = {0, 45.0 / 60, -9.0 / 60, 1.0 / 60};
    const double h = natural_time(p) / 256;
    double before[OBSERVABLE_MAX], after[OBSERVABLE_MAX];
    for (size_t i = 0; i < count; ++i)
        out[i] = 0;
    for (int k = 1; k <= 3; ++k) {
        values_at(s, p, values, -k, h, before);
        values_at(s, p, values, k, h, after);
        for (size_t i = 0; i < count; ++i)
            out[i] += weights[k] * (after[i] - before[i]) / h;
    }
}
