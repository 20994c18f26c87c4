/* SPDX-License-Identifier: MIT */
/* svg.h: as much of SVG as a line chart needs, for the examples.
 *
 * A picture is a FILE; a panel is a rectangle of it that shows a range of
 * data.  Nothing here checks a write: svg_close() tells whether all went well.
 * Texts and file names are plain C strings in UTF-8; numbers must be finite. */
#ifndef EXAMPLE_SVG_H
#define EXAMPLE_SVG_H

#include <math.h>
#include <stdio.h>

/* Colours that stay apart for colour-blind eyes (Okabe and Ito, 2008). */
#define SVG_BLUE "#0072B2"
#define SVG_VERMILLION "#D55E00"
#define SVG_ORANGE "#E69F00"
#define SVG_PURPLE "#CC79A7"
#define SVG_BLACK "#222222"
#define SVG_GREY "#D8D8D8"

/* Points of a curve closer than this, in pixels, are left out: a chord that
 * short leaves an arc of 20 pixels' radius by 0.05, which no one sees. */
#define SVG_CHORD 2.8

/* ------------------------------------------------------------- document -- */

/* Writes text with the three characters that XML keeps for itself replaced. */
static inline void svg_escaped(FILE *f, const char *text)
{
    for (; *text != '\0'; ++text) {
        if (*text == '&')
            fputs("&amp;", f);
        else if (*text == '<')
            fputs("&lt;", f);
        else if (*text == '>')
            fputs("&gt;", f);
        else
            fputc(*text, f);
    }
}

/* What colours become where a reader prefers a dark scheme; others stay. */
static inline void svg_dark_scheme(FILE *f)
{
    static const char *const DARK[][2] = {{"white", "#0d1117"},
                                          {SVG_BLACK, "#c9d1d9"},
                                          {SVG_GREY, "#30363d"},
                                          {SVG_BLUE, "#3fa7e0"}};

    fputs("<style>\n@media (prefers-color-scheme:dark){\n", f);
    for (size_t k = 0; k < sizeof DARK / sizeof DARK[0]; ++k)
        fprintf(f, "[fill=\"%s\"]{fill:%s}[stroke=\"%s\"]{stroke:%s}\n",
                DARK[k][0], DARK[k][1], DARK[k][0], DARK[k][1]);
    fputs("}\n</style>\n", f);
}

/* Begins a picture on a white or dark ground. */
static inline void svg_begin(FILE *f, int width, int height, const char *title)
{
    fprintf(f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
            "height=\"%d\" viewBox=\"0 0 %d %d\" role=\"img\" "
            "font-family=\"Helvetica, Arial, sans-serif\">\n<title>",
            width, height, width, height);
    svg_escaped(f, title);
    fputs("</title>\n", f);
    svg_dark_scheme(f);
    fputs("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n", f);
}

/* The same in a file; null, and errno, if it does not open. */
static inline FILE *svg_open(const char *path, int width, int height,
                             const char *title)
{
    FILE *f = fopen(path, "w");

    if (f != NULL)
        svg_begin(f, width, height, title);
    return f;
}

/* Ends a picture.  Returns 0, or -1 if anything of it was not written. */
static inline int svg_close(FILE *f)
{
    fputs("</svg>\n", f);
    const int failed = ferror(f);
    return fclose(f) != 0 || failed ? -1 : 0;
}

/* --------------------------------------------------------------- shapes -- */

/* anchor: "start", "middle" or "end" of the text is at x; y is its baseline. */
static inline void svg_text(FILE *f, double x, double y, const char *anchor,
                            double size, const char *text)
{
    fprintf(f,
            "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%g\" "
            "text-anchor=\"%s\" fill=\"" SVG_BLACK "\">",
            x, y, size, anchor);
    svg_escaped(f, text);
    fputs("</text>\n", f);
}

static inline void svg_line(FILE *f, double x1, double y1, double x2, double y2,
                            const char *color, double width)
{
    fprintf(f,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" "
            "stroke=\"%s\" stroke-width=\"%g\"/>\n",
            x1, y1, x2, y2, color, width);
}

