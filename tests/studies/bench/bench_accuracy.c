/* SPDX-License-Identifier: MIT */
/* Work against precision of the library's methods and of the textbook's RK4. */
#include "textbook.h"
#include "workprec.h"

#include <string.h>

enum { TEXTBOOK = -1, ADVANCE = 100, ORBIT };

static struct {
    const scene *c;
    int method;
    double setting;
    coin_state s;
    double t; /* since the start */
    coin_orbit orbit;
} at;

static void begin(const solver *self, const scene *c, double setting)
{
    at.c = c;
    at.method = self->which;
    at.setting = setting;
    at.s = c->row[0].s;
    at.t = 0;
}

/* With the first answer the orbit is made: that is what it costs. */
static int go_orbit(double t)
{
    if (at.t == 0 && coin_orbit_init(&at.orbit, &at.s, &at.c->p) < 0)
        return -1;
    at.t += t;
    return coin_orbit_at(&at.orbit, at.t, &at.s);
}

static int go(double t, unsigned long steps)
{
    const double dt = t / (double)steps;
    if (at.method == ADVANCE)
        return coin_advance(&at.s, &at.c->p, t, at.setting, 0);
    if (at.method == ORBIT)
        return go_orbit(t);
    if (at.method != TEXTBOOK)
        return coin_run(&at.s, &at.c->p, at.method, dt, steps, 0);
    textbook_run(&at.s, &at.c->p, dt, steps);
    return 0;
}

static coin_state state(void)
{
    return at.s;
}

/* 2^(-1/4) and 10^(-1/4). */
#define STEPS 1, 0.8408964152537145, 1e-5, 20e6, 0, begin, go, state
#define TOLERANCES 1e-2, 0.5623413251903491, 1e-13, 20e6, 0, begin, go, state

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"textbook RK4", TEXTBOOK, 4, STEPS},
        {"rk4", COIN_RK4, 4, STEPS},
        {"rk8", COIN_RK8, 12, STEPS},
        {"symplectic2", COIN_SYMPLECTIC2, 1, STEPS},
        {"symplectic4", COIN_SYMPLECTIC4, 3, STEPS},
        {"coin_advance", ADVANCE, 0, TOLERANCES},
        {"orbit", ORBIT, 0, 1, 0.5, 1, 20e6, 0, begin, go, state},
    };
    const int mapped = argc > 1 && strcmp(argv[1], "atlas") == 0;
    const int count = sizeof list / sizeof *list;
    return workprec(list, mapped ? count - 1 : count, argc, argv);
}
