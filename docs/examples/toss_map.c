/* SPDX-License-Identifier: MIT */
/* Draws which face a tossed coin shows, against the height that it is let go at
 * and its spin, and a part of that map forty times as large.
 *
 *   cc toss_map.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >toss_map.svg
 *
 * The coin, a disc, is let go with heads up and its face horizontal, and turns
 * about a diameter.  Heads are drawn as the runs of their cells. */
#include "svg.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TOL 1e-6

/* A map: its cells, and their size in pixels. */
enum { COLUMNS = 168, ROWS = 120, SIZE = 2 };
enum { LEFT = 40, TOP = 60, APART = 392 };
enum { WIDTH = 784, HEIGHT = 344 };

static const coin_table TABLE = {
    .mu_static = 0.33, .mu_kinetic = 0.3, .restitution = 0.5};

/* Heights in radii above where it lies, spins in sqrt(g/a). */
typedef struct map {
    const char *title;
    double low, high, slow, fast;
    int heads[ROWS][COLUMNS];
} map;

/* Whether it shows heads, its +Z side. */
static int shows_heads(const coin_params *p, double height, double spin)
{
    const double flat = nextafter(asin(1), 0);
    coin_body b = {.s = {.theta = -flat, .wX = spin}, .y = height};
    int32_t status;

    do
        status = coin_move(&b, p, &TABLE, INFINITY, TOL, 0, NULL);
    while (status == COIN_ESTEP);
    if (status != COIN_RESTS) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
    return b.s.theta < 0;
}

static void compute(map *m, const coin_params *p)
{
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column) {
            const double x = (column + 0.5) / COLUMNS, y = (row + 0.5) / ROWS;
            m->heads[row][column] =
                shows_heads(p, m->low + x * (m->high - m->low),
                            m->slow + y * (m->fast - m->slow));
        }
}

/* -------------------------------------------------------------- drawing -- */

/* The cells that show heads: each run as a line, from the upper left. */
static void draw_heads(const map *m, int x)
{
    printf("<path fill=\"" SVG_GREY "\" d=\"M%d %dh%dv%dh%dz\"/>\n", x, TOP,
           COLUMNS * SIZE, ROWS * SIZE, -COLUMNS * SIZE);
    printf("<path transform=\"translate(%d %g)scale(%d)\" "
           "stroke=\"" SVG_BLUE "\" d=\"",
           x, TOP + SIZE / 2.0, SIZE);
    for (int row = 0; row < ROWS; ++row) {
        const int *cell = m->heads[ROWS - 1 - row];
        for (int column = 0, end; column < COLUMNS; column = end) {
            for (end = column; end < COLUMNS && cell[end] == cell[column];)
                ++end;
            if (cell[column])
                printf("M%d %dh%d", column, row, end - column);
        }
    }
    puts("\"/>");
}

static void draw(const map *m, int x)
{
    const svg_panel v = {x,      TOP,     COLUMNS * SIZE, ROWS * SIZE,
                         m->low, m->high, m->fast,        m->slow};

    svg_text(stdout, x, TOP - 12, "start", 14, m->title);
    svg_ticks(stdout, &v);
    draw_heads(m, x);
    svg_text(stdout, x + v.width, TOP + v.height + 36, "end", 13,
             "height, radii");
}

static void draw_key(void)
{
    printf("<path fill=\"" SVG_BLUE "\" d=\"M%d 12h14v14h-14z\"/>\n", LEFT);
    svg_text(stdout, LEFT + 20, 24, "start", 14, "heads, as it began");
    printf("<path fill=\"" SVG_GREY "\" d=\"M%d 12h14v14h-14z\"/>\n",
           LEFT + 160);
    svg_text(stdout, LEFT + 180, 24, "start", 14, "tails");
}

/* The place of the second map in the first. */
static void draw_frame(const map *all, const map *part)
{
    const svg_panel v = {LEFT,     TOP,       COLUMNS * SIZE, ROWS * SIZE,
                         all->low, all->high, all->fast,      all->slow};
    const double x = svg_x(&v, part->low), y = svg_y(&v, part->fast);

    printf("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
           "fill=\"none\" stroke=\"" SVG_VERMILLION "\" stroke-width=\"2\"/>\n",
           x, y, svg_x(&v, part->high) - x, svg_y(&v, part->slow) - y);
}

int main(void)
{
    static map all = {"spin, sqrt(g/a)", 0, 20, 0, 8, {{0}}};
    static map part = {"the same in the frame", 12, 12.5, 4, 4.2, {{0}}};
    coin_params disc;

    coin_params_disc(&disc, 1, 1, 1);
    compute(&all, &disc);
    compute(&part, &disc);
    svg_begin(stdout, WIDTH, HEIGHT, "Which face a toss ends with");
    draw_key();
    draw(&all, LEFT);
    draw(&part, LEFT + APART);
    draw_frame(&all, &part);
    puts("</svg>");
    return ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
