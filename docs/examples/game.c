/* SPDX-License-Identifier: MIT */
/* A coin in a game, without a window: docs/games.md goes through it.
 *
 *   cc game.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

#define TOL 1e-6

/* What an engine's rigid body holds, and the frames of a game that does not
 * keep its rate. */
struct rigid_body {
    double position[3], q[4], v[3], omega[3];
};

static double frame_time(int frame)
{
    static const double times[] = {1.0 / 60, 1.0 / 60, 1.0 / 30, 1.0 / 144};
    return times[frame % 4];
}

/* An engine's coin is in the air: from here the library moves it. */
static int32_t from_engine(coin_body *b, const coin_params *p,
                           const struct rigid_body *e)
{
    return coin_body_from_motion(b, p, e->q, e->omega, e->position, e->v);
}

/* Of an engine with z up: its (x, y, z) is (x, z, -y) here. */
static void from_z_up(double v[3])
{
    const double y = v[1];
    v[1] = v[2];
    v[2] = -y;
}

/* The same turn, before that of the body.  Any norm will do. */
static void turn_from_z_up(double q[4])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    q[0] = w + x;
    q[1] = x - w;
    q[2] = y + z;
    q[3] = z - y;
}

static void engine_from_z_up(struct rigid_body *e)
{
    from_z_up(e->position);
    from_z_up(e->v);
    from_z_up(e->omega);
    turn_from_z_up(e->q);
}

/* And back: (x, y, z) becomes (x, -z, y). */
static void to_z_up(double m[16])
{
    for (int column = 0; column < 4; ++column) {
        const double y = m[4 * column + 1], z = m[4 * column + 2];
        m[4 * column + 1] = -z;
        m[4 * column + 2] = y;
    }
}

/* The matrix as a shader takes it. */
static int32_t draw(const coin_body *b, const coin_params *p, float out[16])
{
    double m[16];
    const int32_t status = coin_body_matrix(b, p, m);
    if (status != COIN_OK)
        return status;
    to_z_up(m);
    for (int i = 0; i < 16; ++i)
        out[i] = (float)m[i];
    return COIN_OK;
}

static coin_table table_of(const coin_params *p)
{
    coin_table table = {
        .mu_static = 0.4, .mu_kinetic = 0.3, .restitution = 0.5};
    table.losses.dry = 2e-3 * p->mass * p->gravity * p->radius;
    return table;
}

int main(void)
{
    /* As an engine with z up has it: a metre per second upward and a little
     * along the table, from 0.3 m above it; ten turns per second. */
    const struct rigid_body thrown = {
        {0, 0, 0.3}, {0.5935, 0.8048, 0, 0}, {-0.2, 0, 1}, {60, 20, 4}};
    struct rigid_body e = thrown;
    coin_params p;
    coin_body b;
    float m[16];
    double t = 0;
    int frames = 0, flies = 0;
    coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
    const coin_table table = table_of(&p);
    engine_from_z_up(&e);
    int32_t status = from_engine(&b, &p, &e);
    for (; status >= 0 && status != COIN_RESTS; ++frames) {
        double moved;
        status = coin_move(&b, &p, &table, frame_time(frames), TOL, 0, &moved);
        t += moved;
        flies += status == COIN_LIFTS;
        if (draw(&b, &p, m) < 0)
            break;
    }
    printf("%s after %.3f s; of %d frames %d end in the air\n",
           status != COIN_RESTS ? "stops"
           : b.s.theta < 0      ? "heads"
                                : "tails",
           t, frames, flies);
    if (status < 0)
        fprintf(stderr, "%s\n", coin_status_string(status));
    return status < 0;
}
