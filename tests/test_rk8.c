/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/methods.h"
#include "support/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The step of lib/step/rk8.t.h, given slopes that are no motion but show which
 * coefficient goes where. */
#include "run.h"
#undef coin_priv_slopes_at
#undef coin_priv_pose_slopes
#define coin_priv_slopes_at probe_slopes
#define coin_priv_pose_slopes probe_path
static coin_priv_variables probe_slopes(const coin_priv_field *f,
                                        const coin_priv_variables *y);
static coin_priv_pose probe_path(const coin_priv_field *f,
                                 const coin_priv_variables *y);
#include "rk8.t.h"

enum { STAGES = 12, MEMBERS = 8 };

/* ----------------------------------------------------------- the tableau */
struct tableau {
    double a[STAGES][STAGES], b[STAGES];
};

static struct tableau reference(void)
{
    struct tableau t = {0};
    char line[128];
    int i, j, as = 0, bs = 0;
    double value;
    FILE *in = fopen(TEST_DATA "/dormand-prince-8.csv", "r");
    check(in != NULL);
    while (fgets(line, sizeof line, in))
        if (sscanf(line, "a,%d,%d,%lf", &i, &j, &value) == 3) {
            t.a[i - 1][j - 1] = value;
            ++as;
        } else if (sscanf(line, "b,%d,,%lf", &i, &value) == 2) {
            t.b[i - 1] = value;
            ++bs;
        }
    fclose(in);
    check(as == 50 && bs == 8);
    return t;
}

/* Stage `shown` has the slope 1, every other 0. */
static struct {
    int shown, stage;
    double seen[STAGES][MEMBERS];
} probe;

static coin_priv_variables probe_slopes(const coin_priv_field *f,
                                        const coin_priv_variables *y)
{
    const double at[MEMBERS] = {y->wX,  y->wY, y->wZ,  y->sth,
                                y->cth, y->q,  y->sph, y->cph};
    const double d = probe.stage == probe.shown ? f->h : 0;
    const coin_priv_variables slopes = {d, d, d, d, d, d, 0, d, d};
    memcpy(probe.seen[probe.stage++], at, sizeof at);
    return slopes;
}

static coin_priv_pose probe_path(const coin_priv_field *f,
                                 const coin_priv_variables *y)
{
    (void)y;
    const double d = probe.stage - 1 == probe.shown ? f->h : 0;
    const coin_priv_pose slopes = {d, d, d, d, d, d};
    return slopes;
}

/* Column j as the step uses it, the same in every member; from 0 and with one
 * slope of 1 nothing is rounded. */
static void read_column(struct tableau *t, int j)
{
    const coin_priv_variables zero = {.wX = 0};
    const coin_priv_field one = {.h = 1};
    coin_priv_variables end;
    coin_priv_pose adds;
    probe.shown = j;
    probe.stage = 0;
    rk8_sums(&end, &adds, &zero, &one);
    check(probe.stage == STAGES);
    t->b[j] = end.wX;
    const double weights[] = {end.wY,   end.wZ,   end.sth, end.cth,
                              end.q,    end.sph,  end.cph, adds.theta,
                              adds.phi, adds.psi, adds.x,  adds.z};
    for (size_t k = 0; k < sizeof weights / sizeof *weights; ++k)
        check(weights[k] == t->b[j]);
    for (int i = 0; i < STAGES; ++i) {
        t->a[i][j] = probe.seen[i][0];
        for (int k = 1; k < MEMBERS; ++k)
            check(probe.seen[i][k] == t->a[i][j]);
    }
}

static struct tableau in_use(void)
{
    struct tableau t = {0};
    for (int j = 0; j < STAGES; ++j)
        read_column(&t, j);
    return t;
}

TEST(every_member_steps_by_the_reference_tableau)
{
    const struct tableau got = in_use(), want = reference();
    for (int i = 0; i < STAGES; ++i) {
        check_note("row %d", i + 1);
        check_same(got.a[i], want.a[i], sizeof got.a[i]);
    }
    check_note("weights");
    check_same(got.b, want.b, sizeof got.b);
}

/* ------------------------------------------------------------ the motion */
static struct scene scene;

/* Steps so large that truncation rules, and so small that its next order is
 * less than half of it: halving them divides the error by 2^8, and with half
 * as much again of the ninth order by 2^(8 +- 0.42). */
TEST(the_error_is_of_order_8_in_every_scene)
{
    const struct {
        const char *name;
        double t;
        uint64_t steps;
        double error; /* measured */
    } cases[] = {
        {"wobble", 5, 8, 5.8e-9},       {"generic", 5, 32, 4.9e-11},
        {"tumble", 5, 8, 2.2e-11},      {"ring", 5, 32, 6.1e-11},
        {"quarter", 0.25, 16, 6.4e-9},  {"negative", 5, 32, 2.5e-11},
        {"ring_b05", 5, 64, 5.0e-11},   {"si_washer", 0.25, 16, 1.9e-9},
        {"nearflat", 5, 1024, 5.5e-10},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        scene_load(&scene, cases[i].name);
        const size_t row = scene_row(&scene, cases[i].t);
        const double error =
            method_error(&scene, COIN_RK8, row, cases[i].steps);
        check_within(error / cases[i].error, 0.5, 2);
        check_within(measured_order(&scene, COIN_RK8, row, cases[i].steps), 7.5,
                     8.5);
    }
}

/* Its rates are constant, and its centre rests. */
TEST(a_steady_spin_is_exact_in_large_steps)
{
    scene_load(&scene, "spin");
    check_within(method_error(&scene, COIN_RK8, scene_row(&scene, 5), 16), 0,
                 3e-14);
}

/* One step for each frame of a film, as docs/choosing.md has for 3.5 s. */
TEST(a_quarter_at_60_frames_a_second_stays_exact_for_a_second)
{
    scene_load(&scene, "quarter");
    const double error =
        method_error(&scene, COIN_RK8, scene_row(&scene, 1), 60);
    printf("    quarter, 60 steps in 1 s: off by %.3g rad or radii\n", error);
    check_within(error, 2.5e-8, 1e-7);
}
