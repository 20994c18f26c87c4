/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include <math.h>

/* A model is compared with the full one at so many times all over the horizon,
 * and at so many in its last two periods. */
#define EVERYWHERE 256
#define AT_THE_END 64

/* It fits a bound if it keeps to this part of it there; the rest is for the
 * times between, and for the orbit's own error. */
#define KEPT 0.5
#define OWN 0.25

/* Where there is no orbit, the motion is stepped no further than this, in
 * natural units: it is unstable, and by then no cheaper model is left. */
#define STEPPED 64.0

/* The full model: its orbit, or else the state at the last time asked for. */
struct truth {
    const coin_params *p;
    coin_orbit orbit;
    int solved;
    coin_state now;
    double t;
};

static int32_t truth_at(struct truth *full, double t, coin_state *out)
{
    if (full->solved)
        return coin_orbit_at(&full->orbit, t, out);
    const int32_t status =
        coin_advance(&full->now, full->p, t - full->t, 1e-13, 0);
    full->t = t;
    *out = full->now;
    return status;
}

static int32_t model_at(int32_t model, const coin_state *steady,
                        const coin_params *p, const coin_state *start, double t,
                        coin_state *out)
{
    return model == COIN_MODEL_STEADY
               ? coin_steady_at(steady, p, t, out)
               : coin_wobble_at(steady, p, start, t, out);
}

/* The largest difference of two poses, in radians and radii. */
static double apart(const coin_state *s, const coin_state *r, double a)
{
    const double d[5] = {s->theta - r->theta, s->phi - r->phi, s->psi - r->psi,
                         (s->x - r->x) / a, (s->z - r->z) / a};
    double most = 0;
    for (int i = 0; i < 5; ++i)
        most = fabs(d[i]) > most ? fabs(d[i]) : most;
    return most;
}

/* When to look for the k-th time: all over in steps that no period divides,
 * then at the end. */
static double look_at(int k, double horizon, double period)
{
    const double golden = 0.6180339887498949 * k;
    const double swings = fabs(period) + fabs(period), all = fabs(horizon);
    const double end = swings < all ? swings : all;
    const double left = (EVERYWHERE + AT_THE_END - 1 - k) * end / AT_THE_END;
    if (k >= EVERYWHERE)
        return horizon < 0 ? horizon + left : horizon - left;
    return horizon * (k + (golden - (int)golden)) / EVERYWHERE;
}

/* Whether a model keeps the pose within bound. */
static int fits(int32_t model, const coin_state *steady,
                const coin_state *start, struct truth *full, double horizon,
                double bound)
{
    const double a = full->p->radius;
    full->now = *start;
    full->t = 0;
    for (int k = 0; k < EVERYWHERE + AT_THE_END; ++k) {
        const double t = look_at(k, horizon, full->orbit.period);
        coin_state is, said;
        const int32_t failed =
            truth_at(full, t, &is) |
            model_at(model, steady, full->p, start, t, &said);
        if (failed || !(apart(&is, &said, a) <= bound))
            return 0;
    }
    return 1;
}

/* What rounding may do to the orbit over the horizon, in radians and radii:
 * ten times what coin_orbit_at() states, for the heading and what it leads
 * round the path, and the rounding of angles of many turns. */
static double own_error(const coin_orbit *o, const coin_state *start,
                        const coin_state *end, double a, double horizon)
{
    const double turned = fabs(end->phi - start->phi);
    const double rolled = fabs(end->psi - start->psi);
    const double periods = o->period > 0 ? fabs(horizon) / o->period : 0;
    const double reach = o->radius_max > 0 ? o->radius_max / a : rolled;
    const double heading =
        1e-13 + 1e-15 * turned + 1e-14 * o->conditioning * periods;
    return heading * (1 + reach) + 1e-15 * rolled;
}

/* The full motion as far as the horizon, and there: the usual statuses, or
 * COIN_MODEL_STEPS if nothing more can be said. */
static int32_t solve(struct truth *full, const coin_state *start,
                     double horizon, double tol)
{
    const coin_params *p = full->p;
    const double unit = sqrt(p->radius / p->gravity);
    coin_state end;
    full->now = *start;
    full->t = 0;
    full->solved = coin_orbit_init(&full->orbit, start, p) == COIN_OK;
    if (!full->solved && !(fabs(horizon) <= STEPPED * unit))
        return COIN_MODEL_STEPS;
    const int32_t status = truth_at(full, horizon, &end);
    if (status != COIN_OK)
        return status;
    if (!full->solved)
        full->orbit.period = 0;
    else if (!(own_error(&full->orbit, start, &end, p->radius, horizon) <=
               OWN * tol))
        return COIN_MODEL_STEPS;
    return COIN_OK;
}

int32_t coin_model_needed(const coin_state *s, const coin_params *p,
                          double horizon, double tol)
{
    struct truth full;
    coin_state steady;
    int32_t status = coin_state_check(s, p);
    if (status == COIN_EARG || !(tol > 0 && tol < (double)INFINITY))
        return COIN_EARG;
    if (status == COIN_OK && !(horizon - horizon == 0))
        status = COIN_ESTEP;
    if (status != COIN_OK)
        return status;
    full.p = p;
    status = solve(&full, s, horizon, tol);
    if (status != COIN_OK)
        return status;
    if (coin_steady_near(s, p, &steady) == COIN_OK) {
        if (fits(COIN_MODEL_STEADY, &steady, s, &full, horizon, KEPT * tol))
            return COIN_MODEL_STEADY;
        if (fits(COIN_MODEL_WOBBLE, &steady, s, &full, horizon, KEPT * tol))
            return COIN_MODEL_WOBBLE;
    }
    return full.solved ? COIN_MODEL_ORBIT : COIN_MODEL_STEPS;
}
