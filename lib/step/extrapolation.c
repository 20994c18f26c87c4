/* SPDX-License-Identifier: MIT */
/* One step of order 14 in tau: extrapolation (Gragg, Bulirsch, Stoer) of the
 * modified midpoint rule with 2, 4, ..., 12 and 16 substeps.
 *
 * The column of n substeps of h = H/n is
 *
 *     y_1 = y_0 + h f(y_0),   y_(k+1) = y_(k-1) + 2h f(y_k),   k = 1 ... n-1,
 *
 * and the error of y_n is a series in h^2, of which a weighted sum of seven
 * columns removes six terms.  No smoothing step is made.  The columns do not
 * depend on each other, so that each lane of a vector takes one.  The variables
 * are changes from y_0, whose rounding is smaller than that of y.
 *
 * Units within this file: the unit of time is H/120, of which every 2h is an
 * exact multiple.  Z is wZ times k1 = I_Z/I_X, which saves a product. */
#include "../motion/pinned.h"

/* With the first two options gcc puts each result in another register, so that
 * a substep does not wait until the substep before it has freed its registers.
 * With the third it does not move the sums at a step's end behind the branch
 * that uses them.  In vectors of four they save nothing. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__) &&         \
    defined(__x86_64__) && !defined(__AVX__)
#pragma GCC optimize("rename-registers", "no-tree-ter", "no-tree-sink")
#endif

#include "extrapolation.h"
#include "sundman.h"

/* How many columns are computed side by side; 1 without vectors.  The bits do
 * not depend on it. */
#ifndef LANES
#if COIN_PRIV_WIDTH > 16
#define LANES 4
#elif COIN_PRIV_WIDTH == 16
#define LANES 2
#else
#define LANES 1
#endif
#endif
#include "../motion/vector.t.h"

/* The columns of 16, 12, 10, ..., 2 substeps, and that of 2 once more, of
 * weight 0, where lanes are left over. */
enum { COLUMNS = 8, GROUPS = COLUMNS / LANES };

struct variables {
    lanes X, Y, Z, sth, cth, sph, cph;
};
#define EACH_VARIABLE(F) F(X) F(Y) F(Z) F(sth) F(cth) F(sph) F(cph)

/* Sums over the odd substeps, times 2h: of the slopes of psi, x and z, and of
 * the changes of Y and cos theta, which are the slopes of phi and of the time.
 */
struct path {
    lanes psi, x, z, dY, dcth;
};

/* As many columns as there are lanes: 2h, and the changes at the latest even
 * and the latest odd substep.  All members are lanes: total() reads several of
 * them as an array. */
struct columns {
    lanes h2;
    struct variables even, odd;
    struct path path;
};

/* What all columns share: the start, and the coefficients of (32). */
struct problem {
    struct variables start;
    lanes G, KJ, XJ, k, Z;
};

/* ---------------------------------------------------------------- tables -- */
/* 2h. */
static const double double_substep[] = {15, 20, 24, 30, 40, 60, 120, 120};

/* The weight of the column of n substeps: the product of n^2/(n^2 - m^2) over
 * the columns of m substeps.  GRID rounds a weight to a multiple of 2^-49, so
 * that the sums in C2 are exact and the weights add up to 1.  With columns
 * of 2, 4, ..., 14 substeps the weights would be twice as large, and with them
 * the effect of rounding. */
#define GRID(x) (((x) + 12) - 12)
#define C16 GRID(268435456.0 / 42567525.0)
#define C12 GRID(-157464.0 / 13475.0)
#define C10 GRID(244140625.0 / 31135104.0)
#define C8 GRID(-65536.0 / 42525.0)
#define C6 GRID(19683.0 / 246400.0)
#define C4 GRID(-8.0 / 14175.0)
#define C2 (1 - (C16 + C12 + C10 + C8 + C6 + C4))
static const double weight[] = {C16, C12, C10, C8, C6, C4, C2, 0};

/* The weights of the columns of 12, 10, ..., 2 substeps alone, of order 12,
 * minus those above. */
static const double weight_of_error[] = {
    -C16,
    279936.0 / 13475.0,
    -9765625.0 / 486486.0,
    262144.0 / 42525.0,
    -2187.0 / 3850.0,
    128.0 / 14175.0,
    -1.0 / 297675.0,
    0,
};

COIN_PRIV_INLINE lanes all(double value)
{
    const lanes none = {0};
    return (none + 1) * value;
}

