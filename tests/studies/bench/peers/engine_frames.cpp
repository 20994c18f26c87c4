// SPDX-License-Identifier: MIT
/* A frame of a game, 1/60 s, by coin_move() and by physics engines that divide
 * it into 1 to 64 steps: what it costs, and how wrong it gets.  A US quarter
 * rolls for a second, and Euler's disk spins for ten; neither has losses, and
 * neither slips.
 *
 *     engine_frames          CSV */
#include "../clock.h"
#include "engines.h"

#include <algorithm>
#include <numeric>
#include <vector>

enum { ROUNDS = 10, SECOND = 60 };

static void must(int32_t status, const char *what)
{
    if (status < 0) {
        std::fprintf(stderr, "%s: %s\n", what, coin_status_string(status));
        std::exit(1);
    }
}

struct mover : engine {
    coin_params p;
    double tol;
    coin_table table = {};
    coin_body b = {};

    mover(const coin_params &of, double to) : p(of), tol(to)
    {
        table.mu_static = INFINITY;
        table.mu_kinetic = 1;
    }
    void begin(const coin_body &from) override { b = from; }
    void step(double dt) override
    {
        must(coin_move(&b, &p, &table, dt, tol, 0, nullptr), "coin_move");
    }
    coin_seen look() override
    {
        coin_seen s = {{}, {b.s.x, b.y, b.s.z}, {b.vx, b.vy, b.vz}, {}};
        double q[4];
        coin_quaternion(&b.s, q);
        coin_angular_velocity(&b.s, s.w);
        s.axis[0] = 2 * (q[1] * q[3] + q[0] * q[2]);
        s.axis[1] = 2 * (q[2] * q[3] - q[0] * q[1]);
        s.axis[2] = 1 - 2 * (q[1] * q[1] + q[2] * q[2]);
        return s;
    }
};

/* Natural units; 1/60 s is `frame` of them. */
struct motion {
    const char *name;
    coin_params p;
    coin_body start;
    double frame;
    int frames;
};

static motion of_coin(const char *name, double radius, double thickness,
                      coin_state s, int frames)
{
    const double g = 9.80665, unit = std::sqrt(radius / g);
    motion m = {name, {}, {}, 1.0 / 60 / unit, frames};
    must(coin_params_cylinder(&m.p, 1, 1, thickness / radius, 1), name);
    s.wX *= unit;
    s.wY *= unit;
    s.wZ *= unit;
    must(coin_body_from_state(&m.start, &s, &m.p), name);
    return m;
}

/* It leans as that of tests/reference/quarter.csv. */
static motion quarter()
{
    const coin_state s = {0.3, 0, 0, 0, 0, 0, 5, 40};
    return of_coin("quarter", 0.01213, 0.00175, s, SECOND);
}

/* 0.2 rad from flat; if it were thin, its centre would rest. */
static motion disk()
{
    coin_params thin;
    coin_state s;
    must(coin_params_disc(&thin, 0.438, 0.0375, 9.80665), "disk");
    must(coin_steady_spin(&s, &thin, std::acos(-1) / 2 - 0.2), "disk");
    return of_coin("disk", 0.0375, 0.0127, s, 10 * SECOND);
}

/* One way to move a coin. */
struct way {
    const char *name, *options;
    double setting; /* a tolerance, or steps a frame */
    engine *e;
};

static void frame_by(const motion &m, const way &w)
{
    const int steps = w.setting < 1 ? 1 : (int)w.setting;
    for (int k = 0; k < steps; ++k)
        w.e->step(m.frame / steps);
}

/* The least time that each frame of the first second ever took [ns]. */
struct least {
    double ns[SECOND];
    least() { std::fill(ns, ns + SECOND, INFINITY); }
    double mean() const
    {
        return std::accumulate(ns, ns + SECOND, 0.0) / SECOND;
    }
};

static void time_of(const motion &m, const way &w, double tare, least *l)
{
    w.e->begin(m.start);
    for (double &ns : l->ns) {
        const double begin = clock_ns();
        frame_by(m, w);
        ns = std::fmin(ns, clock_ns() - begin - tare);
    }
}

/* The largest error at the end of a frame: of the quarter's centre, in radii;
 * of the disk's energy above that of lying flat, as a part of it. */
static double error_of(const motion &m, const way &w, const engine_scene &c,
                       engine &truth)
{
    double worst = 0;
    truth.begin(m.start);
    w.e->begin(m.start);
    for (int i = 0; i < m.frames; ++i) {
        truth.step(m.frame);
        frame_by(m, w);
        const coin_seen s = w.e->look(), t = truth.look();
        const double error =
            m.frames > SECOND
                ? std::fabs((engine_energy(c, s) - engine_energy(c, t)) /
                            (engine_energy(c, t) - c.half))
                : std::hypot(std::hypot(s.r[0] - t.r[0], s.r[2] - t.r[2]),
                             s.r[1] - t.r[1]);
        if (!std::isfinite(error))
            return INFINITY;
        worst = std::fmax(worst, error);
    }
    return worst;
}

/* All take turns, so that each sees the machine's quiet moments. */
static void measure(const motion &m, const engine_scene &c,
                    const std::vector<way> &ways)
{
    mover truth(m.p, 1e-12);
    std::vector<least> times(ways.size());
    const double tare = clock_cost();
    for (int round = 0; round < ROUNDS; ++round)
        for (size_t k = 0; k < ways.size(); ++k)
            time_of(m, ways[k], tare, &times[k]);
    for (size_t k = 0; k < ways.size(); ++k)
        std::printf("%s,%s,%s,%g,%.4g,%.2g\n", m.name, ways[k].name,
                    ways[k].options, ways[k].setting, times[k].mean(),
                    error_of(m, ways[k], c, truth));
}

static void compare(const motion &m)
{
    const engine_scene c = {m.p.thickness / 2, m.p.inertia_X, m.p.inertia_Z,
                            100, 0, 0};
    const int implicit = BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY,
              plain = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
    mover coarse(m.p, 1e-3), middle(m.p, 1e-6), fine(m.p, 1e-9);
    ode_engine ode(c, true, true), ode_without(c, false, true);
    bullet_engine bullet(c, plain, true), bullet_one(c, plain, false),
        bullet_implicit(c, implicit, true), bullet_both(c, implicit, false);
    mujoco_engine mujoco(c, "RK4"), mujoco_implicit(c, "implicit");
    std::vector<way> ways = {{"coin_move", "", 1e-3, &coarse},
                             {"coin_move", "", 1e-6, &middle},
                             {"coin_move", "", 1e-9, &fine}};
    for (way w : {way{"ODE", "gyroscopic", 1, &ode},
                  way{"ODE", "not gyroscopic", 1, &ode_without},
                  way{"Bullet", "explicit; two directions", 1, &bullet},
                  way{"Bullet", "explicit; one direction", 1, &bullet_one},
                  way{"Bullet", "implicit; two directions", 1,
                      &bullet_implicit},
                  way{"Bullet", "implicit; one direction", 1, &bullet_both},
                  way{"MuJoCo", "RK4", 1, &mujoco},
                  way{"MuJoCo", "implicit", 1, &mujoco_implicit}})
        for (; w.setting <= 64; w.setting *= 2)
            ways.push_back(w);
    measure(m, c, ways);
}

int main()
{
    dInitODE();
    std::printf("scene,by,options,setting,ns,error\n");
    compare(quarter());
    compare(disk());
    return 0;
}
