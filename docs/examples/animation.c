/* SPDX-License-Identifier: MIT */
/* Draws README's animation: a US quarter rolls a rosette that closes.
 *
 *   cc animation.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >animation.svg
 *
 * The drawing has no script: a viewer interpolates between its keys (SMIL),
 * also where it is shown as an image.  Readers who prefer reduced motion get a
 * still of STILLS coins. */
#include "animation.h"

#include <string.h>

enum { TRAILS = 8 }; /* dashes, one on another, that make the trail fade */

/* -------------------------------------------------------------- writing -- */

/* A number, no longer than it has to be. */
static void number(double value, int digits)
{
    char text[32];

    snprintf(text, sizeof text, "%.*f", digits, value);
    char *end = text + strlen(text);
    while (digits > 0 && end[-1] == '0')
        *--end = '\0';
    if (end[-1] == '.')
        *--end = '\0';
    const int minus = text[0] == '-', zero = strcmp(text + minus, "0") == 0;
    const int point = strncmp(text + minus, "0.", 2) == 0;
    printf("%s%s", minus && !zero ? "-" : "", text + minus + point);
}

/* What a group or an element does: an attribute, its members and their digits,
 * and what stands before them. */
typedef struct change {
    const char *what, *before;
    int first, count, digits;
} change;

static const change MOVE = {"translate", "", X, 2, 1};
static const change TURN = {"rotate", "", TILT, 1, 1};
static const change GROW = {"scale", "", SIZE, 1, 2};
static const change FLAT = {"scale", "1 ", MINOR, 1, 3};
static const change SPIN = {"rotate", "", ROLL, 1, 1};
static const change TO_FRONT = {"translate", "0 ", FRONT, 1, 3};
static const change TO_BACK = {"translate", "0 ", BACK, 1, 3};
static const change CAST = {"translate", "", SHADOW_X, 2, 1};
static const change SLANT = {"rotate", "", SHADOW_TILT, 1, 1};
static const change SPREAD = {"scale", "", SHADOW_A, 2, 1};

static void write_change(const change *c, int k)
{
    printf("%s", c->before);
    for (int i = 0; i < c->count; ++i) {
        if (i > 0)
            putchar(' ');
        number(key[k][c->first + i], c->digits);
    }
}

/* Of the animation [s]. */
static double duration(void)
{
    return orbit.period * SWINGS * SECONDS_PER_UNIT * SLOWER;
}

static void write_values(const change *c)
{
    printf(" dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"", duration());
    for (int k = 0; k <= KEYS; ++k) {
        if (k > 0)
            putchar(';');
        write_change(c, k);
    }
    puts("\"/>");
}

/* Opens a group that is where key k has it, or moves if k < 0. */
static void open_group(const change *c, int k)
{
    printf("<g transform=\"%s(", c->what);
    write_change(c, k < 0 ? 0 : k);
    puts(")\">");
    if (k >= 0)
        return;
    printf("<animateTransform attributeName=\"transform\" type=\"%s\"",
           c->what);
    write_values(c);
}

static void close_groups(int count)
{
    while (count-- > 0)
        printf("</g>");
    putchar('\n');
}

static void animate(const char *attribute, int member, int digits)
{
    const change c = {attribute, "", member, 1, digits};

    printf("<animate attributeName=\"%s\"", attribute);
    write_values(&c);
}

static void attribute(const char *name, int member, int digits, int k)
{
    printf(" %s=\"", name);
    number(key[k < 0 ? 0 : k][member], digits);
    putchar('"');
}

/* ----------------------------------------------------------------- coin -- */

/* When a face is seen: from each key time on or not, by turns. */
static void show_when(int side)
{
    int seen = side * key[0][MINOR] > 0;

    printf("<animate attributeName=\"display\" calcMode=\"discrete\" "
           "dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"%s",
           duration(), seen ? "inline" : "none");
    for (int k = 1; k <= KEYS; ++k)
        if (key[k][MINOR] * key[k - 1][MINOR] < 0)
            printf(";%s", (seen = !seen) ? "inline" : "none");
    printf("\" keyTimes=\"0");
    for (int k = 1; k <= KEYS; ++k) {
        const double a = key[k - 1][MINOR], b = key[k][MINOR];
        if (a * b < 0) {
            putchar(';');
            number((k - 1 + a / (a - b)) / KEYS, 4);
        }
    }
    puts("\"/>");
}

static void draw_face(int side, int k)
{
    const int shade = side > 0 ? SHADE_FRONT : SHADE_BACK;
    const int seen = side * key[k < 0 ? 0 : k][MINOR] > 0;

    if (k >= 0 && !seen)
        return;
    printf("<g display=\"%s\">\n", seen ? "inline" : "none");
    if (k < 0)
        show_when(side);
    open_group(side > 0 ? &TO_FRONT : &TO_BACK, k);
    open_group(&FLAT, k);
    puts("<use href=\"#face\"/>");
    open_group(&SPIN, k);
    printf("<use href=\"#%s\"/></g>\n<circle r=\"1\"",
           side > 0 ? "heads" : "tails");
    attribute("fill-opacity", shade, 2, k);
    puts(">");
    if (k < 0)
        animate("fill-opacity", shade, 2);
    puts("</circle>");
    close_groups(3);
}

static void draw_coin(int k)
{
    open_group(&MOVE, k);
    open_group(&TURN, k);
    open_group(&GROW, k);
    printf("<rect x=\"-1\" width=\"2\" rx=\"1\" fill=\"url(#rim)\"");
    attribute("y", RIM_TOP, 3, k);
    attribute("height", RIM_HEIGHT, 3, k);
    attribute("ry", RIM_ROUND, 3, k);
    puts(">");
    if (k < 0) {
        animate("y", RIM_TOP, 3);
        animate("height", RIM_HEIGHT, 3);
        animate("ry", RIM_ROUND, 3);
    }
    puts("</rect>");
    draw_face(1, k);
    draw_face(-1, k);
    close_groups(3);
}

static void draw_shadow(int k)
{
    open_group(&CAST, k);
    open_group(&SLANT, k);
    open_group(&SPREAD, k);
    puts("<circle r=\"1\" class=\"shadow\"/>");
    close_groups(3);
}

/* ---------------------------------------------------------------- table -- */

static void draw_ring(double radius, const char *class)
{
    const double at[3] = {0, 0, 0}, u[3] = {radius, 0, 0},
                 v[3] = {0, 0, radius};
    const ellipse e = camera_circle(&CAMERA, at, u, v, 0);

    printf("<ellipse class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" rx=\"%.1f\" "
           "ry=\"%.1f\"/>\n",
           class, e.x, e.y, e.major, e.minor);
}

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
    animate("stroke-dashoffset", DRAWN, 4);
    for (int k = 1; k <= TRAILS; ++k) {
        const double length = 0.5 * k / TRAILS;
        printf("<use href=\"#path\" stroke-dasharray=\"0 %.2f %.2f 0\"/>\n",
               1 - length, length);
    }
    puts("</g>");
}

