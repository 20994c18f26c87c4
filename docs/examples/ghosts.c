/* SPDX-License-Identifier: MIT */
/* Draws README's toss of a US quarter, and twenty more that are each thrown one
 * per cent harder than the one before.
 *
 *   cc ghosts.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >ghosts.svg
 *
 * A ghost gets the colour of its side when that is decided.  Readers who prefer
 * reduced motion get a still. */
#include "animated.h"
#include "turning.h"

#define TOL 1e-9
#define SECONDS 6.0 /* of the loop */
#define WAIT 0.4    /* in the hand [s] */
#define SLOWER 3.0  /* than a real coin */
#define UNDECIDED "#8c959f"

enum { KEYS = 1000, STILLS = 3, GHOSTS = 20 };
enum { WIDTH = 720, HEIGHT = 420 };
enum { RIGHT = 424, ROW = 336, APART = 14 }; /* of the ghosts */
enum { GHOST = 15 };                         /* radius */
enum { COUNT = 110 };                        /* line of text */
enum { FIRST = 382, SECOND = 410 };          /* lines of text */

static const coin_body THROW = {.s = {.theta = -1.5,
                                      .phi = -0.2,
                                      .x = -0.042,
                                      .wX = 91,
                                      .wY = -3,
                                      .wZ = -24},
                                .y = 0.035,
                                .vx = 0.23,
                                .vy = 0.97,
                                .vz = 0.02}; /* m, s */

static const camera NEAR = {0.55, 0.835, 22, {0, 3, 0}, {206, 172}, 32};
static const camera FAR = {0.55, 0.835, 44, {3.4, 4, 0}, {572, 184}, 15};

static coin_params quarter;
static coin_table table;

/* How a toss ends, and the keys at which that is decided and at which the coin
 * rests. */
typedef struct ending {
    int32_t face;
    int decided, rests;
} ending;

/* --------------------------------------------------------------- motion -- */

static void set_table(void)
{
    const double torque = quarter.mass * quarter.gravity * quarter.radius;

    table.mu_static = 0.3;
    table.mu_kinetic = 0.25;
    table.restitution = 0.45;
    table.losses.dry = 7e-3 * torque;
    table.losses.spin = 0.03 * torque * sqrt(quarter.radius / quarter.gravity);
}

/* The coin, thrown with all its velocities times harder. */
static coin_body thrown(double harder)
{
    coin_body b = THROW;

    b.s.wX *= harder;
    b.s.wY *= harder;
    b.s.wZ *= harder;
    b.vx *= harder;
    b.vy *= harder;
    b.vz *= harder;
    return b;
}

/* Moves a coin by a time.  Returns its mode, and COIN_DECIDED if it was. */
static int32_t move(coin_body *b, double t)
{
    int32_t status = 0, moments = 0;

    for (double moved; t > 0 && !(status & COIN_RESTS); t -= moved) {
        status = coin_move(b, &quarter, &table, t, TOL, COIN_DECIDED, &moved);
        demand(status);
        moments |= status & COIN_DECIDED;
    }
    return status | moments;
}

/* The coin and its shadow in the view, at every key. */
static ending set_keys(coin_body b)
{
    ending e = {0, 0, 0};

    keys = KEYS;
    first_moved = (int)(WAIT / SECONDS * KEYS);
    seconds = SECONDS;
    for (int k = 0; k <= KEYS; ++k) {
        const double *last = key[k > 0 ? k - 1 : 0];
        const double dt = SECONDS / KEYS, t = k * dt - WAIT;
        double m[16];
        if (t > 0 && e.rests == 0) {
            const int32_t status = move(&b, fmin(t, dt) / SLOWER);
            if (status & COIN_DECIDED)
                e.decided = k;
            if (status & COIN_RESTS)
                e.rests = last_moved = k;
        }
        demand(coin_body_matrix(&b, &quarter, m));
        for (int i = 12; i < 15; ++i)
            m[i] /= quarter.radius;
        coin_at(key[k], last, m);
        shadow_at(key[k], last, m);
        key[k][OWN] = GHOST * fmax(fabs(key[k][MINOR]), THICKNESS / 2);
    }
    e.face = coin_body_face(&b, &quarter);
    return e;
}

