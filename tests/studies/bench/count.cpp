/* SPDX-License-Identifier: MIT */
/* Counts what a step computes, and how long it must take: the library's own
 * sources, compiled with arithmetic.h in place of double.
 *     count ADD MUL DIV SQRT       how long each takes, in ns
 * Writes CSV: method, additions, products, divisions, roots, ns of chain. */
#include "arithmetic.h"

#include <coin.h>

#include "../../../lib/step/extrapolation.h"
#include "../../../lib/step/sundman.h"

arithmetic operations;

enum { EXTRAPOLATED = 100, STEPS = 3200 };

static coin_params disc;
static coin_state generic;

static counted latest(const coin_state &s)
{
    double when = 0;
    for (counted v : {s.theta, s.phi, s.psi, s.x, s.z, s.wX, s.wY, s.wZ})
        when.value = when.value > v.ready ? when.value : v.ready;
    return when;
}

static coin_state extrapolate(uint64_t n)
{
    coin_priv_run r;
    coin_priv_check(&generic, &disc, &r.b);
    coin_priv_run_unlimited(&r, &generic);
    for (; n > 0; --n) {
        double error = 1;
        coin_priv_extrapolate(&r, 0.05, &error);
    }
    coin_priv_read_lean(&r.g);
    return coin_priv_run_state(&r);
}

static counted run(int which, uint64_t n)
{
    coin_state s = generic;
    if (which == EXTRAPOLATED)
        s = extrapolate(n);
    else
        coin_run(&s, &disc, which, 0.05, n, nullptr);
    return latest(s);
}

/* Two lengths of run: what differs is the steps alone. */
static void report(const char *name, int which)
{
    const arithmetic none = operations;
    const counted first = run(which, STEPS);
    const arithmetic once = operations;
    const counted second = run(which, 2 * STEPS);
    const arithmetic thrice = operations;
#define PER_STEP(k)                                                            \
    ((float)((thrice.k - once.k) - (once.k - none.k)) / (float)STEPS)
    printf("%s,%.1f,%.1f,%.2f,%.2f,%.2f\n", name, PER_STEP(add), PER_STEP(mul),
           PER_STEP(div), PER_STEP(root),
           (float)(second.value - first.value) / (float)STEPS);
}

int main(int argc, char **argv)
{
    if (argc != 5)
        return 2;
    operations.add_ns = atof(argv[1]);
    operations.mul_ns = atof(argv[2]);
    operations.div_ns = atof(argv[3]);
    operations.root_ns = atof(argv[4]);
    coin_params_disc(&disc, 1, 1, 1);
    generic.theta = 0.5;
    generic.wX = 0.1;
    generic.wY = 0.8;
    generic.wZ = 1.2;
    report("rk4", COIN_RK4);
    report("rk8", COIN_RK8);
    report("order 14 in tau", EXTRAPOLATED);
    report("symplectic2", COIN_SYMPLECTIC2);
    report("symplectic4", COIN_SYMPLECTIC4);
    return 0;
}
