/* SPDX-License-Identifier: MIT */
/* No run is wrong without a status that says so: random runs by every method,
 * each compared with what docs/limits.md states.  `make silent` takes a
 * million. */
#include "studies/limits/judge.h"

/* Seed of none of the runs by which claims and limits were set. */
#define SEED 2026

/* One run in 375 is of RK8 and uses 1 % of its claim: of 60,000. */
enum { RUNS = 4000, MOST_STEPS = 300, MOST_TURN = 10 };

static struct {
    struct study_run run;
    struct study_measure m;
    enum study_outcome outcome;
} runs[RUNS];

FIRST(make_runs)
{
    for (int i = 0; i < RUNS; ++i) {
        check_note("run %d of seed %d", i, SEED);
        runs[i].run = study_draw(SEED, (uint64_t)i, MOST_STEPS, MOST_TURN);
        runs[i].outcome = study_judge(&runs[i].run, &runs[i].m);
    }
}

TEST(no_run_is_wrong_without_a_status)
{
    int of[STUDY_OUTCOMES] = {0};
    for (int i = 0; i < RUNS; ++i) {
        check_note("run %d of seed %d: %s, %s", i, SEED,
                   study_methods[runs[i].run.method],
                   study_families[runs[i].run.family]);
        check(runs[i].outcome != STUDY_SILENT);
        ++of[runs[i].outcome];
    }
    check(of[STUDY_RIGHT] > RUNS / 2);
    check(of[STUDY_FLAGGED_RIGHT] + of[STUDY_FLAGGED_WRONG] > RUNS / 40);
    check(of[STUDY_REFUSED_RIGHT] + of[STUDY_REFUSED_WRONG] > RUNS / 5);
    /* Few runs are so unstable, or so long, that nothing is stated. */
    check(of[STUDY_ORBIT_RIGHT] + of[STUDY_UNSTATED] < RUNS / 50);
}

/* Of 60,000 runs 16,600 are refused, 88.5 % of them rightly. */
TEST(most_refused_runs_would_have_been_wrong)
{
    int right = 0, wrong = 0;
    for (int i = 0; i < RUNS; ++i) {
        right += runs[i].outcome == STUDY_REFUSED_RIGHT;
        wrong += runs[i].outcome == STUDY_REFUSED_WRONG;
    }
    check_share(wrong, right + wrong, 0.88);
}

/* A claim so lax that nothing could break it shows here: some runs of
 * each method use more than a hundredth of it, where rounding is less. */
TEST(each_method_needs_at_least_1_percent_of_its_claim)
{
    double used[STUDY_METHODS] = {0};
    for (int i = 0; i < RUNS; ++i) {
        const struct study_measure *m = &runs[i].m;
        const enum study_method k = runs[i].run.method;
        const double stated = study_claims[k].share * m->sum;
        if (runs[i].outcome == STUDY_RIGHT && stated > m->rounding)
            used[k] = fmax(used[k], m->error / (m->amplified * stated));
    }
    for (int k = 0; k < STUDY_METHODS; ++k) {
        check_note("%s", study_methods[k]);
        check_within(used[k], 0.01, 1);
    }
}