/* -------------------------------------------------------------- drawing -- */

/* Of heads and tails. */
static const char *const COLOURS[] = {"#2f8fd0", "#e69f00"};

/* Unseen before a key. */
static void appear_at(int k)
{
    printf("<animate attributeName=\"opacity\" calcMode=\"discrete\" "
           "dur=\"%gs\" repeatCount=\"indefinite\" values=\"0;1\" "
           "keyTimes=\"0;%g\"/>",
           SECONDS, (double)k / KEYS);
}

/* Where the coin is at first. */
static void draw_hand(void)
{
    printf("<use href=\"#hand\" transform=\"translate(%.1f %.1f) "
           "scale(%.1f)\"/>\n",
           key[0][X], key[0][Y], key[0][SIZE]);
}

static void draw_mark(int k)
{
    printf("<circle cx=\"%d\" cy=\"%d\" r=\"6\"/>", RIGHT + 7 + k * APART, ROW);
}

/* A ghost and its mark in the row below, which get the colour of its side. */
static void draw_ghost(int k, const ending *e)
{
    static const change FLY = {"translate", "", X, 2, 0, 2.2};
    static const change LEAN = {"rotate", "", TILT, 1, 0, 16};
    const char *colour = COLOURS[e->face == COIN_TAILS];

    printf("<g class=\"moving\" fill=\"" UNDECIDED "\"><animate "
           "attributeName=\"fill\" calcMode=\"discrete\" dur=\"%gs\" "
           "repeatCount=\"indefinite\" values=\"" UNDECIDED ";%s\" "
           "keyTimes=\"0;%g\"/>",
           SECONDS, colour, (double)e->decided / KEYS);
    draw_mark(k);
    open_group(&FLY, -1);
    printf("<ellipse rx=\"%d\">", GHOST);
    transform(&LEAN);
    animate("ry", OWN, 0, 2);
    printf("</ellipse></g></g>\n<g class=\"still\" fill=\"%s\">", colour);
    draw_mark(k);
    printf("<ellipse rx=\"%d\" ry=\"%.0f\" transform=\"translate(%.0f %.0f) "
           "rotate(%.0f)\"/></g>\n",
           GHOST, key[KEYS][OWN], key[KEYS][X], key[KEYS][Y], key[KEYS][TILT]);
}

static void write_text(double x, double y, const char *text)
{
    printf("<text x=\"%g\" y=\"%g\">%s</text>\n", x, y, text);
}

static void write_count(int x, int face, int count)
{
    const char *name = face == COIN_HEADS ? "heads" : "tails";

    printf("<circle cx=\"%d\" cy=\"%d\" r=\"8\" fill=\"%s\"/>", x, COUNT - 8,
           COLOURS[face == COIN_TAILS]);
    printf("<text x=\"%d\" y=\"%d\">%d %s</text>\n", x + 18, COUNT, count,
           name);
}

static void draw_ghosts(void)
{
    int heads = 0, last = 0;
    double harder = 1;

    draw_ring(3.4, 9, "table");
    puts("<g fill-opacity=\".6\">");
    for (int k = 0; k < GHOSTS; ++k) {
        harder *= 1.01;
        const ending e = set_keys(thrown(harder));
        draw_ghost(k, &e);
        heads += e.face == COIN_HEADS;
        last = e.decided > last ? e.decided : last;
    }
    puts("</g>\n<g>");
    appear_at(last);
    write_count(RIGHT + 24, COIN_HEADS, heads);
    write_count(RIGHT + 168, COIN_TAILS, GHOSTS - heads);
    puts("</g>");
}

