/* SPDX-License-Identifier: MIT */
/* Whether a step of a rolling coin keeps within the cone of friction. */
#include "../motion/pinned.h"

#include "cone_by_series.h"
#include "slide.h"

/* A coin whose square margin is above this rolls, whatever rounding does.  If
 * each input is rounded once more, the square margin of random states of any
 * body changes by 1.3e-15 at most. */
#define CLEAR 1e-12

/* A step of more strides than this is cut in two halves if it cannot be judged
 * as a whole.  Only the cost depends on it: a half of a short step costs as
 * much as cone.c, which decides then.  With half or twice of it random slides
 * take the same number of steps (make tuning). */
#define HALVED 0.5

/* If the lean leaves the range between the turning points by more than this, in
 * sin theta, they were not those of a swing.  On an unstable steady motion
 * rounding makes the lean turn round. */
#define WIDER 1e-9

/* Calls coin_priv_surely_in_cone() for both halves of the step just made.
 * Returns 0 for a short step, which is not cut. */
static int judge_halves(coin_priv_sliding *g, const coin_priv_end *from,
                        const coin_priv_end *to, double tau, double rate)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_run at = g->w.run;
    const double half = tau / 2, stride = fabs(half) * rate;
    coin_priv_end mid;
    if (!(stride > HALVED / 2))
        return 0;
    coin_priv_again(g, half);
    coin_priv_end_of(&mid, &g->contact, &f, &g->w.l, &g->w.run.g.y, 1 / rate);
    g->w.run = at;
    return coin_priv_surely_in_cone(&g->contact, &f, &g->w.l, from, &mid, half,
                                    stride) &&
           coin_priv_surely_in_cone(&g->contact, &f, &g->w.l, &mid, to, half,
                                    stride);
}

/* Judges the step just made of a coin without losses by series of the force:
 * returns 1 if it is certain that the coin rolls all along. */
static int judge_by_series(coin_priv_sliding *g, double tau, double rate)
{
    const double mu = g->contact.mu_static;
    const coin_priv_search f = {
        &g->p, mu, mu > 1 ? 1 / mu : 1, mu > 1 ? 1 : mu, 0, COIN_SLIPS,
    };
    coin_priv_stretch *const w = &g->series;
    w->from.g.y = g->from.y;
    w->to = g->w.run.g.y;
    w->unit = 1 / rate;
    w->tau = tau;
    w->t = g->ended_in_t ? g->w.run.g.added.t : 0;
    return coin_priv_judge_stretch(&f, w, 1 / rate);
}

/* The same for a coin with losses, by the forces at the ends of the step and
 * within. */
static int judge_by_ends(coin_priv_sliding *g, double tau, double rate)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_losses *l = &g->w.l;
    const coin_priv_end *const from = &g->ends[g->now];
    g->now = !g->now;
    coin_priv_end *const to = &g->ends[g->now];
    coin_priv_end_of(to, &g->contact, &f, l, &g->w.run.g.y, 1 / rate);
    return coin_priv_surely_in_cone(&g->contact, &f, l, from, to, tau,
                                    fabs(tau) * rate) ||
           (to->square_margin > 0 && judge_halves(g, from, to, tau, rate));
}

/* Whether the coin rolls all along the step just made because it did so before
 * at the same leans.  Without losses F/N depends on the lean alone: the
 * integrals give wY and wZ at each lean, and the energy gives wX^2.  The sign
 * of wX changes the sign of F along e_X, and nothing else.  So a coin that kept
 * within the cone from one turning point of its lean to the next keeps within
 * it for ever.  If errors take it to a lean beyond those, the step is tested.
 */
static int is_repeated(const coin_priv_sliding *g)
{
    const double sth = g->w.run.g.y.sth;
    const int within = sth >= g->least_sth && sth <= g->most_sth;
    return !g->lossy && g->turning_points >= 2 && within;
}

int coin_priv_judge_step(coin_priv_sliding *g, double tau, double rate)
{
    const coin_priv_variables *y = &g->w.run.g.y;
    if (is_repeated(g))
        return 1;
    if (coin_priv_larger(g->least_sth - y->sth, y->sth - g->most_sth) > WIDER)
        g->turning_points = 0;
    g->turning_points += (g->from.y.wX < 0) != (y->wX < 0);
    g->least_sth = coin_priv_lesser(g->least_sth, y->sth);
    g->most_sth = y->sth > g->most_sth ? y->sth : g->most_sth;
    return g->lossy ? judge_by_ends(g, tau, rate)
                    : judge_by_series(g, tau, rate);
}

void coin_priv_judge_here(coin_priv_sliding *g)
{
    const coin_priv_field f = coin_priv_field_of(&g->w.run.b, 1);
    const coin_priv_variables *y = &g->w.run.g.y;
    if (g->lossy) {
        coin_priv_end_of(&g->ends[g->now], &g->contact, &f, &g->w.l, y,
                         1 / coin_priv_roll_rate(g));
        g->surely_rolls = g->ends[g->now].square_margin > CLEAR;
    } else
        g->surely_rolls =
            coin_priv_square_margin_at(&g->contact, &f, y) > CLEAR;
    g->turning_points = 0;
    g->least_sth = g->most_sth = y->sth;
}
