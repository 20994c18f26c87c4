/* SPDX-License-Identifier: MIT */
/* coin_advance() of these sources beside that of an older revision, linked in
 * with every name prefixed by old_ (tests/studies/bench/against.sh).
 *     against scenes        ratios at equal errors on the chart's scenes
 *     against coins         ratios at equal tol over 300 random coins
 *     against frames        short calls beside the textbook's step
 *     against until         what coin_move() costs that looks for a slip,
 *                           calls of one length after each other, in the
 *                           older coin_advance()
 *     against moves         what coin_move() costs, in the same
 *
 * A ratio above 1 says how many times faster these sources are, but in the last
 * two how many times dearer. */
#include "clock.h"
#include "scene.h"
#include "textbook.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int32_t old_coin_advance(coin_state *s, const coin_params *p, double t,
                         double tol, double *reached);

typedef int32_t advance(coin_state *, const coin_params *, double, double,
                        double *);

static advance *const both[2] = {old_coin_advance, coin_advance};

enum { RUNGS = 16 * 11 + 1, COINS = 300 };

/* ------------------------------------------------------------ the scenes -- */
static double run_scene(const scene *c, int k, double tol)
{
    coin_state s = c->row[0].s;
    double error = 0;
    for (int i = 1; i < c->rows; ++i) {
        if (both[k](&s, &c->p, c->row[i].t - c->row[i - 1].t, tol, NULL) < 0)
            return INFINITY;
        error = fmax(error, scene_error(c, &s, &c->row[i].s, 0));
    }
    return error;
}

static void go_scene(const scene *c, int k, double tol)
{
    coin_state s = c->row[0].s;
    for (int i = 1; i < c->rows; ++i)
        both[k](&s, &c->p, c->row[i].t - c->row[i - 1].t, tol, NULL);
}

struct curve {
    double error[RUNGS], ns[RUNGS];
};

/* The least cost at which a curve has an error below this, between two rungs
 * by the power law that joins them. */
static double cost_at(const struct curve *c, double error)
{
    double best = INFINITY;
    for (int i = 1; i < RUNGS; ++i) {
        const double e0 = c->error[i - 1], e1 = c->error[i];
        if (e0 > error && e1 <= error) {
            const double w = log(e0 / error) / log(e0 / e1);
            best = fmin(best, c->ns[i - 1] * pow(c->ns[i] / c->ns[i - 1], w));
        }
        if (e1 <= error)
            best = fmin(best, c->ns[i]);
    }
    return best;
}

static void measure_scene(const scene *c, struct curve curve[2])
{
    const double tare = clock_cost();
    for (int i = 0; i < RUNGS; ++i) {
        const double tol = fmax(1e-2 * pow(10, -i / 16.0), 1e-13);
        for (int k = 0; k < 2; ++k) {
            curve[k].error[i] = run_scene(c, k, tol);
            curve[k].ns[i] = INFINITY;
        }
        for (int j = 0; j < 60; ++j)
            for (int k = 0; k < 2; ++k) {
                const double begin = clock_ns();
                go_scene(c, k, tol);
                curve[k].ns[i] =
                    fmin(curve[k].ns[i], clock_ns() - begin - tare);
            }
    }
}

static void scenes(void)
{
    static const struct {
        const char *name;
        double until;
    } list[] = {
        {"generic", 20}, {"tumble", 20}, {"nearflat", 5},
        {"wobble", 20},  {"quarter", 1}, {"ring", 20},
    };
    enum { AT = 10 };
    double product[AT], least = INFINITY;
    for (int i = 0; i < AT; ++i)
        product[i] = 1;
    printf("scene");
    for (int i = 0; i < AT; ++i)
        printf(",1e-%d", i + 3);
    puts("");
    for (int k = 0; k < 6; ++k) {
        static struct curve curve[2];
        scene c;
        scene_load(&c, list[k].name, list[k].until);
        measure_scene(&c, curve);
        printf("%s", c.name);
        for (int i = 0; i < AT; ++i) {
            const double error = pow(10, -i - 3);
            const double ratio =
                cost_at(&curve[0], error) / cost_at(&curve[1], error);
            product[i] *= ratio;
            printf(",%.2f", ratio);
        }
        for (double e = 1e-5; e > 1e-12; e /= 1.3)
            least = fmin(least, cost_at(&curve[0], e) / cost_at(&curve[1], e));
        puts("");
    }
    printf("geometric mean");
    for (int i = 0; i < AT; ++i)
        printf(",%.2f", pow(product[i], 1.0 / 6));
    printf("\nleast below 1e-5,%.2f\n", least);
}

