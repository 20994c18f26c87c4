/* SPDX-License-Identifier: MIT */
/* What the studies of docs/luck.md share.  A study is a file with one function,
 * luck_study(), which writes rows; luck.c has its main():
 *
 *   NAME          the full counts
 *   NAME small    some seconds
 *   NAME map      what a figure draws, of a study that has maps
 *
 * A row with an expected value is a claim: if it is missed by more than chance
 * explains, the program says so and ends with 1. */
#ifndef ROLLCOIN_STUDIES_LUCK_H
#define ROLLCOIN_STUDIES_LUCK_H

#include <coin.h>

struct luck {
    int small, map;
    int missed; /* claims */
};

/* The study of a program. */
void luck_study(struct luck *l);

/* How many tosses: some for `small`. */
int luck_count(const struct luck *l, int full, int small);

/* ------------------------------------------------------------------- rows */

/* So many of n: a share with its binomial error.  x and y say what it is a
 * share of.  expected: the true share, or NAN where none is known.  9,999 in
 * 10,000 rows of a true share pass. */
void luck_share(struct luck *l, const char *what, double x, double y, int got,
                int n, double expected);

/* A number with a standard error, from n tosses; it claims nothing. */
void luck_number(const char *what, double x, double y, double value,
                 double error, int n);

/* A claim that needs no row. */
void luck_claim(struct luck *l, int holds, const char *what);

/* ----------------------------------------------------------------- tosses */

/* A number between low and high, the k-th of toss i: it depends on nothing
 * else, so that threads may toss in any order. */
double luck_random(int i, unsigned k, double low, double high);

/* Calls one(of, i) for i from 0 to n - 1, in all processors. */
void luck_each(int n, void (*one)(void *of, int i), void *of);

/* How a toss ended. */
struct luck_end {
    int heads;   /* coin_body_face() is COIN_HEADS */
    int turns;   /* half turns over: right if it turned about a diameter */
    int impacts; /* those before the last, of no bounce, are counted */
};

/* Moves a body until it rests; ends the program if it cannot. */
struct luck_end luck_toss(coin_body b, const coin_params *p,
                          const coin_table *table, double tol);

/* A table of friction 0.3.  A coin within 1e-3 rad of flat lies down: near the
 * borders of the maps one may rock in a plane for ever, without a loss. */
coin_table luck_table(double restitution);

/* A disc of M = a = g = 1, and a US quarter in kg and m. */
coin_params luck_disc(void);
coin_params luck_quarter(void);

/* A coin with heads up and its face horizontal, at a height, that turns about a
 * diameter. */
coin_body luck_flat(double height, double spin);

/* The last lean before pi/2. */
#define LUCK_FLAT 1.5707963267948963

/* ------------------------------------------------------------------- maps */

/* A map of how tosses end. */
struct luck_map {
    const char *title;
    int columns, rows;
    double left, right, bottom, top;
    struct luck_end (*at)(const void *of, double x, double y);
    const void *of;
};

/* Writes its head, and its rows from the top; a cell is the half turns, as one
 * of 62 letters. */
void luck_draw(const struct luck_map *m);

#endif
