/* SPDX-License-Identifier: MIT */
/* pictures.h: draws a coin's motion: its path from above, its lean in time. */
#ifndef EXAMPLE_PICTURES_H
#define EXAMPLE_PICTURES_H

#include "scenes.h"
#include "svg.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEGREES (180 / 3.14159265358979323846)

/* Enough that the fastest scene, nearflat, draws smooth curves. */
enum { MOMENTS = 10000 };

/* One state of many on the way; bits are the warnings of coin_check(), or what
 * a slide does.  Only a slide has a height and a velocity of its own. */
typedef struct moment {
    double t;
    coin_state state;
    int32_t bits;
    double y, vx, vy, vz;
} moment;

/* What the drawings are made from; MOMENTS + 1 states at most. */
typedef struct motion {
    const scene *scene;
    coin_params params;
    double pull; /* along x, of a slope */
    int slides;  /* it slips and flies where friction does not hold it */
    int32_t end; /* of a slide */
    size_t count;
    moment at[MOMENTS + 1];
} motion;

/* --------------------------------------------------------- on the table -- */

enum { CENTER, CONTACT };

static int flies(const motion *m, size_t k)
{
    return m->slides && (m->at[k].bits & COIN_LIFTS);
}

/* A point of the coin on the table, x and z.  The contact is at the lower rim,
 * Eq. (118). */
static void table_point(const motion *m, size_t k, int which, double xz[2])
{
    const coin_state *s = &m->at[k].state;
    const double half = copysign(m->params.thickness / 2, s->theta);
    const double lever =
        m->params.radius * sin(s->theta) - half * cos(s->theta);

    xz[0] = s->x - (which == CONTACT ? lever * sin(s->phi) : 0);
    xz[1] = s->z - (which == CONTACT ? lever * cos(s->phi) : 0);
}

/* Fits the panel to the coins: the contact is never outside of them.  From
 * above, with x to the right, z points down. */
static void fit_path(svg_panel *v, const motion *m)
{
    const double a = m->params.radius;
    const coin_state *s = &m->at[0].state;

    v->left = v->right = s->x;
    v->top = v->bottom = s->z;
    for (size_t k = 0; k < m->count; ++k) {
        s = &m->at[k].state;
        v->left = fmin(v->left, s->x - a);
        v->right = fmax(v->right, s->x + a);
        v->top = fmin(v->top, s->z - a);
        v->bottom = fmax(v->bottom, s->z + a);
    }
    svg_equal_aspect(v);
}

static void draw_track(FILE *f, const svg_panel *v, const motion *m, int which,
                       const char *color, double width)
{
    svg_curve c;
    double p[2];

    svg_curve_begin(&c, f, color, width);
    for (size_t k = 0; k < m->count; ++k) {
        if (which == CONTACT && flies(m, k)) {
            svg_curve_end(&c);
            svg_curve_begin(&c, f, color, width);
            while (k + 1 < m->count && flies(m, k + 1))
                ++k;
            continue;
        }
        table_point(m, k, which, p);
        svg_curve_point(&c, svg_x(v, p[0]), svg_y(v, p[1]));
    }
    svg_curve_end(&c);
}

/* A coin from above is an ellipse: the full radius along e_X, |sin theta| of
 * it across, or the thickness of a line.  A radius painted on the coin shows
 * how far it has rolled. */
static void draw_coin(FILE *f, const svg_panel *v, const coin_params *p,
                      const coin_state *s)
{
    const double a = svg_x(v, p->radius) - svg_x(v, 0);
    const double x = svg_x(v, s->x), y = svg_y(v, s->z);
    const double cps = cos(s->psi), sps = sin(s->psi);
    double R[9] = {0};

    coin_axes(s, R);
    fprintf(f,
            "<ellipse rx=\"%.1f\" ry=\"%.1f\" transform=\"translate(%.1f,"
            "%.1f) rotate(%.1f)\" fill=\"" SVG_ORANGE "\" "
            "fill-opacity=\"0.35\" stroke=\"" SVG_BLACK "\"/>\n",
            a, fmax(a * hypot(R[3], R[5]), 0.8), x, y,
            atan2(R[2], R[0]) * DEGREES);
    svg_line(f, x, y, x + a * (cps * R[0] + sps * R[3]),
             y + a * (cps * R[2] + sps * R[5]), SVG_BLACK, 1);
}

/* As many coins along the path as do not hide each other, 16 at most. */
static void draw_coins(FILE *f, const svg_panel *v, const motion *m)
{
    enum { COINS = 16 };
    const coin_state *drawn[COINS];
    size_t count = 0;

    for (size_t i = 0; i < COINS; ++i) {
        const coin_state *s = &m->at[i * (m->count - 1) / COINS].state;
        double gap = (double)INFINITY;
        for (size_t j = 0; j < count; ++j)
            gap = fmin(gap, hypot(s->x - drawn[j]->x, s->z - drawn[j]->z));
        if (gap < 2 * m->params.radius)
            continue;
        drawn[count++] = s;
        draw_coin(f, v, &m->params, s);
    }
}

static void draw_scale(FILE *f, const svg_panel *v, const units *in)
{
    const double shown = (v->right - v->left) * in->shown;
    const double bar = svg_round_down(shown / 4);
    const double x = v->x + v->width - v->width * bar / shown;
    const double y = v->y + v->height + 12;
    char text[32];

    svg_line(f, x, y, v->x + v->width, y, SVG_BLACK, 3);
    snprintf(text, sizeof text, "%g %s", bar, in->length);
    svg_text(f, x - 8, y + 4.5, "end", 13, text);
}

