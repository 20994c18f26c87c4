/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "move.h"

#include <string.h>

/* The parts of the losses' own rate, and of the rates at which the direction
 * and the speed of a slip change, in the rate by which steps are measured.
 * With half of either, steps are longer than the method is stable for (move.h).
 * Measured: LOSSES, RELAX in tables.md. */
#define LOSSES 0.3
#define RELAX 0.24

/* The estimate of a step's error may be ESTIMATE times tol times its time.  It
 * is of order 8, and above the error, of order 9.  The time of a step counts as
 * SHORTEST natural units at least, so that a short call need not err by less
 * than tol/16.  Measured: ESTIMATE, SHORTEST in tables.md. */
#define ESTIMATE 2.0
#define SHORTEST 0.03

/* Contour friction is not smooth where the contact turns round, d(psi)/dt = 0.
 * A step is planned to cover TURN_ROUND of the way to there.  Measured:
 * TURN_ROUND in tables.md. */
#define TURN_ROUND 0.5

/* A stage has run away if its rates are so many times those of the start.  Near
 * flat the three stages that only the polynomial needs may run away in a good
 * step: the polynomial would then have false events.  Measured: RUNAWAY in
 * tables.md. */
#define RUNAWAY 1e6

/* A first stride is FIRST times the eighth root of tol over the size of the
 * motion (first_stride()). Measured: FIRST in tables.md. */
#define FIRST 4

/* The last step of a call is made in t, where cos theta and a slip's speed
 * change by less than this part of themselves in it.  Measured: IN_T in
 * tables.md. */
#define IN_T 0.25

/* Where a trial passes the end of the call, the next one is shorter, but at
 * least CUT times as long.  While a slip grows from rest, t grows
 * exponentially.  Measured: CUT in tables.md. */
#define CUT 0.1

static double slip_speed(const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    return sqrt(uX * uX + uh * uh);
}

/* Its factors are measured: (1.5) and (3) in tables.md. */
double coin_priv_rate(const double *y, const coin_priv_law *l, int mode)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double wZ = y[COIN_PRIV_WZ], cwZ = y[COIN_PRIV_C] * wZ;
    const double KJ = l->K[0] / l->J[0], s8 = y[COIN_PRIV_S] / 8;
    if (mode & COIN_PRIV_HELD)
        return sqrt(1 + wX * wX + wZ * wZ);
    const double own2 =
        wX * wX + 1.5 * (wY * wY) + KJ * KJ * (cwZ * cwZ) + y[COIN_PRIV_C];
    const double rate = sqrt(coin_priv_larger(own2, 3 * KJ * fabs(wY * cwZ)));
    if (!(mode & COIN_PRIV_SLIPS))
        return rate;
    /* A slip frees the lean: the inertia against its changes is I_X + sin^2
     * theta instead of I_X + 1.  Measured: s8 and sqrt in tables.md. */
    return rate * coin_priv_larger(1, sqrt(1 / (l->IX + s8 * s8)) / 2);
}

/* The rate in tau at which the losses make the rates decay, (71). */
double coin_priv_loss_rate(const double *y, const coin_priv_law *l, int mode)
{
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double u = coin_priv_roll_speed(y);
    if (!l->lossy || mode & COIN_PRIV_HELD)
        return 0;
    const double lever = s * s / l->IX + c * c / l->K[mode & COIN_PRIV_SLIPS];
    return coin_priv_grip(l, u, c) * lever + l->damping * fabs(u) +
           l->spin * c / l->IX + l->angular * c; /* (71) */
}

/* The slope of the roll speed. */
static double roll_slope(const double *y, const double *d)
{
    return y[COIN_PRIV_C] * d[COIN_PRIV_WZ] + y[COIN_PRIV_S] * d[COIN_PRIV_WY] +
           d[COIN_PRIV_C] * y[COIN_PRIV_WZ] + d[COIN_PRIV_S] * y[COIN_PRIV_WY];
}

