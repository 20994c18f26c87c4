/* SPDX-License-Identifier: MIT */
/* A coin is thrown in a game, without a window: docs/games.md goes through it.
 *
 *   cc game.c $(pkg-config --cflags --libs rollcoin)
 */
#include "engine.h"

#include <stdio.h>

/* The frames of a game that does not keep its rate. */
static double frame_time(int frame)
{
    static const double times[] = {1.0 / 60, 1.0 / 60, 1.0 / 30, 1.0 / 144};
    return times[frame % 4];
}

static const char *const FACES[] = {"", "heads", "tails", "on edge"};

/* A game plays a sound here, the louder the faster the impact. */
static void play(double t, double speed)
{
    printf("%.3f s: hits at %.3f m/s\n", t, speed);
}

/* Moves a coin through a frame, and plays the impacts that can be heard: louder
 * than `least`, and `apart` or more after the sound before, at *heard. */
static int32_t move_with_sounds(coin_body *b, const coin_params *p,
                                const coin_table *table, double frame,
                                double *t, double *heard)
{
    const double least = 0.05, apart = 5e-3; /* m/s, s */
    double moved = 0, v[3] = {0, 0, 0};
    int32_t status = COIN_OK;
    for (double left = frame; left > 0 && status >= 0 && !(status & COIN_RESTS);
         left -= moved) {
        status = coin_move(b, p, table, left, 1e-6, COIN_TOUCHES, &moved);
        *t += moved;
        coin_body_contact(b, p, v);
        if (status >= 0 && status & COIN_TOUCHES && -v[1] > least &&
            *t - *heard > apart) {
            play(*t, -v[1]);
            *heard = *t;
        }
    }
    return status;
}

int main(void)
{
    /* A metre per second upward and a little along the table, from 0.4 m above
     * it; ten turns per second. */
    const struct rigid_body hand = {
        {0, 0, 0.4}, {0.5935, 0.8048, 0, 0}, {-0.2, 0, 1}, {60, 20, 4}};
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.5};
    coin_params p;
    coin_body b;
    float m[16];
    double t = 0, heard = -1;
    int flies = 0, slips = 0, rolls = 0;
    coin_params_cylinder(&p, 0.00567, 0.01213, 1.75e-3, 9.80665);
    table.losses.dry = 2e-3 * p.mass * p.gravity * p.radius;
    int32_t status = from_engine(&b, &p, hand);
    for (int frame = 0; status >= 0 && !(status & COIN_RESTS); ++frame) {
        status =
            move_with_sounds(&b, &p, &table, frame_time(frame), &t, &heard);
        flies += (status & COIN_LIFTS) != 0;
        slips += (status & COIN_SLIPS) != 0;
        rolls += status == COIN_OK;
        draw(&b, &p, m);
    }
    printf("%d frames in the air, %d slip, %d roll\n", flies, slips, rolls);
    printf("%s after %.3f s\n", FACES[coin_body_face(&b, &p)], t);
    if (status < 0)
        fprintf(stderr, "%s\n", coin_status_string(status));
    return status < 0;
}
