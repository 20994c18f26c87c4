/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "control.h"
#include "losses.h"

/* The coefficients of a step, and where its error goes. */
struct lossy_field {
    coin_priv_field ideal; /* first: rk8.t.h passes a pointer to it */
    const coin_priv_losses *l;
    double perw, perwZ; /* weights of the errors of wX, wY and of wZ */
    double most;        /* the sum of the rates from which a trial runs away */
    double *by5, *by3;  /* see coin_priv_error_of() */
    int *holds;         /* 0 once it has run away */
};

/* A trial runs away if a stage has so many times the rates of the start, and
 * sqrt(g/a): its step is far too long for the losses. */
#define RUNAWAY 1e6

/* The sum of the rates. */
COIN_PRIV_INLINE double rates_of(const coin_priv_variables *y)
{
    return fabs(y->wX) + fabs(y->wY) + fabs(y->wZ);
}

/* h d/dtau of the variables: the ideal coin's, and the losses. */
COIN_PRIV_INLINE coin_priv_variables with_losses(const coin_priv_field *f,
                                                 const coin_priv_losses *l,
                                                 const coin_priv_variables *y)
{
    const coin_priv_slowing slow = coin_priv_slowing_of(l, y);
    coin_priv_variables d = coin_priv_sundman_slopes(f, y);
    d.wX += f->h * slow.wX;
    d.wY += f->h * slow.wY;
    d.wZ += f->h * slow.wZ;
    return d;
}

COIN_PRIV_INLINE coin_priv_variables lossy_first(const coin_priv_field *f,
                                                 const coin_priv_variables *y)
{
    const struct lossy_field *with =
        (const struct lossy_field *)(const void *)f;
    return with_losses(f, with->l, y);
}

/* The same at a later stage; 0 once the trial runs away, so that nothing
 * overflows. */
COIN_PRIV_INLINE coin_priv_variables lossy(const coin_priv_field *f,
                                           const coin_priv_variables *y)
{
    const struct lossy_field *with =
        (const struct lossy_field *)(const void *)f;
    if (!(rates_of(y) < with->most)) {
        const coin_priv_variables none = {0, 0, 0, 0, 0, 0, 0, 0, 0};
        *with->holds = 0;
        return none;
    }
    return with_losses(f, with->l, y);
}

/* The sum of squares of the errors. */
COIN_PRIV_INLINE double size2(const struct lossy_field *f,
                              const coin_priv_variables *e)
{
    const double wX = e->wX * f->perw, wY = e->wY * f->perw;
    const double wZ = e->wZ * f->perwZ;
    return wX * wX + wY * wY + wZ * wZ + e->cth * e->cth + e->sth * e->sth +
           e->sph * e->sph + e->cph * e->cph;
}

/* What the estimate of DOP853 needs. */
COIN_PRIV_INLINE void note_error(const coin_priv_field *f,
                                 const coin_priv_variables *e5,
                                 const coin_priv_variables *e3)
{
    const struct lossy_field *with =
        (const struct lossy_field *)(const void *)f;
    *with->by5 = size2(with, e5);
    *with->by3 = size2(with, e3);
}

#define SLOPES lossy
#define FIRST_SLOPES lossy_first
#define POSE_SLOPES coin_priv_sundman_pose_slopes
#define EACH_POSE(F) F(phi) F(psi) F(t)
#define ERROR_TO note_error
#include "../step/rk8.t.h"
#include "../step/sundman.h"

#include "lossy.h"

/* The part of the friction's rate that is added to the coin's own: a step of
 * the longest stride in control.h is then LONGEST_STRIDE/FRICTION = 4 of its
 * relaxation times; the method is stable up to 6.  With half of it one call in
 * 20 takes more steps than are allowed.  Twice takes 1.8 times as many steps
 * for the same errors (make tuning). */
#define FRICTION 0.3

/* The estimate of a step's error is guarded if the step covers more than this
 * part of the way to where the contact turns round: it may pass through 0
 * there. With 0.2 there are 0.4 % fewer steps, and the largest error is three
 * times as large.  With 0.02 both are the same (make tuning).  If every
 * estimate is guarded, a long spin costs 44 % more (make real-cost). */
#define NEAR 0.05

/* The error of a step that is refused since it covers too much of that way.  It
 * exceeds every allowed error, and its quotient by an allowed one is finite. */
#define REFUSED 1e100

/* If the point where the contact turns round is 1/FAR natural units of tau away
 * or more, it does not limit a step. */
#define FAR 1e-30

/* The coin's own rate in tau, over which coin_advance() measures its steps. */
static double ideal_rate(const coin_priv_lossy *w)
{
    return 1 / coin_priv_sundman_tau(&w->run.b, &w->run.g.y, 1);
}

double coin_priv_lossy_rate(const coin_priv_lossy *w)
{
    return ideal_rate(w) +
           FRICTION * coin_priv_friction_rate(&w->l, &w->run.g.y); /* (71) */
}

/* The width z of (71) about u = cos(theta) d(psi)/dt = 0, which a step need not
 * resolve.  For dry and rolling friction it is the width of the softening.  For
 * layer and damping, which have none, it is so small that they change the rates
 * by no more than `effect` within it.  If several of them act, the least width
 * counts. */