/* Whether losses act in this mode that change within a width of the roll speed,
 * soft cos theta, where the contact turns round. */
static int has_width(const coin_priv_moving *g)
{
    return g->law.dry + g->law.rolling > 0 && !(g->mode & COIN_PRIV_HELD);
}

/* How far the roll speed is from where such losses change: sqrt(u^2 + z^2).
 * Here u is the roll speed, and z the width soft cos theta. */
static double way(const coin_priv_moving *g)
{
    const double u = coin_priv_roll_speed(g->step.y);
    const double z = g->law.soft * g->step.y[COIN_PRIV_C];
    return sqrt(u * u + z * z);
}

/* Whether losses act in this mode that change at u = 0 at once: the torque of
 * damping has a kink there, that of layer friction a power 3/2. */
static int has_kink(const coin_priv_moving *g)
{
    return g->law.damping + g->law.layer > 0 && !(g->mode & COIN_PRIV_HELD);
}

/* A step with a kink ends just before u = 0: within AIM of the way to there, or
 * where |u| is below AIMED sqrt(tol): an error of u^2 is far below tol there.
 * The next one passes over it.  Measured: AIM, AIMED in tables.md.
 *
 * From there on u grows by at most LEAVES times itself, or sqrt(tol), in a
 * step: the power 3/2 has no Taylor series at 0, on which the estimate of the
 * error rests. */
#define AIM 0.97
#define AIMED 0.01
#define LEAVES 2

/* Whether the step has passed u = 0 though it began before it. */
static int passed_kink(const coin_priv_moving *g)
{
    const double u0 = coin_priv_roll_speed(g->step.y);
    const double u1 = coin_priv_roll_speed(g->step.end);
    const double least = AIMED * sqrt(g->tol);
    return (u0 < 0) != (u1 < 0) && fabs(u0) > least && fabs(u1) > least;
}

/* The stride of a first step, from the slopes and the rate: that of a sine with
 * as large a slope.  In one motion of twenty a longer one would be refused. */
static double first_stride(const coin_priv_moving *g, double rate)
{
    const double *d = g->step.slope[0];
    double sum = 0;
    for (int i = 0; i < COIN_PRIV_READ; ++i)
        sum += d[i] * d[i];
    const double part = g->tol / (g->tol + sqrt(sum) / rate);
    return coin_priv_lesser(COIN_PRIV_MOST_STRIDE,
                            FIRST * sqrt(sqrt(sqrt(part))));
}

/* Whether the coin slips, and steps follow the direction of its slip. */
static int is_followed(const coin_priv_moving *g)
{
    return g->mode & COIN_PRIV_SLIPS && !(g->slow > 0);
}

/* In one step the speed of a slip becomes at most GROWTH times as large.  The
 * slope of the time is proportional to it, and the estimate of a step's error
 * leaves the time out.  Measured: GROWTH in tables.md. */
#define GROWTH 10

/* Whether the slip became too fast within the step. */
static int slip_outgrows(const coin_priv_moving *g)
{
    return is_followed(g) &&
           slip_speed(g->step.end) > GROWTH * slip_speed(g->step.y);
}

/* The rate by which the steps of a slip are chosen, from that of the motion. */
static double rate_of_slip(const coin_priv_moving *g, double rate)
{
    const coin_priv_law *l = &g->law;
    const double *y = g->step.y, *d = g->step.slope[0];
    const double u = slip_speed(y), s = y[COIN_PRIV_S];
    const double nX = y[COIN_PRIV_UX] / u, nh = y[COIN_PRIV_UH] / u;
    const double N = coin_priv_push_of(y, l, g->mode).N;
    const double h2 = l->half * l->half;
    const double P = coin_priv_lever_of(s, y[COIN_PRIV_C], l->eta).P;
    const double across =
        nh * nh * (1 + 1 / l->IZ + h2 / l->IX) +
        nX * nX * (1 + (1 + h2) / l->IX) / (1 + P * P / l->IX);
    const double du2 =
        d[COIN_PRIV_UX] * d[COIN_PRIV_UX] + d[COIN_PRIV_UH] * d[COIN_PRIV_UH];
    const double slip_rate = sqrt(du2) / u;
    return rate * u / (u + 1) + RELAX * (l->mu_kinetic * N * across / (u + 1) +
                                         slip_rate); /* (87) */
}

