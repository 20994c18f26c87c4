/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "control.h"
#include "friction.h"
#include "slide.h"

/* The most trials of coin_priv_locate().  The method of Illinois needs few:
 * with at most 10 trials the steps and errors of random slides stay the same
 * (make tuning).  A bracket that is halved so often is below rounding. */
#define TRIALS 60

coin_priv_slip coin_priv_slip_of(const coin_priv_variables *y, double uX,
                                 double uh)
{
    const coin_priv_slip at = {
        y->wX,  y->wY,  y->wZ, y->sth, y->cth, uX, uh,
        y->sph, y->cph, 0,     0,      0,      0,  0,
    };
    return at;
}

int coin_priv_slip_into(coin_priv_run *r, const coin_priv_slip *y)
{
    coin_priv_variables next = {
        y->wX, y->wY, y->wZ, y->sth, y->cth, 0, 0, y->sph, y->cph,
    };
    const coin_priv_pose adds = {0, y->phi, y->psi, y->x, y->z, y->t};
    if (y->cth > 0) /* else flat */
        coin_priv_normalize(&next);
    return coin_priv_sundman_accept(r, &next, &adds);
}

int32_t coin_priv_slip_take(coin_priv_sliding *g, const coin_priv_slip *y)
{
    if (!coin_priv_slip_into(&g->w.run, y))
        return COIN_ESTEP;
    g->uX = y->uX;
    g->uh = y->uh;
    coin_priv_add(&g->rem, -y->t);
    return COIN_OK;
}

/* A slip frees the lean: the inertia against its changes is I_X + M a^2 sin^2
 * theta instead of I_X + M a^2.  For a disc, whose I_X is M a^2/4, the rate of
 * sundman.h is enough, and the rate is divided by 2 to be 1 there.  For a body
 * of small I_X the normal force has a narrow peak about upright, where M a^2
 * sin^2 theta is less than I_X.  An eighth of sin theta counts, so that the
 * longest step changes sin theta by 0.3 of itself and cannot pass over the
 * peak.  For random bodies of small I_X a quarter saves a fifth of the steps
 * and doubles the errors (make tuning). */
double coin_priv_slip_rate(const coin_priv_sliding *g)
{
    const coin_priv_body *b = &g->contact.b;
    const coin_priv_variables *y = &g->w.run.g.y;
    const double sth = y->sth / 8;
    const double freed = sqrt(b->m / (b->IX + b->m * (sth * sth))) / 2;
    /* Slopes are by t if psi is held. */
    const double tau = g->contact.psi_held
                           ? 1 / sqrt(b->g_a + y->wX * y->wX + y->wZ * y->wZ)
                           : coin_priv_sundman_tau(b, y, 1);
    return (freed > 1 ? freed : 1) / tau;
}

double coin_priv_slip_size(const coin_priv_contact *contact,
                           const coin_priv_slip *y)
{
    return (fabs(y->wX) + fabs(y->wY) + fabs(y->wZ) + fabs(y->uX) +
            fabs(y->uh) + contact->w0) *
           (fabs(y->sth) + fabs(y->cth));
}

void coin_priv_trial_slopes(double *dy, const double *y, const void *contact)
{
    const coin_priv_contact *t = (const coin_priv_contact *)contact;
    const coin_priv_slip *at = (const coin_priv_slip *)(const void *)y;
    if (isless(coin_priv_slip_size(t, at), t->most)) {
        coin_priv_slip_slopes(dy, y, contact);
        return;
    }
    const coin_priv_slip failed = {0, 0, 0, 0, 0, 0, 0,
                                   0, 0, 0, 0, 0, 0, (double)NAN};
    *(coin_priv_slip *)(void *)dy = failed;
}

double coin_priv_locate(coin_priv_sliding *g, coin_priv_event *event,
                        double at0, double h1, double at1)
{
    const double part = COIN_PRIV_LOCATED * g->tol, rounding = 2 * DBL_EPSILON;
    double h0 = 0;
    int before = 0;
    for (int i = 0; i < TRIALS; ++i) {
        const double off = (part > rounding ? part : rounding) * h1 / 2;
        /* at0, which is halved below, may have become 0. */
        if (!((h1 - h0 > 2 * off) & (at0 > 0)))
            break;
        const double x = h0 + (h1 - h0) * (at0 / (at0 - at1));
        const double low = h0 + off, high = h1 - off;
        const double h = x < low ? low : x > high ? high : x;
        const double at = event(g, h);
        const int side = at < 0 ? -1 : 1;
        if (side > 0) {
            h0 = h;
            at0 = at;
            at1 *= before == side ? 0.5 : 1; /* Illinois */
        } else {
            h1 = h;
            at1 = at;
            at0 *= before == side ? 0.5 : 1;
        }
        before = side;
    }
    return h0;
}

