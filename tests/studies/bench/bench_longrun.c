/* SPDX-License-Identifier: MIT */
/* What becomes of the energy, of the linear integrals and of the phase over ten
 * million steps and more: 32 starts that differ by a thousandth, one of which
 * goes on to 1e8.
 *     bench_longrun            CSV of drifts
 *     bench_longrun damping    CSV of the nutation's amplitude */
#include "scene.h"

#include <extrapolation.h>
#include <run.h>
#include <sundman.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Five marks in a decade, from 1e3 steps to 1e7, and to 1e8 for one start. */
enum { STARTS = 32, FIRST = 3, ALL = 7, LAST = 8, PER_DECADE = 5 };
enum { MARKS = (LAST - FIRST) * PER_DECADE + 1 };

/* Steps between two looks: well under the time in which the phase of any
 * method here slips by half a period, or turns could not be counted. */
#define BLOCK 1000

/* How finely coin_advance() follows a coin to its turning point. */
#define FINE 1e-13

#define TURN 6.283185307179586

enum { ENERGY, K_Y, K_Z, PHASE, DRIFTS };

/* A coin under fixed steps of h: by a method in t, or, as coin_advance() steps,
 * in tau. */
enum { IN_TAU = 100 };

typedef struct mover {
    int32_t method;
    coin_params p;
    coin_state s;
    double h;
    long double t;     /* since the start */
    coin_priv_run run; /* in tau */
} mover;

static const char *name_of(int32_t method)
{
    return method == IN_TAU ? "order 14 in tau" : coin_method_name(method);
}

static mover mover_at(int32_t method, const coin_state *s, const coin_params *p,
                      double h)
{
    mover m = {.method = method, .p = *p, .s = *s, .h = h};
    if (coin_priv_check(s, p, &m.run.b) == COIN_OK)
        coin_priv_run_unlimited(&m.run, s);
    return m;
}

/* n steps; 0, or a step failed.  The time in tau is summed apart, or the sum's
 * rounding would soon be all that one sees of the phase. */