/* What a step is chosen by: the rate of the motion, and the longest step, in
 * the time that it is made in. */
typedef struct plan {
    double rate, h;
} plan;

static plan plan_step(coin_priv_moving *g)
{
    const coin_priv_law *l = &g->law;
    const double *y = g->step.y, *d = g->step.slope[0];
    double rate = coin_priv_rate(y, l, g->mode) +
                  LOSSES * coin_priv_loss_rate(y, l, g->mode);
    if (is_followed(g))
        rate = rate_of_slip(g, rate);
    if (g->stride == 0)
        g->stride = first_stride(g, rate);
    plan r = {rate, g->stride / rate};
    if (has_width(g)) {
        const double slope = fabs(roll_slope(y, d)), far = TURN_ROUND * way(g);
        r.h = r.h * slope > far ? far / slope : r.h;
    }
    if (has_kink(g)) {
        const double roll = coin_priv_roll_speed(y), slope = roll_slope(y, d);
        const int goes_to =
            roll * slope < 0 && fabs(roll) > AIMED * sqrt(g->tol);
        const double far =
            goes_to ? AIM * fabs(roll)
                    : LEAVES * coin_priv_larger(fabs(roll), sqrt(g->tol));
        r.h = r.h * fabs(slope) > far ? far / fabs(slope) : r.h;
    }
    return r;
}

/* The largest estimate with which a step is accepted: what tol allows, plus
 * what rounding may cause: at 1e-9 and above nothing depends on it. */
static double allowed(const coin_priv_moving *g)
{
    const double *y = g->step.y;
    const double size = 1 + fabs(y[COIN_PRIV_WX]) + fabs(y[COIN_PRIV_WY]) +
                        fabs(y[COIN_PRIV_WZ]) + slip_speed(y);
    return ESTIMATE * g->tol *
               coin_priv_larger(g->step.end[COIN_PRIV_ADDS_T], SHORTEST) +
           4 * DBL_EPSILON * size;
}

/* The stride after a step of the stride `used` with this error.  Measured:
 * next_stride() in tables.md. */
static void next_stride(coin_priv_moving *g, double used, double error,
                        double most)
{
    const double factor =
        coin_priv_lesser(2, coin_priv_next_length(error, most));
    const double next = coin_priv_lesser(COIN_PRIV_MOST_STRIDE, used * factor);
    if (error > most || next > g->stride || used > 0.999 * g->stride)
        g->stride = next;
}

/* Whether the time left can be one step in t, of a plan. */
static int can_end_in_t(const coin_priv_moving *g, const plan *p, double left)
{
    const double *y = g->step.y, *d = g->step.slope[0];
    const double per =
        left / d[COIN_PRIV_ADDS_T]; /* its length in the plan's time */
    const double c = IN_T * y[COIN_PRIV_C];
    int good = per <= p->h && per * fabs(d[COIN_PRIV_C]) <= c;
    if (is_followed(g)) {
        const double du = sqrt(d[COIN_PRIV_UX] * d[COIN_PRIV_UX] +
                               d[COIN_PRIV_UH] * d[COIN_PRIV_UH]);
        good = good && per * du <= IN_T * slip_speed(y);
    }
    return good;
}

/* Makes the step of the plan the step to the end of the call, in t. */
static void end_in_t(coin_priv_moving *g, plan *p, double left)
{
    g->step.of.by_t = 1;
    p->rate *= coin_priv_by_t(g->step.slope[0]);
    p->h = left;
}

