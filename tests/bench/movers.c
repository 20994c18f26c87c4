/* SPDX-License-Identifier: MIT */
#include "movers.h"

#include "textbook.h"

#include <state.h>
#include <sundman.h>

static const struct {
    const char *name;
    int32_t method;
} movers[MOVERS] = {
    {"textbook RK4", COIN_RK4},
    {"rk4", COIN_RK4},
    {"rk4 lean", COIN_RK4},
    {"rk8", COIN_RK8},
    {"rk8 lean", COIN_RK8},
    {"rk8 in tau", COIN_RK8},
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
    mover m = {.kind = kind, .p = *p, .s = *s, .h = h, .start = *s};
    if (coin_priv_check(s, p, &m.b) == COIN_OK)
        coin_priv_carry_begin(&m.c, s);
    return m;
}

static int go_lean(mover *m, unsigned long n)
{
    coin_lean l = {m->s.theta, m->s.wX, m->s.wY, m->s.wZ};
    const int32_t status =
        coin_lean_run(&l, &m->p, movers[m->kind].method, m->h, n, NULL);
    m->s.theta = l.theta;
    m->s.wX = l.wX;
    m->s.wY = l.wY;
    m->s.wZ = l.wZ;
    return status < 0;
}

/* The time of n steps is summed apart, or the sum's rounding would soon be all
 * that one sees of the phase. */
static int go_sundman(mover *m, unsigned long n)
{
    for (; n > 0; --n)
        if (!coin_priv_sundman_step(&m->c, &m->b, m->h))
            return 1;
    m->t += m->c.at.pose.t;
    m->c.at.pose.t = 0;
    m->s = coin_priv_state_of(&m->c, &m->b, &m->start);
    return 0;
}

int mover_go(mover *m, unsigned long n)
{
    if (m->kind == MOVER_SUNDMAN)
        return go_sundman(m, n);
    m->t += (long double)m->h * (long double)n;
    if (m->kind == MOVER_RK4_LEAN || m->kind == MOVER_RK8_LEAN)
        return go_lean(m, n);
    if (m->kind != MOVER_TEXTBOOK)
        return coin_run(&m->s, &m->p, movers[m->kind].method, m->h, n, NULL) <
               0;
    textbook_run(&m->s, &m->p, m->h, n);
    return 0;
}