/* -------------------------------------------------------------- substeps -- */
/* Adds 2h f(y), (32). */
COIN_PRIV_INLINE void add_slope(struct variables *to, const struct problem *p,
                                const struct variables *y,
                                const lanes *double_step)
{
    const lanes X = y->X, Y = y->Y, sth = y->sth, cth = y->cth;
    const lanes h2 = *double_step;
    const lanes hX = h2 * X, hY = h2 * Y, hcth = h2 * cth;
    const lanes m = cth * X, n = cth * y->Z, e = sth * Y;
    to->X = (to->X + (p->G * sth) * hcth) - hY * (p->KJ * n + p->XJ * e);
    to->Y = to->Y + hX * (e + n);
    to->Z = to->Z + (p->k * hY) * m;
    to->sth = to->sth + hcth * m;
    to->cth = to->cth - hcth * (sth * X);
    to->sph = to->sph + hY * y->cph;
    to->cph = to->cph - hY * y->sph;
}

#define AT_EVEN(v) p->start.v + c->even.v,
#define AT_ODD(v) p->start.v + c->odd.v,

COIN_PRIV_INLINE void even_substep(struct columns *c, const struct problem *p)
{
    const struct variables y = {EACH_VARIABLE(AT_EVEN)};
    add_slope(&c->odd, p, &y, &c->h2);
}

COIN_PRIV_INLINE void odd_substep(struct columns *c, const struct problem *p)
{
    const struct variables y = {EACH_VARIABLE(AT_ODD)};
    const lanes dps = c->h2 * ((y.cth * y.Z) * p->Z + y.sth * y.Y);
    add_slope(&c->even, p, &y, &c->h2);
    c->path.psi = c->path.psi + dps;
    c->path.x = c->path.x - dps * y.cph;
    c->path.z = c->path.z + dps * y.sph;
    c->path.dY = c->path.dY + c->h2 * c->odd.Y;
    c->path.dcth = c->path.dcth + c->h2 * c->odd.cth;
}

#if LANES > 1
/* Ends the columns beyond the first `on` lanes: their step becomes 0. */
COIN_PRIV_INLINE void keep(struct columns *c, int on)
{
    static const double on_lanes[] = {1, 1, 1, 0, 0, 0};
    c->h2 = c->h2 * load(on_lanes + 3 - on);
}
#endif

/* ------------------------------------------------------------ the columns --
 */
/* An even substep of group g and the odd one after it.  Two groups take turns,
 * so that one computes while the other waits for its sums.  all_substeps() has
 * loops, because code that runs once has to wait for the cache. */
#define ROUND(g)                                                               \
    even_substep(&c[g], p);                                                    \
    odd_substep(&c[g], p);
#define ROUND_OF(g, on)                                                        \
    keep(&c[g], on);                                                           \
    ROUND(g)

#if LANES == 4
COIN_PRIV_INLINE void all_substeps(struct columns *c, const struct problem *p)
{
    static const int last[] = {3, 2, 1, 1};
    odd_substep(&c[0], p);
    odd_substep(&c[1], p);
    for (int on = 2; on > 0; --on) {
        ROUND(0)
        ROUND_OF(1, on)
    }
    ROUND(0)
    for (int i = 0; i < 4; ++i) {
        ROUND_OF(0, last[i])
    }
}
#elif LANES == 2
COIN_PRIV_INLINE void all_substeps(struct columns *c, const struct problem *p)
{
    odd_substep(&c[0], p);
    odd_substep(&c[1], p);
    for (int i = 0; i < 4; ++i) {
        ROUND(0)
        ROUND_OF(1, i < 3 ? 2 : 1)
    }
    odd_substep(&c[2], p);
    for (int on = 2; on > 0; --on) {
        ROUND_OF(0, on)
        ROUND_OF(2, on)
    }
    ROUND_OF(0, 1)
    odd_substep(&c[3], p);
}
#else
static void all_substeps(struct columns *c, const struct problem *p)
{
    static const int half_substeps[] = {8, 6, 5, 4, 3, 2, 1, 1};
    for (int i = 0; i < COLUMNS; ++i) {
        odd_substep(&c[i], p);
        for (int k = 1; k < half_substeps[i]; ++k) {
            even_substep(&c[i], p);
            odd_substep(&c[i], p);
        }
    }
}
#endif

/* The weighted sum over all columns of a member, which is that of the first
 * column here, added in the same order whatever LANES. */
COIN_PRIV_INLINE double total(const lanes *member, const double *weights)
{
    const size_t column = sizeof(struct columns) / sizeof(lanes);
#define TERM(i) (load(weights + (i)*LANES) * member[(i)*column])
#if LANES == 4
    const lanes v = TERM(0) + TERM(1);
    return (v[0] + v[2]) + (v[1] + v[3]);
#elif LANES == 2
    const lanes v = (TERM(0) + TERM(2)) + (TERM(1) + TERM(3));
    return v[0] + v[1];
#else
    return ((TERM(0) + TERM(4)) + (TERM(2) + TERM(6))) +
           ((TERM(1) + TERM(5)) + (TERM(3) + TERM(7)));
#endif
}