static void draw_key(FILE *f, double x, double y)
{
    svg_line(f, x, y, x + 20, y, SVG_BLUE, 2.4);
    svg_text(f, x + 26, y + 4.5, "start", 13, "contact point");
    svg_line(f, x + 122, y, x + 142, y, SVG_VERMILLION, 1.4);
    svg_text(f, x + 148, y + 4.5, "start", 13, "centre");
    svg_dot(f, x + 212, y, "white");
    svg_text(f, x + 221, y + 4.5, "start", 13, "start");
    svg_dot(f, x + 270, y, SVG_BLUE);
    svg_text(f, x + 279, y + 4.5, "start", 13, "end");
}

/* The path in a square whose side is size, below a title and a key. */
static void draw_path(FILE *f, double x, double y, double size, const motion *m)
{
    svg_panel v = {x, y + 52, size, size, 0, 0, 0, 0};
    double p[2];

    svg_text(f, x, y + 14, "start", 15, "Path on the table, from above");
    draw_key(f, x, y + 34);
    fit_path(&v, m);
    draw_coins(f, &v, m);
    draw_track(f, &v, m, CENTER, SVG_VERMILLION, 1.4);
    draw_track(f, &v, m, CONTACT, SVG_BLUE, 2.4);
    table_point(m, 0, CONTACT, p);
    svg_dot(f, svg_x(&v, p[0]), svg_y(&v, p[1]), "white");
    table_point(m, m->count - 1, CONTACT, p);
    svg_dot(f, svg_x(&v, p[0]), svg_y(&v, p[1]), SVG_BLUE);
    draw_scale(f, &v, m->scene->body->in);
}

/* -------------------------------------------------------------- in time -- */

static void fit_lean(svg_panel *v, const motion *m)
{
    double low = m->at[0].state.theta, high = low;

    for (size_t k = 0; k < m->count; ++k) {
        low = fmin(low, m->at[k].state.theta);
        high = fmax(high, m->at[k].state.theta);
    }
    /* A steady lean varies by rounding alone: show at least a degree. */
    const double half = fmax((high - low) * DEGREES * 0.54, 0.5);
    const double middle = (high + low) / 2 * DEGREES;
    v->top = middle + half;
    v->bottom = middle - half;
    v->left = 0;
    v->right = m->at[m->count - 1].t;
}

/* The lean where a warning of the mask stands (0: everywhere), one curve for
 * each such stretch. */
static void draw_lean_where(FILE *f, const svg_panel *v, const motion *m,
                            int32_t mask, const char *color, double width)
{
    svg_curve c;
    int drawing = 0;

    for (size_t k = 0; k < m->count; ++k) {
        const moment *now = &m->at[k];
        const int wanted = mask == 0 || (now->bits & mask) != 0;
        if (wanted && !drawing)
            svg_curve_begin(&c, f, color, width);
        if (wanted)
            svg_curve_point(&c, svg_x(v, now->t),
                            svg_y(v, now->state.theta * DEGREES));
        if (!wanted && drawing)
            svg_curve_end(&c);
        drawing = wanted;
    }
    if (drawing)
        svg_curve_end(&c);
}

static int any_warning(const motion *m, int32_t mask)
{
    for (size_t k = 0; k < m->count; ++k)
        if ((m->at[k].bits & mask) != 0)
            return 1;
    return 0;
}

static void draw_lean(FILE *f, double x, double y, double width, double height,
                      const motion *m)
{
    const int32_t unreal = COIN_SLIPS | COIN_LIFTS;
    svg_panel v = {x + 40, y + 52, width - 40, height, 0, 0, 0, 0};
    char text[64];

    svg_text(f, v.x, y + 14, "start", 15, "Lean in degrees, 0 = upright");
    fit_lean(&v, m);
    svg_ticks(f, &v);
    if (any_warning(m, unreal)) {
        draw_lean_where(f, &v, m, unreal, SVG_PURPLE, 8);
        svg_line(f, v.x, y + 34, v.x + 20, y + 34, SVG_PURPLE, 8);
        svg_text(f, v.x + 26, y + 38.5, "start", 13,
                 !m->slides ? "a real coin would slip or lift off"
                 : any_warning(m, COIN_LIFTS) ? "it slips or flies"
                                              : "it slips");
    }
    draw_lean_where(f, &v, m, 0, SVG_BLUE, 2.4);
    snprintf(text, sizeof text, "time (%s)", m->scene->body->in->time);
    svg_text(f, v.x + v.width, v.y + v.height + 38, "end", 13, text);
}

/* ------------------------------------------------------------ the files -- */

static void draw_both(FILE *f, const motion *m)
{
    svg_text(f, 16, 30, "start", 19, m->scene->story);
    draw_path(f, 16, 46, 340, m);
    draw_lean(f, 400, 46, 384, 320, m);
}

static void draw_path_alone(FILE *f, const motion *m)
{
    draw_path(f, 16, 12, 560, m);
}

static void draw_lean_alone(FILE *f, const motion *m)
{
    draw_lean(f, 16, 12, 760, 300, m);
}

static const struct {
    const char *suffix;
    int width, height;
    void (*draw)(FILE *f, const motion *m);
} PICTURES[] = {
    {"", 800, 470, draw_both},
    {"_path", 592, 660, draw_path_alone},
    {"_lean", 800, 420, draw_lean_alone},
};

enum { PICTURE_COUNT = sizeof PICTURES / sizeof PICTURES[0] };

/* Draws picture k into a file.  Returns 0; -1, and errno, if it could not be
 * written. */
static int draw_picture(const motion *m, size_t k, const char *path)
{
    FILE *f =
        svg_open(path, PICTURES[k].width, PICTURES[k].height, m->scene->story);

    if (f == NULL)
        return -1;
    PICTURES[k].draw(f, m);
    return svg_close(f);
}

#endif
