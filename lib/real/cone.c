/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "cone.h"

/* At a shorter stride the error of the interpolation counts as 0: it is below
 * COIN_PRIV_MISS stride^6 = 6e-21.  Nor are the slopes of the clearance at the
 * ends read: they would be differences of its rounding. */
#define SHORT 1e-3

/* A second derivative is the difference of the slopes at two points: this part
 * of the step before, and after.  1/64 or 1/4096 gives the same decisions on
 * random slides (make tuning). */
#define NEAR (1.0 / 256)

/* The force is computed at both ends of a step and at PLACES - 1 places between
 * them.  With 4 or 16 places random slides are tested 1 or 2 % more often (make
 * tuning).  The first MOVED variables are interpolated. */
enum { PLACES = 8, MOVED = 7 };

double coin_priv_clearance(const coin_priv_contact *contact,
                           const coin_priv_slip *y, int slips)
{
    const double f = contact->psi_held ? 1 : y->cth;
    const double size = f * (contact->b.g_a + y->wX * y->wX) +
                        fabs(y->wY) * (fabs(y->wY) + fabs(y->wZ));
    if (!slips)
        return coin_priv_margin(contact, y) / size;
    const coin_priv_direction none = {0, 0};
    return coin_priv_kinetic(contact, y, none).N / size;
}

/* The variables at an end of the step, and their first and second derivatives
 * by the part of the step, 0 to 1. */
struct end {
    double y[COIN_PRIV_SLIP_SIZE], d[COIN_PRIV_SLIP_SIZE],
        dd[COIN_PRIV_SLIP_SIZE];
};

static void end_of(struct end *e, const coin_priv_tested_step *step,
                   const coin_priv_slip *at)
{
    const double *y = (const double *)at;
    double to[COIN_PRIV_SLIP_SIZE], back[COIN_PRIV_SLIP_SIZE];
    step->slopes(e->d, y, step->contact);
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i) {
        e->y[i] = y[i];
        e->d[i] *= step->h;
        to[i] = y[i] + NEAR * e->d[i];
        back[i] = y[i] - NEAR * e->d[i];
    }
    double d1[COIN_PRIV_SLIP_SIZE], d0[COIN_PRIV_SLIP_SIZE];
    step->slopes(d1, to, step->contact);
    step->slopes(d0, back, step->contact);
    for (int i = 0; i < MOVED; ++i)
        e->dd[i] = step->h * (d1[i] - d0[i]) / (2 * NEAR);
}

/* Hermite's polynomial of degree 5. */
static void between(coin_priv_slip *to, const struct end *a,
                    const struct end *b, double x)
{
    const double r = 1 - x, x3 = x * x * x, r3 = r * r * r;
    const double a0 = r3 * (1 + x * (3 + 6 * x)),
                 b0 = x3 * (1 + r * (3 + 6 * r));
    const double a1 = r3 * x * (1 + 3 * x), b1 = -x3 * r * (1 + 3 * r);
    const double a2 = r3 * x * x / 2, b2 = x3 * r * r / 2;
    double *y = (double *)to;
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i)
        y[i] = i >= MOVED ? a->y[i]
                          : (a0 * a->y[i] + a1 * a->d[i] + a2 * a->dd[i]) +
                                (b0 * b->y[i] + b1 * b->d[i] + b2 * b->dd[i]);
}

/* The second difference of three neighbours. */
static double bend(const double *m)
{
    return (m[1] - m[0]) + (m[-1] - m[0]);
}

/* The largest third difference of a place k and its neighbours. */
static double third(const double *m, int k)
{
    const double b = bend(&m[k]);
    const double to = k < PLACES - 1 ? fabs(bend(&m[k + 1]) - b) : 0;
    const double from = k > 1 ? fabs(b - bend(&m[k - 1])) : 0;
    return to > from ? to : from;
}

/* The least of the parabola through place k and its neighbours, and below that
 * what the third differences say that it may miss.  A cubic misses it by at
 * most 1/15 of its third difference; an eighth is taken. */
static double least(const double *m, int k)
{
    const double slope = m[k + 1] - m[k - 1], b = bend(&m[k]);
    const double dip = fabs(slope) < 2 * b ? slope * slope / (8 * b) : 0;
    return m[k] - dip - third(m, k) / 8;
}

/* The least clearance between an end of the step, where it is m0, and place k,
 * the next one, by the slope at the end.  m1 is the clearance at a part EDGE of
 * the way from that end to that place. */
#define EDGE (1.0 / 256)
static double least_beside(double m0, double m1, const double *m, int k)
{
    const double slope = (m1 - m0) / EDGE, b = bend(&m[k]) - third(m, k);
    if (!(slope < 0))
        return m0;
    return -slope < b ? m0 - slope * slope / (2 * b) : m0 + slope;
}

/* The clearance a part x of the step on. */
static double clearance_between(const coin_priv_tested_step *step,
                                const struct end *a, const struct end *b,
                                double x)
{
    coin_priv_slip at;
    between(&at, a, b, x);
    return coin_priv_clearance(step->contact, &at,
                               step->slopes == coin_priv_slip_slopes);
}

coin_priv_verdict coin_priv_test_cone(const coin_priv_tested_step *step,
                                      double *part)
{
    struct end a, b;
    const double s2 = step->stride * step->stride;
    const int closely = step->contact->mu_static > 0 && step->stride > SHORT;
    const double miss = closely ? COIN_PRIV_MISS * s2 * s2 * s2 : 0;
    const double places = PLACES, edge = EDGE / places;
    double m[PLACES + 1];
    *part = 0.5;
    end_of(&a, step, step->from);
    end_of(&b, step, step->to);
    for (int k = 0; k <= PLACES; ++k)
        m[k] = clearance_between(step, &a, &b, k / places);
    if (closely && least_beside(m[0], clearance_between(step, &a, &b, edge), m,
                                1) < (m[0] < miss ? 0 : miss))
        return COIN_PRIV_UNCLEAR;
    for (int k = 1; k < PLACES; ++k) {
        if (m[k] < -miss) {
            *part = k / places;
            return COIN_PRIV_LEAVES;
        }
        if (least(m, k) < miss)
            return COIN_PRIV_UNCLEAR;
    }
    const double last = clearance_between(step, &a, &b, 1 - edge);
    if (closely && m[PLACES] >= 0 &&
        least_beside(m[PLACES], last, m, PLACES - 1) <
            (m[PLACES] < miss ? 0 : miss))
        return COIN_PRIV_UNCLEAR;
    *part = 1;
    return COIN_PRIV_STAYS;
}
