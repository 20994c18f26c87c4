/* SPDX-License-Identifier: MIT */
/* Draws a US quarter that rolls a rosette which closes.
 *
 *   cc animation.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >animation.svg
 *
 * Readers who prefer reduced motion get a still of STILLS coins. */
#include "animation.h"

enum { TRAILS = 8 }; /* dashes, one on another, that make the trail fade */

/* ---------------------------------------------------------------- table -- */

/* Cubics from points and slopes p[k] = x, y, x', y' at every step. */
static void write_cubics(double p[][4], int count)
{
    double x = floor(10 * p[0][0] + 0.5) / 10;
    double y = floor(10 * p[0][1] + 0.5) / 10;

    printf("M%.1f %.1f", x, y);
    for (int k = 1; k <= count; ++k) {
        const double *a = p[k - 1], *b = p[k];
        const double to[6] = {a[0] + a[2] / 3 - x,
                              a[1] + a[3] / 3 - y,
                              b[0] - b[2] / 3 - x,
                              b[1] - b[3] / 3 - y,
                              b[0] - x,
                              b[1] - y};
        putchar('c');
        for (int i = 0; i < 6; ++i) {
            if (i > 0)
                putchar(' ');
            number(to[i], 1);
        }
        x += floor(10 * to[4] + 0.5) / 10;
        y += floor(10 * to[5] + 0.5) / 10;
    }
}

/* Dashes that end where the coin is: drawn as it goes, and fading behind it. */
static void draw_trail(void)
{
    puts("<g class=\"trail moving\">");
    animate("stroke-dashoffset", DRAWN, 4, 0);
    for (int k = 1; k <= TRAILS; ++k) {
        const double length = 0.5 * k / TRAILS;
        printf("<use href=\"#path\" stroke-dasharray=\"0 %.2f %.2f 0\"/>\n",
               1 - length, length);
    }
    puts("</g>");
}

static void draw_table(void)
{
    draw_ring(0, 3.8, "table");
    draw_ring(0, 3, "ring");
    draw_ring(0, 2, "ring");
    draw_ring(0, 1, "ring");
    printf("<defs><path id=\"path\" pathLength=\"1\" d=\"");
    write_cubics(path, KEYS);
    puts("\"/></defs>\n<use href=\"#path\" class=\"path\"/>");
    draw_trail();
}

/* ---------------------------------------------------------------- graph -- */

static double graph_x(double part)
{
    return LEFT + (RIGHT - LEFT) * part;
}

static void draw_axes(void)
{
    const double real = seconds / SLOWER;

    printf("<text x=\"%d\" y=\"%d\">Lean</text>\n", LEFT, TOP - 16);
    for (int lean = 0; lean <= LEAN_AXIS; lean += 10) {
        printf("<path class=\"grid\" d=\"M%d %.1fH%d\"/>", LEFT, graph_y(lean),
               RIGHT);
        printf("<text class=\"small\" x=\"%d\" y=\"%.1f\" "
               "text-anchor=\"end\">%d\302\260</text>\n",
               LEFT - 8, graph_y(lean) + 4.5, lean);
    }
    for (int t = 0; t < real; ++t)
        printf("<text class=\"small\" x=\"%.1f\" y=\"%d\" "
               "text-anchor=\"middle\">%d s</text>\n",
               graph_x(t / real), BOTTOM + 20, t);
}

