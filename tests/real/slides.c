/* SPDX-License-Identifier: MIT */
/* What coins that slip cost, and how they end: too long for `make check`.
 *     slides launches N   random launches: how they end, and the worst cost
 *     slides cost         beside coin_advance(), where nothing slips
 *     slides rivals       beside regularised friction and time stepping */
#include "support/slides.h"
#include "support/methods.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---------------------------------------------------------------- launches */
static void launches(int n)
{
    struct random r = random_begin(201);
    int ended[4] = {0}, pulled = 0;
    double rise = 0, worst = 0, all = 0, time = 0;
    for (int i = 0; i < n; ++i) {
        coin_params p;
        coin_params_ring(&p, 1, 1, i % 2 ? 0 : random_between(&r, 0, 1), 1);
        const double mu = random_between(&r, 0.2, 0.6);
        const coin_friction f = {mu, 0.9 * mu};
        coin_slide d = random_launch(&r, &p);
        double E = coin_slide_energy(&d, &p), reached = 0;
        int32_t status = COIN_OK;
        const double begin = seconds();
        for (int k = 0; k < 20 && (status == COIN_OK || status == COIN_SLIPS);
             ++k) {
            coin_force force;
            status = coin_slide_advance(&d, &p, &f, NULL, 1, 1e-9, &reached);
            rise = fmax(rise, coin_slide_energy(&d, &p) - E);
            E = coin_slide_energy(&d, &p);
            coin_slide_reaction(&d, &p, &f, NULL, &force);
            pulled += status >= 0 && force.normal < 0;
            time += reached;
        }
        const double took = seconds() - begin;
        worst = fmax(worst, took);
        all += took;
        ++ended[status == COIN_ELIFT ? 2 : status < 0 ? 3 : status];
    }
    printf("%d launches: %d roll, %d slip, %d lift, %d other; energy rises by "
           "%.1e at most; %d of N < 0 unsaid\n",
           n, ended[0], ended[1], ended[2], ended[3], rise, pulled);
    printf("%.1f us per natural unit, the worst launch %.1f ms\n",
           1e6 * all / time, 1e3 * worst);
}

/* ------------------------------------------------------------------- rolls */
static void cost(void)
{
    const coin_state start = {.theta = 0.1, .wY = 0.05, .wZ = 1.2};
    const double T = 1000;
    coin_params p;
    coin_params_disc(&p, 1, 1, 1);
    for (double tol = 1e-2; tol > 1e-13; tol /= 100)
        for (int mu = 0; mu < 2; ++mu) {
            const coin_friction f = {mu ? 0.3 : INFINITY, 0.25};
            double rolls = INFINITY, slides = INFINITY;
            for (int k = 0; k < 9; ++k) {
                coin_state s = start;
                coin_slide d;
                coin_slide_of(&d, &start, &p);
                const double t0 = seconds();
                coin_advance(&s, &p, T, tol, NULL);
                const double t1 = seconds();
                coin_slide_advance(&d, &p, &f, NULL, T, tol, NULL);
                const double t2 = seconds();
                rolls = fmin(rolls, t1 - t0);
                slides = fmin(slides, t2 - t1);
            }
            printf("tol %.0e, mu_static %g: %.2f times coin_advance()\n", tol,
                   f.mu_static, slides / rolls);
        }
}

/* ------------------------------------------------------------------ rivals */
enum { WX, WY, WZ, VX, VH, THETA, PHI, PSI, AT_X, AT_Z, SIZE };

struct rival {
    double IX, IZ, mu, delta; /* natural units, M = a = g = 1 */
};

/* Slopes by t under a friction -c N u. */
static void slopes(double *d, const double *y, const struct rival *r)
{
    const double s = sin(y[THETA]), c = cos(y[THETA]), T = s / c;
    const double uX = y[VX] + y[WZ], uh = y[VH] - y[WX] * c;
    const double k = r->mu / sqrt(uX * uX + uh * uh + r->delta * r->delta);
    const double gX = -y[WY] * (r->IZ * y[WZ] + r->IX * y[WY] * T) / r->IX;
    const double N =
        (1 - y[WX] * y[WX] * c - s * gX) / (1 + s * (s + k * uh * c) / r->IX);
    const double FX = -k * N * uX, Fh = -k * N * uh, turn = y[WY] / c;
    d[WX] = gX + (N * s - Fh * c) / r->IX;
    d[WY] = y[WX] * (y[WY] * T + r->IZ / r->IX * y[WZ]);
    d[WZ] = FX / r->IZ;
    d[VX] = FX - turn * y[VH];
    d[VH] = Fh + turn * y[VX];
    d[THETA] = y[WX];
    d[PHI] = turn;
    d[PSI] = y[WZ] + y[WY] * T;
    d[AT_X] = y[VX] * cos(y[PHI]) + y[VH] * sin(y[PHI]);
    d[AT_Z] = y[VH] * cos(y[PHI]) - y[VX] * sin(y[PHI]);
}