static inline void svg_dot(FILE *f, double x, double y, const char *fill)
{
    fprintf(f,
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"%s\" "
            "stroke=\"" SVG_BLACK "\" stroke-width=\"1.6\"/>\n",
            x, y, fill);
}

/* --------------------------------------------------------------- curves -- */

/* A curve that is being drawn: begin, then any number of points, then end. */
typedef struct svg_curve {
    FILE *f;
    double x, y;       /* the last point given */
    double at_x, at_y; /* the last point written */
    int count;         /* points given */
} svg_curve;

static inline void svg_curve_begin(svg_curve *c, FILE *f, const char *color,
                                   double width)
{
    const svg_curve fresh = {f, 0, 0, 0, 0, 0};

    *c = fresh;
    fprintf(f,
            "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%g\" "
            "stroke-linejoin=\"round\" stroke-linecap=\"round\" points=\"",
            color, width);
}

static inline void svg_curve_write(svg_curve *c)
{
    fprintf(c->f, "%.1f,%.1f\n", c->x, c->y);
    c->at_x = c->x;
    c->at_y = c->y;
}

static inline void svg_curve_point(svg_curve *c, double x, double y)
{
    c->x = x;
    c->y = y;
    if (c->count++ == 0 || hypot(x - c->at_x, y - c->at_y) > SVG_CHORD)
        svg_curve_write(c);
}

static inline void svg_curve_end(svg_curve *c)
{
    if (c->count > 0 && (c->x != c->at_x || c->y != c->at_y))
        svg_curve_write(c);
    fputs("\"/>\n", c->f);
}

/* --------------------------------------------------------------- panels -- */

/* The rectangle, in pixels, and the data at its left, right, top and bottom
 * edge; give the larger value to the top for an axis that points upward. */
typedef struct svg_panel {
    double x, y, width, height;
    double left, right, top, bottom;
} svg_panel;

static inline double svg_x(const svg_panel *v, double x)
{
    return v->x + v->width * (x - v->left) / (v->right - v->left);
}

static inline double svg_y(const svg_panel *v, double y)
{
    return v->y + v->height * (y - v->top) / (v->bottom - v->top);
}

/* Widens the range along one axis, both ways, until a unit of data is as long
 * across as down. */
static inline void svg_equal_aspect(svg_panel *v)
{
    const double across = v->right - v->left, down = v->bottom - v->top;
    const double scale = fmin(v->width / across, v->height / down);
    const double dx = (v->width / scale - across) / 2;
    const double dy = (v->height / scale - down) / 2;

    v->left -= dx;
    v->right += dx;
    v->top -= dy;
    v->bottom += dy;
}

/* The largest of 1, 2 and 5 times a power of ten that is <= x; x > 0. */
static inline double svg_round_down(double x)
{
    const double power = pow(10, floor(log10(x)));

    if (x >= 5 * power)
        return 5 * power;
    return x >= 2 * power ? 2 * power : power;
}

/* Tick lines and their numbers: 4 to 10 along each axis.  (+ 0.0 makes a plain
 * zero of the -0 that ceil() may give.) */
static inline void svg_ticks(FILE *f, const svg_panel *v)
{
    const double dx = svg_round_down((v->right - v->left) / 4);
    const double dy = svg_round_down((v->top - v->bottom) / 4);
    char text[32];

    for (double k = ceil(v->left / dx) + 0.0; k * dx <= v->right; ++k) {
        const double x = svg_x(v, k * dx);
        svg_line(f, x, v->y, x, v->y + v->height, SVG_GREY, 1);
        snprintf(text, sizeof text, "%g", k * dx);
        svg_text(f, x, v->y + v->height + 18, "middle", 13, text);
    }
    for (double k = ceil(v->bottom / dy) + 0.0; k * dy <= v->top; ++k) {
        const double y = svg_y(v, k * dy);
        svg_line(f, v->x, y, v->x + v->width, y, SVG_GREY, 1);
        snprintf(text, sizeof text, "%g", k * dy);
        svg_text(f, v->x - 6, y + 4.5, "end", 13, text);
    }
}

#endif
