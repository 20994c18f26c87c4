/* SPDX-License-Identifier: MIT */
/* The quasi-steady model against the full equations.
 *     quasi csv            its errors, for the chart
 *     quasi laws           the powers of the loss that they go by
 *     quasi ask WHAT LAW N N questions, to be counted: coin_time_to_rest (0),
 *                          coin_quasisteady_at (1), coin_losses_fit (2), or a
 *                          textbook step (3)
 * Fails if a power is not what docs/models.md says. */
#include "laws.h"

#include "bench/textbook.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The errors of a disc that spins without swing from 0.1 rad: of the time to
 * rest, relative; and at half of it, of the lean and of the roll [rad], the
 * largest of eight moments, as the slow start leaves a swing of its own. */
struct errors {
    double time, rest, lean, roll;
    double rolled; /* at half-time [rad] */
};

static struct errors errors_of(int i, double m)
{
    const coin_params p = disc();
    const coin_losses l = one_loss(i, m);
    coin_state start, slow, full = slow_spin(&p, &l, 0.1);
    struct errors e = {0, 0, 0, 0, 0};
    double when = 0;
    coin_steady_spin(&start, &p, HALF_PI - 0.1);
    e.time = coin_time_to_rest(&start, &p, &l);
    for (int k = 0; k < 8; ++k) {
        const double at = e.time / 2 + 0.1 * k;
        coin_settle(&full, &p, &l, at - when, 1e-12, NULL);
        when = at;
        coin_quasisteady_at(&start, &p, &l, at, &slow);
        e.lean = fmax(e.lean, fabs(slow.theta - full.theta));
        e.roll = fmax(e.roll, fabs(slow.psi - full.psi));
    }
    e.rolled = full.psi;
    for (int32_t status = COIN_OK; status != COIN_RESTS;) {
        double left; /* a call has 2^20 steps */
        status = coin_settle(&full, &p, &l, 1e9, 1e-9, &left);
        when += left;
    }
    e.rest = fabs(e.time / when - 1);
    return e;
}

/* The first m of each law: a life of some 40 rad. */
static const double first[LAWS] = {1e-3, 1e-4, 4e-5, 1e-5, 2e-2, 2e-2};

static void csv(void)
{
    printf("loss,m,time,rolled,rest,lean,roll\n");
    for (int i = 0; i < LAWS; ++i)
        for (int k = 0; k < 7; ++k) {
            const double m = first[i] * pow(10, -0.5 * k);
            const struct errors e = errors_of(i, m);
            printf("%s,%.3g,%.5g,%.4g,%.2e,%.2e,%.2e\n", loss_names[i], m,
                   e.time, e.rolled, e.rest, e.lean, e.roll);
        }
}

/* The life is as 1/m, the last fall as the root of the angle that it begins at:
 * m, m^(2/3), m^(4/7), m^(2/5).  A coin slowed by rolling swings at its end;
 * damping has no last fall. */
static void laws(void)
{
    const double law_of_rest[LAWS] = {1.5, 4.0 / 3, 9.0 / 7, 1.2, 0.8, 2};
    printf("loss     errors go as this power of m: rest  lean  roll\n");
    for (int i = 0; i < LAWS; ++i) {
        const struct errors a = errors_of(i, first[i] / 10);
        const struct errors b = errors_of(i, first[i] / 100);
        const double rest = log10(a.rest / b.rest);
        const double lean = log10(a.lean / b.lean);
        const double roll = log10(a.roll / b.roll);
        printf("%-8s %31.2f  %.2f  %.2f\n", loss_names[i], rest, lean, roll);
        claim(fabs(lean - 2) < 0.03 && fabs(roll - 1) < 0.03, loss_names[i]);
        claim(fabs(rest - law_of_rest[i]) < 0.03, "the time to rest");
    }
}

/* Discs that spin at leans from 0.05 to 0.6 rad above the table. */
static double ask(int what, int i, int n)
{
    const coin_params p = disc();
    double sum = 0;
    for (int k = 0; k < n; ++k) {
        coin_losses l = one_loss(i, first[i] / 10);
        coin_state s, out;
        coin_steady_spin(&s, &p, HALF_PI - 0.05 - 0.55 * (k % 16) / 15);
        if (what == 0)
            sum += coin_time_to_rest(&s, &p, &l);
        else if (what == 1)
            sum += coin_quasisteady_at(&s, &p, &l, 3 * (k % 16), &out);
        else if (what == 2)
            sum += coin_losses_fit(&l, &s, &p, 100);
        else
            textbook_run(&s, &p, 0.001, 1);
    }
    return sum;
}

int main(int count, char **of)
{
    const char *what = count > 1 ? of[1] : "";
    if (!strcmp(what, "csv"))
        csv();
    else if (!strcmp(what, "laws"))
        laws();
    else if (!strcmp(what, "ask") && count > 4)
        printf("%g\n", ask(atoi(of[2]), atoi(of[3]), atoi(of[4])));
    else
        failed = 2;
    return failed;
}
