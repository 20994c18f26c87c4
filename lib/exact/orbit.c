/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "half_period.h"

#include <math.h>
#include <string.h>

#define ELEMENT COIN_PRIV_ELEMENT

/* An orbit whose conditioning is above this is refused. */
#define CONDITIONING_MAX 1e12

/* An orbit whose lean comes nearer to flat than this is refused.  There the
 * rounding of theta, 1e-16, is 1e-7 of the angle from flat.  The pieces would
 * suffice nearer too: of 500 random falls from within 1e-3 rad of flat this
 * limit refuses 136 (make tuning). */
#define LEAN_MAX (COIN_PRIV_HALF_PI - 1e-9)

/* If half of the heading gained in a period differs from a multiple of pi by
 * less than this, it is rounding, and the path drifts (held by test_orbit). */
#define STRAIGHT 1e-15

/* Least acceleration of the lean, in the orbit's unit of time, for which
 * conditioning_of() does not underflow: steady to rounding if it is stable. */
#define ACCELERATION_MIN 1e-70

/* What may be missing at the radii, in parts of the larger: a tenth of what
 * coin.h admits. */
#define MISSING 1e-13

/* An extreme of the distance is located to this part of the length of its
 * piece.  With 1e-8 a least radius of 6e-10 of the larger is wrong by
 * half of itself (test_orbit). */
#define FOUND 1e-12

/* ------------------------------------------------------------- the frame -- */
/* Measures times, angles and path of all pieces from A, in A's frame. */
static void measure_from_A(const coin_priv_half_period *h)
{
    coin_orbit *o = h->o;
    const coin_priv_turning_point *A = &h->A;
    const coin_priv_sc ph = coin_priv_sincos(A->phi);
    double *term = o->private_terms;
    o->private_edges[0] = A->time;
    o->private_edges[h->count] = h->B.time;
    for (int n = 0; n <= h->count; ++n)
        o->private_edges[n] -= A->time;
    for (int n = 0; n < h->count; ++n) {
        o->private_centers[n] -= A->time;
        double *z = term + COIN_PRIV_Z * COIN_PRIV_TERMS;
        double *x = term + COIN_PRIV_X * COIN_PRIV_TERMS;
        term[COIN_PRIV_PHI * COIN_PRIV_TERMS] -= A->phi;
        term[COIN_PRIV_PSI * COIN_PRIV_TERMS] -= A->psi;
        *z -= A->z;
        *x -= A->x;
        for (int k = 0; k < COIN_PRIV_TERMS; ++k) {
            const double zk = z[k], xk = x[k];
            z[k] = zk * ph.c + xk * ph.s;
            x[k] = xk * ph.c - zk * ph.s;
        }
        term += COIN_PRIV_PIECE;
    }
}

/* An angle in turns, less the nearest whole number of them, in three parts: the
 * products of its parts and those of 1/(2 pi).  All but the last products are
 * exact. */
static void split_turns(double part[3], double angle)
{
    double a[3], b[3];
    coin_priv_split(a, angle, 0);
    coin_priv_split(b, 0.15915494309189535, -9.839338337591067e-18);
    const double first = a[0] * b[0] - coin_priv_round(a[0] * b[0]);
    coin_priv_split(part, first,
                    (a[0] * b[1] + a[1] * b[0]) +
                        (a[0] * b[2] + a[1] * b[1] + a[2] * b[0]));
}

static void set_times(const coin_priv_half_period *h)
{
    coin_orbit *o = h->o;
    double *f = o->private_frame;
    const double period = 2 * (h->B.time - h->A.time); /* (55) */
    f[COIN_PRIV_RATE] = h->rate;
    f[COIN_PRIV_COUNT] = h->count;
    f[COIN_PRIV_SINCE] = -h->A.time;
    f[COIN_PRIV_OVER] = 1 / period;
    coin_priv_split(f + COIN_PRIV_PERIOD, period, 0);
    o->period = period / h->rate;
}