/* Sets the slopes that a step begins with, in the time of the mode. */
static void first_slopes(coin_priv_moving *g)
{
    const double *const y = g->step.y;
    coin_priv_problem *const of = &g->step.of;
    of->rates = g->slow > 0 ? coin_priv_slow_rates : coin_priv_rates;
    of->mode = g->mode;
    of->by_t = 0;
    of->limit = RUNAWAY * (1 + fabs(y[COIN_PRIV_WX]) + fabs(y[COIN_PRIV_WY]) +
                           fabs(y[COIN_PRIV_WZ]) + slip_speed(y));
    (void)of->rates(g->step.slope[0], y, of);
}

/* A step whose error is allowed, not beyond the end of the call.  Returns its
 * stride, or 0 if no trials are left.  *ends: it ends the call.  Measured: 0.9
 * in tables.md. */
static double try_steps(coin_priv_moving *g, int *ends)
{
    coin_priv_dop853 *const w = &g->step;
    const double left = coin_priv_time_left(g);
    double most_h = (double)INFINITY;
    *ends = 0;
    while (g->tries > 0) {
        plan p = plan_step(g);
        p.h = coin_priv_lesser(p.h, most_h);
        *ends = can_end_in_t(g, &p, left);
        if (*ends)
            end_in_t(g, &p, left);
        --g->tries;
        double error = coin_priv_try_step(w, p.h);
        if (error < (double)INFINITY &&
            ((has_kink(g) && passed_kink(g)) || slip_outgrows(g)))
            error = (double)INFINITY;
        const double most = error < (double)INFINITY ? allowed(g) : g->tol;
        const double used = p.h * p.rate;
        const int over =
            error <= most && !*ends && w->end[COIN_PRIV_ADDS_T] > left;
        if (over) {
            const double part = left / w->end[COIN_PRIV_ADDS_T];
            most_h = coin_priv_larger(0.9 * p.h * part, CUT * p.h);
        } else {
            next_stride(g, used, error, most);
            if (error <= most)
                return used;
        }
        first_slopes(g);
    }
    return 0;
}

/* Adds a part to a sum, which may become `most`. */
static int add_within(coin_priv_sum *to, double part, double most)
{
    coin_priv_add(to, part);
    return fabs(to->sum) <= most;
}

int32_t coin_priv_accept(coin_priv_moving *g, const double *y, int ends)
{
    coin_priv_coin to = g->c;
    if (!(add_within(&to.phi, y[COIN_PRIV_ADDS_PHI], COIN_PRIV_ANGLE_MAX) &&
          add_within(&to.psi, y[COIN_PRIV_ADDS_PSI], COIN_PRIV_ANGLE_MAX) &&
          add_within(&to.x, y[COIN_PRIV_ADDS_X], COIN_PRIV_PLACE_MAX) &&
          add_within(&to.z, y[COIN_PRIV_ADDS_Z], COIN_PRIV_PLACE_MAX)))
        return COIN_ERANGE;
    for (int i = COIN_PRIV_WX; i <= COIN_PRIV_WZ; ++i)
        if (!(fabs(y[i]) <= COIN_PRIV_RATE_MAX))
            return COIN_ERANGE;
    coin_priv_spend(g, y[COIN_PRIV_ADDS_T], ends);
    g->c = to;
    memcpy(g->step.y, y, sizeof g->step.y);
    for (int i = COIN_PRIV_READ; i < COIN_PRIV_WIDE; ++i)
        g->step.y[i] = 0;
    coin_priv_normalize_pair(&g->step.y[COIN_PRIV_S], &g->step.y[COIN_PRIV_C]);
    coin_priv_normalize_pair(&g->step.y[COIN_PRIV_SPH],
                             &g->step.y[COIN_PRIV_CPH]);
    g->slow = 0;
    g->changed = 1;
    return COIN_OK;
}

