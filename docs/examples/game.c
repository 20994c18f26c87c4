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

int main(void)
{
    /* A metre per second upward and a little along the table, from 0.3 m above
     * it; ten turns per second. */
    const struct rigid_body hand = {
        {0, 0, 0.3}, {0.5935, 0.8048, 0, 0}, {-0.2, 0, 1}, {60, 20, 4}};
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.5};
    coin_params p;
    coin_body b;
    float m[16];
    double t = 0;
    int flies = 0, slips = 0, rolls = 0;
    coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
    table.losses.dry = 2e-3 * p.mass * p.gravity * p.radius;
    int32_t status = from_engine(&b, &p, hand);
    for (int frame = 0; status >= 0 && status != COIN_RESTS; ++frame) {
        double moved;
        status = coin_move(&b, &p, &table, frame_time(frame), 1e-6, 0, &moved);
        t += moved;
        flies += status == COIN_LIFTS;
        slips += status == COIN_SLIPS;
        rolls += status == COIN_OK;
        draw(&b, &p, m);
    }
    printf("%d frames in the air, %d slip, %d roll\n", flies, slips, rolls);
    printf("%s after %.3f s\n", b.s.theta < 0 ? "heads" : "tails", t);
    if (status < 0)
        fprintf(stderr, "%s\n", coin_status_string(status));
    return status < 0;
}
