/* SPDX-License-Identifier: MIT */
/* The ladder of models over many random scenes, as CSV.
 *
 *     study choice 10000   what coin_model_needed() names, and if it holds
 *     study unstable 20000 the same on unstable circles, by a finer truth
 *     study errors         of the models, against the distance from steady
 *     study costs          of one answer of each, over a textbook RK4 step */
#include "support/check.h"
#include "support/rungs.h"

#include "costs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LOOKS = 600, SAMPLES = 100 };

struct tally {
    int named[4], missed, cheaper[4], refused;
    int doubted;  /* judged by named_error(), the steps being no better */
    double gain;  /* the most that the orbit's error then was of theirs */
    double worst; /* error of the named rung over its tolerance */
};

static void count(struct tally *n, const struct rung_scene *scene,
                  const struct rungs *found)
{
    if (found->wanted < 0) {
        ++n->refused;
        return;
    }
    const int32_t rung = found->wanted;
    ++n->named[rung];
    if (rung < COIN_MODEL_STEPS) {
        double error = found->error[rung];
        if (rung == COIN_MODEL_ORBIT && !(error <= scene->tol)) {
            ++n->doubted;
            const double finer = named_error(scene, COIN_MODEL_ORBIT, LOOKS);
            n->gain = fmax(n->gain, finer / error);
            error = finer;
        }
        n->missed += !(error <= scene->tol);
        n->worst = fmax(n->worst, error / scene->tol);
    }
    for (int32_t k = 0; k < rung; ++k)
        if (found->error[k] <= scene->tol) {
            ++n->cheaper[rung];
            return;
        }
}

static int study_choice(int scenes)
{
    struct random r = random_begin(2026);
    int missed = 0;
    printf("scenes,of,steady,wobble,orbit,steps,refused,missed,judged_finer,"
           "cheaper_for_wobble,cheaper_for_orbit,cheaper_for_steps,"
           "worst_error_over_tol,"
           "finer_over_stepped\n");
    for (int kind = 0; kind < KINDS_OF_SCENES; ++kind) {
        struct tally n = {{0}, 0, {0}, 0, 0, 0, 0};
        const int of = scenes / KINDS_OF_SCENES;
        for (int k = 0; k < of; ++k) {
            const struct rung_scene scene = random_scene(&r, kind, 3000);
            const struct rungs found = climb(&scene, &r, LOOKS);
            count(&n, &scene, &found);
        }
        printf("%s,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%d,%.3g,%.2g\n",
               kinds_of_scenes[kind], of, n.named[0], n.named[1], n.named[2],
               n.named[3], n.refused, n.missed, n.doubted, n.cheaper[1],
               n.cheaper[2], n.cheaper[3], n.worst, n.gain);
        missed += n.missed;
    }
    return missed ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* Of each model: how often it was named and missed, and its largest error over
 * the tolerance. */
static int study_unstable(int scenes)
{
    struct random r = random_begin(2028);
    int named[4] = {0, 0, 0, 0}, missed[4] = {0, 0, 0, 0}, misses = 0;
    double worst[4] = {0, 0, 0, 0};
    for (int k = 0; k < scenes; ++k) {
        const struct rung_scene scene = random_scene(&r, UNSTABLE, 0);
        const int32_t rung = coin_model_needed(&scene.start, &scene.params,
                                               scene.horizon, scene.tol);
        check_within(rung, COIN_MODEL_STEADY, COIN_MODEL_STEPS);
        ++named[rung];
        if (rung == COIN_MODEL_STEPS)
            continue;
        const double error = named_error(&scene, rung, LOOKS / 10) / scene.tol;
        missed[rung] += !(error <= 1);
        worst[rung] = fmax(worst[rung], error);
    }
    printf("model,named,missed,worst_error_over_tol\n");
    for (int rung = 0; rung < 4; ++rung) {
        printf("%d,%d,%d,%.3g\n", rung, named[rung], missed[rung], worst[rung]);
        misses += missed[rung];
    }
    return misses ? EXIT_FAILURE : EXIT_SUCCESS;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Stable circles and rolls of a disc, leaning up to 0.8, left by a distance. */
static struct rung_scene left_by(struct random *r, double distance)
{
    struct rung_scene scene = {.horizon = 30, .tol = 1};
    double L = 1;
    check_status(coin_params_disc(&scene.params, 1, 1, 1), COIN_OK);
    while (!(L < -0.1)) {
        const double theta = random_between(r, 0.05, 0.8);
        check_status(coin_steady_circle(&scene.start, &scene.params, theta,
                                        random_between(r, 0.2, 1.5), 1),
                     COIN_OK);
        check_status(coin_stability(&scene.start, &scene.params, &L), COIN_OK);
    }
    scene.start.theta += distance * random_between(r, -1, 1);
    scene.start.wX += distance * random_between(r, -1, 1);
    scene.start.wY += distance * random_between(r, -1, 1);
    scene.start.wZ += distance * random_between(r, -1, 1);
    return scene;
}

static int study_errors(void)
{
    struct random r = random_begin(2027);
    printf("distance,steady,steady_most,wobble,wobble_most,orbit,"
           "orbit_most\n");
    for (int k = 0; k <= 28; ++k) {
        const double distance = pow(10, -8 + k / 4.0);
        double error[3][SAMPLES];
        for (int i = 0; i < SAMPLES; ++i) {
            const struct rung_scene scene = left_by(&r, distance);
            const struct rungs found = climb(&scene, &r, LOOKS / 4);
            for (int rung = 0; rung < 3; ++rung)
                error[rung][i] = found.error[rung];
        }
        printf("%.3e", distance);
        for (int rung = 0; rung < 3; ++rung) {
            qsort(error[rung], SAMPLES, sizeof error[rung][0], by_size);
            printf(",%.3e,%.3e", error[rung][SAMPLES / 2],
                   error[rung][SAMPLES - 1]);
        }
        printf("\n");
    }
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "choice") == 0)
        return study_choice(atoi(argv[2]));
    if (argc == 3 && strcmp(argv[1], "unstable") == 0)
        return study_unstable(atoi(argv[2]));
    if (argc == 2 && strcmp(argv[1], "errors") == 0)
        return study_errors();
    if (argc == 2 && strcmp(argv[1], "costs") == 0)
        return study_costs();
    fprintf(stderr,
            "usage: study choice SCENES | unstable SCENES | errors | costs\n");
    return EXIT_FAILURE;
}