/* A slip begins or has ended; the length of the next step is
 * not known then. */
static void set_slips(coin_priv_moving *g, int slips)
{
    g->mode = slips ? g->mode | COIN_PRIV_SLIPS : g->mode & ~COIN_PRIV_SLIPS;
    g->stride = 0;
}

/* A step, or the part of one up to the first event in it. */
static int32_t make_step(coin_priv_moving *g)
{
    coin_priv_dop853 *const w = &g->step;
    int ends;
    const double stride = try_steps(g, &ends);
    if (stride == 0)
        return COIN_OK;
    double cut[COIN_PRIV_WIDE], radians = stride;
    if (is_followed(g) && !ends) {
        /* The strides of a slip are shorter than the coin's own turn. */
        const double u = slip_speed(g->step.y);
        radians =
            w->h * coin_priv_rate(g->step.y, &g->law, g->mode) * u / (u + 1);
    }
    const int whole = !coin_priv_first_event(cut, g, radians);
    double *const to = whole ? w->end : cut;
    if (g->slow > 0)
        coin_priv_end_slow(g, to);
    return coin_priv_accept(g, to, whole && ends);
}

/* Whether the coin has come to rest on its edge, where nothing leans it. */
static int stands(coin_priv_moving *g)
{
    double *const y = g->step.y;
    const double speed = coin_priv_upright_speed(y);
    if (!(g->law.plain && speed < COIN_PRIV_SLIP_LEAST))
        return 0;
    y[COIN_PRIV_WZ] = y[COIN_PRIV_UX] = y[COIN_PRIV_UH] = 0;
    g->mode = COIN_PRIV_RESTS;
    g->changed |= speed > 0 && g->time > 0;
    return 1;
}

/* Whether the rim that does not touch has come down: the coin is upright by the
 * rule of coin_priv_set_upright(). */
static int rocks(coin_priv_moving *g)
{
    double *const y = g->step.y;
    const double eta = g->law.eta;
    if (!(eta * y[COIN_PRIV_S] <= 2 * COIN_PRIV_EPSILON &&
          eta * y[COIN_PRIV_WX] < 0))
        return 0;
    y[COIN_PRIV_S] = 0;
    y[COIN_PRIV_C] = 1;
    g->mode |= COIN_PRIV_ROCKS;
    return 1;
}

/* A roll that counts as stopped is left out; not that of a coin that nothing
 * leans, which would end it early. */
void coin_priv_set_held(coin_priv_moving *g)
{
    double *const y = g->step.y;
    const int held =
        coin_priv_upright_speed(y) > DBL_MAX &&
        coin_priv_is_held(y, &g->law, g->mode & COIN_PRIV_SLIPS, g->tol);
    if (held == ((g->mode & COIN_PRIV_HELD) != 0))
        return;
    g->mode ^= COIN_PRIV_HELD;
    if (held) {
        const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
        const double turn = c * y[COIN_PRIV_WY] - s * y[COIN_PRIV_WZ];
        y[COIN_PRIV_WY] = turn * c;
        y[COIN_PRIV_WZ] = -turn * s;
    }
}

int coin_priv_next_mode(coin_priv_moving *g)
{
    const double *const y = g->step.y;
    if (g->law.keeps_rolling)
        return g->mode;
    g->margin = coin_priv_contact_margin(y, &g->law, g->mode);
    if (g->margin >= 0)
        return g->mode;
    /* In the air it keeps its slip velocity. */
    return g->mode |
           (coin_priv_leaves(y, &g->law) ? COIN_PRIV_AIR : COIN_PRIV_SLIPS);
}

void coin_priv_end_here(coin_priv_moving *g, int32_t why)
{
    g->found |= why;
    g->time = g->moved.sum;
    g->moved.low = 0;
}

