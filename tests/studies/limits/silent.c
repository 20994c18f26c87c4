/* SPDX-License-Identifier: MIT */
/* Whether a wrong answer ever comes without a word: random runs, counted by
 * what became of them.
 *     silent judge SEED RUNS   by the public functions, against the claims
 *     silent steps SEED RUNS   without limits: what a step of each size adds */
#include "judge.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_STEPS 1e4
#define MOST_TURN 200.0 /* radians: what the truth costs goes by it */

/* ------------------------------------------------------------- judging -- */

static struct counts {
    unsigned long runs, of[STUDY_OUTCOMES];
} counts[STUDY_METHODS][STUDY_FAMILIES];

static void tell(const struct study_run *r, uint64_t seed, uint64_t run,
                 const struct study_measure *m)
{
    fprintf(stderr,
            "silent: seed %" PRIu64 " run %" PRIu64 ", %s, %s: error %.3g, "
            "sum %.3g, amplified %.3g, rounding %.3g, energy %.3g\n",
            seed, run, study_methods[r->method], study_families[r->family],
            m->error, m->sum, m->amplified, m->rounding, m->energy);
}

static int judge(uint64_t seed, uint64_t runs)
{
    int silent = 0;
    for (uint64_t i = 0; i < runs; ++i) {
        const struct study_run r = study_draw(seed, i, MOST_STEPS, MOST_TURN);
        struct study_measure m;
        const enum study_outcome outcome = study_judge(&r, &m);
        struct counts *c = &counts[r.method][r.family];
        ++c->runs;
        ++c->of[outcome];
        if (outcome == STUDY_SILENT) {
            tell(&r, seed, i, &m);
            silent = 1;
        }
    }
    puts("method,family,runs,right,orbit_right,unstated,silent,flagged_right,"
         "flagged_wrong,refused_right,refused_wrong");
    for (int k = 0; k < STUDY_METHODS; ++k)
        for (int f = 0; f < STUDY_FAMILIES; ++f) {
            const struct counts *c = &counts[k][f];
            printf("%s,%s,%lu", study_methods[k], study_families[f], c->runs);
            for (int o = 0; o < STUDY_OUTCOMES; ++o)
                printf(",%lu", c->of[o]);
            puts("");
        }
    return silent;
}

/* ------------------------------------------------------- what steps add -- */

/* Half octaves of |dt| W, with 1.2 between two of them. */
enum { BINS = 24, AT_1_2 = 20 };

static double upper(int bin)
{
    return 1.2 * exp2((bin - AT_1_2) / 2.0);
}

static struct bin {
    unsigned long runs, failed;
    double worst; /* over (|dt| W)^(order + 1) */
} bins[4][BINS];

static struct bin *bin_of(int method, double dtW)
{
    const double at = AT_1_2 - floor(2 * log2(1.2 / dtW));
    return at >= 0 && at < BINS ? &bins[method][(int)at] : NULL;
}

static void note(struct bin *b, const struct study_measure *m)
{
    const double rounding = m->amplified * m->rounding;
    const double over = (m->error - rounding) / (m->amplified * m->sum);
    ++b->runs;
    b->worst = fmax(b->worst, over);
}

static int steps(uint64_t seed, uint64_t runs)
{
    for (uint64_t i = 0; i < runs; ++i) {
        const struct study_run r = study_draw(seed, i, MOST_STEPS, MOST_TURN);
        if (r.method > STUDY_SYMPLECTIC4)
            continue;
        struct study_claim least = study_claims[r.method];
        least.share /= 100;
        const struct study_measure m = study_measure(&r, &least);
        struct bin *b = bin_of((int)r.method, m.fastest);
        if (b && m.finished)
            note(b, &m);
        else if (b)
            ++b->failed;
    }
    puts("method,dtW,runs,failed,worst");
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < BINS; ++i) {
            const struct bin *b = &bins[k][i];
            printf("%s,%.3g,%lu,%lu,%.2g\n", coin_method_name(k), upper(i),
                   b->runs, b->failed, b->worst);
        }
    return 0;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int (*make)(uint64_t seed, uint64_t runs);
    } modes[] = {{"judge", judge}, {"steps", steps}};
    for (int i = 0; argc == 4 && i < 2; ++i)
        if (strcmp(argv[1], modes[i].name) == 0)
            return modes[i].make(strtoull(argv[2], NULL, 10),
                                 strtoull(argv[3], NULL, 10));
    fputs("usage: silent judge|steps SEED RUNS\n", stderr);
    return 2;
}
