/* SPDX-License-Identifier: MIT */
/* What a motion keeps: energy, the two linear integrals, steady motions, and
 * the turning points that the integrals fix. */
#include "support/check.h"
#include "support/random.h"
#include "support/scene.h"

#include <math.h>

static struct scene scene;

/* Relative changes of E, K_Y, K_Z; of K against the larger of the two. */
static void drift_between(const coin_state *a, const coin_state *b,
                          const coin_params *p, double out[3])
{
    const double E = coin_energy(a, p);
    double K[2], L[2];
    check_status(coin_integrals(a, p, K), COIN_OK);
    check_status(coin_integrals(b, p, L), COIN_OK);
    const double size = fmax(fabs(K[0]), fabs(K[1]));
    out[0] = fabs(coin_energy(b, p) - E) / E;
    out[1] = fabs(L[0] - K[0]) / size;
    out[2] = fabs(L[1] - K[1]) / size;
}

static double largest_drift(size_t row, uint64_t steps)
{
    const coin_state start = scene_state(&scene, 0);
    const coin_state end = scene_run(&scene, row, steps);
    double drift[3];
    drift_between(&start, &end, &scene.params, drift);
    return fmax(drift[0], fmax(drift[1], drift[2]));
}

/* To row 6.  The drift is of order 4, or 5 where its leading part, even in
 * time, cancels over periods: 16 to 32 times less for half a step. */
TEST(integrals_drift_no_faster_than_the_order)
{
    const struct {
        const char *name;
        uint64_t steps;
    } cases[] = {
        {"wobble", 400},   {"generic", 800},    {"ring", 800},
        {"ring_b05", 800}, {"negative", 800},   {"quarter", 800},
        {"tumble", 800},   {"si_washer", 2000},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        scene_load(&scene, cases[i].name);
        const double one = largest_drift(6, cases[i].steps);
        const double half = largest_drift(6, cases[i].steps * 2);
        check_note("scene %s: drift %.3g, then %.3g", cases[i].name, one, half);
        check_within(one, 1e-10, 1e-4);
        check_within(one / half, 13, 40);
    }
}

/* Where positions are amplified a million times the integrals are not. */
TEST(integrals_hold_where_the_path_is_lost)
{
    scene_load(&scene, "tumble");
    const size_t row = 8;
    check(scene_at(&scene, row, "amp") > 1e6);
    check_within(largest_drift(row, 40000), 0, 1e-9);
}

TEST(integrals_hold_in_random_scenes)
{
    struct random r = random_begin(44);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state start = random_motion(&r, &p, 1.0 / 40, 80);
        coin_state end = start;
        double drift[3];
        check_status(
            coin_run(&end, &p, COIN_RK4, natural_time(&p) / 400, 800, NULL),
            COIN_OK);
        drift_between(&start, &end, &p, drift);
        /* Within |dt| W <= 0.035: 1e-6 (0.035/0.1)^4 = 2e-8 per unit. */
        for (int k = 0; k < 3; ++k)
            check_within(drift[k], 0, 1e-7);
    }
}

/* ---------------------------------------------------------- steady motions */
TEST(steady_motions_stay)
{
    struct random r = random_begin(45);
    for (int i = 0; i < 60; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const double theta = random_between(&r, 0.4, 1.2);
        coin_state start, end;
        if (i % 2)
            check_status(coin_steady_spin(&start, &p, theta), COIN_OK);
        else
            check_status(coin_steady_circle(&start, &p, theta,
                                            random_between(&r, w / 2, w), 1),
                         COIN_OK);
        end = start;
        check_note("scene %d, theta = %g", i, theta);
        check_status(coin_run(&end, &p, COIN_RK4, 0.02 / w, 1000, NULL),
                     COIN_OK);
        /* wY is off by 8 u, and so is the motion's amplitude: times the ratio
         * of rates, below 10.  Steps add a part of u each. */
        const double bound = (80 + 1000) * U;
        check_near(end.theta, theta, bound);
        check_near(end.wX, 0, bound * w * 10);
        check_near(end.wY, start.wY, bound * w * 10);
        check_near(end.wZ, start.wZ, bound * w * 10);
    }
}

/* The heading is the angle of a pair that the steps turn: Runge-Kutta turns it
 * by z - z^5/120 for z. */
TEST(upright_motions_do_not_lean_at_all)
{
    const double rate = 0.3, dt = 0.05, n = 1000, z = rate * dt;
    const double way = rate * dt * n;
    coin_params p;
    coin_state s;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(coin_steady_roll(&s, &p, rate), COIN_OK);
    check_status(coin_run(&s, &p, COIN_RK4, dt, (uint64_t)n, NULL), COIN_OK);
    check(s.theta == 0 && s.wX == 0 && s.wY == 0 && s.wZ == rate);
    check(s.phi == 0 && s.z == 0);
    check_near(s.x, -way, n * U * way);
    check_near(s.psi, way, n * U * way);
    check_status(coin_steady_upright_spin(&s, &p, rate), COIN_OK);
    check_status(coin_run(&s, &p, COIN_RK4, dt, (uint64_t)n, NULL), COIN_OK);
    check(s.theta == 0 && s.wX == 0 && s.wY == rate && s.wZ == 0);
    check(s.psi == 0 && s.x == 0 && s.z == 0);
    check_near(s.phi, way, 1.01 * n * pow(z, 5) / 120);
}

/* ---------------------------------------------------------- turning points */
/* Steps on until wX changes its sign; the state between, linearly.  The lean
 * is at an extreme there, and so exact to dt^2 of its curvature. */
static coin_state next_turn(coin_state *s, const coin_params *p, double dt)
{
    coin_state before;
    do {
        before = *s;
        check(coin_step(s, p, dt) >= 0);
    } while (before.wX * s->wX > 0 || before.wX == 0);
    const double part = before.wX / (before.wX - s->wX);
    coin_state turn = *s;
    turn.theta = before.theta + part * (s->theta - before.theta);
    turn.phi = before.phi + part * (s->phi - before.phi);
    turn.psi = before.psi + part * (s->psi - before.psi);
    return turn;
}

TEST(the_lean_turns_where_the_reference_does)
{
    const struct {
        const char *name, *turns;
        double dt;
    } cases[] = {
        {"wobble", "wobble.turns.csv", 1e-3},
        {"generic", "generic.turns.csv", 1e-3},
        {"tumble", "tumble.turns.csv", 1e-3},
        {"ring", "ring.turns.csv", 1e-3},
        {"ring_b05", "ring_b05.turns.csv", 1e-3},
        {"negative", "negative.turns.csv", 1e-3},
        {"quarter", "quarter.turns.csv", 2e-5},
        {"si_washer", "si_washer.turns.csv", 2e-5},
    };
    struct table turns;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        scene_load(&scene, cases[i].name);
        table_load(&turns, cases[i].turns);
        coin_state s = scene_state(&scene, 0);
        for (size_t k = 0; k < 4; ++k) {
            const coin_state turn = next_turn(&s, &scene.params, cases[i].dt);
            check_note("turn %zu of %s", k, cases[i].name);
            /* dt^2/8 times wX', which is below 5/T^2. */
            check_near(turn.theta, table_at(&turns, k, "theta"), 1e-6);
            check_near(turn.phi, table_at(&turns, k, "phi"), 1e-5);
            check_near(turn.psi, table_at(&turns, k, "psi"), 1e-5);
        }
    }
}