void coin_priv_moments(coin_priv_moving *g, int32_t is)
{
    const int32_t was = g->was, moves = COIN_SLIPS | COIN_LIFTS;
    int32_t begins = is & ~was;
    if (was >= 0 && was & moves && !(is & (moves | COIN_RESTS)))
        begins |= COIN_ROLLS;
    g->was = is;
    if (g->stop & begins)
        coin_priv_end_here(g, g->stop & begins);
}

double coin_priv_undecided(const coin_priv_coin *c, const coin_priv_law *l)
{
    const double v2 = c->vx * c->vx + c->vy * c->vy + c->vz * c->vz;
    const double rotation =
        l->IX * (c->wX * c->wX + c->wY * c->wY) + l->IZ * (c->wZ * c->wZ);
    return (v2 + rotation) / 2 + c->y - coin_priv_barrier(l->half);
}

/* The bits of coin_priv_moments() of a mode in contact. */
static int32_t bits_of(const coin_priv_moving *g, int mode)
{
    int32_t decided = 0;
    if (g->stop & COIN_DECIDED) {
        coin_priv_coin c;
        coin_priv_set_contact(&c, g->step.y, g->law.eta);
        decided = coin_priv_undecided(&c, &g->law) < 0 ? COIN_DECIDED : 0;
    }
    const int32_t slips = mode & COIN_PRIV_SLIPS ? COIN_SLIPS : 0;
    const int32_t low =
        g->step.y[COIN_PRIV_C] < COIN_PRIV_NEARLY_FLAT ? COIN_NEARLY_FLAT : 0;
    return decided | (mode & COIN_PRIV_AIR ? COIN_LIFTS : slips | low);
}

/* Whether the coin is nearer to flat than `flat`: its contact then ends on the
 * face.  A call of no time changes nothing. */
static int lies_down(coin_priv_moving *g)
{
    if (!(g->time > 0 && g->step.y[COIN_PRIV_C] < g->law.flat)) /* (97) */
        return 0;
    if (g->was < 0)
        coin_priv_moments(g, bits_of(g, g->mode)); /* those of the rim */
    g->mode = COIN_PRIV_RESTS | COIN_PRIV_LIES;
    g->changed = 1;
    return 1;
}

/* The first step of a slip, or one of a slow slip. */
static int32_t make_slow_step(coin_priv_moving *g, int begins)
{
    if (begins)
        coin_priv_begin_slip(g);
    g->stride = 0;
    first_slopes(g);
    const int32_t status = make_step(g);
    if (g->slow > 0) {
        coin_priv_end_slow(g, g->step.y);
        g->slow = 0;
    }
    set_slips(g, slip_speed(g->step.y) > 0);
    return status;
}

/* Moves until the contact or the call ends. */
static int32_t follow(coin_priv_moving *g)
{
    int32_t status = COIN_OK;
    while (status == COIN_OK) {
        if (lies_down(g) || stands(g) || rocks(g))
            return COIN_OK;
        coin_priv_set_held(g);
        const int next = coin_priv_next_mode(g);
        const int slip_begins = next & ~g->mode & COIN_PRIV_SLIPS;
        g->mode = next & ~slip_begins;
        coin_priv_moments(g, bits_of(g, next));
        if (g->mode & COIN_PRIV_AIR || !(coin_priv_time_left(g) > 0))
            return COIN_OK;
        first_slopes(g);
        if (g->tries <= 0)
            coin_priv_end_here(g, COIN_MORE);
        else if (coin_priv_end_slip(g))
            set_slips(g, 0);
        else if (slip_begins || coin_priv_slips_slowly(g))
            status = make_slow_step(g, slip_begins);
        else
            status = make_step(g);
    }
    return status;
}

int32_t coin_priv_go(coin_priv_moving *g)
{
    const int32_t status = follow(g);
    if (g->changed)
        coin_priv_end(g);
    if (g->mode & COIN_PRIV_LIES) {
        g->c.th.s = g->c.th.s < 0 ? -1 : 1;
        g->c.th.c = 0;
    }
    return status;
}