static void draw_table(void)
{
    draw_ring(3.8, "table");
    draw_ring(3, "ring");
    draw_ring(2, "ring");
    draw_ring(1, "ring");
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
    const double seconds = duration() / SLOWER;

    printf("<text x=\"%d\" y=\"%d\">Lean</text>\n", LEFT, TOP - 16);
    for (int lean = 0; lean <= LEAN_AXIS; lean += 10) {
        printf("<path class=\"grid\" d=\"M%d %.1fH%d\"/>", LEFT, graph_y(lean),
               RIGHT);
        printf("<text class=\"small\" x=\"%d\" y=\"%.1f\" "
               "text-anchor=\"end\">%d\302\260</text>\n",
               LEFT - 8, graph_y(lean) + 4.5, lean);
    }
    for (int t = 0; t < seconds; ++t)
        printf("<text class=\"small\" x=\"%.1f\" y=\"%d\" "
               "text-anchor=\"middle\">%d s</text>\n",
               graph_x(t / seconds), BOTTOM + 20, t);
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
    printf(">\n<animate attributeName=\"cx\" dur=\"%.2fs\" "
           "repeatCount=\"indefinite\" values=\"%d;%d\"/>\n",
           duration(), LEFT, RIGHT);
    animate("cy", HEIGHT, 1);
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

static const char DEFS[] =
    "<defs>\n"
    "<linearGradient id=\"rim\"><stop stop-color=\"#5d4636\"/>"
    "<stop offset=\".3\" stop-color=\"#c9966f\"/>"
    "<stop offset=\".5\" stop-color=\"#eed0b4\"/>"
    "<stop offset=\".75\" stop-color=\"#b07d58\"/>"
    "<stop offset=\"1\" stop-color=\"#4d392c\"/></linearGradient>\n"
    "<g id=\"face\"><circle r=\"1\" fill=\"#dde2e7\"/>"
    "<circle r=\".9\" fill=\"#c6cdd4\" stroke=\"#8f99a3\" "
    "stroke-width=\".03\"/></g>\n"
    "<g id=\"heads\" fill=\"#7d8893\">"
    "<path d=\"M.55 0 .17-.12 .17-.52-.07-.2-.45-.32-.21 0-.45 .32-.07 .2 "
    ".17 .52 .17 .12z\"/>"
    "<circle cx=\".75\" r=\".1\" fill=\"#d55e00\"/></g>\n"
    "<g id=\"tails\" fill=\"none\" stroke=\"#7d8893\" stroke-width=\".1\">"
    "<circle r=\".5\"/><path d=\"M-.5 0H.5M-.25-.43 .25 .43M-.25 .43 "
    ".25-.43\"/>"
    "<circle cx=\".75\" r=\".1\" fill=\"#d55e00\" stroke=\"none\"/></g>\n"
    "</defs>\n";

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
           "lean, %d turns, %d rolls</title>\n%s%s"
           "<rect class=\"ground\" width=\"800\" height=\"400\"/>\n",
           SWINGS, TURNS, ROLLS, STYLE, DEFS);
    draw_table();
    draw_coins();
    draw_graph();
    write_captions();
    puts("</svg>");
    return ferror(stdout) != 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
