/* SPDX-License-Identifier: MIT */
#include "coins.h"

#include "check.h"
#include "random.h"

#include <math.h>

coin_params disc(void)
{
    return ring(0);
}

coin_params ring(double inner)
{
    coin_params p;
    check_status(coin_params_ring(&p, 1, 1, inner, 1), COIN_OK);
    return p;
}

coin_state circle(const coin_params *p, double theta, double wZ, int32_t branch)
{
    coin_state s;
    check_status(coin_steady_circle(&s, p, theta, wZ, branch), COIN_OK);
    return s;
}

coin_state state_in_row(const struct table *t, size_t row)
{
    const coin_state s = {
        table_at(t, row, "theta"), table_at(t, row, "phi"),
        table_at(t, row, "psi"),   table_at(t, row, "x"),
        table_at(t, row, "z"),     table_at(t, row, "wX"),
        table_at(t, row, "wY"),    table_at(t, row, "wZ"),
    };
    return s;
}

coin_state start_in_row(const struct table *t, size_t row)
{
    const coin_state s = {
        .theta = table_at(t, row, "theta0"),
        .wX = table_at(t, row, "wX0"),
        .wY = table_at(t, row, "wY0"),
        .wZ = table_at(t, row, "wZ0"),
    };
    return s;
}

double fastest_rate(const coin_state *s, const coin_params *p)
{
    const double c = cos(s->theta);
    return sqrt((s->wX * s->wX + s->wY * s->wY) / (c * c) + s->wZ * s->wZ +
                p->gravity / p->radius / c);
}

double fastest_ahead(const coin_state *s, const coin_params *p, double t)
{
    const int parts = 16 + (int)(128 * fabs(t) / natural_time(p));
    coin_state at = *s;
    double W = fastest_rate(&at, p);
    for (int i = 0; i < parts; ++i) {
        check_status(coin_advance(&at, p, t / parts, 1e-6, NULL), COIN_OK);
        W = fmax(W, fastest_rate(&at, p));
    }
    return W;
}
