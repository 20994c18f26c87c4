/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

/* a + w b, member by member. */
static inline coin_priv_stage add(const coin_priv_stage *a, double w,
                                  const coin_priv_stage *b)
{
    const double sth = a->sth + w * b->sth, q = a->q + w * b->q;
    const coin_priv_stage r = {
        a->wX + w * b->wX,   a->wY + w * b->wY,   a->wZ + w * b->wZ,
        sth,                 a->cth + w * b->cth, q,
        q * sth,             a->sph + w * b->sph, a->cph + w * b->cph,
    };
    return r;
}

static inline coin_priv_pose add_pose(const coin_priv_pose *a, double w,
                                      const coin_priv_pose *b)
{
    const coin_priv_pose r = {
        a->phi + w * b->phi,
        a->psi + w * b->psi,
        a->x + w * b->x,
        a->z + w * b->z,
    };
    return r;
}

/* Brings the pairs back to the unit circle, so that the angles alone tell the
 * state, and a run of n steps is n runs of one.  The lean's pair, which the
 * next step waits for, gets three terms of (1 - e)^(-1/2): the step left e =
 * O(h^5), and 5/16 e^3 remains, rounding for steps that are not coarse. */
static inline void renew(coin_priv_stage *y)
{
    const double q = 1 / y->cth;
    const double lean = 1 - (y->sth * y->sth + y->cth * y->cth);
    const double turn = 1 / sqrt(y->sph * y->sph + y->cph * y->cph);
    const double longer = 0.5 + 0.375 * lean;
    y->tth = y->sth * q;
    y->sth += (y->sth * lean) * longer;
    y->cth += (y->cth * lean) * longer;
    y->q = q - (q * lean) * (0.5 + 0.125 * lean);
    y->sph *= turn;
    y->cph *= turn;
}

/* The coefficients for a step h. */
struct rk4 {
    coin_priv_field half, full, sixth;
};

/* One classical Runge-Kutta step; *lowest is the least cos theta of its
 * stages.  The slopes are times h/2, h/2, h and h/6, so that the classical
 * sum is (d1 + 2 d2 + d3)/3 + d4, and nothing but the last addition waits for
 * the last slope. */
static inline coin_priv_carry rk4_step(const coin_priv_carry *c,
                                       const struct rk4 *k, double *lowest)
{
    const coin_priv_stage y1 = c->y;
    coin_priv_stage sum = coin_priv_motion(&k->half, &y1);
    coin_priv_pose path = coin_priv_drift(&k->half, &y1);
    const coin_priv_stage y2 = add(&y1, 1, &sum);

    const coin_priv_stage d2 = coin_priv_motion(&k->half, &y2);
    const coin_priv_pose v2 = coin_priv_drift(&k->half, &y2);
    const coin_priv_stage y3 = add(&y1, 1, &d2);
    sum = add(&sum, 2, &d2);
    path = add_pose(&path, 2, &v2);

    const coin_priv_stage d3 = coin_priv_motion(&k->full, &y3);
    const coin_priv_pose v3 = coin_priv_drift(&k->full, &y3);
    const coin_priv_stage y4 = add(&y1, 1, &d3);
    sum = add(&sum, 1, &d3);
    path = add_pose(&path, 1, &v3);

    coin_priv_carry r;
    const coin_priv_stage d4 = coin_priv_motion(&k->sixth, &y4);
    const coin_priv_pose v4 = coin_priv_drift(&k->sixth, &y4);
    r.y = add(&y1, 1.0 / 3, &sum);
    r.pose = add_pose(&c->pose, 1.0 / 3, &path);
    r.y = add(&r.y, 1, &d4);
    r.pose = add_pose(&r.pose, 1, &v4);
    renew(&r.y);

    const double lower = y2.cth < y3.cth ? y2.cth : y3.cth;
    *lowest = lower < y4.cth ? lower : y4.cth;
    return r;
}

uint64_t coin_priv_rk4(coin_priv_carry *c, const coin_priv_body *b,
                       coin_priv_limits *limits, double dt, uint64_t n)
{
    const struct rk4 k = {
        coin_priv_field_of(b, dt / 2),
        coin_priv_field_of(b, dt),
        coin_priv_field_of(b, dt / 6),
    };
    const double most2 = limits->most2, g_a = b->g_a;
    coin_priv_carry state[2];
    double rate2 = coin_priv_rate2(g_a, &c->y), worst2 = 0;
    uint64_t done = 0;
    state[0] = *c;
    for (; done < n; ++done) {
        double lowest;
        coin_priv_carry *next = &state[(done + 1) & 1];
        *next = rk4_step(&state[done & 1], &k, &lowest);
        const double next2 = coin_priv_rate2(g_a, &next->y);
        const double step2 = rate2 > next2 ? rate2 : next2;
        if (!coin_priv_sound(next, lowest, step2, most2))
            break;
        worst2 = step2 > worst2 ? step2 : worst2;
        rate2 = next2;
    }
    if (worst2 > limits->coarse2)
        limits->warnings = COIN_COARSE;
    *c = state[done & 1];
    return done;
}