/* ----------------------------------------------------------- random coins --
 */
static uint64_t seed = 1;

static double between(double low, double high)
{
    uint64_t z = seed += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    z ^= z >> 31;
    return low + (high - low) * (double)(z >> 11) * 0x1p-53;
}

static void random_coins(void)
{
    static coin_state start[COINS];
    static coin_params p[COINS];
    const double tols[] = {1e-6, 1e-9, 1e-12}, times[] = {1, 4, 20};
    const double tare = clock_cost();
    for (int i = 0; i < COINS; ++i) {
        coin_params_ring(&p[i], 1, 1, between(0, 1), 1);
        start[i].theta = between(-1.5, 1.5);
        start[i].wX = between(-2, 2);
        start[i].wY = between(-2, 2);
        start[i].wZ = between(-2, 2);
    }
    puts("tol,horizon 1,4,20,geometric mean");
    for (int a = 0; a < 3; ++a) {
        double product = 1;
        printf("%g", tols[a]);
        for (int h = 0; h < 3; ++h) {
            double sum[2] = {0, 0};
            for (int i = 0; i < COINS; ++i) {
                double ns[2] = {INFINITY, INFINITY};
                for (int j = 0; j < 60; ++j)
                    for (int k = 0; k < 2; ++k) {
                        coin_state s = start[i];
                        const double begin = clock_ns();
                        both[k](&s, &p[i], times[h], tols[a], NULL);
                        ns[k] = fmin(ns[k], clock_ns() - begin - tare);
                    }
                sum[0] += ns[0];
                sum[1] += ns[1];
            }
            product *= sum[0] / sum[1];
            printf(",%.2f", sum[0] / sum[1]);
        }
        printf(",%.2f\n", pow(product, 1.0 / 3));
    }
}

/* ---------------------------------------------------------- short frames -- */
static double textbook(const scene *c)
{
    coin_state s = c->row[0].s;
    textbook_run(&s, &c->p, 1e-3 * c->unit, 400);
    return s.theta;
}

/* A call after a call, as a loop over frames makes them; theta stands for what
 * the next frame reads. */
static void frames_of(const char *name, double dt, double tol)
{
    scene c;
    scene_load(&c, name, 20);
    const double tare = clock_cost();
    double ns[2] = {INFINITY, INFINITY}, step = INFINITY;
    volatile double used = 0;
    for (int j = 0; j < 2000; ++j) {
        double begin = clock_ns();
        used = textbook(&c);
        step = fmin(step, (clock_ns() - begin - tare) / 400);
        for (int k = 0; k < 2; ++k) {
            coin_state s = c.row[0].s;
            begin = clock_ns();
            for (int i = 0; i < 200; ++i)
                both[k](&s, &c.p, dt, tol, NULL);
            ns[k] = fmin(ns[k], (clock_ns() - begin - tare) / 200);
            used = s.theta;
        }
    }
    (void)used;
    printf("%s,%.4g,%g,%.2f,%.2f\n", name, dt, tol, ns[0] / step, ns[1] / step);
}

static void frames(void)
{
    puts("scene,t,tol,old / textbook step,new / textbook step");
    frames_of("quarter", 1.0 / 60, 1e-6);
    frames_of("quarter", 1.0 / 60, 1e-9);
    frames_of("quarter", 1.0 / 240, 1e-6);
    frames_of("quarter", 1.0 / 1000, 1e-6);
    frames_of("quarter", 1.0 / 1000, 1e-9);
    frames_of("generic", 0.05, 1e-9);
    frames_of("generic", 0.05, 1e-6);
    frames_of("generic", 0.02, 1e-9);
    frames_of("generic", 0.01, 1e-12);
}

/* ------------------------------------------------------ stops at events -- */
enum { REACH = 20, LENGTHS = 15, SEARCHES = 4 };

/* What is looked for, and does not occur. */
struct search {
    double mu;
    int32_t bits;
};

static double largest_ratio(const scene *c)
{
    coin_state s = c->row[0].s;
    double most = 0;
    for (double t = 0; t < 1.01 * REACH; t += 0.002) {
        coin_force f;
        coin_reaction(&s, &c->p, &f);
        most = fmax(most, f.ratio);
        coin_advance(&s, &c->p, 0.002 * c->unit, 1e-11, NULL);
    }
    return most;
}

