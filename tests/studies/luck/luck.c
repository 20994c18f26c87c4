/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "luck.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define SEED 20261129

/* 9,999 of 10,000 numbers of a normal distribution are closer. */
#define CHANCE 3.9

/* Thousands of times what a toss takes. */
#define MOST_CALLS 100000

int luck_count(const struct luck *l, int full, int small)
{
    return l->small ? small : full;
}

/* ------------------------------------------------------------------- rows */

void luck_claim(struct luck *l, int holds, const char *what)
{
    if (holds)
        return;
    ++l->missed;
    fprintf(stderr, "missed: %s\n", what);
}

/* Of a share that was seen, (got + 1)/(n + 2) stands for the true one: 0 of n
 * has an error too. */
static double binomial_error(double got, double n)
{
    const double share = (got + 1) / (n + 2);
    return sqrt(share * (1 - share) / n);
}

void luck_share(struct luck *l, const char *what, double x, double y, int got,
                int n, double expected)
{
    const double error = isnan(expected) ? binomial_error(got, n)
                                         : sqrt(expected * (1 - expected) / n);
    const double share = (double)got / n;
    printf("%s,%g,%g,%d,%.6g,%.2g,%.6g\n", what, x, y, n, share, error,
           expected);
    luck_claim(l, isnan(expected) || fabs(share - expected) <= CHANCE * error,
               what);
}

void luck_number(const char *what, double x, double y, double value,
                 double error, int n)
{
    printf("%s,%g,%g,%d,%.6g,%.2g,nan\n", what, x, y, n, value, error);
}

/* ----------------------------------------------------------------- tosses */

static uint64_t mixed(uint64_t x) /* splitmix64 */
{
    x += UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

double luck_random(int i, unsigned k, double low, double high)
{
    const uint64_t bits = mixed(mixed(mixed(SEED) + (uint64_t)i) + k);
    return low + (high - low) * (double)(bits >> 11) / 0x1p53;
}

struct work {
    void (*one)(void *of, int i);
    void *of;
    int n;
    atomic_int next;
};

static void *worker(void *of)
{
    struct work *w = of;
    for (int i; (i = atomic_fetch_add(&w->next, 1)) < w->n;)
        w->one(w->of, i);
    return NULL;
}

static int processors(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 64 ? 64 : (int)n;
}

void luck_each(int n, void (*one)(void *of, int i), void *of)
{
    struct work w = {one, of, n, 0};
    pthread_t threads[64];
    int started = 0;
    while (started < processors() - 1 &&
           pthread_create(&threads[started], NULL, worker, &w) == 0)
        ++started;
    worker(&w);
    while (started > 0)
        pthread_join(threads[--started], NULL);
}

static void must_move(int32_t status)
{
    if (status >= 0)
        return;
    fprintf(stderr, "a toss: %s\n", coin_status_string(status));
    exit(1);
}

/* Of the two whole numbers next to the half turns of a flight, that which gives
 * the face.  A coin that rocks on the table turns over once at most. */
static int half_turns(double angle, int changed)
{
    const int turns = 2 * (int)(angle / 2 / acos(-1));
    return changed                        ? turns + 1
           : angle / acos(-1) - turns > 1 ? turns + 2
                                          : turns;
}

struct luck_end luck_toss(coin_body b, const coin_params *p,
                          const coin_table *table, double tol)
{
    struct luck_end end = {coin_body_face(&b, p) == COIN_HEADS, 0, 0};
    int32_t status = COIN_OK;
    int calls = 0;
    while (!(status & COIN_RESTS)) {
        double moved;
        status = coin_move(&b, p, table, INFINITY, tol, COIN_TOUCHES, &moved);
        must_move(status);
        if (++calls > MOST_CALLS) {
            fprintf(stderr, "a toss does not come to rest\n");
            exit(1);
        }
        const int heads = coin_body_face(&b, p) == COIN_HEADS;
        end.turns += half_turns(fabs(b.s.wX) * moved, heads != end.heads);
        end.impacts += (status & COIN_TOUCHES) != 0;
        end.heads = heads;
    }
    return end;
}

coin_table luck_table(double restitution)
{
    const coin_table table = {.mu_static = 0.33,
                              .mu_kinetic = 0.3,
                              .restitution = restitution,
                              .losses = {.flat = 1e-3}};
    return table;
}

coin_params luck_disc(void)
{
    coin_params p;
    must_move(coin_params_disc(&p, 1, 1, 1));
    return p;
}

coin_params luck_quarter(void)
{
    coin_params p;
    must_move(coin_params_disc(&p, 0.00567, 0.01213, 9.80665));
    return p;
}

coin_body luck_flat(double height, double spin)
{
    const coin_body b = {.s = {.theta = -LUCK_FLAT, .wX = spin}, .y = height};
    return b;
}

/* ------------------------------------------------------------------- maps */

struct drawing {
    const struct luck_map *m;
    char *cells;
};

static void draw_row(void *of, int row)
{
    static const char letters[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                  "abcdefghijklmnopqrstuvwxyz";
    const struct drawing *d = of;
    const struct luck_map *m = d->m;
    const double y = m->top - (row + 0.5) / m->rows * (m->top - m->bottom);
    for (int column = 0; column < m->columns; ++column) {
        const double x =
            m->left + (column + 0.5) / m->columns * (m->right - m->left);
        const int turns = m->at(m->of, x, y).turns;
        d->cells[row * m->columns + column] =
            letters[turns > 61 ? 60 + turns % 2 : turns];
    }
}

void luck_draw(const struct luck_map *m)
{
    struct drawing d = {m, malloc((size_t)m->columns * (size_t)m->rows)};
    if (!d.cells)
        exit(1);
    luck_each(m->rows, draw_row, &d);
    printf("map|%s|%g|%g|%g|%g\n", m->title, m->left, m->right, m->bottom,
           m->top);
    for (int row = 0; row < m->rows; ++row)
        printf("%.*s\n", m->columns, d.cells + row * m->columns);
    free(d.cells);
}

/* ------------------------------------------------------------------- main */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
    struct luck l = {0, 0, 0};
    const double begin = now();
    l.small = argc == 2 && !strcmp(argv[1], "small");
    l.map = argc == 2 && !strcmp(argv[1], "map");
    if (argc > 1 && !l.small && !l.map) {
        fprintf(stderr, "usage: %s [small | map]\n", argv[0]);
        return 1;
    }
    if (!l.map)
        printf("what,x,y,tosses,share,error,expected\n");
    luck_study(&l);
    if (!l.map)
        printf("# seed %d, %.0f s, %d threads\n", SEED, now() - begin,
               processors());
    return l.missed || fflush(stdout) != 0;
}
