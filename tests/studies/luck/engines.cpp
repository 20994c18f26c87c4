/* SPDX-License-Identifier: MIT */
/* The same tosses of a quarter by coin_move() and by physics engines, in frames
 * of 1/60 s of 1, 4 and 16 steps: how many show heads, and what a toss costs.
 *
 * The tosses are those of docs/examples/python/toss.py, with tails up.  Lengths
 * are in radii and times in sqrt(a/g), since engines ask for bodies of about a
 * metre.  An engine's coin is a cylinder as thick as a quarter.  It is moved
 * until it has not had the energy to turn over for half a second, or for 20 s:
 * then it still rolls on its edge; coin_move() goes on to rest.
 *
 * From make luck-engines. */
extern "C" {
#include "luck.h"
}

#include "peers/engines.h"

#include <ctime>
#include <vector>

static const double A = 0.01213, G = 9.80665, UNIT = std::sqrt(A / G);
static const double HALF = 0.00175 / 2 / A; /* of the thickness */
static const double MU = 0.4, E = 0.5, DRY = 5e-3;
static const double FRAME = 1.0 / 60 / UNIT;
static const engine_scene SCENE = {HALF, 0.25, 0.5, MU, E, DRY};
static const int FRAMES = 20 * 60;

static coin_body thrown(int i, int n)
{
    coin_body b = {};
    b.y = 0.5 / A;
    b.vy = 2 * UNIT / A;
    b.s.theta = 1; /* tails up */
    b.s.wX = (200 + 100.0 * i / n) * UNIT;
    b.s.wZ = 5 * UNIT;
    return b;
}

/* ------------------------------------------------------------------ tosses */
/* 1 heads, -1 tails, 0 neither: it may still turn over. */
static int side_by(engine &e, const coin_body &b, int steps)
{
    int low = 0;
    e.begin(b);
    for (int frame = 0; frame < FRAMES && low < 30; ++frame) {
        for (int k = 0; k < steps; ++k)
            e.step(FRAME / steps);
        low = engine_energy(SCENE, e.look()) < 1 ? low + 1 : 0;
    }
    return low < 30 ? 0 : e.look().axis[1] > 0 ? 1 : -1;
}

static double seconds()
{
    return (double)std::clock() / CLOCKS_PER_SEC;
}

/* So many tosses with 1, with 4 and with 16 steps a frame. */
static void by_engine(struct luck *l, const char *name, engine &e,
                      const int (&full)[3])
{
    for (int k = 0; k < 3; ++k) {
        const int steps = 1 << 2 * k, n = luck_count(l, full[k], 20);
        const double begin = seconds();
        int heads = 0, neither = 0;
        for (int i = 0; i < n; ++i) {
            const int side = side_by(e, thrown(i, n), steps);
            heads += side > 0;
            neither += side == 0;
        }
        const double taken = seconds() - begin;
        luck_share(l, name, steps, 0, heads, n, NAN);
        luck_share(l, "  neither", steps, 0, neither, n, NAN);
        luck_number("  ms a toss", steps, 0, 1e3 * taken / n, 0, n);
        std::fflush(stdout);
    }
}

struct tosses {
    std::vector<int> heads;
    double tol;
};

static void by_move(void *of, int i)
{
    tosses *t = static_cast<tosses *>(of);
    const coin_params p = luck_disc();
    coin_table table = luck_table(E);
    table.mu_static = MU;
    table.losses.dry = DRY;
    t->heads[i] =
        luck_toss(thrown(i, (int)t->heads.size()), &p, &table, t->tol).heads;
}

void luck_study(struct luck *l)
{
    const int n = luck_count(l, 100000, 200);
    for (double tol = 1e-3; tol > 1e-7; tol /= 1e3) {
        tosses t = {std::vector<int>((size_t)n), tol};
        const double begin = seconds();
        luck_each(n, by_move, &t);
        int heads = 0;
        for (int one : t.heads)
            heads += one;
        luck_share(l, "coin_move", tol, 0, heads, n, NAN);
        luck_number("  ms a toss", tol, 0, 1e3 * (seconds() - begin) / n, 0, n);
        std::fflush(stdout);
    }
    dInitODE();
    ode_engine ode(SCENE, true, false), ode_without(SCENE, false, false);
    by_engine(l, "ODE", ode, {4000, 4000, 4000});
    by_engine(l, "ODE without gyroscopic torque", ode_without,
              {100000, 100000, 40000});
    bullet_engine bullet(SCENE, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY,
                         false);
    by_engine(l, "Bullet", bullet, {100000, 100000, 10000});
    mujoco_engine mujoco(SCENE, "RK4");
    by_engine(l, "MuJoCo", mujoco, {4000, 4000, 2000});
}