static void draw_graph(void)
{
    const double dt = orbit.period * SWINGS / PIECES;
    double lean[PIECES + 1][4];

    draw_axes();
    for (int k = 0; k <= PIECES; ++k) {
        const coin_state *s = &state[k * (KEYS / PIECES)];
        lean[k][0] = graph_x((double)k / PIECES);
        lean[k][1] = graph_y(s->theta * DEGREES);
        lean[k][2] = (double)(RIGHT - LEFT) / PIECES;
        lean[k][3] = graph_y(s->wX * dt * DEGREES) - graph_y(0);
    }
    printf("<path class=\"lean\" d=\"");
    write_cubics(lean, PIECES);
    printf("\"/>\n<circle class=\"dot moving\" r=\"6\" cx=\"%d\"", LEFT);
    attribute("cy", HEIGHT, 1, 0);
    printf(">\n<animate attributeName=\"cx\" dur=\"%gs\" "
           "repeatCount=\"indefinite\" values=\"%d;%d\"/>\n",
           seconds, LEFT, RIGHT);
    animate("cy", HEIGHT, 1, 0);
    puts("</circle>");
}

static void write_captions(void)
{
    printf("<text class=\"small\" x=\"%d\" y=\"%d\">A US quarter, %g times "
           "slower.</text>\n",
           LEFT - 32, BOTTOM + 56, SLOWER);
    printf("<text class=\"small\" x=\"%d\" y=\"%d\">%d swings, %d turns, %d "
           "rolls: it starts again.</text>\n",
           LEFT - 32, BOTTOM + 76, SWINGS, TURNS, ROLLS);
    printf("<text class=\"small\" x=\"%d\" y=\"%d\">It needs a coefficient of "
           "friction of %.2f.</text>\n",
           LEFT - 32, BOTTOM + 96, ceil(100 * friction()) / 100);
}

/* ------------------------------------------------------------- document -- */

static const char STYLE[] =
    "<style>\n"
    "text{font:15px Helvetica,Arial,sans-serif;fill:#1f2328}\n"
    ".small{font-size:13px;fill:#59636e}\n"
    ".ground{fill:#fff}.table{fill:#f3f5f8;stroke:#d5dae1}\n"
    ".ring,.grid{fill:none;stroke:#e1e5ea}\n"
    ".path,.lean,.trail{fill:none;stroke:#0072b2;stroke-linejoin:round}\n"
    ".path{stroke-width:1.2;opacity:.3}.trail{stroke-width:3;stroke-opacity:."
    "28}\n"
    ".lean{stroke-width:2}.dot{fill:#d55e00;stroke:#fff;stroke-width:1.5}\n"
    ".shadow{fill:#101820;fill-opacity:.22}.still{display:none}\n"
    "@media (prefers-color-scheme:dark){\n"
    "text{fill:#e6edf3}.small{fill:#9198a1}.ground{fill:#0d1117}\n"
    ".table{fill:#161d27;stroke:#2b333e}.ring,.grid{stroke:#2b333e}\n"
    ".path,.lean,.trail{stroke:#4fb0ea}.dot{stroke:#0d1117}\n"
    ".shadow{fill:#000;fill-opacity:.5}}\n"
    "@media (prefers-reduced-motion:reduce){\n"
    ".moving{display:none}.still{display:inline}.path{opacity:1}}\n"
    "</style>\n";

static void draw_coins(void)
{
    puts("<g class=\"moving\">");
    draw_shadow(-1);
    draw_coin(-1);
    puts("</g>\n<g class=\"still\">");
    for (int k = 0; k < STILLS; ++k)
        draw_shadow(k * KEYS / STILLS);
    for (int k = 0; k < STILLS; ++k)
        draw_coin(k * KEYS / STILLS);
    puts("</g>");
}

int main(void)
{
    demand(coin_params_disc(&disc, 1, 1, 1));
    find_orbit();
    set_keys();
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" "
           "height=\"400\" viewBox=\"0 0 800 400\" role=\"img\">\n"
           "<title>A US quarter rolls a rosette that closes: %d swings of its "
           "lean, %d turns, %d rolls</title>\n%s"
           "<defs>\n%s</defs>\n"
           "<rect class=\"ground\" width=\"800\" height=\"400\"/>\n",
           SWINGS, TURNS, ROLLS, STYLE, COIN_DEFS);
    draw_table();
    draw_coins();
    draw_graph();
    write_captions();
    puts("</svg>");
    return ferror(stdout) != 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
