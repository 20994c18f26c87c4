/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "../motion/state.h"
#include "orbit.h"
#include "pair.h"
#include "steady.h"

#include <math.h>

#define OF COIN_PRIV_OF
#define ADD coin_priv_pair_add
#define LOAD coin_priv_pair_load

/* The rank of the piece that a time is in: how many edges but the first are
 * not beyond it, compared one by one, since that waits for nothing. */
static inline int rank_of(const double *edge, int count, double t)
{
    int rank = 0;
    for (int i = 1; i < count; ++i)
        rank += edge[i] <= t;
    return rank;
}

/* A piece a time t after its centre.  Even and odd powers apart make eight
 * chains of dependences that run side by side. */
static inline void piece_at(coin_priv_pair row[4], const double *term, double t)
{
    const coin_priv_pair t1 = coin_priv_pair_both(t);
    const coin_priv_pair t2 = coin_priv_pair_both(t * t);
    const double *p = term + COIN_PRIV_ROWS * (COIN_PRIV_TERMS - 2);
    coin_priv_pair e0 = LOAD(p), e1 = LOAD(p + 2);
    coin_priv_pair e2 = LOAD(p + 4), e3 = LOAD(p + 6);
    coin_priv_pair o0 = LOAD(p + 8), o1 = LOAD(p + 10);
    coin_priv_pair o2 = LOAD(p + 12), o3 = LOAD(p + 14);
    while (p != term) {
        p -= 2 * COIN_PRIV_ROWS;
        e0 = ADD(LOAD(p), e0, t2);
        e1 = ADD(LOAD(p + 2), e1, t2);
        e2 = ADD(LOAD(p + 4), e2, t2);
        e3 = ADD(LOAD(p + 6), e3, t2);
        o0 = ADD(LOAD(p + 8), o0, t2);
        o1 = ADD(LOAD(p + 10), o1, t2);
        o2 = ADD(LOAD(p + 12), o2, t2);
        o3 = ADD(LOAD(p + 14), o3, t2);
    }
    row[0] = ADD(e0, o0, t1);
    row[1] = ADD(e1, o1, t1);
    row[2] = ADD(e2, o2, t1);
    row[3] = ADD(e3, o3, t1);
}

/* What a start and k periods make of an angle that A to now adds.  The large
 * parts are exact; the sum of the small ones comes last. */
static inline double angle_of(const double start[2], const double part[3],
                              double k, double since_A)
{
    return (start[0] + k * part[0]) +
           ((k * part[1] + (since_A + start[1])) + k * part[2]);
}

/* The path k periods on, on the table: that of A's frame, carried.  (58) */
static inline void carry(coin_state *at, const double *f, double k, double z,
                         double x)
{
    const double *b = f + COIN_PRIV_TURN;
    /* Half a turn more would change both signs, and no product. */
    const double whole = coin_priv_round(k * b[0]);
    const double half_turns = ((k * b[0] - whole) + k * b[1]) + k * b[2];
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

static int32_t steady_at(const coin_orbit *o, double t, coin_state *out)
{
    const double *f = o->private_frame, *s = o->private_terms;
    const coin_priv_steady rates = {
        f[COIN_PRIV_STEADY_HEADING],
        f[COIN_PRIV_STEADY_ROLL],
        f[COIN_PRIV_STEADY_SPEED],
    };
    coin_state at = {
        s[COIN_PRIV_THETA], s[COIN_PRIV_PHI], s[COIN_PRIV_PSI],
        s[COIN_PRIV_X],     s[COIN_PRIV_Z],   0,
        s[COIN_PRIV_WY],    s[COIN_PRIV_WZ],
    };
    if (coin_priv_steady_move(&at, &rates, t) != COIN_OK)
        return COIN_ESTEP;
    *out = at;
    return COIN_OK;
}

int32_t coin_orbit_at(const coin_orbit *o, double t, coin_state *out)
{
    if (!o || !out)
        return COIN_EARG;
    if (o->period == 0)
        return steady_at(o, t, out);
    const double *f = o->private_frame, *T = f + COIN_PRIV_PERIOD;
    const double pieces = f[COIN_PRIV_COUNT], before = f[COIN_PRIV_BACK];
    if (!(before >= 0 && before < pieces && pieces <= (int)COIN_PRIV_PIECES))
        return COIN_EARG;
    const double now = t * f[COIN_PRIV_RATE];
    const double periods = (now + f[COIN_PRIV_SINCE]) * f[COIN_PRIV_OVER];
    if (!(fabs(periods) < COIN_PRIV_ANGLE_MAX))
        return COIN_ESTEP;
    /* The time since the nearest A; before it, all is mirrored.  (57) */
    const double k = coin_priv_round(periods);
    const double r = (((now - k * T[0]) - k * T[1]) + f[COIN_PRIV_SINCE]) +
                     (f[COIN_PRIV_SINCE + 1] - k * T[2]);
    const double side = r < 0 ? -1 : 1, since = side * r;
    const int count = (int)pieces, back = (int)before;
    const int piece =
        coin_priv_piece(rank_of(o->private_edges, count, since), back, count);
    coin_priv_pair row[4];
    piece_at(row, coin_priv_term(o, piece, 0),
             since - o->private_centers[piece]);
    const double rate = f[COIN_PRIV_RATE];
    coin_state at = {
        OF(row[0], 0),
        angle_of(f + COIN_PRIV_PHI0, f + COIN_PRIV_HEADING, k,
                 side * OF(row[0], 1)),
        angle_of(f + COIN_PRIV_PSI0, f + COIN_PRIV_ROLL, k,
                 side * OF(row[1], 0)),
        0,
        0,
        side * OF(row[1], 1) * rate,
        OF(row[2], 0) * rate,
        OF(row[2], 1) * rate,
    };
    carry(&at, f, k, OF(row[3], 0), side * OF(row[3], 1));
    if (coin_priv_check_members(&at) != COIN_OK)
        return COIN_ESTEP;
    *out = at;
    return COIN_OK;
}
