/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"
#include "../step/advance.h"

#include "control.h"
#include "hold.h"
#include "lossy.h"

/* The most steps of a call, those refused included.  They take 0.4 s. */
#define TRIES_MAX (UINT64_C(1) << 20)

/* Where cos theta is less than END and the coin is too slow to rise, the law of
 * losses that never stop the contact gives the time left.  With END
 * from 1e-12 to 1e-8 the time of rest is the same, and the steps within 0.05 %
 * (make tuning).  The coin is too slow if its energy is below TOO_SLOW
 * M g a cos theta: it cannot rise beyond 5 times its angle from flat.  By (75)
 * a coin that spins there has 1.5 M g a cos theta.  TOO_SLOW = 2.5 or 10 gives
 * the same. */
#define END 1e-10
#define TOO_SLOW 5

/* A coin on its way to rest. */
struct settling {
    coin_priv_lossy w;
    coin_priv_sum rem; /* the time still to go */
    double tol, stride;
    uint64_t tries;
};

/* The tau that the time rem takes, from rem = cth tau - sth cth wX tau^2/2 +
 * ...; infinite where that has no solution. */
static double quadratic_tau(const coin_priv_variables *y, double rem)
{
    const double r = rem / y->cth;
    const double room = 1 - 2 * y->sth * y->wX * r;
    return room >= 0 ? 2 * r / (1 + sqrt(room)) : (double)INFINITY;
}

/* The tau of the next step.  It is limited by the stride, by the bound of (71),
 * and by `rest`, the tau of the time left. */
static double next_tau(const struct settling *g, double rest, double rate,
                       double bound)
{
    const double side = g->rem.sum < 0 ? -1 : 1;
    double full = g->stride / rate;
    if (bound < full)
        full = bound;
    return fabs(rest) < full ? rest : side * full;
}

/* One step, as long as its error allows.  *ends becomes 1 if the step was
 * chosen to take all the time left, else 0. */
static int32_t step(struct settling *g, double rate, int *ends)
{
    coin_priv_trial trial;
    const double rest = quadratic_tau(&g->w.run.g.y, g->rem.sum);
    const double effect =
        coin_priv_allowed_in(&g->w.run, g->tol, COIN_PRIV_BRIEF);
    const double bound = coin_priv_lossy_bound(&g->w, effect);
    for (int done = 0; !done;) {
        const double tau = next_tau(g, rest, rate, bound);
        const double used = fabs(tau) * rate;
        if (++g->tries > TRIES_MAX)
            return COIN_ESTEP;
        coin_priv_lossy_try(&trial, &g->w, tau, effect);
        const double most = coin_priv_allowed(&g->w.run, g->tol, trial.adds.t);
        g->stride = coin_priv_next_stride(g->stride, used, trial.error, most);
        done = trial.error <= most;
        *ends = tau == rest;
    }
    if (!coin_priv_sundman_accept(&g->w.run, &trial.next, &trial.adds))
        return COIN_ESTEP;
    coin_priv_add(&g->rem, -trial.adds.t);
    return COIN_OK;
}

/* Sets the coin to the end of a fall or of a part of it.  Its point of contact
 * stays where it is.  Returns 0, and does nothing, if the pose would leave
 * its range. */
static int put(coin_priv_run *r, const coin_priv_held_fall *f,
               const coin_priv_losses *l)
{
    coin_priv_progress *const g = &r->g;
    coin_priv_pose added = g->added;
    added.phi += f->phi;
    if (!coin_priv_pose_holds(g, &r->limits, &added))
        return 0;
    coin_priv_variables *const y = &g->y, from = g->y;
    const coin_priv_sc at = coin_priv_sincos(f->x);
    const double side = y->sth < 0 ? -1 : 1;
    const double turn = coin_priv_fall_turn(f, l);
    g->added.phi = added.phi;
    const coin_priv_sum phi = {coin_priv_total(g->phi, g->added.phi), 0};
    const coin_priv_sc ph = coin_priv_angle_pair(phi);
    y->sth = side * at.c;
    y->cth = at.s;
    y->wX = side * f->v;
    y->wY = at.s * turn;
    y->wZ = -y->sth * turn;
    y->sph = ph.s;
    y->cph = ph.c;
    g->added.x += y->sth * y->sph - from.sth * from.sph; /* (21) */
    g->added.z += y->sth * y->cph - from.sth * from.cph; /* (21) */
    ++r->steps;
    return 1;
}

/* Makes a part of the rise of a coin whose contact has stopped.  Returns 0, and
 * does nothing, if the losses do not hold the contact until its end. */
static int rise(struct settling *g, double eps)
{
    coin_priv_run after = g->w.run;
    const coin_priv_losses *l = &g->w.l;
    const coin_priv_held_fall f = coin_priv_fall_of(l, &g->w.run.g.y);
    const double whole = coin_priv_rise_time(&f, l, &g->w.run.b);
    const double time = whole < g->rem.sum ? whole : g->rem.sum;
    coin_priv_held_fall end = f;
    coin_priv_fall_by(&end, l, &g->w.run.b, time);
    if (!put(&after, &end, l) ||
        !coin_priv_is_held(l, &g->w.run.b, &after.g.y, eps))
        return 0;
    g->w.run = after;
    coin_priv_add(&g->rem, -time);
    if (time < whole)
        g->rem.sum = 0;
    return 1;
}

