/* SPDX-License-Identifier: MIT */
/* Draws which launches roll, which slip and which lift off, for a disc on a
 * table with a coefficient of friction of 0.3.
 *
 *   cc slip_map.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >slip_map.svg
 *
 * To the right the lean, upwards wY, the spin about the diameter.  The coin on
 * the left spins in place, that on the right rolls ahead with wZ = 1.  A region
 * is drawn as the runs of its cells, one path for each. */
#include "svg.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define TOL 1e-8
#define TIME 10.0 /* in sqrt(a/g) */

/* A map, in degrees by sqrt(g/a); its cells, and their size in pixels. */
enum { LEANS = 84, SPINS = 6, COLUMNS = 112, ROWS = 80, SIZE = 3 };
enum { LEFT = 40, TOP = 40, APART = 392 };
enum { WIDTH = 784, HEIGHT = 324 };

static const coin_table TABLE = {.mu_static = 0.3, .mu_kinetic = 0.27};

typedef enum fate { ROLLS, SLIPS, LIFTS, FATES } fate;

/* A word in a map, and its width in pixels. */
typedef struct label {
    const char *name;
    double lean, wY;
    int width;
} label;

typedef struct map {
    const char *title;
    double wZ, wY_low; /* of the lower edge */
    label labels[6];
    fate cell[ROWS][COLUMNS];
} map;

static const struct {
    const char *name, *color;
} LOOK[FATES] = {
    {"rolls", SVG_BLUE}, {"slips", SVG_VERMILLION}, {"lifts off", SVG_PURPLE}};

static double lean_of(int column)
{
    return (column + 0.5) * LEANS / COLUMNS * PI / 180;
}

static double wY_of(const map *m, int row)
{
    return m->wY_low + (row + 0.5) * SPINS / ROWS;
}

/* Moves a body until the first moment of `stop`; the mode at the end. */
static int32_t move(coin_body *b, const coin_params *p, double t, int32_t stop)
{
    const int32_t status = coin_move(b, p, &TABLE, t, TOL, stop, NULL);

    if (status < 0 || status & COIN_MORE) {
        fprintf(stderr, "%s\n", coin_status_string(status));
        exit(EXIT_FAILURE);
    }
    return status;
}

/* What becomes of a launch: one that slips, from the start or later, may go on
 * to lift off. */
static fate fate_of(const coin_state *start, const coin_params *p)
{
    coin_body b;

    coin_body_from_state(&b, start, p);
    int32_t mode = move(&b, p, 0, 0);
    if (mode == COIN_OK)
        mode = move(&b, p, TIME, COIN_SLIPS | COIN_LIFTS);
    if (mode == COIN_OK || mode & COIN_RESTS)
        return ROLLS;
    if (mode & COIN_SLIPS)
        mode = move(&b, p, TIME, COIN_LIFTS);
    return mode & COIN_LIFTS ? LIFTS : SLIPS;
}

static void compute(map *m, const coin_params *p)
{
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column) {
            const coin_state s = {
                .theta = lean_of(column), .wY = wY_of(m, row), .wZ = m->wZ};
            m->cell[row][column] = fate_of(&s, p);
        }
}

/* -------------------------------------------------------------- drawing -- */

/* What fills a region, in cells: even, dotted, hatched. */
static void draw_patterns(void)
{
    static const char *const MARK[FATES] = {
        "", "<circle cx=\"1\" cy=\"1\" r=\".4\"/>",
        "<path d=\"M0 2L2 0h.7L0 2.7zM0 0h.7L0 .7z\"/>"};

    for (int k = 0; k < FATES; ++k)
        printf("<pattern id=\"p%d\" width=\"2\" height=\"2\" "
               "patternUnits=\"userSpaceOnUse\" fill=\"%s\">"
               "<path fill-opacity=\".35\" d=\"M0 0h2v2H0z\"/>%s</pattern>\n",
               k, LOOK[k].color, MARK[k]);
}

/* The cells of one fate: each run as a line, in cells from the upper left. */
static void draw_region(const map *m, int which, int x)
{
    printf("<path transform=\"translate(%d %g)scale(%d)\" "
           "stroke=\"url(#p%d)\" d=\"",
           x, TOP + SIZE / 2.0, SIZE, which);
    for (int row = 0; row < ROWS; ++row) {
        const fate *cell = m->cell[ROWS - 1 - row];
        for (int column = 0, end; column < COLUMNS; column = end) {
            for (end = column; end < COLUMNS && cell[end] == cell[column];)
                ++end;
            if ((int)cell[column] == which)
                printf("M%d %dh%d", column, row, end - column);
        }
    }
    puts("\"/>");
}

/* The steady motions, which need no swing. */
static void draw_steady(const map *m, const svg_panel *v, const coin_params *p)
{
    svg_curve c;

    svg_curve_begin(&c, stdout, SVG_BLACK, 1.4);
    for (int lean = 1; lean < LEANS; ++lean) {
        coin_state s;
        const double theta = lean * PI / 180;
        const int32_t status = m->wZ > 0
                                   ? coin_steady_circle(&s, p, theta, m->wZ, 1)
                                   : coin_steady_spin(&s, p, theta);
        if (status == COIN_OK)
            svg_curve_point(&c, svg_x(v, lean), svg_y(v, s.wY));
    }
    svg_curve_end(&c);
}

static void draw_name(const svg_panel *v, const label *at)
{
    const double x = svg_x(v, at->lean), y = svg_y(v, at->wY);

    printf("<rect x=\"%.0f\" y=\"%.0f\" width=\"%d\" height=\"20\" rx=\"4\" "
           "fill=\"white\"/>\n",
           x - at->width / 2, y - 15, at->width);
    svg_text(stdout, x, y, "middle", 13, at->name);
}

static void draw(const map *m, const coin_params *p, int x)
{
    const svg_panel v = {x, TOP,   COLUMNS * SIZE,    ROWS * SIZE,
                         0, LEANS, m->wY_low + SPINS, m->wY_low};

    svg_text(stdout, x, TOP - 16, "start", 15, m->title);
    svg_ticks(stdout, &v);
    for (int which = 0; which < FATES; ++which)
        draw_region(m, which, x);
    draw_steady(m, &v, p);
    for (const label *at = m->labels; at->name != NULL; ++at)
        draw_name(&v, at);
    svg_text(stdout, x + v.width, TOP + v.height + 36, "end", 13,
             "lean, degrees");
}

int main(void)
{
    static map maps[] = {
        {"wY against lean: it spins in place, wZ = 0",
         0,
         0,
         {{"rolls", 30, 1.3, 40},
          {"slips", 12, 4, 40},
          {"slips", 42, 0.45, 40},
          {"lifts off", 52, 4.6, 62},
          {"steady", 20, 1.85, 48}},
         {{ROLLS}}},
        {"wY against lean: it rolls ahead, wZ = 1",
         1,
         -3,
         {{"rolls", 8, 0.1, 40},
          {"slips", 56, 0.7, 40},
          {"slips", 60, -2.1, 40},
          {"lifts off", 32, 2.1, 62},
          {"lifts off", 15, -2.1, 62}},
         {{ROLLS}}},
    };
    coin_params disc;

    coin_params_disc(&disc, 1, 1, 1);
    svg_begin(stdout, WIDTH, HEIGHT, "Which launches roll, slip or lift off");
    draw_patterns();
    for (int k = 0; k < 2; ++k) {
        compute(&maps[k], &disc);
        draw(&maps[k], &disc, LEFT + k * APART);
    }
    puts("</svg>");
    return ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
