/* SPDX-License-Identifier: MIT */
/* A coin in a game, without a window: docs/games.md goes through it.
 *
 *   cc game.c $(pkg-config --cflags --libs rollcoin)
 */
#include <coin.h>
#include <stdio.h>

#define STEP (1.0 / 240) /* s */
#define MU 0.3           /* friction of coin and table */
#define TOL 1e-6

/* A coin of the game, and what an engine's rigid body holds. */
struct game_coin {
    coin_params p;
    coin_state s;
    double owed; /* time that passed and is not simulated yet */
};

struct body {
    double position[3], q[4], v[3], omega[3];
};

/* The frames of a game that does not keep its rate. */
static double frame_time(int frame)
{
    static const double times[] = {1.0 / 60, 1.0 / 60, 1.0 / 30, 1.0 / 144};
    return times[frame % 4];
}

/* Whole steps only, and the rest is owed to the next frame.  A stall of the
 * program is not made up for. */
static int32_t fixed_steps(struct game_coin *c, double frame)
{
    c->owed += frame < 0.1 ? frame : 0.1;
    const uint64_t steps = (uint64_t)(c->owed / STEP);
    uint64_t done = 0;
    const int32_t status = coin_run(&c->s, &c->p, COIN_RK8, STEP, steps, &done);
    c->owed -= (double)done * STEP;
    return status < 0 ? status : coin_check(&c->s, &c->p, COIN_RK8, STEP, MU);
}

/* What to draw: the state in the middle of a step, by a part of one. */
static coin_state shown(const struct game_coin *c)
{
    coin_state now = c->s;
    coin_run(&now, &c->p, COIN_RK8, c->owed, 1, NULL);
    return now;
}

/* Any frame at once, but not beyond what a real coin would do. */
static int32_t variable_frame(struct game_coin *c, double frame, double *used)
{
    return coin_advance_until(&c->s, &c->p, frame, TOL, MU,
                              COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT, used);
}

/* With losses.  Rest comes first: of a coin at rest coin_check() may say that
 * it slips or lifts. */
static int32_t lossy_frame(struct game_coin *c, const coin_losses *l,
                           double frame, double *used)
{
    const int32_t status = coin_settle(&c->s, &c->p, l, frame, TOL, used);
    return status == COIN_OK ? coin_check(&c->s, &c->p, COIN_RK4, 0, MU)
                             : status;
}

/* From here the engine's rigid body goes on. */
static int32_t to_engine(struct body *b, const struct game_coin *c)
{
    coin_center(&c->s, &c->p, b->position);
    coin_velocity(&c->s, &c->p, b->v);
    coin_angular_velocity(&c->s, b->omega);
    return coin_quaternion(&c->s, b->q);
}

/* And back, once it touches the table. */
static int32_t from_engine(struct game_coin *c, const struct body *b)
{
    return coin_state_from_landing(&c->s, &c->p, b->q, b->omega, b->v,
                                   b->position[0], b->position[2]);
}

/* For an engine with z up: (x, y, z) becomes (x, -z, y). */
static void to_z_up(double m[16])
{
    for (int column = 0; column < 4; ++column) {
        const double y = m[4 * column + 1], z = m[4 * column + 2];
        m[4 * column + 1] = -z;
        m[4 * column + 2] = y;
    }
}

/* The matrix as a shader takes it. */
static int32_t draw(const coin_state *s, const coin_params *p, float out[16])
{
    double m[16];
    const int32_t status = coin_matrix(s, p, m);
    if (status != COIN_OK)
        return status;
    to_z_up(m);
    for (int i = 0; i < 16; ++i)
        out[i] = (float)m[i];
    return COIN_OK;
}

/* ---------------------------------------------------------------- the scenes
 */
static int32_t roll_by_fixed_steps(struct game_coin *c)
{
    float m[16] = {0};
    int32_t status = COIN_OK, seen = COIN_OK;
    c->owed = 0;
    for (int frame = 0; frame < 60 && status >= 0; ++frame) {
        status = fixed_steps(c, frame_time(frame));
        seen |= status;
    }
    if (status < 0)
        return status;
    const coin_state now = shown(c);
    status = draw(&now, &c->p, m);
    printf("fixed steps: at (%.4f, %.4f, %.4f) m after 60 frames, bits %d\n",
           (double)m[12], (double)m[13], (double)m[14], (int)seen);
    return status;
}

static int32_t roll_until_it_slips(struct game_coin *c)
{
    struct body b;
    double t = 0, used;
    int32_t status = COIN_OK;
    for (int frame = 0; frame < 600 && status == COIN_OK; ++frame) {
        status = variable_frame(c, frame_time(frame), &used);
        t += status >= 0 ? used : 0;
    }
    if (status < 0)
        return status;
    printf("bits %d after %.4f s: ", (int)status, t);
    status = to_engine(&b, c);
    printf("the engine takes over at %.3f m/s\n", b.v[0]);
    return status;
}

static int32_t come_to_rest(struct game_coin *c, const coin_losses *l)
{
    double t = 0, used = 0;
    int32_t status = COIN_OK;
    for (int frame = 0; status >= 0 && status != COIN_RESTS; ++frame) {
        status = lossy_frame(c, l, frame_time(frame), &used);
        t += used;
    }
    printf("rests after %.3f s\n", t);
    return status;
}

int main(void)
{
    /* Half a metre per second along the table, and down on it; the coin stands
     * in its plane, leaning by 0.3 rad. */
    const struct body thrown = {
        {0, 0.0116, 0}, {0.9888, 0.1494, 0, 0}, {-0.5, -0.3, 0}, {0, 4, 0}};
    coin_losses l = {0};
    struct game_coin c;
    int32_t status = coin_params_disc(&c.p, 0.00567, 0.01213, 9.80665);
    if (status >= 0)
        status = from_engine(&c, &thrown);
    if (status >= 0)
        status = roll_by_fixed_steps(&c);
    if (status >= 0)
        status = from_engine(&c, &thrown);
    if (status >= 0)
        status = roll_until_it_slips(&c);
    l.viscous = 1e-9;
    if (status >= 0)
        status = coin_steady_spin(&c.s, &c.p, 1.0);
    if (status >= 0)
        status = coin_losses_fit(&l, &c.s, &c.p, 4.0);
    if (status >= 0)
        status = come_to_rest(&c, &l);
    if (status < 0)
        fprintf(stderr, "%s\n", coin_status_string(status));
    return status < 0;
}