static void set_angles(const coin_priv_half_period *h, const coin_state *s,
                       double a)
{
    coin_orbit *o = h->o;
    double *f = o->private_frame;
    const coin_priv_turning_point *A = &h->A, *B = &h->B;
    const coin_priv_sc ph = coin_priv_sincos(s->phi);
    const coin_priv_sc by = coin_priv_sincos(A->phi); /* phi + A's is rounded */
    o->heading_per_period = 2 * (B->phi - A->phi);    /* (57) */
    o->roll_per_period = 2 * (B->psi - A->psi);       /* (57) */
    o->theta_min = A->theta < B->theta ? A->theta : B->theta;
    o->theta_max = A->theta < B->theta ? B->theta : A->theta;
    coin_priv_split(f + COIN_PRIV_HEADING, o->heading_per_period, 0);
    coin_priv_split(f + COIN_PRIV_ROLL, o->roll_per_period, 0);
    split_turns(f + COIN_PRIV_TURN, o->heading_per_period);
    f[COIN_PRIV_PHI0] = s->phi;
    f[COIN_PRIV_PHI0 + 1] = A->phi;
    f[COIN_PRIV_PSI0] = s->psi;
    f[COIN_PRIV_PSI0 + 1] = A->psi;
    f[COIN_PRIV_AXIS] = a * (ph.c * by.c - ph.s * by.s);
    f[COIN_PRIV_AXIS + 1] = a * (ph.s * by.c + ph.c * by.s);
    f[COIN_PRIV_PLACE] = s->z + a * (A->z * ph.c - A->x * ph.s);
    f[COIN_PRIV_PLACE + 1] = s->x + a * (A->x * ph.c + A->z * ph.s);
}

/* ------------------------------------------------------------ the annulus --
 */
/* A point of a piece.  u: its time since the piece's centre, in parts of the
 * piece's reach.  distance: from the centre of the annulus, which lies on A's
 * axis.  slope: half of the derivative of its square by u. */
struct place {
    double u, distance, slope;
};

/* The derivative of the slope by u, in powers of u; and a bound of its own
 * derivative. */
enum { BEND_TERMS = 2 * COIN_PRIV_TERMS - 3 };
struct bend {
    double term[BEND_TERMS], bound;
};

/* A row of a piece a time after its centre, and its derivative. */
static coin_priv_pair row_at(const coin_orbit *o, int piece, int row, double t)
{
    return coin_priv_row_at(coin_priv_row(o, piece, row), t);
}

/* Widens the annulus to a point of a piece, and returns this. */
static struct place widen_to(coin_orbit *o, int piece, double reach, double u,
                             double center)
{
    const coin_priv_pair z = row_at(o, piece, COIN_PRIV_Z, u * reach);
    const coin_priv_pair x = row_at(o, piece, COIN_PRIV_X, u * reach);
    const double away = ELEMENT(z, 0) - center;
    const struct place at = {
        u,
        coin_priv_hypot(away, ELEMENT(x, 0)),
        reach * (away * ELEMENT(z, 1) + ELEMENT(x, 0) * ELEMENT(x, 1)),
    };
    o->radius_min = coin_priv_lesser(o->radius_min, at.distance);
    o->radius_max = coin_priv_larger(o->radius_max, at.distance);
    return at;
}

/* Widens the annulus to where the slope is 0 between two points, if its sign
 * changes, by the secant with halved weights (Illinois). */
static void widen_to_extreme(coin_orbit *o, int piece, double reach,
                             struct place left, struct place right,
                             double center)
{
    while (left.slope * right.slope < 0 && fabs(right.u - left.u) > FOUND) {
        const double u = (left.u * right.slope - right.u * left.slope) /
                         (right.slope - left.slope);
        const struct place middle = widen_to(o, piece, reach, u, center);
        if (middle.slope * right.slope > 0)
            left.slope /= 2;
        else
            left = right;
        right = middle;
    }
}

