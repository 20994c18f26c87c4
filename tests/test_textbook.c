/* SPDX-License-Identifier: MIT */
/* COIN_RK4 errs like the classical method as a textbook writes it: the pose, at
 * equal steps, on the public scenes and on spins.  Where a motion is steady the
 * textbook errs by rounding alone, and COIN_RK4 by a small part of what it errs
 * on ordinary motions. */
#include "support/check.h"
#include "support/coins.h"
#include "support/floats.h"
#include "support/methods.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/spread.h"
#include "support/textbook.h"

#include <math.h>
#include <stdio.h>

#define TURN 6.283185307179586

static const double sizes[] = {0.02, 0.05, 0.1}; /* dt W, W the largest */
enum { SIZES = 3, SPINS = 60 };

/* What counts as good whatever the textbook does: ordinary motions err by some
 * 0.01 (dt W)^4. */
#define STEADY 1.5e-3

/* In the textbook's errors.  Beyond MOST_AS_A_RULE is the heading of some spins
 * near the table alone: 8 of 1800 random ones, by 1.66 at most. */
#define MOST 1.7
#define MOST_AS_A_RULE 1.5

static double tolerated(double dtW, double textbook, double most)
{
    return fmax(most * textbook, STEADY * dtW * dtW * dtW * dtW) + 2e-13;
}

static void by_textbook(coin_state *s, const coin_params *p, double dt,
                        uint64_t n)
{
    for (; n > 0; --n)
        textbook_step(s, p, dt);
}

/* The ratios of the errors where the textbook's is an ordinary one. */
struct ratios {
    double of[(SCENES + SPINS) * SIZES];
    size_t count;
    int good, all; /* up to MOST_AS_A_RULE, and compared */
};

static void compare(struct ratios *r, double dtW, double ours, double textbook)
{
    check_within(ours, 0, tolerated(dtW, textbook, MOST));
    r->good += ours <= tolerated(dtW, textbook, MOST_AS_A_RULE);
    ++r->all;
    if (textbook > STEADY * dtW * dtW * dtW * dtW)
        r->of[r->count++] = ours / textbook;
}

/* ------------------------------------------------------------- public scenes
 */
static struct scene scene;

/* Five natural units; near the table fewer as a rule, so that a scene turns by
 * no more than 5100 rad of W: that of flat3 is 2600 as the coin passes,
 * at 1.97. */
static double horizon(double W, const coin_params *p)
{
    const double all = 5.001 * natural_time(p);
    return all_asked() ? all : fmin(all, 5100 / W);
}

/* From row to row; the largest errors seen. */
static void along_a_scene(double dtW, double W, double *ours, double *textbook)
{
    const coin_params *p = &scene.params;
    coin_state a = scene_state(&scene, 0), b = a;
    *ours = *textbook = 0;
    for (size_t row = 1; row < scene.rows.rows; ++row) {
        const double t = scene_at(&scene, row, "t");
        const double span = t - scene_at(&scene, row - 1, "t");
        const uint64_t n = (uint64_t)ceil(span * W / dtW);
        if (t > horizon(W, p))
            break;
        check_status(coin_run(&a, p, COIN_RK4, span / (double)n, n, NULL),
                     COIN_OK);
        by_textbook(&b, p, span / (double)n, n);
        *ours = fmax(*ours, scene_error(&scene, row, &a));
        *textbook = fmax(*textbook, scene_error(&scene, row, &b));
    }
}

TEST(it_errs_like_the_textbook_s_on_the_public_scenes)
{
    static struct ratios r;
    for (int i = 0; i < SCENES; ++i) {
        scene_load(&scene, scene_names[i]);
        const coin_state start = scene_state(&scene, 0);
        const double T = natural_time(&scene.params);
        const double W = fastest_ahead(&start, &scene.params, 5 * T);
        for (int k = 0; k < SIZES; ++k) {
            double ours, textbook;
            along_a_scene(sizes[k], W, &ours, &textbook);
            check_note("%s, dt W = %g", scene_names[i], sizes[k]);
            compare(&r, sizes[k], ours, textbook);
        }
    }
    const struct spread s = spread_of(r.of, r.count);
    printf("    %zu scenes: %.3g of the textbook's error, at worst %.3g\n",
           r.count, s.median, s.worst);
    check(r.count >= 20 && r.good == r.all);
    check_within(s.median, 0.9, 1.1);
}

