/* SPDX-License-Identifier: MIT */
/* A quarter is tossed in a game, without a window, which tells what it would
 * play: docs/games.md goes through it.
 *
 *   cc game.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

static const char *const FACES[] = {"", "heads", "tails", "on edge"};

/* A game plays sounds here: `speed` says how loud an impact is.  `before` is
 * what the call before returned. */
static void tell(double t, int32_t status, int32_t before, double speed)
{
    if (status & COIN_TOUCHES && speed > 0.05)
        printf("%.3f s: hits at %.2f m/s\n", t, speed);
    if (status & ~before & COIN_SLIPS)
        printf("%.3f s: slips\n", t);
    if (status & COIN_ROLLS)
        printf("%.3f s: rolls\n", t);
    if (status & COIN_DECIDED)
        printf("%.3f s: decided\n", t);
}

int main(void)
{
    const int32_t stop = COIN_TOUCHES | COIN_SLIPS | COIN_ROLLS | COIN_DECIDED;
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.5};
    /* Nearly flat, heads up.  It flips by wX, 60/(2 pi) times a second, and
     * spins about its own axis by wZ.  Units are m, m/s and rad/s. */
    coin_body b = {
        .s = {.theta = -1.5, .wX = 60, .wZ = 20}, .y = 0.2, .vx = 0.2, .vy = 1};
    coin_params p;
    double t = 0, moved, v[3], m[16];
    int32_t status = COIN_LIFTS; /* it has left the hand */
    coin_params_cylinder(&p, 0.00567, 0.01213, 1.75e-3, 9.80665);
    table.losses.dry = 5e-3 * p.mass * p.gravity * p.radius;
    while (!(status & COIN_RESTS)) { /* a frame */
        for (double left = 1. / 60; left > 0 && !(status & COIN_RESTS);
             left -= moved) {
            const int32_t before = status;
            status = coin_move(&b, &p, &table, left, 1e-6, stop, &moved);
            if (status < 0)
                return 1; /* coin_status_string(status) says why */
            t += moved;
            coin_body_contact(&b, &p, v);
            tell(t, status, before, -v[1]);
        }
        coin_body_matrix(&b, &p, m); /* and draw */
    }
    printf("%s after %.3f s\n", FACES[coin_body_face(&b, &p)], t);
}