static struct bend bend_of(const coin_orbit *o, int piece, double reach,
                           double center)
{
    const double *row_z = coin_priv_row(o, piece, COIN_PRIV_Z);
    const double *row_x = coin_priv_row(o, piece, COIN_PRIV_X);
    double z[COIN_PRIV_TERMS], x[COIN_PRIV_TERMS], power = 1;
    struct bend bend = {{0}, 0};
    for (int i = 0; i < COIN_PRIV_TERMS; ++i, power *= reach) {
        z[i] = (row_z[i] - (i == 0 ? center : 0)) * power;
        x[i] = row_x[i] * power;
    }
    for (int i = 0; i < COIN_PRIV_TERMS; ++i)
        for (int j = i < 2 ? 2 - i : 0; j < COIN_PRIV_TERMS; ++j)
            bend.term[i + j - 2] += z[i] * z[j] + x[i] * x[j];
    for (int k = 0; k < BEND_TERMS; ++k) {
        bend.term[k] *= (k + 2) * (k + 1) / 2;
        bend.bound += k * fabs(bend.term[k]);
    }
    return bend;
}

/* How far beyond a point there is one extreme at most, or too little to miss:
 * as far as the bend surely keeps its sign, or the slope does, or MISSING says.
 */
static double stride(const coin_orbit *o, const struct bend *bend,
                     struct place at)
{
    const double slope = fabs(at.slope), R = o->radius_max;
    const double least = MISSING * R * (at.distance + MISSING * R);
    double b = 0;
    for (int k = BEND_TERMS; k-- > 0;)
        b = b * at.u + bend->term[k];
    b = fabs(b);
    const double keeps =
        2 * slope / (b + sqrt(b * b + 2 * bend->bound * slope));
    return coin_priv_larger(coin_priv_larger(keeps, b / bend->bound),
                            sqrt(least / bend->bound));
}

/* Widens the annulus to a piece.  Of 30,000 orbits one takes 26 points in the
 * mean, and 200 at most. */
static void widen_to_piece(coin_orbit *o, int piece, double center)
{
    const double t = o->private_centers[piece];
    const double from = o->private_edges[piece] - t;
    const double to = o->private_edges[piece + 1] - t;
    const double reach = coin_priv_larger(fabs(from), fabs(to));
    const double end = to / reach;
    const struct bend bend = bend_of(o, piece, reach, center);
    struct place at = widen_to(o, piece, reach, from / reach, center);
    while (at.u < end) {
        const double u = at.u + stride(o, &bend, at);
        const struct place next =
            widen_to(o, piece, reach, u < end ? u : end, center);
        widen_to_extreme(o, piece, reach, at, next, center);
        at = next;
    }
}

static void set_path(const coin_priv_half_period *h, double a)
{
    coin_orbit *o = h->o;
    double *f = o->private_frame;
    const double *turn = f + COIN_PRIV_TURN;
    const double cA = f[COIN_PRIV_AXIS], sA = f[COIN_PRIV_AXIS + 1];
    const coin_priv_sc ph = coin_priv_sincos(h->A.phi);
    const double dz = h->B.z - h->A.z, dx = h->B.x - h->A.x;
    const double z = dz * ph.c + dx * ph.s, x = dx * ph.c - dz * ph.s;
    const double b = 2 * COIN_PRIV_HALF_PI * (turn[0] + (turn[1] + turn[2]));
    const coin_priv_sc by = coin_priv_sincos(b);
    const double L = 2 * (x * by.c - z * by.s); /* from (58) */
    const int straight = fabs(b) < STRAIGHT / COIN_PRIV_ANGLE_MAX;
    f[COIN_PRIV_SWING] = straight ? 0 : L / by.s; /* from (58) */
    f[COIN_PRIV_DRIFT] = straight ? L : 0;
    if (fabs(b) < STRAIGHT) {
        o->center[0] = o->center[1] = (double)NAN;
        o->radius_min = o->radius_max = (double)NAN;
        o->drift[0] = L * cA;
        o->drift[1] = -L * sA;
        return;
    }
    const double center = z - x * by.c / by.s;    /* from (58) */
    o->radius_min = o->radius_max = fabs(center); /* that of A */
    for (int n = 0; n < h->count; ++n)
        widen_to_piece(o, n, center);
    o->radius_min *= a;
    o->radius_max *= a;
    o->center[0] = f[COIN_PRIV_PLACE + 1] + center * sA;
    o->center[1] = f[COIN_PRIV_PLACE] + center * cA;
}

