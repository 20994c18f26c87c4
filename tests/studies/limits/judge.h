/* SPDX-License-Identifier: MIT */
/* A random run held against the accuracy that docs/limits.md states for its
 * steps.  Knows the steps inside the library: a header, to be compiled with
 * whatever holds that. */
#ifndef ROLLCOIN_TESTS_JUDGE_H
#define ROLLCOIN_TESTS_JUDGE_H

#include "check.h"
#include "coins.h"
#include "study.h"

#include <coin_run.h>

#include <math.h>

/* What docs/limits.md states: a step adds at most share (|dt| W)^(order + 1),
 * in radians, radii and parts of W, W the larger of that where it begins and
 * that where it ends; the motion amplifies it from there.  To the energy a step
 * adds at most as large a part of it.  coin_advance() adds share tol in a
 * natural unit of time. */
struct study_claim {
    int order;
    double share;
};

static const struct study_claim study_claims[STUDY_METHODS] = {
    [STUDY_RK4] = {4, 0.1},         [STUDY_RK8] = {8, 2e-4},
    [STUDY_SYMPLECTIC2] = {2, 0.6}, [STUDY_SYMPLECTIC4] = {4, 0.04},
    [STUDY_ADVANCE] = {0, 2},
};

/* The tolerance of the truth, which is coin_advance()'s. */
#define TRUTH 1e-13

/* A run without limits, against the truth. */
struct study_measure {
    int finished;     /* no step failed, and the true coin did not fall flat */
    double fastest;   /* the largest |dt| W */
    double sum;       /* of (|dt| W)^(order + 1) */
    double fine;      /* the same, |dt| W beyond the coarse counted as that */
    double rounding;  /* what rounding and the truth's own error may add */
    double amplified; /* by how much the motion amplifies what is added; 1 if
                         the error is within the claim without that */
    double error;     /* at the end */
    double energy;    /* relative error of the energy */
    coin_state end, truth;
};

enum study_outcome {
    STUDY_RIGHT,         /* within what is stated */
    STUDY_ORBIT_RIGHT,   /* so unstable that more than a radian is stated; the
                            energy is within what is stated */
    STUDY_UNSTATED,      /* so long that the steps alone may add a radian */
    STUDY_SILENT,        /* wrong, and not a word */
    STUDY_FLAGGED_RIGHT, /* COIN_COARSE, yet no worse than if it were not */
    STUDY_FLAGGED_WRONG,
    STUDY_REFUSED_RIGHT, /* the step refused would have been no worse than one
                            that is not coarse */
    STUDY_REFUSED_WRONG,
    STUDY_OUTCOMES
};

/* ----------------------------------------------------------- measuring -- */

static double largest(const double *off, size_t count)
{
    double worst = 0;
    for (size_t i = 0; i < count; ++i)
        if (!(fabs(off[i]) <= worst))
            worst = fabs(off[i]);
    return worst;
}

/* Angles, places in radii and rates in parts of W. */
static double apart(const coin_state *s, const coin_state *t,
                    const coin_params *p)
{
    const double W = fastest_rate(t, p), a = p->radius;
    const double off[] = {
        s->theta - t->theta, (s->wX - t->wX) / W, (s->wY - t->wY) / W,
        (s->wZ - t->wZ) / W, s->phi - t->phi,     s->psi - t->psi,
        (s->x - t->x) / a,   (s->z - t->z) / a,
    };
    return largest(off, 8);
}

/* A start that is off by so much in one of the four things that drive the
 * coin, as an error of a step is: angles as they change, rates as W has them
 * change.  Returns by how much it is, 0 if a double cannot hold it. */
static double nudged(coin_state *s, const coin_params *p, int which,
                     double size)
{
    const double c = cos(s->theta), W = fastest_rate(s, p);
    double *const member[] = {&s->theta, &s->wX, &s->wY, &s->wZ};
    const double unit[] = {c, c * W, c * W, c * W};
    const double before = *member[which];
    *member[which] += size * unit[which];
    const double by = fabs(*member[which] - before) / unit[which];
    return by < 1.5 * fabs(size) ? by : 0;
}

/* All four at once, either way, and the heading, whose error turns the way that
 * is left. */