static double until_ns(const scene *c, double length, double tol,
                       const struct search *f)
{
    const int calls = (int)ceil(REACH / length);
    coin_state s = c->row[0].s;
    const coin_table table = {.mu_static = f ? f->mu : 0,
                              .mu_kinetic = f ? fmin(f->mu, 0.1) : 0};
    coin_body b;
    coin_body_from_state(&b, &s, &c->p);
    const double begin = clock_ns(), t = length * c->unit;
    for (int i = 0; i < calls; ++i) {
        if (!f)
            old_coin_advance(&s, &c->p, t, tol, NULL);
        else if (coin_move(&b, &c->p, &table, t, tol, f->bits, NULL))
            return NAN;
    }
    return (clock_ns() - begin) / calls;
}

/* The costs in those of the older coin_advance(), whose ns come first. */
static void until_row(const scene *c, double length, double tol,
                      const struct search f[SEARCHES])
{
    double old = INFINITY, ns[SEARCHES];
    for (int k = 0; k < SEARCHES; ++k)
        ns[k] = INFINITY;
    for (int j = 0; j < 200; ++j) {
        old = fmin(old, until_ns(c, length, tol, NULL));
        for (int k = 0; k < SEARCHES; ++k)
            ns[k] = fmin(ns[k], until_ns(c, length, tol, &f[k]));
    }
    printf("%s,%g,%g,%.0f", c->name, tol, length, old);
    for (int k = 0; k < SEARCHES; ++k)
        printf(",%.2f", ns[k] / old);
    puts("");
}

static void until(void)
{
    static const double lengths[LENGTHS] = {0.02, 0.05, 0.1, 0.15, 0.2,
                                            0.24, 0.3,  0.4, 0.48, 0.6,
                                            1,    1.5,  2.5, 5,    20};
    const char *names[] = {"generic", "tumble", "wobble", "quarter", "ring"};
    puts("scene,tol,length,old ns,mu 2,mu 1.1,mu 1.0001,nearly flat");
    for (int k = 0; k < 5; ++k) {
        scene c;
        scene_load(&c, names[k], 0);
        const double most = largest_ratio(&c);
        const int32_t both_bits = COIN_SLIPS | COIN_LIFTS;
        const struct search f[SEARCHES] = {
            {2 * most, both_bits},
            {1.1 * most, both_bits},
            {1.0001 * most, both_bits},
            {2 * most, both_bits | COIN_NEARLY_FLAT},
        };
        for (double tol = 1e-6; tol > 5e-13; tol /= 1000)
            for (int i = 0; i < LENGTHS; ++i)
                until_row(&c, lengths[i], tol, f);
    }
}

/* ---------------------------------------------------------------- moves -- */
enum {
    MODES = 3
}; /* the old coin_advance(), and coin_move() with much friction and
      with little more than is needed */

static double calls_of(int mode, const coin_params *p, const coin_table *f,
                       double t, double tol)
{
    const coin_state start = {.theta = 0.1, .wY = 0.05, .wZ = 1.2};
    const int calls = t < 4 ? (int)(4 / t) : 1;
    coin_state s = start;
    coin_body b;
    coin_body_from_state(&b, &start, p);
    const double begin = clock_ns();
    for (int i = 0; i < calls; ++i)
        if (mode == 0)
            old_coin_advance(&s, p, t, tol, NULL);
        else
            coin_move(&b, p, &f[mode - 1], t, tol, 0, NULL);
    return (clock_ns() - begin) / calls;
}

static void moves(void)
{
    /* Its motion needs F/N up to 0.0695. */
    const coin_table f[MODES - 1] = {
        {.mu_static = 0.14, .mu_kinetic = 0.126},
        {.mu_static = 0.0709, .mu_kinetic = 0.0638},
    };
    const double tols[] = {1e-6, 1e-9, 1e-12};
    const double times[] = {0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 20};
    coin_params p;
    coin_params_disc(&p, 1, 1, 1);
    puts("tol,t,old ns,move / old,move near the cone / old");
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 8; ++b) {
            double ns[MODES] = {INFINITY, INFINITY, INFINITY};
            for (int j = 0; j < 200; ++j)
                for (int k = 0; k < MODES; ++k)
                    ns[k] = fmin(ns[k], calls_of(k, &p, f, times[b], tols[a]));
            printf("%g,%g,%.0f,%.2f,%.2f\n", tols[a], times[b], ns[0],
                   ns[1] / ns[0], ns[2] / ns[0]);
        }
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "scenes") == 0)
        scenes();
    else if (strcmp(what, "coins") == 0)
        random_coins();
    else if (strcmp(what, "frames") == 0)
        frames();
    else if (strcmp(what, "until") == 0)
        until();
    else if (strcmp(what, "moves") == 0)
        moves();
    else
        return 2;
    return 0;
}
