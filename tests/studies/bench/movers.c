/* SPDX-License-Identifier: MIT */
#include "movers.h"

#include "textbook.h"

#include <extrapolation.h>
#include <sundman.h>

static const struct {
    const char *name;
    int32_t method;
} movers[MOVERS] = {
    {"textbook RK4", COIN_RK4},
    {"rk4", COIN_RK4},
    {"rk8", COIN_RK8},
    {"order 14 in tau", COIN_RK8},
    {"symplectic2", COIN_SYMPLECTIC2},
    {"symplectic4", COIN_SYMPLECTIC4},
};

const char *mover_name(enum mover_kind kind)
{
    return movers[kind].name;
}

mover mover_at(enum mover_kind kind, const coin_state *s, const coin_params *p,
               double h)
{
    mover m = {.kind = kind, .p = *p, .s = *s, .h = h};
    if (coin_priv_check(s, p, &m.run.b) == COIN_OK)
        coin_priv_run_unlimited(&m.run, s);
    return m;
}

/* The time of n steps is summed apart, or the sum's rounding would soon be all
 * that one sees of the phase. */
static int go_sundman(mover *m, unsigned long n)
{
    for (; n > 0; --n) {
        double error = 1;
        if (!coin_priv_extrapolate(&m->run, m->h, &error))
            return 1;
    }
    m->t += m->run.g.added.t;
    m->run.g.added.t = 0;
    coin_priv_read_lean(&m->run.g);
    m->s = coin_priv_run_state(&m->run);
    return 0;
}

int mover_go(mover *m, unsigned long n)
{
    if (m->kind == MOVER_SUNDMAN)
        return go_sundman(m, n);
    m->t += (long double)m->h * (long double)n;
    if (m->kind != MOVER_TEXTBOOK)
        return coin_run(&m->s, &m->p, movers[m->kind].method, m->h, n, NULL) <
               0;
    textbook_run(&m->s, &m->p, m->h, n);
    return 0;
}