/* The end of the step, and what it adds to the pose.  The columns integrate the
 * path of the point of contact; (21) gives that of the centre. */
COIN_PRIV_INLINE void add_totals(coin_priv_variables *to, coin_priv_pose *adds,
                                 const coin_priv_variables *y,
                                 const struct columns *c,
                                 const coin_priv_constants *b, double unit)
{
    const double rate = 1 / unit;
    to->wX = y->wX + rate * total(&c->even.X, weight);
    to->wY = y->wY + rate * total(&c->even.Y, weight);
    to->wZ = y->wZ + (rate / b->k1) * total(&c->even.Z, weight);
    to->sth = y->sth + total(&c->even.sth, weight);
    to->cth = y->cth + total(&c->even.cth, weight);
    to->sph = y->sph + total(&c->even.sph, weight);
    to->cph = y->cph + total(&c->even.cph, weight);
    coin_priv_normalize(to);
    adds->theta = 0;
    adds->phi = 120 * (unit * y->wY) + total(&c->path.dY, weight);
    adds->psi = total(&c->path.psi, weight);
    adds->x = total(&c->path.x, weight) + (to->sth * to->sph - y->sth * y->sph);
    adds->z = total(&c->path.z, weight) + (to->sth * to->cph - y->sth * y->cph);
    adds->t = unit * (120 * y->cth + total(&c->path.dcth, weight));
}

/* The largest difference of order 12 from order 14, of the sines and cosines
 * and of psi: angles all.  That of cos theta is a part of it; q is its inverse.
 * The height of a low bounce decides when the coin next comes close to flat,
 * and there it moves the faster, the lower the bounce.  Next to flat the others
 * are small, and that of cos theta may be 0 by chance.  So wX is asked too:
 * what it would turn in the time of the step.  1 if the largest is more, or is
 * not a number, and at least a rounding.  With all twelve sums the estimate
 * would be no better. */
COIN_PRIV_INLINE double error_of(const struct columns *c, double q)
{
    const double e[] = {
        total(&c->even.sth, weight_of_error),
        total(&c->even.cth, weight_of_error) * q,
        total(&c->even.sph, weight_of_error),
        total(&c->even.cph, weight_of_error),
        total(&c->path.psi, weight_of_error),
        120 * total(&c->even.X, weight_of_error),
    };
    double most = DBL_EPSILON;
    for (int i = 0; i < 6; ++i)
        most = coin_priv_larger(fabs(e[i]), most);
    return coin_priv_lesser(most, 1);
}

COIN_PRIV_INLINE struct problem problem_of(const coin_priv_variables *y,
                                           const coin_priv_constants *b,
                                           double unit)
{
    const struct problem p = {
        {
            all(unit * y->wX),
            all(unit * y->wY),
            all(unit * b->k1 * y->wZ),
            all(y->sth),
            all(y->cth),
            all(y->sph),
            all(y->cph),
        },
        all(unit * unit * b->GJ),
        all(b->KJ / b->k1),
        all(b->XJ),
        all(b->k1 * b->k2),
        all(1 / b->k1),
    };
    return p;
}

#define FIRST(v) (0.5 * h2) * slope->v,
COIN_PRIV_INLINE struct columns columns_of(int group,
                                           const struct variables *slope)
{
    const lanes h2 = load(double_substep + group * LANES), none = {0};
    const struct columns c = {
        h2,
        {none, none, none, none, none, none, none},
        {EACH_VARIABLE(FIRST)},
        {none, none, none, none, none},
    };
    return c;
}

#define GROUP(i) columns[i] = columns_of(i, slope);
COIN_PRIV_INLINE void start_columns(struct columns *columns,
                                    const struct variables *slope)
{
#if LANES == 4
    GROUP(0) GROUP(1)
#elif LANES == 2
    GROUP(0) GROUP(1) GROUP(2) GROUP(3)
#else
    for (int i = 0; i < GROUPS; ++i)
        GROUP(i)
#endif
}

int coin_priv_extrapolate(coin_priv_run *r, double tau, double *error)
{
    const double unit = tau / 120;
    const lanes none = {0}, one = none + 1;
    const struct problem p = problem_of(&r->g.y, &r->b, unit);
    struct columns columns[GROUPS];
    struct variables slope = {none, none, none, none, none, none, none};
    coin_priv_variables to;
    coin_priv_pose adds;
    add_slope(&slope, &p, &p.start, &one);
    start_columns(columns, &slope);
    all_substeps(columns, &p);
    add_totals(&to, &adds, &r->g.y, columns, &r->b, unit);
    const double most = *error;
    *error = to.cth > 0 ? error_of(columns, to.q) : 1;
    return to.cth > 0 && *error <= most && coin_priv_accept_step(r, &to, &adds);
}