/* The fall of a coin whose contact has stopped. */
static int32_t fall_flat(struct settling *g)
{
    const coin_priv_losses *l = &g->w.l;
    const coin_priv_body *b = &g->w.run.b;
    const coin_priv_held_fall f = coin_priv_fall_of(l, &g->w.run.g.y);
    const double time = coin_priv_fall_time(&f, l, b);
    const int flat = time <= g->rem.sum;
    coin_priv_held_fall end = f;
    coin_priv_fall_by(&end, l, b, flat ? time : g->rem.sum);
    if (flat)
        end.x = 0;
    if (!put(&g->w.run, &end, l))
        return COIN_ESTEP;
    if (!flat) {
        g->rem.sum = 0;
        return COIN_OK;
    }
    coin_priv_add(&g->rem, -time);
    return COIN_RESTS;
}

/* The time to rest of a coin so flat and slow that it will not rise again, with
 * losses that never stop the contact: its energy is proportional to (t0 - t)^2.
 * Infinite for other coins. */
static double time_left(const coin_priv_lossy *w)
{
    const coin_priv_variables *y = &w->run.g.y;
    const double E = (w->l.J * y->wX * y->wX + w->l.IX * y->wY * y->wY) / 2 +
                     w->run.b.Mga * y->cth;
    if (!(y->cth < END && E < TOO_SLOW * w->run.b.Mga * y->cth))
        return (double)INFINITY;
    const double power = coin_priv_endless_power(&w->l, y);
    const double twice = 2 * E * y->cth;
    return twice / DBL_MAX < power ? twice / power : (double)INFINITY;
}

/* Lays the coin flat, a time later, with the wX that it has. */
static int32_t lay_flat(struct settling *g, double after)
{
    coin_priv_add(&g->rem, -after);
    ++g->w.run.steps;
    return coin_priv_lay_flat(&g->w.run);
}

/* Moves the coin until the time is over, or it rests, or a step fails or is one
 * too many. */
static int32_t approach(struct settling *g)
{
    const double eps = coin_priv_stopped(g->tol);
    for (;;) {
        const coin_priv_variables *y = &g->w.run.g.y;
        const double rem = g->rem.sum;
        if (rem == 0)
            return COIN_OK;
        if (y->cth < COIN_PRIV_FLAT)
            return lay_flat(g, 0);
        if (coin_priv_is_held(&g->w.l, &g->w.run.b, y, eps)) {
            if (y->sth * y->wX >= 0)
                return fall_flat(g);
            if (rise(g, eps))
                continue;
        }
        if (time_left(&g->w) <= rem)
            return lay_flat(g, time_left(&g->w));
        const double rate = coin_priv_lossy_rate(&g->w);
        const int is_short = fabs(rem) * rate <= COIN_PRIV_LAST_LOSSY * y->cth;
        int ends;
        const int32_t status = step(g, rate, &ends);
        if (status != COIN_OK)
            return status;
        if (ends & is_short)
            g->rem.sum = 0;
        else if ((g->rem.sum < 0) != (rem < 0))
            g->stride /= 2;
    }
}

static int32_t ideal(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    const int32_t status = coin_advance(s, p, t, tol, reached);
    if (status != COIN_EFLAT)
        return status;
    s->wX = copysign(s->wX, s->theta);
    s->wY = 0;
    return COIN_RESTS;
}

int32_t coin_settle(coin_state *s, const coin_params *p, const coin_losses *l,
                    double t, double tol, double *reached)
{
    struct settling g;
    if (!s || !p || !l || !coin_priv_tol_is_valid(tol))
        return COIN_EARG;
    if (coin_losses_check(l, p) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check(s, p, &g.w.run.b);
    if (status != COIN_OK)
        return status;
    if (!(t >= 0 && coin_priv_time_holds(t, &g.w.run.b)))
        return COIN_ESTEP;
    if (coin_priv_lies_flat(s)) {
        if (reached)
            *reached = 0;
        return COIN_RESTS;
    }
    if (coin_priv_lossless(l))
        return ideal(s, p, t, tol, reached);
    (void)coin_priv_losses_of(&g.w.l, l, &g.w.run.b);
    coin_priv_run_unlimited(&g.w.run, s);
    g.rem.sum = t;
    g.rem.low = 0;
    g.tol = tol;
    g.tries = 0;
    g.stride = coin_priv_first_stride(tol);
    status = approach(&g);
    if (g.w.run.steps > 0)
        coin_priv_read_lean(&g.w.run.g);
    coin_state end = coin_priv_run_state(&g.w.run);
    if (status == COIN_RESTS)
        end.wY = 0;
    const int lost = !coin_priv_state_holds(&end, &g.w.run.b);
    if (!lost)
        coin_priv_copy_state(s, &end);
    if (reached)
        *reached = lost ? 0 : coin_priv_passed(t, &g.rem);
    return lost || status == COIN_ESTEP ? coin_priv_refusal(s, g.w.run.b.a)
                                        : status;
}