static void draw_toss(void)
{
    const ending e = set_keys(thrown(1));

    draw_ring(0, 4.8, "table");
    puts("<g class=\"moving\">");
    draw_shadow(-1);
    draw_hand();
    draw_coin(-1);
    puts("</g>\n<g class=\"still\">");
    for (int k = 0; k <= STILLS; ++k) {
        draw_shadow(k * e.rests / STILLS);
        draw_coin(k * e.rests / STILLS);
    }
    printf("</g>\n<text class=\"verdict\" x=\"%.0f\" y=\"%.0f\">%s",
           key[KEYS][X], key[KEYS][Y] - 44,
           e.face == COIN_HEADS ? "heads" : "tails");
    appear_at(e.rests);
    puts("</text>");
}

/* ------------------------------------------------------------- document -- */

static const char STYLE[] =
    "<style>\n"
    "text{font:22px Helvetica,Arial,sans-serif;fill:#1f2328}\n"
    ".verdict{font-weight:bold;font-size:30px;text-anchor:middle}\n"
    ".ground{fill:#fff}.table{fill:#eef1f5;stroke:#d5dae1}\n"
    ".shadow{fill:#101820;fill-opacity:.22}.still{display:none}\n"
    "@media (prefers-color-scheme:dark){\n"
    "text{fill:#e6edf3}.ground{fill:#0d1117}\n"
    ".table{fill:#161d27;stroke:#2b333e}\n"
    ".shadow{fill:#000;fill-opacity:.5}}\n"
    "@media (prefers-reduced-motion:reduce){\n"
    ".moving{display:none}.still{display:inline}}\n"
    "</style>\n";

/* It flicks its thumb, in radii of the coin, and is gone. */
static const char HAND[] =
    "<g id=\"hand\"><animateTransform attributeName=\"transform\" "
    "type=\"translate\" dur=\"6s\" repeatCount=\"indefinite\" "
    "values=\"0 0;0 .3;0 -.3;-9 4;-9 4\" keyTimes=\"0;.045;.067;.25;1\"/>"
    "<g stroke=\"#d9a679\" stroke-linecap=\"round\" fill=\"none\">"
    "<path stroke-width=\"1.3\" d=\"M-9 4.6L-2 1.5\"/>"
    "<path stroke-width=\".6\" stroke=\"#c48f63\" d=\"M-1.5 1.1L-.9 1.9M-1 "
    ".95L-.4 1.7M-.5 .8L.1 1.45\"/>"
    "<path stroke-width=\".7\" d=\"M-1.6 1.2L-.6 .8\"/>"
    "<path stroke-width=\".42\" d=\"M-1.7 .8L.1 .5\">"
    "<animateTransform attributeName=\"transform\" type=\"rotate\" "
    "dur=\"6s\" repeatCount=\"indefinite\" values=\"0 -1.7 .8;0 -1.7 .8;-40 "
    "-1.7 .8;-40 -1.7 .8\" keyTimes=\"0;.06;.075;1\"/></path></g></g>\n";

int main(void)
{
    demand(coin_params_cylinder(&quarter, 0.00567, 0.01213, 0.00175, 9.80665));
    set_table();
    thinned = 1;
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
           "height=\"%d\" viewBox=\"0 0 %d %d\" role=\"img\">\n"
           "<title>A US quarter is tossed; twenty more, each thrown one per "
           "cent harder, part into heads and tails</title>\n%s"
           "<defs>\n%s%s</defs>\n"
           "<rect class=\"ground\" width=\"%d\" height=\"%d\"/>\n",
           WIDTH, HEIGHT, WIDTH, HEIGHT, STYLE, COIN_DEFS, HAND, WIDTH, HEIGHT);
    view = NEAR;
    draw_toss();
    view = FAR;
    draw_ghosts();
    write_text(16, FIRST, "A US quarter is tossed,");
    write_text(16, SECOND, "three times slower than real.");
    write_text(RIGHT, FIRST, "Twenty more, each thrown");
    write_text(RIGHT, SECOND, "1 % harder than the last.");
    puts("</svg>");
    return ferror(stdout) != 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
