/* SPDX-License-Identifier: MIT */
/* What coins with losses do over whole lives: too long for `make check`.
 *     study launches N     random violent launches: do all end, and how
 *     study calls          the time of rest by calls and tolerances
 *     study textbook N     N textbook steps, to be counted
 * Fails if a figure is not what docs/limits.md says. */
#include "laws.h"

#include "studies/bench/textbook.h"
#include "support/losses.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---------------------------------------------------------------- launches */
/* How a launch ends: at rest; upright, where contour friction has no lever;
 * with 2^20 steps in each of four calls; still turning after the time; or it
 * fails.
 */
enum { RESTS, STANDS, LONG, TURNS, FAILS, ENDS };

/* The time after the first 40 natural units, in that unit. */
#define LIFE 1e5

/* One launch; *rise is what the energy gained at most in a call, relative. */
static int launch(struct random *r, double *rise)
{
    const coin_params p = random_coin(r);
    const double T = natural_time(&p);
    const coin_losses l =
        random_losses(r, &p, exp(random_between(r, log(0.05), 0)));
    coin_state s = random_state(r, &p, 1.57);
    const double faster = random_between(r, 1, 4);
    s.wX *= faster;
    s.wY *= faster;
    s.wZ *= faster;
    double E = coin_energy(&s, &p), left = LIFE * T, reached;
    int32_t status = COIN_OK;
    for (int calls = 0; calls < 44; ++calls) {
        const double t = calls < 40 ? T : left;
        status = coin_settle(&s, &p, &l, t, 1e-6, &reached);
        const double now = coin_energy(&s, &p);
        *rise = fmax(*rise, now / E - 1);
        E = now;
        left -= calls < 40 ? 0 : reached;
        if (status == COIN_RESTS || (calls >= 40 && status == COIN_OK))
            break;
        if (status < 0 && status != COIN_ESTEP)
            return FAILS;
    }
    return status == COIN_RESTS   ? RESTS
           : status != COIN_OK    ? LONG
           : fabs(s.theta) < 1e-3 ? STANDS
                                  : TURNS;
}

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

/* Seconds of the processor that a textbook step takes now: another program may
 * slow the processor. */
static double textbook_step(void)
{
    enum { STEPS = 4000 };
    const coin_params p = disc();
    coin_state s = {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2};
    const double begin = seconds();
    textbook_run(&s, &p, 0.001, STEPS);
    return (seconds() - begin) / STEPS;
}

static void launches(int n)
{
    struct random r = random_begin(171);
    int ends[ENDS] = {0};
    double rise = 0, dearest = 0, total = 0;
    for (int i = 0; i < n; ++i) {
        const double begin = seconds();
        ++ends[launch(&r, &rise)];
        const double took = (seconds() - begin) / textbook_step();
        dearest = fmax(dearest, took);
        total += took;
    }
    printf("%d launches: %d rest, %d stand upright, %d turn after %g units, %d "
           "need more than 2^22 steps, %d fail; the energy rises by %.1e at "
           "most\n",
           n, ends[RESTS], ends[STANDS], ends[TURNS], LIFE, ends[LONG],
           ends[FAILS], rise);
    printf("the dearest takes %.3g textbook steps, the mean %.3g\n", dearest,
           total / n);
    claim(ends[FAILS] == 0, "no launch fails");
    claim(rise < 1e-6, "no call gains energy beyond its tolerance");
}

/* ------------------------------------------------------------------- calls */
static coin_state toy(int quarter, coin_params *p, coin_losses *l)
{
    coin_state s;
    if (quarter)
        coin_params_disc(p, 0.00567, 0.01213, 9.80665);
    else
        coin_params_disc(p, 0.438, 0.0375, 9.80665);
    *l = one_loss(DRY, (quarter ? 8.5e-4 : 5.24e-5) * p->mass * p->gravity *
                           p->radius);
    const double angle = quarter ? 0.5235987755982988 : 0.3054326190990077;
    coin_steady_spin(&s, p, HALF_PI - angle);
    s.wX = 0.01 * angle * sqrt(p->gravity / p->radius);
    return s;
}

/* When it rests: in calls of 1/fps s, or in one if fps is 0. */
static double life(int quarter, double tol, double fps, double *turns)
{
    coin_params p;
    coin_losses l;
    coin_state s = toy(quarter, &p, &l);
    double when = 0, reached;
    int32_t status;
    do {
        status =
            coin_settle(&s, &p, &l, fps > 0 ? 1 / fps : 1e3, tol, &reached);
        when += reached;
    } while (status == COIN_OK || status == COIN_ESTEP);
    *turns = s.psi / (4 * HALF_PI);
    return when;
}

static void calls(void)
{
    for (int quarter = 0; quarter < 2; ++quarter) {
        double turns;
        const double T = sqrt((quarter ? 0.01213 : 0.0375) / 9.80665);
        const double exact = life(quarter, 1e-12, 0, &turns);
        printf("%s: rests after %.12g s, %.3f turns\n",
               quarter ? "quarter" : "Euler's disk", exact, turns);
        for (double tol = 1e-6; tol > 5e-12; tol /= 10) {
            const double one = life(quarter, tol, 0, &turns);
            const double frames = life(quarter, tol, 60, &turns);
            printf("  tol %.0e: one call off by %.1e, 60 a second by %.1e, "
                   "relative\n",
                   tol, one / exact - 1, frames / exact - 1);
            const double most = fmax(10 * tol * T, 1e-9 * exact);
            claim(fabs(one - exact) < most && fabs(frames - exact) < most,
                  "the time of rest");
        }
    }
}

int main(int count, char **of)
{
    const char *what = count > 1 ? of[1] : "";
    const double number = count > 2 ? atof(of[2]) : 0;
    if (!strcmp(what, "launches"))
        launches((int)number);
    else if (!strcmp(what, "calls"))
        calls();
    else if (!strcmp(what, "textbook")) {
        const coin_params p = disc();
        coin_state s = {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2};
        textbook_run(&s, &p, 0.001, (unsigned long)number);
        printf("theta = %g\n", s.theta);
    } else
        failed = 2;
    return failed;
}