static double growth(const coin_state *s, const coin_params *p, double t,
                     double size, double tol)
{
    coin_state end = *s;
    if (coin_advance(&end, p, t, tol, NULL) != COIN_OK)
        return (double)INFINITY;
    double sum = 1 + hypot(end.x - s->x, end.z - s->z) / p->radius;
    for (int which = 0; which < 4; ++which) {
        double most = 0;
        for (int side = -1; side <= 1; side += 2) {
            coin_state other = *s;
            const double by = nudged(&other, p, which, side * size);
            if (by > 0 && coin_advance(&other, p, t, tol, NULL) != COIN_OK)
                return (double)INFINITY;
            if (by > 0)
                most = fmax(most, apart(&other, &end, p) / by);
        }
        sum += most;
    }
    return sum;
}

/* By how much an error of about this size at *s grows until t later.  Where it
 * grows much, a path that is only roughly right would not tell. */
static double amplification(const coin_state *s, const coin_params *p, double t,
                            double error)
{
    const double size = fmin(fmax(error, 1e-12), 1e-3);
    const double roughly = growth(s, p, t, size, 1e-6);
    return roughly < 1e3 ? roughly : growth(s, p, t, size, TRUTH);
}

/* A run taken step by step, without limits. */
struct walk {
    const struct study_run *r;
    const struct study_claim *claim;
    struct study_measure *m;
    coin_priv_run at, fastest;
    double before2; /* W^2 where the step begins */
    double q;       /* the largest 1/cos theta */
};

static double whole_time(const struct study_run *r)
{
    return r->dt * (double)r->steps;
}

static double power(double x, int n)
{
    double y = 1;
    for (; n > 0; --n)
        y *= x;
    return y;
}

/* |dt| W beyond which nobody would look at the result. */
#define ABSURD 3.0

/* One step; 0 if it fails. */
static int stride(struct walk *w)
{
    const double coarse = coin_priv_reaches[w->r->method].coarse;
    const int factors = w->claim->order + 1;
    const coin_priv_variables *const y = &w->at.g.y;
    if (coin_priv_run_on(&w->at, (int32_t)w->r->method, 1) == 0)
        return 0;
    const double W2 = coin_priv_rate2(w->at.b.g_a, y);
    const double dtW = fabs(w->r->dt) * sqrt(fmax(W2, w->before2));
    w->m->sum += power(dtW, factors);
    w->m->fine += power(fmin(dtW, coarse), factors);
    w->before2 = W2;
    w->q = fmax(w->q, y->q);
    if (dtW > w->m->fastest) {
        w->m->fastest = dtW;
        w->fastest = w->at;
    }
    return dtW <= ABSURD;
}

static int walk_steps(struct walk *w)
{
    w->before2 = coin_priv_rate2(w->at.b.g_a, &w->at.g.y);
    w->q = w->at.g.y.q;
    for (uint64_t k = 0; k < w->r->steps; ++k)
        if (!stride(w))
            return 0;
    w->m->end = coin_priv_run_state(&w->at);
    return coin_state_check(&w->m->end, &w->r->p) == COIN_OK;
}

/* Natural units of time, or radians where the coin turns faster. */
static double turned(const struct study_run *r)
{
    const double speed2 = 2 * coin_energy(&r->s, &r->p) / r->p.mass;
    return fabs(whole_time(r)) * sqrt(speed2) / r->p.radius;
}

static int walk_time(struct walk *w)
{
    const struct study_run *r = w->r;
    w->m->sum = w->m->fine = (1 + turned(r)) * r->tol;
    return coin_advance(&w->m->end, &r->p, whole_time(r), r->tol, NULL) ==
           COIN_OK;
}

/* What a run of so many steps and the truth may lose to rounding.  The
 * symplectic methods add to theta itself, which knows cos theta only to u. */
static double rounding(const struct walk *w, const coin_state *truth)
{
    const struct study_run *r = w->r;
    const int by_theta =
        r->method == STUDY_SYMPLECTIC2 || r->method == STUDY_SYMPLECTIC4;
    const double a = r->p.radius, step = by_theta ? 4 * w->q : 4;
    const double pose[] = {1, truth->phi, truth->psi, truth->x / a,
                           truth->z / a};
    return U * (step * (double)r->steps + 16 * largest(pose, 5)) +
           study_claims[STUDY_ADVANCE].share * TRUTH * (1 + turned(r));
}

/* From where W is largest, from the start, and from so many parts of the way.
 */
