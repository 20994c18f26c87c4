/* SPDX-License-Identifier: MIT */
/* Whether a step of a rolling coin keeps within the cone of friction. */
#include "../motion/pinned.h"

#include "part.h"
#include "slide.h"

/* A coin whose margin is above this rolls, whatever rounding does. */
#define CLEAR 1e-12

/* A longer stride that is not judged as a whole may be so by halves. */
#define HALVED 0.5

/* Whether the step made, with losses, is plain by halves. */
static int is_plain_by_halves(coin_priv_sliding *g, const coin_priv_end *from,
                              const coin_priv_end *to, double tau, double rate)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_run at = g->w.run;
    const double half = tau / 2, stride = fabs(half) * rate;
    coin_priv_end mid;
    if (!(stride > HALVED / 2))
        return 0;
    coin_priv_again(g, half);
    coin_priv_end_of(&mid, &g->table, &f, &g->w.l, &g->w.run.g.y, 1 / rate);
    g->w.run = at;
    return coin_priv_plain(&g->table, &f, &g->w.l, from, &mid, half, stride) &&
           coin_priv_plain(&g->table, &f, &g->w.l, &mid, to, half, stride);
}

static coin_priv_search search_of(const coin_priv_sliding *g)
{
    const double mu = g->table.mu_static;
    const coin_priv_search f = {
        &g->p, mu, mu > 1 ? 1 / mu : 1, mu > 1 ? 1 : mu, 0, COIN_SLIPS,
    };
    return f;
}

/* Whether the coin certainly rolls all along the step made, without losses: by
 * so many terms of series. */
static int is_plain_by_series(coin_priv_sliding *g, double tau, double rate,
                              int terms)
{
    const coin_priv_search f = search_of(g);
    coin_priv_stretch *const w = &g->series;
    w->from.g.y = g->from.y;
    w->to = g->w.run.g.y;
    w->unit = 1 / rate;
    w->tau = tau;
    w->t = g->landed ? g->w.run.g.added.t : 0;
    g->at = -1;
    return coin_priv_is_clear_all_along(&f, w, 1 / rate, terms);
}

/* How many terms the step made needs, by the force where it began: few, if
 * coin_priv_plain() may do without series, or if that force is not there. */
static int terms_for(const coin_priv_sliding *g, double stride)
{
    const coin_priv_search f = search_of(g);
    coin_priv_force at;
    if (g->lossy || (g->at < 0 && g->series.force.terms == 0))
        return COIN_PRIV_FORCE_FEW;
    if (g->at < 0)
        return coin_priv_terms_for(&f, &g->series.force, stride);
    at.along[0].at[1] = g->ends[g->at].force.X;
    at.across[0].at[1] = g->ends[g->at].force.h;
    at.normal[0].at[1] = g->ends[g->at].force.N;
    return coin_priv_terms_for(&f, &at, stride);
}

/* Whether the coin certainly rolls all along the step made. */
static int is_plain(coin_priv_sliding *g, double tau, double rate)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_losses *l = g->lossy ? &g->w.l : NULL;
    const double stride = fabs(tau) * rate;
    const int terms = terms_for(g, stride);
    if (terms > COIN_PRIV_FORCE_FEW)
        return is_plain_by_series(g, tau, rate, terms);
    coin_priv_end *const from = &g->ends[g->at > 0];
    if (g->at < 0)
        coin_priv_end_of(from, &g->table, &f, l, &g->from.y, 1 / rate);
    g->at = g->at <= 0;
    coin_priv_end *const to = &g->ends[g->at];
    coin_priv_end_of(to, &g->table, &f, l, &g->w.run.g.y, 1 / rate);
    if (coin_priv_plain(&g->table, &f, l, from, to, tau, stride))
        return 1;
    if (!(to->margin > 0))
        return 0;
    return g->lossy ? is_plain_by_halves(g, from, to, tau, rate)
                    : is_plain_by_series(g, tau, rate, COIN_PRIV_FORCE_SOME);
}

/* Whether the coin rolls all along the step made since it did so before at the
 * same leans.  Without losses F and N depend on the lean alone: wY and wZ are
 * functions of it by the integrals, wX^2 is one by the energy, and with wX only
 * the sign of F along e_X changes.  So a coin that kept within the cone from
 * one turning point of its lean to the next keeps within it for ever.  Errors
 * may lead it to other leans, which are then looked at. */
static int is_repeated(coin_priv_sliding *g)
{
    const double sth = g->w.run.g.y.sth;
    if (g->lossy || g->turns < 2 || sth < g->low || sth > g->high)
        return 0;
    g->at = -1;
    g->series.force.terms = 0;
    return 1;
}

int coin_priv_keeps_rolling(coin_priv_sliding *g, double tau, double rate)
{
    const coin_priv_variables *y = &g->w.run.g.y;
    if (is_repeated(g))
        return 1;
    g->turns += (g->from.y.wX < 0) != (y->wX < 0);
    g->low = coin_priv_lesser(g->low, y->sth);
    g->high = y->sth > g->high ? y->sth : g->high;
    return is_plain(g, tau, rate);
}

void coin_priv_see(coin_priv_sliding *g)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_variables *y = &g->w.run.g.y;
    g->at = 0;
    coin_priv_end_of(&g->ends[0], &g->table, &f, g->lossy ? &g->w.l : NULL, y,
                     1 / coin_priv_roll_rate(g));
    g->seen = g->ends[0].margin > CLEAR;
    g->turns = 0;
    g->low = g->high = y->sth;
}
