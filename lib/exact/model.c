/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../step/extrapolation.h"
#include "../step/sundman.h"

#include "steady.h"
#include "wobble.h"

/* A model is compared with the orbit at AT_THE_END times in the last two
 * periods of the horizon, and at EVERYWHERE times all over it. */
#define AT_THE_END 32
#define EVERYWHERE 96

/* Where a model is compared, it may differ by this part of the tolerance.  The
 * rest is for the times between. */
#define KEPT 0.5

/* The part of the tolerance that the error of the full motion may take. */
#define OWN 0.25

/* Where there is no orbit, the motion is followed by steps, for at most
 * TIME_MAX natural units and STEPS_MAX steps.  Such a motion is unstable or
 * next to the table, so that no cheaper model holds for longer. */
#define TIME_MAX 64.0
#define STEPS_MAX 4096

/* No steady motion is looked for whose lean differs by more than this: such a
 * swing would not be small. */
#define NEAR 0.5

/* The stride of these steps.  It is less than half of the stride of
 * coin_advance() at its least tol, because a model is compared at many places.
 */
#define STRIDE 0.15

/* The rounding of the acceleration of the lean next to a steady motion, over
 * the size of its terms: 128 u, u = 2^-53. */
#define ROUNDED (64 * DBL_EPSILON)

/* A scene, and the steady motion next to its start. */
struct scene {
    coin_priv_body b;
    const coin_state *start;
    double horizon, tol;
    /* near: whether there is such a steady motion.  swings: whether the start
     * is a small wobble about it. */
    int near, swings;
    coin_state steady; /* that motion, its constant rates and its lambda^2 */
    coin_priv_steady rates;
    double lambda2;
    coin_priv_wobble wobble;
};

/* Looks for the steady motion, within `most` of the start's lean. */
static void find_steady(struct scene *scene, double most)
{
    const coin_priv_body *b = &scene->b;
    coin_state *steady = &scene->steady;
    scene->near = scene->swings = 0;
    if (coin_priv_steady_near(scene->start, b, most, steady) != COIN_OK)
        return;
    const coin_priv_sc th = coin_priv_sincos(steady->theta);
    scene->near = 1;
    scene->rates = coin_priv_steady_rates(steady, b, &th);
    scene->lambda2 = coin_priv_stability(steady, b, &th);
    scene->swings = coin_priv_wobble_begin(&scene->wobble, steady, scene->start,
                                           b, &th) == COIN_OK;
}

/* The largest difference of two poses, in radians and radii. */
static double apart(const coin_state *s, const coin_state *r, double a)
{
    const double d[5] = {s->theta - r->theta, s->phi - r->phi, s->psi - r->psi,
                         (s->x - r->x) / a, (s->z - r->z) / a};
    double most = 0;
    for (int i = 0; i < 5; ++i)
        most = fabs(d[i]) <= most ? most : fabs(d[i]);
    return most;
}

/* Whether a model gives the state *is at the time t, to within KEPT tol. */
static int keeps(const struct scene *scene, int32_t model, double t,
                 const coin_state *is)
{
    const coin_priv_body *b = &scene->b;
    coin_state said = scene->steady;
    const int32_t status =
        model == COIN_MODEL_STEADY
            ? coin_priv_steady_move(&said, &scene->rates, t)
            : coin_priv_wobble_at(&scene->wobble, b, t, &said);
    return (status == COIN_OK) & (apart(is, &said, b->a) <= KEPT * scene->tol);
}

/* The size of the terms of Eq. (14) that balance each other in a steady motion.
 */
static double terms_of(const coin_priv_body *b, const coin_state *s)
{
    return b->GJ * fabs(coin_priv_sincos(s->theta).s) +
           b->KJ * fabs(s->wY * s->wZ);
}

/* Whether steps can be trusted next to the steady motion.  If that motion is
 * unstable, rounding may keep the steps on it although the coin leaves it.  The
 * effect of rounding at the end of the horizon is the distance of two wobbles,
 * one of which is displaced by the rounding. */