static double amplified(const struct walk *w, double error, int parts)
{
    const struct study_run *r = w->r;
    const coin_state fast = coin_priv_run_state(&w->fastest);
    const double left = ((double)r->steps - (double)w->fastest.steps) * r->dt;
    double most = amplification(&fast, &r->p, left, error);
    coin_state s = r->s;
    for (int k = parts; k > 0; --k) {
        most = fmax(most,
                    amplification(&s, &r->p, whole_time(r) * k / parts, error));
        coin_advance(&s, &r->p, whole_time(r) / parts, TRUTH, NULL);
    }
    return most;
}

static struct study_measure study_measure(const struct study_run *r,
                                          const struct study_claim *claim)
{
    struct study_measure m = {.end = r->s, .truth = r->s, .amplified = 1};
    struct walk w = {.r = r, .claim = claim, .m = &m};
    check_status(coin_priv_check(&r->s, &r->p, &w.at.b), COIN_OK);
    coin_priv_run_from(
        &w.at, &r->s,
        r->method == STUDY_ADVANCE ? COIN_RK8 : (int32_t)r->method, r->dt);
    w.at.limits.coarse2 = (double)INFINITY;
    w.at.limits.most2 = w.at.b.w2_max;
    w.fastest = w.at;
    m.finished =
        (r->method == STUDY_ADVANCE ? walk_time : walk_steps)(&w) &&
        coin_advance(&m.truth, &r->p, whole_time(r), TRUTH, NULL) == COIN_OK;
    if (!m.finished)
        return m;
    m.error = apart(&m.end, &m.truth, &r->p);
    m.energy = fabs(coin_energy(&m.end, &r->p) / coin_energy(&r->s, &r->p) - 1);
    m.rounding = rounding(&w, &m.truth);
    /* Four parts as a rule; a run that they call wrong is looked at closely. */
    const double each = claim->share * m.sum + m.rounding;
    if (m.error > claim->share * m.fine + m.rounding)
        m.amplified = amplified(&w, each, 4);
    if (m.error > m.amplified * each)
        m.amplified = amplified(&w, each, 64);
    return m;
}

/* ------------------------------------------------------------- judging -- */

/* The run by the public function: its status, and where it stops. */
static int32_t by_library(const struct study_run *r, coin_state *s)
{
    const coin_params *p = &r->p;
    *s = r->s;
    if (r->method == STUDY_ADVANCE)
        return coin_advance(s, p, whole_time(r), r->tol, NULL);
    return coin_run(s, p, (int32_t)r->method, r->dt, r->steps, NULL);
}

/* Whether the error is within what steps may add that each add so much, and
 * that is less than a radian. */
static int is_right(const struct study_measure *m, double each)
{
    const double bound = m->amplified * (each + m->rounding);
    return m->finished && bound < 1 && m->error <= bound;
}

static enum study_outcome judge_whole(const struct study_measure *m,
                                      const struct study_claim *claim)
{
    const double each = claim->share * m->sum, stated = each + m->rounding;
    if (!m->finished)
        return STUDY_SILENT;
    if (stated >= 1)
        return STUDY_UNSTATED;
    if (is_right(m, each))
        return STUDY_RIGHT;
    return m->amplified * stated >= 1 && m->energy <= stated ? STUDY_ORBIT_RIGHT
                                                             : STUDY_SILENT;
}

/* The step that coin_run() refuses from *s, or the time that coin_advance()
 * refuses, at its best. */
static struct study_run refused(const struct study_run *r, const coin_state *s)
{
    struct study_run one = *r;
    one.tol = TRUTH;
    if (r->method != STUDY_ADVANCE) {
        one.s = *s;
        one.steps = 1;
    }
    return one;
}

/* Makes the run by the public function, and judges.  *m is the measure of the
 * run, or of the step refused.  Fails the test if a run has not the bits of
 * its steps taken one by one. */
static enum study_outcome study_judge(const struct study_run *r,
                                      struct study_measure *m)
{
    const struct study_claim *claim = &study_claims[r->method];
    coin_state s;
    const int32_t status = by_library(r, &s);
    if (status < 0) {
        const struct study_run one = refused(r, &s);
        *m = study_measure(&one, claim);
        return is_right(m, claim->share * m->fine) ? STUDY_REFUSED_RIGHT
                                                   : STUDY_REFUSED_WRONG;
    }
    *m = study_measure(r, claim);
    if (m->finished)
        check_same(&m->end, &s, sizeof s);
    if (status == COIN_COARSE)
        return is_right(m, claim->share * m->fine) ? STUDY_FLAGGED_RIGHT
                                                   : STUDY_FLAGGED_WRONG;
    return judge_whole(m, claim);
}

#endif
