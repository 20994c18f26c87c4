/* SPDX-License-Identifier: MIT */
/* The time to rest, and losses for a time to rest, by settling copies. */
#include "../motion/pinned.h"

#include "move.h"
#include "settle.h"

/* The tolerance of the settlings of a fit.  Measured: TOL in tables.md. */
#define TOL 1e-6

/* A copy of a start whose angles and path have all their room left. */
static coin_state copy_of(const coin_state *s)
{
    coin_state copy = *s;
    copy.phi = copy.psi = copy.x = copy.z = 0;
    return copy;
}

/* The sum of all coefficients but spin. */
static double slowing(const coin_losses *l)
{
    return l->damping + l->dry + l->viscous + l->layer + l->gap + l->rolling +
           l->angular;
}

/* Whether a coin stays upright: nothing leans it, and it spins, or rolls and
 * nothing slows it.  A spin fades, but not to 0. */
static int stays_upright(const coin_state *s, const coin_losses *l)
{
    const int rolls_on = s->wZ != 0 && slowing(l) == 0;
    return s->theta == 0 && s->wX == 0 && (s->wY != 0 ? s->wZ == 0 : rolls_on);
}

double coin_time_to_rest(const coin_state *s, const coin_params *p,
                         const coin_losses *l, double tol)
{
    coin_priv_constants b;
    double time = 0;
    if (!s || !p || coin_priv_check(s, p, &b) != COIN_OK ||
        coin_losses_check(l, p) != COIN_OK || !coin_priv_tol_in_range(tol))
        return (double)NAN;
    if (stays_upright(s, l))
        return (double)INFINITY;
    coin_state copy = copy_of(s);
    const int32_t status =
        coin_settle(&copy, p, l, (double)INFINITY, tol, &time);
    if (status == COIN_RESTS)
        return time;
    return slowing(l) == 0 ? (double)INFINITY : (double)NAN;
}

/* A time within CLOSE of the one asked for is it.  Factors that differ by JUMP
 * of themselves are one.  The search looks at up to PLACES factors on either
 * side of a first guess, each SPREAD times the next.  CLOSE is half the error
 * that coin.h allows.  Measured: CLOSE, JUMP, SPREAD, PLACES in tables.md. */
#define CLOSE 5e-3
#define JUMP 1e-3
#define SPREAD 1.02
#define PLACES 100

/* A settling of the first guesses may take LONG times the time asked for, and
 * later ones BEYOND of it: it is then known to be too long.  All settlings of a
 * search together may make TRIES trials of steps.  Measured: LONG, BEYOND,
 * TRIES in tables.md. */
#define LONG 2
#define BEYOND 1.02
#define TRIES 100000

/* A search for a factor. */
struct search {
    const coin_state *s;
    const coin_params *p;
    const coin_losses *l;
    double time;
    int tries; /* of steps: how many are left */
};

/* A factor tried, and its time to rest over the time asked for; no less than
 * `most` where it is longer than that, or where there is no answer. */
struct tried {
    double factor, at;
};

static coin_losses scaled(const coin_losses *l, double by)
{
    coin_losses r = *l;
    r.damping *= by;
    r.dry *= by;
    r.viscous *= by;
    r.layer *= by;
    r.gap *= by;
    r.rolling *= by;
    r.spin *= by;
    r.angular *= by;
    return r;
}

static struct tried try_factor(struct search *f, double factor, double most)
{
    const coin_losses l = scaled(f->l, factor);
    struct tried r = {factor, most};
    coin_state copy = copy_of(f->s);
    double time = 0;
    const int32_t status = coin_priv_settle(&copy, f->p, &l, most * f->time,
                                            TOL, &f->tries, &time);
    if (status == COIN_RESTS)
        r.at = time / f->time;
    else if (status == COIN_EPARAMS && factor > 1)
        r.at = 0; /* stronger than losses may be */
    return r;
}

static int is_close(const struct tried *r)
{
    return fabs(r->at - 1) <= CLOSE;
}

/* A factor between a weak and a strong one, or 0 where the time jumps between
 * them. */
static double between(struct search *f, double weak, double strong)
{
    while (fabs(strong - weak) > JUMP * strong) {
        const struct tried mid =
            try_factor(f, sqrt(weak) * sqrt(strong), BEYOND);
        if (is_close(&mid))
            return mid.factor;
        *(mid.at > 1 ? &weak : &strong) = mid.factor;
    }
    return 0;
}

/* The next factor in one direction: 1 and *found if it is near, or if a bracket
 * between it and the last one has a factor. */
static int look(struct search *f, struct tried *last, double by, double *found)
{
    const struct tried next = try_factor(f, last->factor * by, BEYOND);
    const struct tried before = *last;
    *last = next;
    *found = is_close(&next) ? next.factor : 0;
    if (*found == 0 && (next.at > 1) != (before.at > 1))
        *found = next.at > 1 ? between(f, next.factor, before.factor)
                             : between(f, before.factor, next.factor);
    return *found > 0;
}

/* A factor near a guess, from the nearest brackets on; 0 if there is none. */
static double search_from(struct search *f, struct tried guess)
{
    struct tried low = guess, high = guess;
    double found = is_close(&guess) ? guess.factor : 0;
    for (int i = 0; i < PLACES && found == 0 && f->tries > 0; ++i)
        if (look(f, &low, 1 / SPREAD, &found) || look(f, &high, SPREAD, &found))
            break;
    return found;
}

int32_t coin_losses_fit(coin_losses *l, const coin_state *s,
                        const coin_params *p, double time)
{
    coin_priv_constants b;
    if (!l || !s || !p || !(time > 0 && time <= DBL_MAX))
        return COIN_EARG;
    if (coin_losses_check(l, p) != COIN_OK)
        return COIN_EPARAMS;
    const int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    if (!(LONG * time * sqrt(b.g_a) <= COIN_PRIV_TIME_MAX))
        return COIN_EARG;
    struct search f = {s, p, l, time, TRIES};
    struct tried guess = try_factor(&f, 1, LONG);
    /* The time is about inversely proportional to the factor. */
    for (int i = 0; i < 20 && fabs(guess.at - 1) > 0.1 && guess.at > 0; ++i)
        guess = try_factor(&f, guess.factor * guess.at, LONG);
    const double factor = search_from(&f, guess);
    if (factor == 0)
        return COIN_EDOMAIN;
    *l = scaled(l, factor);
    return COIN_OK;
}
