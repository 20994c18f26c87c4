/* SPDX-License-Identifier: MIT */
/* Polynomials tell where in a stretch a bit may hold.  There a partial step of
 * the motion itself decides whether one does, and from when on. */
#include "../motion/pinned.h"

#include "../step/sundman.h"

#include "event.h"

#include <math.h>

/* The longest part, in strides.  The curve over it errs by less than 4e-8 of
 * the changes of the force at its ends: (SHORT/COIN_PRIV_REACH)^14.  Half of
 * it costs 4 % more steps in all, twice saves 6 %, but the bound is then 1e4
 * times as large (make tuning). */
#define SHORT 0.8

/* The force of a state and that of the series at it differ by rounding: by less
 * than this part of the natural size of a force.  Nor may the rounding of cos
 * theta matter: it has to exceed OFF_FLAT times the least.  Both only choose
 * the states for which coin_check() is called.  Any ROUNDED from 1e-13 to 1e-6
 * and any OFF_FLAT from 1.1 to 3 gives the same number of calls in random
 * motions (make tuning). */
#define ROUNDED 1e-9
#define OFF_FLAT 1.5

/* Next to a place that the polynomials find, the motion is searched from a
 * quarter of tol on.  Each time that a bit still holds, the search goes WIDER
 * times as far back.  With 2 or 64 the number of calls of coin_check() is the
 * same within 0.3 % (make tuning). */
#define WIDER 8

/* Where the curve of N changes its sign, N itself does so within this part of a
 * stretch.  The curve errs by 4e-8, see SHORT.  Where N only touches 0, the
 * place errs by the square root of that. */
#define OFF 2e-4

static int32_t bits_of(const coin_priv_search *f, const coin_state *s)
{
    const int32_t bits = coin_check(s, f->p, COIN_RK4, 0, f->mu);
    return bits > 0 ? bits & f->bits : 0;
}

int32_t coin_priv_bits_at(const coin_priv_search *f, const coin_state *s,
                          const coin_priv_force_series *at)
{
    const double A = f->per_F * at->X[0].at[1], B = f->per_F * at->h[0].at[1];
    const double room = f->per_N * at->normal[0].at[1] - ROUNDED;
    const int is_clear = (room >= 0) & (A * A + B * B <= room * room) &
                         (at->cth[0].at[1] > OFF_FLAT * COIN_PRIV_NEARLY_FLAT);
    return is_clear ? 0 : bits_of(f, s);
}

/* A step in tau that is shorter changes nothing, and 1 over it may overflow. */
#define NO_STEP 1e-300

/* The run at x of a stretch, without theta. */
static coin_priv_run run_to(const coin_priv_stretch *w, double x)
{
    coin_priv_run r = w->from;
    r.g.added.t = 0;
    if (fabs(x * w->tau) > NO_STEP)
        (void)coin_priv_extrapolate(&r, x * w->tau);
    return r;
}

static coin_priv_moment moment_of(const coin_priv_search *f,
                                  const coin_priv_stretch *w, double x)
{
    coin_priv_moment m = {x, run_to(w, x), 0};
    coin_priv_read_lean(&m.run.g);
    const coin_state s = coin_priv_run_state(&m.run);
    m.bits = bits_of(f, &s);
    return m;
}

/* Whether the coin is held down: the sign of N. */
static int presses(const coin_priv_search *f, const coin_priv_moment *m)
{
    coin_force force = {{0, 0, 0}, 0, 0, 0};
    const coin_state s = coin_priv_run_state(&m->run);
    (void)coin_reaction(&s, f->p, &force);
    return force.normal > 0;
}

/* Moves *high back to the moment from which on a bit holds, to within tol.  No
 * bit holds at low; one does at *high. */
static void bisect(const coin_priv_search *f, const coin_priv_stretch *w,
                   double low, coin_priv_moment *high, double tol)
{
    while (high->x - low > tol) {
        const coin_priv_moment m = moment_of(f, w, low + (high->x - low) / 2);
        if (m.bits != 0)
            *high = m;
        else
            low = m.x;
    }
}

/* A moment at which a bit holds, between two moments at which none does, if N
 * has different signs at these.  Where N changes its sign, F exceeds mu N for
 * every mu, so that a bit holds.  Returns high if N has one sign at both. */