/* The rates of a steady motion are constant, so that its angles are exact; what
 * is left is the path round a circle, off by 1.5e-6 (dt W)^4. */
TEST(it_follows_steady_motions_closely)
{
    const char *const names[] = {"spin", "circle"};
    for (int i = 0; i < 2; ++i) {
        scene_load(&scene, names[i]);
        const coin_state start = scene_state(&scene, 0);
        const double W = fastest_rate(&start, &scene.params);
        for (int k = 0; k < SIZES; ++k) {
            const double fourth = pow(sizes[k], 4);
            double ours, textbook;
            along_a_scene(sizes[k], W, &ours, &textbook);
            check_note("%s, dt W = %g", names[i], sizes[k]);
            check_within(ours, 0, 6e-6 * fourth + 2e-14);
        }
    }
}

/* ---------------------------------------------------------------- spins -- */
/* A spin whose wY is not the steady one, over PARTS times of PART natural
 * units: where it truly is after each, and how fast it gets. */
enum { PARTS = 6 };
#define PART 0.5

struct spin {
    coin_params p;
    coin_state start, after[PARTS];
    double W;
};

/* Steps of |dt| W <= size in a part. */
static uint64_t steps_in(const struct spin *m, double size)
{
    return (uint64_t)ceil(PART * m->W / size);
}

/* By the textbook's steps of |dt| W = 0.01 and of half as much, extrapolated:
 * what is left is below 1e-12. */
static void find_truth(struct spin *m)
{
    m->W = fastest_ahead(&m->start, &m->p, PARTS * PART);
    const uint64_t n = steps_in(m, 0.01);
    coin_state s = m->start, half = m->start;
    for (int k = 0; k < PARTS; ++k) {
        by_textbook(&s, &m->p, PART / (double)n, n);
        by_textbook(&half, &m->p, PART / (2 * (double)n), 2 * n);
        m->after[k] = half;
        double *const x = (double *)&m->after[k];
        for (int i = 0; i < 8; ++i)
            x[i] += (x[i] - ((const double *)&s)[i]) / 15;
    }
}

/* Each sixth is the steady one. */
static struct spin spin_of(int i, struct random *r)
{
    struct spin m = {.p = disc()};
    const double lean = 0.02 + 1.5 * i / (SPINS - 1);
    check_status(coin_steady_spin(&m.start, &m.p, lean), COIN_OK);
    m.start.wY *= i % 6 ? random_between(r, 0.5, 3) : 1;
    check_note("spin %d: theta = %.17g, wY = %.17g", i, lean, m.start.wY);
    return m;
}

/* The largest errors of the pose after any part. */
static void along_a_spin(const struct spin *m, double dtW, double *ours,
                         double *textbook)
{
    const uint64_t n = steps_in(m, dtW);
    const double dt = PART / (double)n;
    coin_state a = m->start, b = a;
    *ours = *textbook = 0;
    for (int k = 0; k < PARTS; ++k) {
        check_status(coin_run(&a, &m->p, COIN_RK4, dt, n, NULL), COIN_OK);
        by_textbook(&b, &m->p, dt, n);
        *ours = fmax(*ours, path_apart(&a, &m->after[k], &m->p));
        *textbook = fmax(*textbook, path_apart(&b, &m->after[k], &m->p));
    }
}

TEST(it_errs_like_the_textbook_s_on_spins)
{
    static struct ratios r;
    struct random random = random_begin(311);
    for (int i = 0; i < SPINS; ++i) {
        struct spin m = spin_of(i, &random);
        find_truth(&m);
        for (int k = 0; k < SIZES; ++k) {
            double ours, textbook;
            along_a_spin(&m, sizes[k], &ours, &textbook);
            compare(&r, sizes[k], ours, textbook);
        }
    }
    const struct spread s = spread_of(r.of, r.count);
    printf("    %zu spins: %.3g of the textbook's error, at worst %.3g\n",
           r.count, s.median, s.worst);
    check(r.count >= 90);
    check_within((double)r.good / r.all, 0.99, 1);
    check_within(s.median, 0.9, 1.1);
}

/* ------------------------------------------------------------------ the twin
 */
/* What coinf.h states for 20 natural units, mostly rounding. */
#define ROUNDING 4e-6

/* A stage turns the pairs by short series.  Up to turns of 0.3 these miss 1e-6,
 * so that the steps are the textbook's within a part of the error of those. */