static double zone(const coin_priv_lossy *w, double du, double effect)
{
    const coin_priv_variables *y = &w->run.g.y;
    const coin_priv_losses *l = &w->l;
    const double w0 = sqrt(w->run.b.g_a), turn = effect * w0 * du;
    double least = (double)INFINITY;
    if (l->solid > 0)
        least = sqrt(l->soft2) * y->cth;
    if (l->layer > 0) { /* A^(7/16), a little below A^(2/5) */
        const double A =
            turn * l->IX * y->cth * sqrt(y->cth / w0) / (l->layer * w0 * w0);
        const double root = sqrt(sqrt(sqrt(sqrt(A))));
        const double cube = root * root * root;
        least = coin_priv_lesser(w0 * cube * cube * root, least);
    }
    if (l->damping > 0) {
        least =
            coin_priv_lesser(sqrt(turn / (l->damping * rates_of(y))), least);
    }
    return least;
}

double coin_priv_turn_bound(const coin_priv_lossy *w, double effect)
{
    const coin_priv_variables *y = &w->run.g.y;
    const double u = coin_priv_roll_speed(y->wY, y->wZ, y->sth, y->cth);
    const double w0 = sqrt(w->run.b.g_a), du = fabs(w->du);
    if (!(du > FAR * w0 * (w0 + fabs(u))))
        return (double)INFINITY;
    const double least = zone(w, du, effect);
    return COIN_PRIV_TURN_ROUND * sqrt(u * u + least * least) / du;
}

double coin_priv_lossy_bound(coin_priv_lossy *w, double effect)
{
    const coin_priv_variables *y = &w->run.g.y;
    const coin_priv_field f = coin_priv_field_of(&w->run.b, 1);
    const coin_priv_variables d = with_losses(&f, &w->l, y);
    w->du = y->cth * d.wZ + y->sth * d.wY + d.cth * y->wZ + d.sth * y->wY;
    return coin_priv_turn_bound(w, effect);
}

/* After a part x of the step u has changed by a x + b x^2.  The contact
 * turns round where |a| x + |b| x^2 = way, at x = 1/part.  If a and b have
 * different signs, or lead away from there, this part is too large, which is
 * safe. */
double coin_priv_part_of_way(const coin_priv_lossy *w, double then, double tau,
                             double effect)
{
    const coin_priv_variables *y = &w->run.g.y;
    const double u = coin_priv_roll_speed(y->wY, y->wZ, y->sth, y->cth);
    const double a = w->du * tau, b = then - u - a;
    const double most = fabs(a) + fabs(b);
    if (!(most > NEAR * NEAR * fabs(u)))
        return 0;
    const double least = zone(w, most / fabs(tau), effect);
    if (!(least <= DBL_MAX)) /* friction is smooth */
        return 0;
    const double way = sqrt(u * u + least * least) + DBL_MIN;
    return (fabs(a) + sqrt(a * a + 4 * way * fabs(b))) / (2 * way);
}

/* The `size` of coin_priv_guarded_error() for a step from y to z.  Rates count
 * in parts of w0, and the rounding is that of coin_priv_allowed_in(). */
static double size_of(const coin_priv_variables *y,
                      const coin_priv_variables *z, double w0)
{
    const double rates = rates_of(y);
    const double turned =
        fabs(z->wX - y->wX) + fabs(z->wY - y->wY) + fabs(z->wZ - y->wZ);
    const double moved = fabs(z->sth - y->sth) + fabs(z->cth - y->cth) +
                         fabs(z->sph - y->sph) + fabs(z->cph - y->cph);
    const double size = 1 + rates / w0;
    return coin_priv_lesser(turned / w0 + moved + 4000 * DBL_EPSILON * size,
                            size);
}

void coin_priv_lossy_try(coin_priv_trial *trial, const coin_priv_lossy *w,
                         double tau, double effect)
{
    const double natural = sqrt(w->run.b.g_a);
    const double rate = ideal_rate(w);
    const double slow = rate < natural ? rate : natural;
    double by5, by3;
    int holds = 1;
    const struct lossy_field f = {
        coin_priv_field_of(&w->run.b, tau),
        &w->l,
        1 / slow,
        1 / natural,
        RUNAWAY * (rates_of(&w->run.g.y) + natural),
        &by5,
        &by3,
        &holds,
    };
    trial->adds.theta = 0; /* the pair holds it */
    const double lowest =
        rk8_sums(&trial->next, &trial->adds, &w->run.g.y, &f.ideal);
    coin_priv_normalize(&trial->next);
    const int above = coin_priv_lesser(lowest, trial->next.cth) > 0;
    trial->error = (double)INFINITY;
    if (!(holds & above))
        return;
    const coin_priv_variables *z = &trial->next;
    const double then = coin_priv_roll_speed(z->wY, z->wZ, z->sth, z->cth);
    const double part = coin_priv_part_of_way(w, then, tau, effect);
    if (part > COIN_PRIV_TURNED)
        trial->error = REFUSED;
    else if (part > NEAR)
        trial->error =
            coin_priv_guarded_error(by5, by3, size_of(&w->run.g.y, z, natural));
    else
        trial->error = coin_priv_error_of(by5, by3);
}

int32_t coin_priv_lay_flat(coin_priv_run *r)
{
    coin_priv_variables *y = &r->g.y;
    y->sth = y->sth < 0 ? -1 : 1;
    y->cth = 0;
    y->wY = 0;
    y->wX = y->sth * fabs(y->wX);
    return COIN_RESTS;
}