static int mover_go(mover *m, unsigned long n)
{
    if (m->method != IN_TAU) {
        m->t += (long double)m->h * (long double)n;
        return coin_run(&m->s, &m->p, m->method, m->h, n, NULL) < 0;
    }
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

/* One start: what is exact, and how far off a run has been. */
struct track {
    mover m;
    double energy, K[2];
    double period, top; /* of theta; when it is first at its greatest */
    double slip;        /* of the phase, whole turns included [T] */
    double worst[DRIFTS];
};

/* SplitMix64, uniform in [-1, 1). */
static double uniform(void)
{
    static uint64_t seed = 20260102;
    uint64_t z = seed += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return (double)(int64_t)(z ^ (z >> 31)) * 0x1p-63;
}

static double advance(coin_state *s, const coin_params *p, double t)
{
    coin_advance(s, p, t, FINE, NULL);
    return t;
}

/* The time from *s to where theta is at its greatest on *s's own exact orbit,
 * or a period later if that is near: wX falls through 0.  Moves *s there. */
static double to_top(coin_state *s, const coin_params *p)
{
    double t = advance(s, p, 0.25), before;
    do {
        before = s->wX;
        t += advance(s, p, 0.25);
    } while (!(before > 0 && s->wX <= 0));
    for (int i = 0; i < 6; ++i) {
        coin_state rate;
        coin_rates(s, p, &rate);
        t += advance(s, p, -s->wX / rate.wX);
    }
    return t;
}

/* All starts but the first are moved by up to a thousandth. */
static struct track begin(int32_t method, double h, const scene *c, int index)
{
    const double by = index == 0 ? 0 : 1e-3;
    coin_state s = c->row[0].s;
    s.theta *= 1 + by * uniform();
    s.wX *= 1 + by * uniform();
    s.wY *= 1 + by * uniform();
    s.wZ *= 1 + by * uniform();
    struct track k = {.m = mover_at(method, &s, &c->p, h)};
    k.energy = coin_energy(&s, &c->p);
    coin_integrals(&s, &c->p, k.K);
    k.top = to_top(&s, &c->p);
    for (int i = 0; i < 64; ++i)
        k.period += to_top(&s, &c->p) / 64;
    return k;
}

static void widen(double *worst, double by)
{
    *worst = fabs(by) <= *worst ? *worst : fabs(by);
}

static void look(struct track *k)
{
    const double size = hypot(k->K[0], k->K[1]), P = k->period;
    double K[2];
    coin_state s = k->m.s;
    coin_integrals(&s, &k->m.p, K);
    widen(&k->worst[ENERGY], coin_energy(&s, &k->m.p) / k->energy - 1);
    widen(&k->worst[K_Y], (K[0] - k->K[0]) / size);
    widen(&k->worst[K_Z], (K[1] - k->K[1]) / size);
    const long double top = k->m.t + to_top(&s, &k->m.p) - k->top;
    k->slip += remainder((double)fmodl(top, P) - k->slip, P);
    widen(&k->worst[PHASE], k->slip * TURN / P);
}

static double mark(int i)
{
    return round(pow(10, FIRST + (double)i / PER_DECADE) / BLOCK) * BLOCK;
}

/* Fills out[mark][drift]; returns the marks reached before a step failed. */
static int follow(struct track *k, int marks, double out[][DRIFTS])
{
    double steps = 0;
    for (int i = 0; i < marks; ++i) {
        for (; steps < mark(i); steps += BLOCK) {
            if (mover_go(&k->m, BLOCK))
                return i;
            look(k);
        }
        memcpy(out[i], k->worst, sizeof k->worst);
    }
    return marks;
}

static void drifts(int32_t method, double h, const scene *c)
{
    static double all[STARTS][MARKS][DRIFTS];
    int reached[STARTS];
    for (int i = 0; i < STARTS; ++i) {
        struct track k = begin(method, h, c, i);
        const int marks = i == 0 ? MARKS : (ALL - FIRST) * PER_DECADE + 1;
        reached[i] = follow(&k, marks, all[i]);
    }
    for (int j = 0; j < MARKS; ++j) {
        double square[DRIFTS] = {0}, worst[DRIFTS] = {0};
        int n = 0;
        for (int i = 0; i < STARTS; ++i) {
            n += reached[i] > j;
            for (int d = 0; d < DRIFTS && reached[i] > j; ++d) {
                square[d] += all[i][j][d] * all[i][j][d];
                widen(&worst[d], all[i][j][d]);
            }
        }
        printf("%s,%g,%.0f,%.6g,%d", name_of(method), h, mark(j), mark(j) * h,
               n);
        for (int d = 0; d < DRIFTS; ++d)
            printf(",%.3g,%.3g", sqrt(square[d] / n), worst[d]);
        puts("");
    }
    fflush(stdout);
}

/* Twice the nutation's amplitude in windows of three periods or so: a hundred
 * windows, evenly spaced in the logarithm of time. */
static void damping(int32_t method, double h, const scene *c)
{
    const int window = (int)(12 / h);
    mover m = mover_at(method, &c->row[0].s, &c->p, h);
    double next = 10;
    while (next < 1e6) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < window; ++i) {
            if (mover_go(&m, 1))
                return;
            low = fmin(low, m.s.theta);
            high = fmax(high, m.s.theta);
        }
        printf("%s,%g,%.6g,%.4g\n", name_of(method), h, (double)m.t,
               high - low);
        for (next *= 1.12; m.t < next;)
            if (mover_go(&m, (unsigned long)window))
                return;
    }
    fflush(stdout);
}

int main(int argc, char **argv)
{
    static const struct {
        int32_t method;
        double h;
    } long_runs[] =
        {
            {COIN_RK4, 0.05},         {COIN_RK4, 0.01},        {COIN_RK8, 0.1},
            {COIN_RK8, 0.05},         {IN_TAU, 0.1},           {IN_TAU, 0.05},
            {COIN_SYMPLECTIC2, 0.05}, {COIN_SYMPLECTIC4, 0.1},
        },
      coarse[] = {
          {COIN_RK4, 0.2}, {COIN_RK4, 0.1},         {COIN_RK4, 0.05},
          {COIN_RK8, 0.2}, {COIN_SYMPLECTIC2, 0.1}, {COIN_SYMPLECTIC4, 0.2},
      };
    scene c;
    scene_load(&c, "generic", 20);
    if (argc > 1 && strcmp(argv[1], "damping") == 0) {
        puts("method,h,t,swing");
        for (unsigned i = 0; i < sizeof coarse / sizeof *coarse; ++i)
            damping(coarse[i].method, coarse[i].h, &c);
        return 0;
    }
    puts("method,h,steps,t,starts,energy_rms,energy_worst,KY_rms,KY_worst,"
         "KZ_rms,KZ_worst,phase_rms,phase_worst");
    for (unsigned i = 0; i < sizeof long_runs / sizeof *long_runs; ++i)
        drifts(long_runs[i].method, long_runs[i].h, &c);
    return 0;
}