#define PART_OF_ERROR 0.01

/* Steps below some 0.1 err by rounding alone. */
static const double twin_sizes[] = {0.1, 0.3};
enum { TWIN_SIZES = 2 };

static int told; /* how often the textbook erred by ten times the rounding */

/* PARTS times n steps of the twin and of the textbook, from the same numbers.
 * Of the textbook's own error, steps half as long show 15/16. */
static void twin_beside_textbook(coinf_state s, const coinf_params *fp,
                                 float dt, uint64_t n)
{
    const coin_params p = doubles_params(fp);
    coin_state want = doubles_state(&s), truth = want;
    for (int k = 0; k < PARTS; ++k) {
        check(coinf_run(&s, fp, COIN_RK4, dt, n, NULL) >= COIN_OK);
        by_textbook(&want, &p, dt, n);
        by_textbook(&truth, &p, dt / 2.0, 2 * n);
        coin_state got = doubles_state(&s);
        got.phi = want.phi + remainder(got.phi - want.phi, TURN);
        got.psi = want.psi + remainder(got.psi - want.psi, TURN);
        const double error = path_apart(&want, &truth, &p);
        check_within(path_apart(&got, &want, &p), 0,
                     PART_OF_ERROR * error + ROUNDING);
        told += error > 10 * ROUNDING;
    }
}

/* In steps of each size over W, and at most as long. */
static void twin_for(const coin_params *p, const coin_state *start, double W,
                     double time)
{
    const coinf_params fp = floats_params(p);
    const coinf_state s = floats_state(start);
    for (int k = 0; k < TWIN_SIZES; ++k) {
        const uint64_t n = (uint64_t)ceil(time / PARTS * W / twin_sizes[k]);
        check_note("dt W = %g, theta = %.17g, wY = %.17g", twin_sizes[k],
                   start->theta, start->wY);
        twin_beside_textbook(s, &fp, (float)(time / PARTS / (double)n), n);
    }
}

TEST(the_twin_takes_the_textbook_s_steps_on_spins)
{
    struct random random = random_begin(312);
    told = 0;
    for (int i = 0; i < SPINS; ++i) {
        const struct spin m = spin_of(i, &random);
        const double time = PARTS * PART;
        const double W = fastest_ahead(&m.start, &m.p, time);
        twin_for(&m.p, &m.start, W, time);
    }

    check(told >= 15); /* 42 on the average */
}

TEST(the_twin_takes_them_on_random_motions)
{
    enum { MOTIONS = 60 };
    struct random random = random_begin(313);
    told = 0;
    for (int i = 0; i < MOTIONS; ++i) {
        const coin_params p = random_coin(&random);
        const coin_state start = random_motion(&random, &p, 1.0 / 32, 64);
        const double time = 2 * natural_time(&p);
        twin_for(&p, &start, fastest_ahead(&start, &p, time), time);
    }

    check(told >= 20); /* 70 on the average */
}

/* Where stages by slopes of the pairs and of 1/cos theta erred by 1.84, 1.58
 * and 2.15 times as much as the textbook; and the same with steps twice as
 * long. */
TEST(the_twin_takes_them_where_slopes_of_pairs_err_most)
{
    static const struct {
        double inner;
        coinf_state s;
        float dt;
        uint64_t n;
    } one[] = {
        {0.5,
         {.theta = 0x1.e9a09ep-1f, .wY = 0x1.61bf0ep-1f},
         0x1.cc1186p-5f,
         89},
        {1,
         {.theta = 0x1.4825c6p+0f, .wY = 0x1.a61e94p-2f},
         0x1.5a1e88p-5f,
         118},
        {0,
         {.theta = -0x1.6016eap-4f,
          .wX = 0x1.145cf8p-1f,
          .wY = -0x1.700222p-1f,
          .wZ = -0x1.012f46p+0f},
         0x1.e739bep-5f,
         84},
    };
    for (int i = 0; i < 3; ++i) {
        const coin_params p = one[i].inner > 0 ? ring(one[i].inner) : disc();
        const coinf_params fp = floats_params(&p);
        check_note("case %d", i);
        told = 0;
        twin_beside_textbook(one[i].s, &fp, one[i].dt, one[i].n / PARTS);
        twin_beside_textbook(one[i].s, &fp, 2 * one[i].dt,
                             one[i].n / PARTS / 2);

        check(told >= PARTS / 2);
    }
}
