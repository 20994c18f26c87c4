/* SPDX-License-Identifier: MIT */
/* animated.h: a coin that moves in a drawing.
 *
 * A program sets what a camera sees of the coin and of its shadow at every key,
 * evenly spread in time.  The drawing has no script: a viewer interpolates
 * between the keys (SMIL), also where it is shown as an image. */
#ifndef EXAMPLE_ANIMATED_H
#define EXAMPLE_ANIMATED_H

#include "camera.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PI 3.14159265358979323846
#define DEGREES (180 / PI)

#define THICKNESS 0.144 /* of a quarter, in radii */

/* What moves, at a key: angles in degrees, X, Y and the shadow in pixels,
 * lengths on the coin in half axes of its circle (SIZE). */
/* clang-format off */
enum {
    X, Y, SIZE, TILT,                /* the coin's circle: an ellipse */
    MINOR,                           /* its short half axis, < 0 from behind */
    FRONT, BACK,                     /* where its faces are along that axis */
    RIM_TOP, RIM_HEIGHT, RIM_ROUND,  /* its outline: a rectangle, rounded */
    ROLL,                            /* of what is on its faces */
    SHADE_FRONT, SHADE_BACK,         /* the light that they lack */
    SHADOW_X, SHADOW_Y, SHADOW_TILT, SHADOW_A, SHADOW_B,
    OWN,                             /* two of the program's own */
    MEMBERS = OWN + 2
};
/* clang-format on */

enum { MOST_KEYS = 1200 };

static double key[MOST_KEYS + 1][MEMBERS];
static int keys;       /* the last of them */
static double seconds; /* the animation's duration */

/* Whether keys are left out that a viewer interpolates well enough, and the two
 * that never are, between which the coin moves. */
static int thinned, first_moved, last_moved;

static camera view;
static const double LIGHT[3] = {-0.42, 0.85, 0.32}; /* where it comes from */

/* ----------------------------------------------------------------- keys -- */