static coin_priv_moment between(const coin_priv_search *f,
                                const coin_priv_stretch *w,
                                coin_priv_moment low, coin_priv_moment high)
{
    const int side = presses(f, &high);
    while (side != presses(f, &low)) {
        const coin_priv_moment m =
            moment_of(f, w, low.x + (high.x - low.x) / 2);
        if (m.bits != 0 || !(m.x > low.x && m.x < high.x))
            return m;
        if (presses(f, &m) == side)
            high = m;
        else
            low = m;
    }
    return high;
}

/* The part of a stretch that lasts no longer than tol: cos theta changes by a
 * factor below 3 in half a step.  4 counts as any number that is larger. */
static double least_part(const coin_priv_search *f, const coin_priv_stretch *w)
{
    const double a = w->from.g.y.cth, b = w->to.cth;
    const double longest = 3 * fabs(w->tau) * (a > b ? a : b);
    return f->tol < 4 * longest ? f->tol / longest : 4;
}

/* Searches the motion itself, at and next to a place that the polynomials of a
 * part have found.  Returns the moment from which on a bit holds, to within
 * tol, or a moment with bits 0 if none holds there. */
static coin_priv_moment locate(const coin_priv_search *f,
                               const coin_priv_part *w, coin_priv_place at)
{
    const double tol = least_part(f, w->of);
    const double from = w->first + w->width * at.from;
    const double to = w->first + w->width * coin_priv_lesser(at.to, 1);
    const double middle = from + (to - from) / 2;
    double width = tol / 4, low = from - width;
    coin_priv_moment high =
        moment_of(f, w->of, coin_priv_lesser(from + width, middle));
    if (high.bits == 0 && high.x < middle)
        high = moment_of(f, w->of, middle);
    if (high.bits == 0) {
        const double first = low - OFF, last = to + width + OFF;
        high = between(f, w->of, moment_of(f, w->of, first > 0 ? first : 0),
                       moment_of(f, w->of, coin_priv_lesser(last, 1)));
    }
    if (high.bits == 0)
        return high;
    const double found = coin_priv_lesser(from, high.x);
    for (low = found - width; low > 0; low = found - width) {
        const coin_priv_moment m = moment_of(f, w->of, low);
        if (m.bits == 0)
            break;
        high = m;
        width *= WIDER;
    }
    bisect(f, w->of, low > 0 ? low : 0, &high, tol);
    return high;
}

/* The first event of a part; 0 if there is none.  The places are zeros of
 * polynomials, so that their number is bounded. */
static int first_of_part(coin_priv_moment *out, const coin_priv_search *f,
                         const coin_priv_part *w)
{
    coin_priv_place at = {-1, 2};
    for (;;) {
        at = coin_priv_next_place(f, w, at.from);
        if (at.from > 1)
            return 0;
        *out = locate(f, w, at);
        if (out->bits != 0)
            return 1;
    }
}

/* The first event of a stretch that the polynomials of the whole did not clear,
 * part by part.  A part is at most SHORT of the strides where it begins. */
static int first_in_parts(coin_priv_moment *out, const coin_priv_search *f,
                          const coin_priv_stretch *w)
{
    const double length = fabs(w->tau);
    coin_priv_part part;
    coin_priv_variables begin = w->from.g.y;
    coin_priv_force_series force;
    part.of = w;
    part.first = 0;
    for (int parts = 2; parts > 1; part.first += part.width) {
        const double one = coin_priv_sundman_tau(&w->from.b, &begin, 1);
        const double left = 1 - part.first;
        parts = 1 + (int)(left * length / (SHORT * one));
        part.width = left / parts;
        const coin_priv_variables end =
            parts > 1 ? run_to(w, part.first + part.width).g.y : w->to;
        coin_priv_force_series_of(&force, &w->from.b, &begin, &end, w->unit,
                                  COIN_PRIV_FORCE_TERMS);
        if (!coin_priv_is_clear(f, &force, part.width * w->tau / w->unit,
                                part.width * length / one)) {
            coin_priv_join_part(&part, f, &force);
            if (first_of_part(out, f, &part))
                return 1;
        }
        begin = end;
    }
    return 0;
}

int coin_priv_first_event(coin_priv_moment *out, const coin_priv_search *f,
                          coin_priv_stretch *w)
{
    const double one = coin_priv_sundman_tau(&w->from.b, &w->from.g.y, 1);
    return !coin_priv_judge_stretch(f, w, one) && first_in_parts(out, f, w);
}