/* Regularised friction, by RK4 as near to its limit of stability as is safe. */
static long regularised(double *y, const struct rival *r, double t)
{
    const double rate = r->mu * (1 + 1 / r->IX) / r->delta;
    const long n = (long)ceil(t * rate / 2) + 50;
    const double h = t / (double)n;
    for (long i = 0; i < n; ++i) {
        double k[4][SIZE], at[SIZE];
        const double part[] = {0, 0.5, 0.5, 1};
        for (int j = 0; j < 4; ++j) {
            for (int m = 0; m < SIZE; ++m)
                at[m] = y[m] + (j ? part[j] * h * k[j - 1][m] : 0);
            slopes(k[j], at, r);
        }
        for (int m = 0; m < SIZE; ++m)
            y[m] += h / 6 * (k[0][m] + 2 * k[1][m] + 2 * k[2][m] + k[3][m]);
    }
    return n;
}

/* Time stepping: velocities without friction, then the impulse that stops the
 * slip, or as much of it as mu N h gives; then the pose. */
static void time_stepping(double *y, const struct rival *of, double t, long n)
{
    const double h = t / (double)n;
    const struct rival smooth = {of->IX, of->IZ, 0, 1};
    for (long i = 0; i < n; ++i) {
        double d[SIZE];
        slopes(d, y, &smooth);
        const double s = sin(y[THETA]), c = cos(y[THETA]);
        const double T = s / c, k = 1 / of->IX;
        const double gX = -y[WY] * (of->IZ * y[WZ] + of->IX * y[WY] * T) * k;
        const double weight = 1 - y[WX] * y[WX] * c - s * gX;
        const double D = 1 + k * s * s;
        for (int m = WX; m <= VH; ++m)
            y[m] += h * d[m];
        const double aX = 1 + 1 / of->IZ, ah = (1 + k) / D;
        double pX = -(y[VX] + y[WZ]) / aX, ph = -(y[VH] - y[WX] * c) / ah;
        const double N = (h * weight + k * s * c * ph) / D;
        const double size = hypot(pX, ph), most = of->mu * N;
        if (size > most) {
            const double uX = y[VX] + y[WZ], uh = y[VH] - y[WX] * c;
            const double u = hypot(uX, uh);
            const double slid = h * weight / (D + k * s * c * of->mu * uh / u);
            pX = -of->mu * slid * uX / u;
            ph = -of->mu * slid * uh / u;
        }
        const double more = k * s * c * ph / D; /* of N */
        y[WX] += k * (more * s - ph * c);
        y[WZ] += pX / of->IZ;
        y[VX] += pX;
        y[VH] += ph;
        slopes(d, y, &smooth);
        for (int m = THETA; m < SIZE; ++m)
            y[m] += h * d[m];
    }
}

static double apart(const double *y, const coin_state *s)
{
    const double d[] = {y[THETA] - s->theta, y[PHI] - s->phi, y[PSI] - s->psi,
                        y[AT_X] - s->x, y[AT_Z] - s->z};
    double most = 0;
    for (int i = 0; i < 5; ++i)
        most = fmax(most, fabs(d[i]));
    return most;
}

static void rivals(void)
{
    const coin_state at = {.theta = 0.15, .wY = 0.3, .wZ = 1.25};
    const coin_slide start = slide_at(&at, 1, 0.1);
    const double t = 7, mu = 0.375;
    const coin_friction f = {mu, mu};
    coin_params p;
    coin_params_ring(&p, 1, 1, 0.5, 1);
    coin_slide exact = start;
    coin_slide_advance(&exact, &p, &f, NULL, t, 1e-13, NULL);
    for (double tol = 1e-2; tol > 1e-11; tol /= 100) {
        coin_slide d = start;
        double took = INFINITY;
        for (int k = 0; k < 9; ++k) {
            const double t0 = seconds();
            d = start;
            coin_slide_advance(&d, &p, &f, NULL, t, tol, NULL);
            took = fmin(took, seconds() - t0);
        }
        printf("located, tol %.0e: error %.1e, %.1f us\n", tol,
               path_apart(&d.s, &exact.s, &p), 1e6 * took);
    }
    const double y0[SIZE] = {0, at.wY, at.wZ, 1, 0.1, 0.15, 0, 0, 0, 0};
    for (double delta = 1e-2; delta > 5e-6; delta /= 10) {
        const struct rival r = {p.inertia_X, p.inertia_Z, mu, delta};
        double y[SIZE];
        memcpy(y, y0, sizeof y);
        const double t0 = seconds();
        const long n = regularised(y, &r, t);
        printf("regularised, delta %.0e: error %.1e, %ld steps, %.1f us\n",
               delta, apart(y, &exact.s), n, 1e6 * (seconds() - t0));
    }
    for (long n = 700; n < 8000000; n *= 10) {
        const struct rival r = {p.inertia_X, p.inertia_Z, mu, 0};
        double y[SIZE];
        memcpy(y, y0, sizeof y);
        const double t0 = seconds();
        time_stepping(y, &r, t, n);
        printf("time stepping, h %.0e: error %.1e, %ld steps, %.1f us\n",
               t / (double)n, apart(y, &exact.s), n, 1e6 * (seconds() - t0));
    }
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "launches") == 0)
        launches(argc > 2 ? atoi(argv[2]) : 10000);
    else if (strcmp(what, "cost") == 0)
        cost();
    else if (strcmp(what, "rivals") == 0)
        rivals();
    else
        return 2;
    return 0;
}
