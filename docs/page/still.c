/* SPDX-License-Identifier: MIT */
/* still.c: the coin of the page, for browsers without scripts: the path of the
 * contact from above, and eight coins on it, as SVG. */
#include "../examples/scenes.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>

enum { POINTS = 120, COINS = 8 };

static void draw_coin(const coin_state *s, double radius)
{
    double R[9] = {0};

    coin_axes(s, R);
    printf("<ellipse rx=\"1\" ry=\"%.3f\" transform=\"translate(%.3f %.3f) "
           "rotate(%.1f)\"/>\n",
           fmax(hypot(R[3], R[5]), 0.03), s->x / radius, s->z / radius,
           atan2(R[2], R[0]) * 180 / acos(-1));
}

int main(void)
{
    const scene *k = &SCENES[SCENE_COUNT - 1]; /* the rosette */
    const body *b = k->body;
    coin_params p;
    coin_state s[POINTS + 1];
    double low[2] = {0, 0}, high[2] = {0, 0};

    coin_params_ring(&p, b->mass, b->radius, b->inner_radius, b->gravity);
    coin_sample(&k->start, &p, COIN_RK8, k->duration / POINTS / 16, 16,
                POINTS + 1, s, NULL);
    for (int i = 0; i <= POINTS; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            const double at = (axis ? s[i].z : s[i].x) / b->radius;
            low[axis] = fmin(low[axis], at - 1.2);
            high[axis] = fmax(high[axis], at + 1.2);
        }
    printf("<svg viewBox=\"%.2f %.2f %.2f %.2f\" width=\"320\" role=\"img\" "
           "aria-label=\"%s\" fill=\"#e3c067\" fill-opacity=\"0.6\" "
           "stroke=\"#8a6d2a\" stroke-width=\"0.1\">\n"
           "<path fill=\"none\" stroke=\"#0072b2\" d=\"M",
           low[0], low[1], high[0] - low[0], high[1] - low[1], k->story);
    for (int i = 0; i <= POINTS; ++i) {
        double r[3] = {0}, v[3];
        coin_contact(&s[i], &p, r, v);
        printf("%.2f %.2f ", r[0] / b->radius, r[2] / b->radius);
    }
    puts("\"/>");
    for (int i = 0; i < POINTS; i += POINTS / COINS)
        draw_coin(&s[i], b->radius);
    puts("</svg>");
    return 0;
}
