/* SPDX-License-Identifier: MIT */
#include "pinned.h"

/* gcc would allocate registers loop by loop, and spill at the seams: 3 % of a
 * step; renamed, they let the processor start the next stage sooner: 2 %. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("ira-region=all", "rename-registers")
#endif

#include "march.h"

/* a + w b, member by member. */
COIN_PRIV_INLINE coin_priv_stage add(const coin_priv_stage *a, double w,
                                     const coin_priv_stage *b)
{
    const double sth = a->sth + w * b->sth, q = a->q + w * b->q;
    const coin_priv_stage r = {
        a->wX + w * b->wX,
        a->wY + w * b->wY,
        a->wZ + w * b->wZ,
        sth,
        a->cth + w * b->cth,
        q,
        q * sth,
        a->sph + w * b->sph,
        a->cph + w * b->cph,
    };
    return r;
}

/* The same for a pose; t stays 0, the steps count it. */
COIN_PRIV_INLINE coin_priv_pose add_pose(const coin_priv_pose *a, double w,
                                         const coin_priv_pose *b)
{
    const coin_priv_pose r = {
        a->phi + w * b->phi,
        a->psi + w * b->psi,
        a->x + w * b->x,
        a->z + w * b->z,
        0,
    };
    return r;
}

/* The coefficients for a step h. */
struct rk4 {
    coin_priv_field half, full, sixth;
};

/* One classical Runge-Kutta step.  The slopes are times h/2, h/2, h and h/6, so
 * that the classical sum is (d1 + 2 d2 + d3)/3 + d4, and nothing but the last
 * addition waits for the last slope. */
COIN_PRIV_INLINE double rk4_step(coin_priv_moment *next,
                                 const coin_priv_moment *c,
                                 const void *coefficients)
{
    const struct rk4 *k = (const struct rk4 *)coefficients;
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

    const coin_priv_stage d4 = coin_priv_motion(&k->sixth, &y4);
    const coin_priv_pose v4 = coin_priv_drift(&k->sixth, &y4);
    const coin_priv_stage y = add(&y1, 1.0 / 3, &sum);
    const coin_priv_pose pose = add_pose(&c->pose, 1.0 / 3, &path);
    next->y = add(&y, 1, &d4);
    coin_priv_renew(&next->y);
    next->pose = add_pose(&pose, 1, &v4);
    const double lower = y2.cth < y3.cth ? y2.cth : y3.cth;
    return lower < y4.cth ? lower : y4.cth;
}

COIN_PRIV_INLINE double lean_step(coin_priv_moment *next,
                                  const coin_priv_moment *now, const void *k)
{
    return coin_priv_pathless(rk4_step, next, now, k);
}

static struct rk4 coefficients(const coin_priv_body *b, double dt)
{
    const struct rk4 k = {
        coin_priv_field_of(b, dt / 2),
        coin_priv_field_of(b, dt),
        coin_priv_field_of(b, dt / 6),
    };
    return k;
}

void coin_priv_rk4(coin_priv_carry *c, const coin_priv_body *b,
                   coin_priv_limits *limits, double dt, uint64_t n)
{
    const struct rk4 k = coefficients(b, dt);
    coin_priv_march(c, b, limits, n, rk4_step, &k);
}

void coin_priv_rk4_lean(coin_priv_carry *c, const coin_priv_body *b,
                        coin_priv_limits *limits, double dt, uint64_t n)
{
    const struct rk4 k = coefficients(b, dt);
    coin_priv_march(c, b, limits, n, lean_step, &k);
}