static int is_known(const struct scene *scene)
{
    if (!scene->swings)
        return 0; /* no wobble is set */
    const coin_priv_body *b = &scene->b;
    const coin_state *steady = &scene->steady;
    coin_priv_wobble off = scene->wobble;
    coin_state is = *steady, may = *steady;
    off.Y += ROUNDED * terms_of(b, steady) / off.L;
    const int32_t failed =
        coin_priv_wobble_at(&scene->wobble, b, scene->horizon, &is) |
        coin_priv_wobble_at(&off, b, scene->horizon, &may);
    return (failed == COIN_OK) & (apart(&is, &may, b->a) <= OWN * scene->tol);
}

/* --------------------------------------------------------- with an orbit -- */
/* The k-th time of comparison: at first in the last two periods, then all over
 * the horizon in steps that no period divides. */
static double time_of(int k, double horizon, double period)
{
    const double two = 2 * fabs(period), all = fabs(horizon);
    const double end = two < all ? two : all;
    if (k < AT_THE_END) {
        const double left = k * end / AT_THE_END;
        return horizon < 0 ? horizon + left : horizon - left;
    }
    const double golden = 0.6180339887498949 * k;
    return horizon * (k - AT_THE_END + (golden - (int)golden)) / EVERYWHERE;
}

static int fits(const struct scene *scene, int32_t model, const coin_orbit *o)
{
    for (int k = 0; k < AT_THE_END + EVERYWHERE; ++k) {
        const double t = time_of(k, scene->horizon, o->period);
        coin_state is = *scene->start;
        const int32_t status = coin_orbit_at(o, t, &is);
        if ((status != COIN_OK) | (keeps(scene, model, t, &is) == 0))
            return 0;
    }
    return 1;
}

/* An upper bound of W, Eq. (47), over an orbit, from its energy and its largest
 * lean. */
static double fastest_of(const struct scene *scene, const coin_orbit *o)
{
    const coin_priv_body *b = &scene->b;
    const coin_priv_variables y = coin_priv_variables_of(scene->start);
    const double lean =
        coin_priv_larger(fabs(o->theta_min), fabs(o->theta_max));
    const double q = 1 / coin_priv_sincos(lean).c;
    const double T2 =
        b->J * y.wX * y.wX + b->IX * y.wY * y.wY + b->K * y.wZ * y.wZ;
    const double E2 = T2 + 2 * b->Mga * y.cth;              /* (23) */
    return sqrt((E2 / b->IX * q + b->g_a) * q + E2 / b->K); /* (47) */
}

/* The error of the heading at the horizon that comes from the lean about which
 * the orbit swings, or at which it stays.  Rounding moves that lean by what it
 * leaves of the acceleration, over the square of the rate of small swings. */
static double heading_off(const struct scene *scene, const coin_orbit *o)
{
    const coin_priv_body *b = &scene->b;
    const coin_priv_variables y = coin_priv_variables_of(scene->start);
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const coin_priv_sc th = {y.sth, y.cth};
    double off = 2 * DBL_EPSILON * terms_of(b, scene->start);
    double rate = 4 * COIN_PRIV_HALF_PI;
    if (o->period > 0)
        rate /= o->period;
    else {
        rate = sqrt(fabs(coin_priv_stability(scene->start, b, &th)));
        off += fabs(coin_priv_slopes_at(&f, &y).wX) + fabs(y.wX) * rate;
    }
    const double least2 = DBL_EPSILON * b->g_a;
    const double lean = off / coin_priv_larger(rate * rate, least2);
    const double W = sqrt(coin_priv_rate2(b->g_a, &y));
    return lean * (1 + W * y.q * fabs(scene->horizon));
}

/* The error of the orbit over the horizon, in radians and radii: ten times what
 * coin_orbit_at() states, for the heading and what it leads round the path, and
 * the rounding of angles of many turns.  The errors by the rounding of the time
 * and by that of the lean, which changes the rate of the heading, are added as
 * coin_orbit_at() states them. */
static double own_error(const struct scene *scene, const coin_orbit *o,
                        const coin_state *end)
{
    const double turned = fabs(end->phi - scene->start->phi);
    const double rolled = fabs(end->psi - scene->start->psi);
    const double periods = o->period > 0 ? fabs(scene->horizon) / o->period : 0;
    /* radius_max is NaN if the coin drifts.  Only == compares a NaN without an
     * exception. */
    const int circles = o->radius_max == o->radius_max;
    const double reach =
        circles && o->radius_max > 0 ? o->radius_max / scene->b.a : rolled;
    const double late =
        2 * DBL_EPSILON * (periods > 0 ? fabs(scene->horizon) + o->period : 0);
    const double heading = 1e-13 + 1e-15 * turned +
                           1e-14 * o->conditioning * periods +
                           fastest_of(scene, o) * late + heading_off(scene, o);
    return heading * (1 + reach) + 1e-15 * rolled;
}