/* ------------------------------------------------------------- the motion --
 */
/* The variables a time after a piece's centre.  The pair of the heading is left
 * out. */
static coin_priv_variables variables_at(const coin_orbit *o, int piece,
                                        double t)
{
    const coin_priv_pair th = row_at(o, piece, COIN_PRIV_THETA, t);
    const coin_priv_pair phi = row_at(o, piece, COIN_PRIV_PHI, t);
    const coin_priv_pair psi = row_at(o, piece, COIN_PRIV_PSI, t);
    const coin_priv_sc sc = coin_priv_sincos(ELEMENT(th, 0));
    const double q = 1 / sc.c;
    coin_priv_variables y = {
        ELEMENT(th, 1), 0, 0, sc.s, sc.c, q, q * sc.s, 0, 1,
    };
    coin_priv_spin_rates(&y.wY, &y.wZ, ELEMENT(phi, 1), ELEMENT(psi, 1), sc);
    return y;
}

/* d(wX)/dt. */
static double acceleration(const coin_priv_half_period *h,
                           const coin_priv_variables *y)
{
    return coin_priv_slopes_at(&h->field, y).wX;
}

/* The integral of this from A to B is -J/2 dT/dE, for any k.  dT/dE is an
 * integral of 1/wX^2, which is infinite at A and B.  So the time derivative of
 * a/(wX Q) has been added, whose infinities cancel these: a = d(wX)/dt, and
 * Q = a^2 + (k wX)^2.  If k is the frequency of a small swing, the sum is small
 * all along the swing. */
static double period_slope(const coin_priv_half_period *h,
                           const coin_priv_variables *y, double k)
{
    const double kv = k * y->wX, a = acceleration(h, y), Q = a * a + kv * kv;
    return (k * k + coin_priv_fall_slope(&h->b, y)) * (kv - a) * (kv + a) /
           (Q * Q);
}

/* 1 + J/2 |dT/dE| s^2/w with w^2 = 2E/J.  s is the larger of the accelerations
 * of theta at A and B, but at most w^2. */
static double conditioning_of(const coin_priv_half_period *h)
{
    const coin_orbit *o = h->o;
    const coin_priv_constants *b = &h->b;
    const double *t = o->private_centers, *edge = o->private_edges;
    const int last = h->count - 1;
    const double half = edge[h->count];
    const coin_priv_variables A = variables_at(o, 0, -t[0]);
    const coin_priv_variables B = variables_at(o, last, half - t[last]);
    const double w2 = b->XJ * A.wY * A.wY + b->KJ * A.wZ * A.wZ +
                      2 * b->GJ * A.cth; /* from (23) */
    const double at_A = fabs(acceleration(h, &A));
    const double at_B = fabs(acceleration(h, &B));
    const double s = coin_priv_lesser(coin_priv_larger(at_A, at_B), w2);
    const double k = 2 * COIN_PRIV_HALF_PI / half;
    if (!(s > ACCELERATION_MIN))
        return (double)INFINITY;
    double sum = 0;
    for (int n = 0; n < h->count; ++n) {
        const double length = edge[n + 1] - edge[n];
        const double mid = (edge[n] + edge[n + 1]) / 2 - t[n];
        for (int i = -1; i < 2; ++i) { /* Gauss' three points */
            const double at = mid + i * (0.7745966692414834 / 2) * length;
            const coin_priv_variables y = variables_at(o, n, at);
            sum += length * (i == 0 ? 8.0 / 18 : 5.0 / 18) *
                   period_slope(h, &y, k);
        }
    }
    return 1 + fabs(sum) * (s * s / sqrt(w2));
}

/* RATE_MIN: the least rate of a swing, in parts of the root of the terms of
 * (14). CURVATURE: 8 times a bound of the second derivative of these terms by
 * the lean, in parts of their sum over cos theta. */
#define RATE_MIN 1e-5
#define CURVATURE 80