/* Starts a slide, after the checks. */
static void start(coin_priv_sliding *g, const coin_slide *d,
                  const coin_params *p, const coin_losses *l, double t,
                  double tol)
{
    static const coin_losses none = {0, 0, 0, 0, 0, 0, 0, 0};
    g->p = *p;
    g->losses = l ? *l : none;
    g->lossy = !coin_priv_lossless(&g->losses);
    g->w.run.b = g->contact.b;
    if (g->lossy)
        (void)coin_priv_losses_of(&g->w.l, &g->losses, &g->contact.b);
    coin_priv_run_unlimited(&g->w.run, &d->s);
    const coin_priv_slip y =
        coin_priv_slip_start(d, &g->w.run.g.y, g->contact.b.a);
    g->slips = coin_priv_slips(&g->contact, &y);
    g->uX = y.uX;
    g->uh = y.uh;
    g->surely_rolls = g->ended_in_t = 0;
    g->series.from.b = g->contact.b;
    g->series.force.terms = 0;
    g->now = 0;
    g->rem.sum = t;
    g->rem.low = 0;
    g->tol = tol;
    /* A roll without losses has steps of one stride, which none repeats. */
    g->lengths = coin_priv_lengths_of(tol / 16);
    g->roll_stride =
        g->lossy ? coin_priv_first_stride(tol) : g->lengths.stride / 2;
    g->slip_stride = coin_priv_first_stride(tol);
    g->tries = 0;
    if (!g->slips)
        coin_priv_judge_here(g);
}

/* The variables *at, with the slip velocity of the slide or 0. */
static coin_priv_slip slip_at(const coin_priv_sliding *g,
                              const coin_priv_variables *at, int slips)
{
    return coin_priv_slip_of(at, slips ? g->uX : 0, slips ? g->uh : 0);
}

/* What the coin does where the slide has come to: COIN_OK if it rolls,
 * COIN_SLIPS if it slips or is about to, COIN_ELIFT if it lifts off. */
static int32_t mode_of(const coin_priv_sliding *g)
{
    const int32_t slips = COIN_SLIPS, lifts = COIN_ELIFT;
    const coin_priv_contact *t = &g->contact;
    if (g->surely_rolls) /* then slips is 0 */
        return COIN_OK;
    const coin_priv_slip y = slip_at(g, &g->w.run.g.y, g->slips);
    if (g->slips)
        return coin_priv_clearance(t, &y, 1) > 0 ? slips : lifts;
    if (coin_priv_clearance(t, &y, 0) < 0)
        return coin_priv_can_slip(t, &y) ? slips : lifts;
    return coin_priv_static(t, &y).N > 0 ? COIN_OK : lifts;
}

/* Rolls and slips until the time is over. */
static int32_t go_on(coin_priv_sliding *g)
{
    int32_t status = COIN_OK;
    while (status == COIN_OK && g->rem.sum != 0) {
        if (g->tries > COIN_PRIV_SLIDE_TRIES)
            return COIN_ESTEP;
        status = g->slips ? coin_priv_slip_on(g) : coin_priv_roll_on(g);
    }
    return status == COIN_OK ? mode_of(g) : status;
}

/* Where the slide has come to.  vx and vz go with the phi that is returned.
 * The run's variables have a phi that differs by the error of the steps, and
 * the next call would take the difference for a slip. */
static coin_slide end_of(coin_priv_sliding *g, int32_t status)
{
    coin_slide end;
    double v[2];
    if (g->w.run.steps > 0 && !g->ended_in_t)
        coin_priv_read_lean(&g->w.run.g);
    end.s = coin_priv_run_state(&g->w.run);
    if (status == COIN_RESTS)
        end.s.wY = 0;
    const coin_priv_variables at = coin_priv_variables_of(&end.s);
    const coin_priv_slip y = slip_at(g, &at, g->slips | (status == COIN_SLIPS));
    coin_priv_centre_velocity(v, &y, g->contact.b.a);
    end.vx = v[0];
    end.vz = v[1];
    return end;
}

int32_t coin_slide_advance(coin_slide *d, const coin_params *p,
                           const coin_friction *f, const coin_losses *l,
                           double t, double tol, double *reached)
{
    coin_priv_sliding g;
    if (!d || !p || !f || !coin_priv_tol_is_valid(tol))
        return COIN_EARG;
    if (coin_priv_contact_of(&g.contact, p, f, l) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coin_priv_check_slide(d, &g.contact.b);
    if (status != COIN_OK)
        return status;
    if (!(t >= 0 && coin_priv_time_holds(t, &g.contact.b)))
        return COIN_ESTEP;
    double moved = 0;
    status = COIN_RESTS;
    if (!coin_priv_lies_flat(&d->s)) {
        start(&g, d, p, l, t, tol);
        status = mode_of(&g);
        if (t > 0 && status != COIN_ELIFT) {
            status = go_on(&g);
            const coin_slide end = end_of(&g, status);
            const int lost =
                coin_priv_check_slide(&end, &g.contact.b) != COIN_OK;
            if (!lost) {
                *d = end;
                /* A moment is located to within COIN_PRIV_LOCATED tol, and may
                 * lie so far beyond t. */
                moved = coin_priv_lesser(coin_priv_passed(t, &g.rem), t);
            }
            if (lost || status == COIN_ESTEP)
                status = coin_priv_refusal(&d->s, g.contact.b.a);
        }
    }
    if (reached)
        *reached = moved;
    return status;
}
