/* SPDX-License-Identifier: MIT */
/* Draws which face a tossed coin shows, and how often it turned over before,
 * against the height that it is let go at and its spin; and a part of that map
 * forty times as large.
 *
 *   cc toss_map.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >toss_map.svg
 *
 * The coin, a disc, is let go with heads up and its face horizontal, and turns
 * about a diameter.  It shows heads after an even number of half turns.  Each
 * colour is drawn as the runs of its cells. */
#include "svg.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define TOL 1e-6

/* A map: its cells, and their size in pixels. */
enum { COLUMNS = 336, ROWS = 240 };
enum { LEFT = 40, TOP = 84, APART = 392 };
enum { WIDTH = 784, HEIGHT = 368 };

/* A coin within 1e-3 rad of flat lies down: in a plane one may rock without a
 * loss for ever. */
static const coin_table TABLE = {.mu_static = 0.33,
                                 .mu_kinetic = 0.3,
                                 .restitution = 0.5,
                                 .losses = {.flat = 1e-3}};

/* Of heads and tails after 0 or 1 half turns, to 3, to 7, and more. */
enum { SHADES = 4 };
static const char *const COLOURS[2 * SHADES] = {"#08519c", "#a63603", "#2f7fbc",
                                                "#e6550d", "#74b0d8", "#fd9a50",
                                                "#c0d8ec", "#fdd0a2"};

/* Heights in radii above where it lies, spins in sqrt(g/a). */
typedef struct map {
    const char *title;
    double low, high, slow, fast;
    int turns[ROWS][COLUMNS];
} map;

/* Of the two whole numbers next to the half turns of a flight, that which is
 * odd if the face has changed.  A coin on the table turns over once at most. */
static int half_turns(double angle, int changed)
{
    const double turns = angle / (2 * asin(1));
    const int even = 2 * (int)(turns / 2);

    return changed ? even + 1 : even + 2 * (turns > even + 1);
}

/* How often it turns over until it rests. */
static int turns_of(const coin_params *p, double height, double spin)
{
    const double flat = nextafter(asin(1), 0);
    coin_body b = {.s = {.theta = -flat, .wX = spin}, .y = height};
    int turns = 0;

    for (int32_t status = COIN_OK; !(status & COIN_RESTS);) {
        const int heads = b.s.theta < 0;
        double t;
        status = coin_move(&b, p, &TABLE, INFINITY, TOL, COIN_TOUCHES, &t);
        if (status < 0) {
            fprintf(stderr, "%s\n", coin_status_string(status));
            exit(EXIT_FAILURE);
        }
        turns += half_turns(fabs(b.s.wX) * t, (b.s.theta < 0) != heads);
    }
    return turns;
}

static void compute(map *m, const coin_params *p)
{
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column) {
            const double x = (column + 0.5) / COLUMNS, y = (row + 0.5) / ROWS;
            m->turns[row][column] = turns_of(p, m->low + x * (m->high - m->low),
                                             m->slow + y * (m->fast - m->slow));
        }
}

/* -------------------------------------------------------------- drawing -- */

static int colour_of(int turns)
{
    int shade = 0;

    while (shade < SHADES - 1 && turns >> (shade + 1))
        ++shade;
    return 2 * shade + turns % 2;
}

/* The cells of a colour: each run as a line, from the end of the one before. */
static void draw_colour(const map *m, int x, int colour)
{
    printf(
        "<path transform=\"translate(%d %g)\" shape-rendering=\"crispEdges\" "
        "stroke=\"%s\" d=\"",
        x, TOP + 0.5, COLOURS[colour]);
    for (int row = 0, at = 0, up = 0; row < ROWS; ++row) {
        const int *cell = m->turns[ROWS - 1 - row];
        for (int column = 0, end; column < COLUMNS; column = end) {
            end = column;
            while (end < COLUMNS && colour_of(cell[end]) == colour)
                ++end;
            if (end > column) {
                printf("m%d %dh%d", column - at, row - up, end - column);
                at = end;
                up = row;
            } else {
                ++end;
            }
        }
    }
    puts("\"/>");
}

static void draw(const map *m, int x)
{
    const svg_panel v = {x,      TOP,     COLUMNS, ROWS,
                         m->low, m->high, m->fast, m->slow};

    svg_text(stdout, x, TOP - 12, "start", 14, m->title);
    svg_ticks(stdout, &v);
    for (int colour = 0; colour < 2 * SHADES; ++colour)
        draw_colour(m, x, colour);
    svg_text(stdout, x + v.width, TOP + v.height + 36, "end", 13,
             "height, radii");
}

static void draw_key(void)
{
    static const char *const names[2] = {"heads, as it began", "tails"};

    for (int k = 0; k < 2 * SHADES; ++k)
        printf("<path fill=\"%s\" d=\"M%d 38h14v14h-14z\"/>\n", COLOURS[k],
               LEFT + k / 2 * 14 + k % 2 * 208);
    for (int face = 0; face < 2; ++face)
        svg_text(stdout, LEFT + 62 + face * 208, 50, "start", 14, names[face]);
    svg_text(stdout, LEFT + APART, 50, "start", 14,
             "after 0 or 1 half turns, to 3, to 7, and more");
}

/* The place of the second map in the first. */
static void draw_frame(const map *all, const map *part)
{
    const svg_panel v = {LEFT,     TOP,       COLUMNS,   ROWS,
                         all->low, all->high, all->fast, all->slow};
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
    svg_text(stdout, LEFT, 22, "start", 16,
             "Which face a toss ends with, and after how many half turns");
    draw_key();
    draw(&all, LEFT);
    draw(&part, LEFT + APART);
    draw_frame(&all, &part);
    puts("</svg>");
    return ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
