/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc would move arithmetic behind the branches that use it. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("no-tree-sink")
#endif

#include "../motion/angles.h"
#include "../motion/state.h"
#include "pair.h"
#include "pieces.h"
#include "steady_at.h"

#include <math.h>

#define ELEMENT COIN_PRIV_ELEMENT
#define ROW_AT(rows, row, t)                                                   \
    coin_priv_row_at((rows) + COIN_PRIV_TERMS * (row), t)

/* The piece that contains the time t: the number of edges between pieces that
 * are not beyond t.  Unlike in a binary search, no comparison waits for
 * another. */
static inline int piece_at(const double *edge, int count, double t)
{
    int piece = 0;
    for (int i = 1; i < count; ++i)
        piece += edge[i] <= t;
    return piece;
}

/* An angle: that at A, start[0] + start[1], plus what k periods add, plus
 * since_A.  The products with part[0] and part[1] are exact.  That with part[0]
 * is the largest and is added first. */
static inline double angle_after(const double start[2], const double part[3],
                                 double k, double since_A)
{
    return (start[0] + k * part[0]) +
           ((k * part[1] + (since_A + start[1])) + k * part[2]);
}

/* Sets z and x, on the table and k periods later, from those in A's frame.
 * (58) */
static inline void set_place(coin_state *at, const double *f, double k,
                             double z, double x)
{
    const double *b = f + COIN_PRIV_TURN;
    /* Leaves out whole half turns.  An odd number of them would change the
     * signs of kb.s and kb.c, and so none of their products. */
    const double nearest = coin_priv_round(k * b[0]);
    const double half_turns = ((k * b[0] - nearest) + k * b[1]) + k * b[2];
    const coin_priv_sc kb =
        coin_priv_sincos(2 * COIN_PRIV_HALF_PI * half_turns);
    const double c = kb.c * kb.c - kb.s * kb.s, s = 2 * kb.c * kb.s;
    const double D = f[COIN_PRIV_SWING] * kb.s + f[COIN_PRIV_DRIFT] * k;
    const double zk = z * c - x * s - D * kb.s; /* (58) */
    const double xk = x * c + z * s + D * kb.c; /* (58) */
    const double C = f[COIN_PRIV_AXIS], S = f[COIN_PRIV_AXIS + 1];
    at->z = f[COIN_PRIV_PLACE] + (zk * C - xk * S);
    at->x = f[COIN_PRIV_PLACE + 1] + (xk * C + zk * S);
}

/* *out becomes *at, unless that is out of range. */
static int32_t end(const coin_orbit *o, const coin_state *at, coin_state *out)
{
    const double *f = o->private_frame;
    if (!coin_priv_members_in_range(at, f[COIN_PRIV_FAR], f[COIN_PRIV_W2_MAX]))
        return COIN_ERANGE;
    *out = *at;
    return COIN_OK;
}

static int32_t steady_at(const coin_orbit *o, double t, coin_state *out)
{
    const double *f = o->private_frame, *s = o->private_terms;
    const double most = COIN_PRIV_TIME_MAX * COIN_PRIV_RATE_MAX;
    if (!(t * t * f[COIN_PRIV_W2_MAX] <= most * most))
        return COIN_ESTEP;
    const coin_priv_steady rates = {
        f[COIN_PRIV_STEADY_HEADING],
        f[COIN_PRIV_STEADY_ROLL],
        f[COIN_PRIV_STEADY_SPEED],
    };
    coin_state at = {
        s[COIN_PRIV_THETA], s[COIN_PRIV_PHI],      s[COIN_PRIV_PSI],
        s[COIN_PRIV_X],     s[COIN_PRIV_Z],        0,
        s[COIN_PRIV_ROWS],  s[COIN_PRIV_ROWS + 1],
    };
    coin_priv_steady_move(&at, &rates, t);
    return end(o, &at, out);
}

/* The state in a piece a time tau after its centre, moved on by k periods.  If
 * side is -1, the mirror image of that state: that before A instead of after
 * A. */
COIN_PRIV_INLINE coin_state state_at(const coin_orbit *o, int piece, double tau,
                                     double side, double k)
{
    const double *f = o->private_frame;
    const double *rows = coin_priv_row(o, piece, COIN_PRIV_THETA);
    const coin_priv_pair th = ROW_AT(rows, COIN_PRIV_THETA, tau);
    const coin_priv_pair phi = ROW_AT(rows, COIN_PRIV_PHI, tau);
    const coin_priv_pair psi = ROW_AT(rows, COIN_PRIV_PSI, tau);
    const coin_priv_pair z = ROW_AT(rows, COIN_PRIV_Z, tau);
    const coin_priv_pair x = ROW_AT(rows, COIN_PRIV_X, tau);
    const coin_priv_sc lean = coin_priv_sine_cosine(ELEMENT(th, 0));
    const double rate = f[COIN_PRIV_RATE];
    coin_state at = {
        ELEMENT(th, 0),
        angle_after(f + COIN_PRIV_PHI0, f + COIN_PRIV_HEADING, k,
                    side * ELEMENT(phi, 0)),
        angle_after(f + COIN_PRIV_PSI0, f + COIN_PRIV_ROLL, k,
                    side * ELEMENT(psi, 0)),
        0,
        0,
        side * ELEMENT(th, 1) * rate,
        0,
        0,
    };
    coin_priv_spin_rates(&at.wY, &at.wZ, ELEMENT(phi, 1) * rate,
                         ELEMENT(psi, 1) * rate, lean);
    set_place(&at, f, k, ELEMENT(z, 0), side * ELEMENT(x, 0));
    return at;
}

int32_t coin_orbit_at(const coin_orbit *o, double t, coin_state *out)
{
    if (!o || !out || o->private_frame[0] != COIN_PRIV_FORMAT)
        return COIN_EARG;
    if (o->period == 0)
        return steady_at(o, t, out);
    const double *f = o->private_frame, *T = f + COIN_PRIV_PERIOD;
    const double count = f[COIN_PRIV_COUNT];
    if (!(count > 0 && count <= (int)COIN_PRIV_PIECES))
        return COIN_EARG;
    if (!(fabs(t) / COIN_PRIV_ANGLE_MAX < o->period))
        return COIN_ESTEP;
    const double now = t * f[COIN_PRIV_RATE];
    const double periods = (now + f[COIN_PRIV_SINCE]) * f[COIN_PRIV_OVER];
    /* r is the time since the nearest A.  Before A, where r < 0, the motion is
     * the mirror image of that after A, (57). */
    const double k = coin_priv_round(periods);
    const double r =
        (((now - k * T[0]) - k * T[1]) + f[COIN_PRIV_SINCE]) - k * T[2];
    const double side = copysign(1, r), since = fabs(r);
    const int piece = piece_at(o->private_edges, (int)count, since);
    const double tau = since - o->private_centers[piece];
    const coin_state at = state_at(o, piece, tau, side, k);
    return end(o, &at, out);
}
