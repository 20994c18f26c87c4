/* SPDX-License-Identifier: MIT */
/* Draws how long a US quarter rolls until it lies flat, against the lean of its
 * launch, and a part of that range forty times as large.
 *
 *   cc lean_map.c $(pkg-config --cflags --libs rollcoin) -lm
 *   ./a.out >lean_map.svg
 *
 * It rolls at 12 rad/s and turns at 1 rad/s, against a dry loss. */
#include "svg.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LAUNCHES = 400, WIDTH = 784, HEIGHT = 344 };

static void draw(const coin_params *p, const coin_losses *l, const char *title,
                 const svg_panel *v)
{
    svg_text(stdout, v->x, v->y - 12, "start", 14, title);
    svg_ticks(stdout, v);
    printf("<path stroke=\"" SVG_BLUE "\" stroke-width=\"3\" "
           "stroke-linecap=\"round\" d=\"");
    for (int i = 0; i < LAUNCHES; ++i) {
        const double lean =
            v->left + (i + 0.5) / LAUNCHES * (v->right - v->left);
        const coin_state s = {.theta = lean, .wY = 1, .wZ = 12};
        const double t = coin_time_to_rest(&s, p, l, 1e-6);
        if (isnan(t))
            exit(EXIT_FAILURE);
        printf("M%.1f %.1fh0", svg_x(v, lean), svg_y(v, t));
    }
    puts("\"/>");
    svg_text(stdout, v->x + v->width, v->y + v->height + 36, "end", 13,
             "lean of the launch, rad");
}

int main(void)
{
    const svg_panel all = {40, 44, 336, 244, 0, 1.2, 12, 0};
    const svg_panel part = {432, 44, 330, 244, 0.3, 0.33, 12, 0};
    coin_params quarter;
    coin_losses losses = {.dry = 0};

    coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    losses.dry = 1e-3 * quarter.mass * quarter.gravity * quarter.radius;
    svg_begin(stdout, WIDTH, HEIGHT, "How long a quarter rolls, by its lean");
    draw(&quarter, &losses, "time until it rests, s", &all);
    draw(&quarter, &losses, "the same between 0.3 and 0.33 rad", &part);
    puts("</svg>");
    return ferror(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}
