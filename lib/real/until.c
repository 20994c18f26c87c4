/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"
#include "../step/advance.h"

#include "event.h"

#define EVERY_BIT (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT)

/* The largest tol of the steps, whatever the caller asks for.  With a larger
 * one they would err by more than 1e-6, the part of mu up to which coin.h
 * allows an excursion beyond the cone to be missed. */
#define COARSEST 1e-6

/* A motion under way. */
struct moving {
    coin_priv_run run;
    coin_priv_lengths lengths;
    coin_priv_pace pace;
    double t;
    coin_priv_sum rem; /* of t, still to go */
};

/* Makes one step in tau.  If it passes the end of the time, others lead back.
 * Makes none if the time left is short. */
static int32_t step(struct moving *g, coin_priv_stretch *w)
{
    coin_priv_run *const r = &g->run;
    int32_t status = COIN_OK;
    w->tau = 0;
    do {
        if (coin_priv_one_step_suffices(r, &g->lengths, g->rem.sum))
            break;
        status = coin_priv_advance_by(r, &g->lengths, &g->pace, &g->rem);
        w->tau += status == COIN_OK ? g->pace.tau : 0;
    } while (status == COIN_OK && g->rem.sum * g->t < 0);
    return status;
}

/* The next stretch: a step in tau, and the last in t if that is near; *last if
 * the time is over. */
static int32_t next_stretch(struct moving *g, coin_priv_stretch *w, int *last)
{
    coin_priv_run *const r = &g->run;
    const double rem = g->rem.sum;
    w->from = g->run;
    w->t = 0;
    int32_t status = step(g, w);
    *last = status == COIN_OK &&
            coin_priv_one_step_suffices(r, &g->lengths, g->rem.sum);
    if (*last) {
        const double left = g->rem.sum;
        const double tau = coin_priv_tau_of(&r->b, &r->g.y, left);
        if (r->steps > 0)
            coin_priv_read_lean(&r->g);
        status = coin_priv_last_step(r, &g->lengths, &g->rem);
        if (status == COIN_OK && left != 0) {
            w->tau += tau;
            w->t = rem;
        }
    }
    w->to = r->g.y;
    return status;
}

/* The motion is at the end of a stretch, at whose begin the time `rem` was
 * left.  Puts it back to the event found in the stretch.  If rounding gives the
 * time left the wrong sign, it becomes 0. */
static void stop_at(struct moving *g, const coin_priv_moment *event,
                    coin_priv_sum rem)
{
    coin_priv_add(&rem, -event->run.g.added.t);
    const double side = g->t < 0 ? -1 : 1, left = side * rem.sum;
    g->run = event->run;
    g->rem.sum = side * (left + fabs(left)) / 2;
    g->rem.low = rem.low;
}

static int32_t follow(struct moving *g, coin_priv_stretch *w,
                      const coin_priv_search *f)
{
    coin_priv_moment m;
    int32_t status = COIN_OK;
    for (int last = g->rem.sum == 0; status == COIN_OK && !last;) {
        const coin_priv_sum rem = g->rem;
        status = next_stretch(g, w, &last);
        if (g->run.steps == w->from.steps)
            break;
        if (coin_priv_first_event(&m, f, w)) {
            stop_at(g, &m, rem);
            return m.bits;
        }
    }
    return status;
}

/* Checks the arguments and starts the motion.  Returns an error, or the bits
 * that hold at the start. */
static int32_t prepare(struct moving *g, coin_priv_stretch *w,
                       coin_priv_search *f, const coin_state *s, double t)
{
    const int32_t status = coin_priv_check(s, f->p, &g->run.b);
    if (status != COIN_OK)
        return status;
    const double w0 = sqrt(g->run.b.g_a);
    if (!coin_priv_time_holds(t, &g->run.b))
        return COIN_ESTEP;
    coin_priv_run_unlimited(&g->run, s);
    g->lengths = coin_priv_lengths_of(f->tol < COARSEST ? f->tol : COARSEST);
    g->t = t;
    g->rem.sum = t;
    g->rem.low = 0;
    w->unit = coin_priv_sundman_tau(&g->run.b, &g->run.g.y, 1);
    f->tol /= w0;
    w->from = g->run;
    w->to = g->run.g.y;
    w->t = 0;
    coin_priv_stretch_know(w, 1);
    const int32_t bits = coin_priv_bits_at(f, s, &w->force);
    return bits == 0 && t >= 0 && coin_priv_lies_flat(s) ? COIN_EFLAT : bits;
}

int32_t coin_advance_until(coin_state *s, const coin_params *p, double t,
                           double tol, double mu, int32_t bits, double *reached)
{
    struct moving g;
    coin_priv_stretch w;
    coin_priv_search f = {p, mu, 0, 1, tol, bits};
    const int good = coin_priv_tol_is_valid(tol) && mu >= 0 && bits != 0 &&
                     (bits & ~EVERY_BIT) == 0;
    if (bits & COIN_SLIPS) {
        f.per_F = mu > 1 ? 1 / mu : 1;
        f.per_N = mu > 1 ? 1 : mu;
    }
    int32_t status = good ? prepare(&g, &w, &f, s, t) : COIN_EARG;
    if (status != COIN_OK) {
        if (reached && (status > 0 || status == COIN_EFLAT))
            *reached = 0;
        return status;
    }
    status = follow(&g, &w, &f);
    if (status < 0 && g.run.steps > 0)
        coin_priv_read_lean(&g.run.g);
    status = coin_priv_end_call(s, &g.run, status, t, &g.rem, reached);
    return status == COIN_OK ? coin_priv_bits_at(&f, s, &w.force) : status;
}
