/* SPDX-License-Identifier: MIT */
#include "peaks.h"

#include "check.h"

#include <math.h>

/* Samples in a natural unit of time. */
enum { PER_UNIT = 40 };

struct motion motion_any(struct random *r)
{
    static struct motion m;
    coin_force f;
    do {
        m.p = random_coin(r);
        m.s = random_state(r, &m.p, 1.3);
        m.unit = natural_time(&m.p);
        m.side = r->drawn % 2 ? 1 : -1;
        check_status(coin_reaction(&m.s, &m.p, &f), COIN_OK);
    } while (f.normal <= 0 || coin_orbit_init(&m.o, &m.s, &m.p) != COIN_OK ||
             m.o.conditioning > 100);
    return m;
}

coin_state motion_after(const struct motion *m, double t)
{
    coin_state s;
    check_status(coin_orbit_at(&m->o, m->side * t, &s), COIN_OK);
    return s;
}

double motion_ratio(const struct motion *m, double t)
{
    const coin_state s = motion_after(m, t);
    coin_force f;
    check_status(coin_reaction(&s, &m->p, &f), COIN_OK);
    return f.ratio;
}

/* The largest F/N between two times between which it has one maximum, and
 * where. */
static double peak(const struct motion *m, double low, double high, double *at)
{
    for (int i = 0; i < 50; ++i) {
        const double a = low + 0.382 * (high - low);
        const double b = low + 0.618 * (high - low);
        if (motion_ratio(m, a) < motion_ratio(m, b))
            low = a;
        else
            high = b;
    }
    *at = (low + high) / 2;
    return motion_ratio(m, *at);
}

double motion_largest(const struct motion *m, double t, double *at)
{
    const int n = (int)(PER_UNIT * t / m->unit) + 2;
    double most = 0, before = 0, here = motion_ratio(m, 0), where;
    for (int k = 0; k <= n; ++k) {
        const double next = k < n ? motion_ratio(m, (k + 1) * t / n) : 0;
        if (here >= before && here >= next && here > 0.9 * most) {
            const double low = fmax(k - 1, 0), high = fmin(k + 1, n);
            const double top = peak(m, low * t / n, high * t / n, &where);
            if (fmax(here, top) > most) {
                most = fmax(here, top);
                *at = here >= top ? k * t / n : where;
            }
        }
        before = here;
        here = next;
    }
    return most;
}

struct motion motion_with_peak(struct random *r, double *t, double *most,
                               double *at)
{
    struct motion m;
    do {
        m = motion_any(r);
        *t = random_between(r, 1, 6) * m.unit;
        *most = motion_largest(&m, *t, at);
    } while (*most > 10 || *at < 0.05 * m.unit || *at > *t - 0.05 * m.unit);
    return m;
}
