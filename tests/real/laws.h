/* SPDX-License-Identifier: MIT */
/* The losses that stop a coin, one at a time, and its slow start. */
#ifndef ROLLCOIN_TESTS_REAL_LAWS_H
#define ROLLCOIN_TESTS_REAL_LAWS_H

#include <coin.h>

#include <stdio.h>

#define HALF_PI 1.5707963267948966

enum { DRY, VISCOUS, LAYER, GAP, ROLLING, DAMPING, LAWS };

static const char *const names[LAWS] = {"dry", "viscous", "layer",
                                        "gap", "rolling", "damping"};
static int failed;

static void claim(int holds, const char *what)
{
    printf("%s %s\n", holds ? "ok  " : "FAIL", what);
    failed |= !holds;
}

static coin_losses law(int i, double m)
{
    coin_losses l = {0};
    double *const members[LAWS] = {&l.dry, &l.viscous, &l.layer,
                                   &l.gap, &l.rolling, &l.damping};
    *members[i] = m;
    return l;
}

static coin_params disc(void)
{
    coin_params p;
    coin_params_disc(&p, 1, 1, 1);
    return p;
}

/* The slow start of a spin. */
static coin_state spin(const coin_params *p, const coin_losses *l, double angle)
{
    coin_state s;
    coin_steady_spin(&s, p, HALF_PI - angle);
    coin_quasisteady_at(&s, p, l, 0, &s);
    return s;
}

#endif