/* -------------------------------------------------------------- by steps -- */
/* Steps over the horizon, and clears good[k] where model k differs.  Returns
 * COIN_OK at the end of the horizon, COIN_MODEL_STEPS after too many steps, or
 * an error. */
static int32_t follow(const struct scene *scene, int good[2])
{
    const double all = fabs(scene->horizon), side = scene->horizon < 0 ? -1 : 1;
    coin_priv_run r;
    coin_priv_sum t = {0, 0};
    double compared = 0;
    r.b = scene->b;
    coin_priv_run_unlimited(&r, scene->start);
    for (;;) {
        const double passed = fabs(t.sum);
        if (passed >= all * (compared / EVERYWHERE)) {
            coin_priv_read_lean(&r.g);
            const coin_state now = coin_priv_run_state(&r);
            for (int32_t k = COIN_MODEL_STEADY; k <= COIN_MODEL_WOBBLE; ++k)
                good[k] = good[k] && keeps(scene, k, t.sum, &now);
            ++compared;
        }
        if (passed >= all)
            return COIN_OK;
        if (r.g.y.cth < COIN_PRIV_FLAT)
            return COIN_EFLAT;
        if (r.steps == STEPS_MAX)
            return COIN_MODEL_STEPS;
        r.g.added.t = 0;
        const double tau = coin_priv_sundman_tau(&r.b, &r.g.y, STRIDE);
        if (!coin_priv_extrapolate(&r, side * tau))
            return COIN_ESTEP;
        coin_priv_add(&t, r.g.added.t);
    }
}

static int32_t judge_by_steps(struct scene *scene)
{
    if (!(fabs(scene->horizon) <= TIME_MAX / sqrt(scene->b.g_a)))
        return COIN_MODEL_STEPS;
    find_steady(scene, NEAR);
    const int known = scene->near && is_known(scene);
    int good[2] = {known, known};
    const int32_t status = follow(scene, good);
    return status != COIN_OK         ? status
           : good[COIN_MODEL_STEADY] ? COIN_MODEL_STEADY
           : good[COIN_MODEL_WOBBLE] ? COIN_MODEL_WOBBLE
                                     : COIN_MODEL_STEPS;
}

static int32_t judge_by_orbit(struct scene *scene, const coin_orbit *o)
{
    coin_state end;
    const double theta = scene->start->theta;
    const double up = o->theta_max - theta, down = theta - o->theta_min;
    const int32_t status = coin_orbit_at(o, scene->horizon, &end);
    if (status != COIN_OK)
        return status;
    if (!(own_error(scene, o, &end) <= OWN * scene->tol))
        return o->period > 0 ? COIN_MODEL_STEPS : judge_by_steps(scene);
    /* The steady motion is looked for no farther away than the turning points:
     * the potential has a minimum between them. */
    const double most = up > down ? up : down;
    find_steady(scene, most < NEAR ? most : NEAR);
    if (scene->near && (scene->lambda2 < 0 || is_known(scene))) {
        if (fits(scene, COIN_MODEL_STEADY, o))
            return COIN_MODEL_STEADY;
        if (scene->swings && fits(scene, COIN_MODEL_WOBBLE, o))
            return COIN_MODEL_WOBBLE;
    }
    return COIN_MODEL_ORBIT;
}

int32_t coin_model_needed(const coin_state *s, const coin_params *p,
                          double horizon, double tol)
{
    struct scene scene;
    coin_orbit orbit;
    int32_t status = coin_priv_check(s, p, &scene.b);
    if (status == COIN_EARG || !(tol > 0 && tol < (double)INFINITY))
        return COIN_EARG;
    if (status == COIN_OK && !(horizon - horizon == 0))
        status = COIN_ESTEP;
    if (status != COIN_OK)
        return status;
    scene.start = s;
    scene.horizon = horizon;
    scene.tol = tol;
    return coin_orbit_init(&orbit, s, p) == COIN_OK
               ? judge_by_orbit(&scene, &orbit)
               : judge_by_steps(&scene);
}