/* Whether the lean is constant to rounding: its swing is below the rounding of
 * the lean, or its acceleration below that of the terms of (14).  -1 if
 * rounding decides whether it is stable and an eighth of its well holds the
 * swing. */
static int is_steady(const coin_priv_half_period *h)
{
    const coin_priv_variables y = coin_priv_point_variables(h->now.at);
    const double L = coin_priv_fall_slope(&h->b, &y);
    const double dwX = acceleration(h, &y), wX = y.wX;
    const double terms = h->b.GJ * fabs(y.sth) + h->b.KJ * fabs(y.wY * y.wZ) +
                         h->b.XJ * y.wY * y.wY * fabs(y.tth); /* from (14) */
    const double least = L < 0 && -L > terms ? -L : terms;
    const double rate = coin_priv_larger(sqrt(fabs(L)), RATE_MIN * sqrt(least));
    const double swing = fabs(wX) * rate + fabs(dwX);
    const int stays = L < 0 && swing * (CURVATURE * terms) <= L * L * y.cth;
    if (!(swing <= 4 * DBL_EPSILON * least))
        return 0;
    if (y.sth == 0) /* it stays upright, stable or not, if wX is 0 */
        return stays || wX == 0;
    return stays ? 1 : -1;
}

static void set_steady(const coin_priv_half_period *h, const coin_state *s,
                       double a)
{
    const coin_priv_point *p = h->now.at;
    const double heading = ELEMENT(p[1].row[0], 1) * h->rate;
    const double roll = ELEMENT(p[1].row[1], 0) * h->rate;
    const int drifts = s->wZ != 0 && fabs(heading) <= STRAIGHT * fabs(s->wZ);
    const double R =
        s->wZ == 0 || drifts ? 0 : a * s->wZ / heading; /* from (43) */
    const coin_priv_sc ph = coin_priv_sincos(s->phi);
    coin_orbit *o = h->o;
    const double start[] = {s->theta, s->phi, s->psi, s->z, s->x, s->wY, s->wZ};
    o->theta_min = o->theta_max = s->theta;
    o->center[0] = drifts ? (double)NAN : s->x + R * ph.s;
    o->center[1] = drifts ? (double)NAN : s->z + R * ph.c;
    o->radius_min = o->radius_max = drifts ? (double)NAN : fabs(R);
    o->private_frame[COIN_PRIV_STEADY_HEADING] = heading;
    o->private_frame[COIN_PRIV_STEADY_ROLL] = roll;
    o->private_frame[COIN_PRIV_STEADY_SPEED] = a * s->wZ;
    memcpy(o->private_terms, start, sizeof start);
}

/* Returns how many pieces are filled, 0 if there is no orbit. */
static int solve(coin_orbit *o, const coin_state *s,
                 const coin_priv_constants *b)
{
    coin_priv_half_period h;
    o->conditioning = 1;
    o->private_frame[0] = COIN_PRIV_FORMAT;
    o->private_frame[COIN_PRIV_FAR] = COIN_PRIV_PLACE_MAX * b->a;
    o->private_frame[COIN_PRIV_W2_MAX] = b->w2_max;
    coin_priv_half_period_begin(&h, o, s, b);
    const int steady = is_steady(&h);
    if (steady) {
        set_steady(&h, s, b->a);
        return steady > 0;
    }
    if (!coin_priv_half_period_solve(&h))
        return 0;
    if (!(coin_priv_larger(fabs(h.A.theta), fabs(h.B.theta)) < LEAN_MAX))
        return 0;
    measure_from_A(&h);
    set_times(&h);
    set_angles(&h, s, b->a);
    set_path(&h, b->a);
    o->conditioning = conditioning_of(&h);
    return o->conditioning < CONDITIONING_MAX ? h.count : 0;
}

int32_t coin_orbit_init(coin_orbit *o, const coin_state *s,
                        const coin_params *p)
{
    coin_priv_constants b;
    const int32_t status = o ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    coin_orbit made;
    memset(&made, 0, sizeof made);
    if (!solve(&made, s, &b))
        return COIN_EDOMAIN;
    memcpy(o, &made, sizeof made);
    return COIN_OK;
}