/* The angle nearest to another, of those that differ by whole turns. */
static double continued(double angle, double near)
{
    return angle + 360 * floor((near - angle) / 360 + 0.5);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How far the coin has rolled, as an angle of its ellipse: where the point of
 * the rim on the coin's own first axis is. */
static void roll_at(double *now, const double *last, const double m[16])
{
    const double rim[3] = {m[12] + m[0], m[13] + m[1], m[14] + m[2]};
    const double sin_t = sin(now[TILT] / DEGREES),
                 cos_t = cos(now[TILT] / DEGREES);
    double at[2];

    camera_point(&view, rim, NULL, at, NULL);
    const double dx = at[0] - now[X], dy = at[1] - now[Y];
    now[ROLL] =
        continued(DEGREES * atan2((cos_t * dy - sin_t * dx) / now[MINOR],
                                  cos_t * dx + sin_t * dy),
                  last[ROLL]);
}

/* A coin's pose is the matrix of coin_matrix() or coin_body_matrix(), in radii.
 * Its angles follow those of the key before, last.  The faces stand off the
 * circle by half the thickness.  (A camera sees that along the short axis,
 * nearly.) */
static void coin_at(double *now, const double *last, const double m[16])
{
    double at[2], out[2], eye[3];
    const ellipse e =
        camera_circle(&view, m + 12, m, m + 4, last[TILT] / DEGREES);

    camera_point(&view, m + 12, m + 8, at, out);
    for (int i = 0; i < 3; ++i)
        eye[i] = view.target[i] - m[12 + i];
    eye[1] += view.distance * view.sth;
    eye[2] += view.distance * view.cth;
    now[X] = e.x;
    now[Y] = e.y;
    now[SIZE] = e.major;
    now[TILT] = e.tilt * DEGREES;
    now[MINOR] = copysign(e.minor / e.major, dot(m + 8, eye));
    now[FRONT] =
        THICKNESS / 2 / e.major * (cos(e.tilt) * out[1] - sin(e.tilt) * out[0]);
    now[BACK] = -now[FRONT];
    now[RIM_TOP] = -fabs(now[FRONT]) - fabs(now[MINOR]);
    now[RIM_HEIGHT] = -2 * now[RIM_TOP];
    now[RIM_ROUND] = fabs(now[MINOR]);
    now[SHADE_FRONT] = 0.22 - 0.22 * dot(m + 8, LIGHT);
    now[SHADE_BACK] = 0.22 + 0.22 * dot(m + 8, LIGHT);
    roll_at(now, last, m);
}

/* The shadow of a point or of a direction. */
static void cast(const double r[3], double on[3])
{
    on[0] = r[0] - r[1] * LIGHT[0] / LIGHT[1];
    on[1] = 0;
    on[2] = r[2] - r[1] * LIGHT[2] / LIGHT[1];
}

static void shadow_at(double *now, const double *last, const double m[16])
{
    double at[3], u[3], v[3];

    cast(m + 12, at);
    cast(m, u);
    cast(m + 4, v);
    const ellipse e =
        camera_circle(&view, at, u, v, last[SHADOW_TILT] / DEGREES);
    now[SHADOW_X] = e.x;
    now[SHADOW_Y] = e.y;
    now[SHADOW_TILT] = e.tilt * DEGREES;
    now[SHADOW_A] = e.major;
    now[SHADOW_B] = fmax(e.minor, THICKNESS / 2 * e.major);
}

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
 * what stands before them, and by how much a thinned one may be off. */
typedef struct change {
    const char *what, *before;
    int first, count, digits;
    double off;
} change;

static const change MOVE = {"translate", "", X, 2, 1, 0.6};
static const change TURN = {"rotate", "", TILT, 1, 1, 3.5};
static const change GROW = {"scale", "", SIZE, 1, 2, 0.3};
static const change FLAT = {"scale", "1 ", MINOR, 1, 3, 0.025};
static const change SPIN = {"rotate", "", ROLL, 1, 1, 5};
static const change TO_FRONT = {"translate", "0 ", FRONT, 1, 3, 0.01};
static const change TO_BACK = {"translate", "0 ", BACK, 1, 3, 0.01};
static const change CAST = {"translate", "", SHADOW_X, 2, 1, 1.5};
static const change SLANT = {"rotate", "", SHADOW_TILT, 1, 1, 5};
static const change SPREAD = {"scale", "", SHADOW_A, 2, 1, 1.5};

static void write_change(const change *c, int k)
{
    printf("%s", c->before);
    for (int i = 0; i < c->count; ++i) {
        if (i > 0)
            putchar(' ');
        number(key[k][c->first + i], c->digits);
    }
}

/* Whether a straight line from one key to another passes all keys between. */
static int straight(const change *c, int from, int to)
{
    for (int k = from + 1; k < to; ++k)
        for (int i = c->first; i < c->first + c->count; ++i) {
            const double part = (double)(k - from) / (to - from);
            const double drawn =
                key[from][i] + part * (key[to][i] - key[from][i]);
            if (fabs(drawn - key[k][i]) > c->off)
                return 0;
        }
    return 1;
}

/* The next key that is written after one. */
static int after(const change *c, int from)
{
    int to = from + 1;

    while (thinned && to < keys && to != first_moved && to != last_moved &&
           straight(c, from, to + 1))
        ++to;
    return to;
}

static void write_values(const change *c)
{
    printf(" dur=\"%gs\" repeatCount=\"indefinite\" values=\"", seconds);
    write_change(c, 0);
    for (int k = 0; k < keys;) {
        k = after(c, k);
        putchar(';');
        write_change(c, k);
    }
    if (thinned) {
        printf("\" keyTimes=\"0");
        for (int k = 0; k < keys;) {
            k = after(c, k);
            putchar(';');
            number((double)k / keys, 3);
        }
    }
    puts("\"/>");
}

static void transform(const change *c)
{
    printf("<animateTransform attributeName=\"transform\" type=\"%s\"",
           c->what);
    write_values(c);
}

/* Opens a group that is where key k has it, or moves if k < 0. */
static void open_group(const change *c, int k)
{
    printf("<g transform=\"%s(", c->what);
    write_change(c, k < 0 ? 0 : k);
    puts(")\">");
    if (k < 0)
        transform(c);
}

static void close_groups(int count)
{
    while (count-- > 0)
        printf("</g>");
    putchar('\n');
}

static void animate(const char *attribute, int member, int digits, double off)
{
    const change c = {attribute, "", member, 1, digits, off};

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
           "dur=\"%gs\" repeatCount=\"indefinite\" values=\"%s",
           seconds, seen ? "inline" : "none");
    for (int k = 1; k <= keys; ++k)
        if (key[k][MINOR] * key[k - 1][MINOR] < 0)
            printf(";%s", (seen = !seen) ? "inline" : "none");
    printf("\" keyTimes=\"0");
    for (int k = 1; k <= keys; ++k) {
        const double a = key[k - 1][MINOR], b = key[k][MINOR];
        if (a * b < 0) {
            putchar(';');
            number((k - 1 + a / (a - b)) / keys, 4);
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
        animate("fill-opacity", shade, 2, 0.05);
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
        animate("y", RIM_TOP, 3, 0.03);
        animate("height", RIM_HEIGHT, 3, 0.05);
        animate("ry", RIM_ROUND, 3, 0.04);
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

/* A circle on the table, somewhere on its first axis. */
static void draw_ring(double x, double radius, const char *class)
{
    const double at[3] = {x, 0, 0}, u[3] = {radius, 0, 0},
                 v[3] = {0, 0, radius};
    const ellipse e = camera_circle(&view, at, u, v, 0);

    printf("<ellipse class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" rx=\"%.1f\" "
           "ry=\"%.1f\"/>\n",
           class, e.x, e.y, e.major, e.minor);
}

/* The coin's rim and faces; the page has the same heads and tails. */
static const char COIN_DEFS[] =
    "<linearGradient id=\"rim\"><stop stop-color=\"#5d4636\"/>"
    "<stop offset=\".3\" stop-color=\"#c9966f\"/>"
    "<stop offset=\".5\" stop-color=\"#eed0b4\"/>"
    "<stop offset=\".75\" stop-color=\"#b07d58\"/>"
    "<stop offset=\"1\" stop-color=\"#4d392c\"/></linearGradient>\n"
    "<g id=\"face\"><circle r=\"1\" fill=\"#dde2e7\"/>"
    "<circle r=\".9\" fill=\"#c6cdd4\" stroke=\"#8f99a3\" "
    "stroke-width=\".03\"/></g>\n"
    "<path id=\"heads\" fill=\"#6f7a85\" d=\"M.16 .62C.2 .5 .17 .42 .06 .4-.05 "
    ".4-.12 .37-.13 .29-.13 .25-.1 .23-.13 .2-.16 .18-.18 .16-.15 .13-.17 .1-"
    ".16 .08-.2 .05-.26 .02-.27 0-.24-.05-.18-.13-.15-.2-.16-.28-.12-.42 "
    ".02-.5 "
    ".16-.48 .33-.45 .42-.3 .4-.14 .4 0 .34 .1 .3 .2 .3 .32 .36 .44 .46 .55 "
    ".36 "
    ".6 .26 .62 .16 .62z\"/>\n"
    "<path id=\"tails\" fill=\"#6f7a85\" d=\"M0-.2C.05-.27 .1-.3 .07-.36 "
    ".02-.4-"
    ".06-.38-.08-.33L-.12-.3-.07-.28C-.08-.24-.12-.2-.14-.14-.3-.3-.48-.36-.62-"
    ".3-.56-.24-.54-.2-.53-.14-.48-.14-.46-.1-.45-.05-.4-.05-.38 0-.36 .05-.3 "
    ".05-.26 .1-.16 .12-.14 .2-.1 .26-.06 .3L-.12 .48 0 .42 .12 .48 .06 .3C.1 "
    ".26 .14 .2 .16 .12 .26 .1 .3 .05 .36 .05 .38 0 .4-.05 .45-.05 .46-.1 .48-"
    ".14 .53-.14 .54-.2 .56-.24 .62-.3 .48-.36 .3-.3 .14-.14 .1-.18 .05-.2 "
    "0-.2z\"/>\n";

#endif
