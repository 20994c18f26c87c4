/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

/* h d/dt of a state's members, or a part of their change. */
struct slope {
    float theta, phi, psi, x, z, wX, wY, wZ;
};

/* a + w b, member by member. */
static inline coinf_priv_stage add(const coinf_priv_stage *a, float w,
                                   const coinf_priv_stage *b)
{
    const float sth = a->sth + w * b->sth, q = a->q + w * b->q;
    const coinf_priv_stage r = {
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

/* The slope at a stage; *d is that of the stage.  psi' = wZ + phi' sin theta:
 * what is known of phi' beyond its digits serves psi' too. */
static inline struct slope slope_at(coinf_priv_stage *d,
                                    const coinf_priv_plan *plan,
                                    const coinf_priv_stage *y)
{
    const coinf_priv_field *f = &plan->f;
    const float phi = coinf_priv_drift(f, y).phi;
    float v[3];
    coinf_priv_velocity(v, f->h * plan->a, y);
    *d = coinf_priv_motion(f, y);
    const struct slope of = {
        f->h * y->wX,                /* (17) */
        phi,                         /* (18) */
        f->h * y->wZ + phi * y->sth, /* (19) */
        v[0],
        v[2],
        d->wX,
        d->wY,
        d->wZ,
    };
    return of;
}

/* rest + w (of - first). */
static inline void gather(struct slope *rest, float w, const struct slope *of,
                          const struct slope *first)
{
    rest->theta += w * (of->theta - first->theta);
    rest->phi += w * (of->phi - first->phi);
    rest->psi += w * (of->psi - first->psi);
    rest->x += w * (of->x - first->x);
    rest->z += w * (of->z - first->z);
    rest->wX += w * (of->wX - first->wX);
    rest->wY += w * (of->wY - first->wY);
    rest->wZ += w * (of->wZ - first->wZ);
}

/* What the first slope's rounding left out, where it is the same in each step
 * of a steady motion and adds up. */
static struct slope left_out(const struct slope *first,
                             const coinf_priv_plan *plan,
                             const coinf_priv_stage *y)
{
    const float h = plan->f.h, cth = y->cth;
    const float off =
        coinf_priv_residue(h, y->wY) - coinf_priv_residue(first->phi, cth);
    const float phi = y->q * ((h * y->wY - first->phi * cth) + off); /* (18) */
    const struct slope low = {
        0, phi, phi * y->sth, 0, 0, coinf_priv_fall_low(plan, y), 0, 0,
    };
    return low;
}

/* The classical Runge-Kutta step, as the first slope and the rest of the
 * change: ((f2 - f1) + (f3 - f1))/3 + (f4 - f1)/6.  Rounding a weight to a
 * float then costs a part of the rest only; in a steady motion it would add up.
 * 0 if the last stage, which stands for the end of the step, is too fast: near
 * the table that it is, long before a stage could be below. */
static int slopes(struct slope *first, struct slope *rest,
                  coinf_priv_plan *plan, const coinf_priv_stage *y1)
{
    static const float reach[] = {0.5f, 0.5f, 1};
    static const float weight[] = {1.0f / 3, 1.0f / 3, 1.0f / 6};
    coinf_priv_stage y, d;
    *first = slope_at(&d, plan, y1);
    *rest = left_out(first, plan, y1);
    for (int i = 0; i < 3; ++i) {
        y = add(y1, reach[i], &d);
        const struct slope of = slope_at(&d, plan, &y);
        gather(rest, weight[i], &of, first);
    }
    return coinf_priv_within(plan, &y);
}

/* Ends a step by its change. */
static int change(coinf_state *s, const struct slope *first,
                  const struct slope *rest, const coinf_priv_plan *plan)
{
    coinf_state next = *s;
    coinf_priv_add(&next.theta, &next.low[0], first->theta, rest->theta);
    coinf_priv_add(&next.phi, &next.low[1], first->phi, rest->phi);
    coinf_priv_add(&next.psi, &next.low[2], first->psi, rest->psi);
    coinf_priv_add(&next.x, &next.low[3], first->x, rest->x);
    coinf_priv_add(&next.z, &next.low[4], first->z, rest->z);
    coinf_priv_add(&next.wX, &next.low[5], first->wX, rest->wX);
    coinf_priv_add(&next.wY, &next.low[6], first->wY, rest->wY);
    coinf_priv_add(&next.wZ, &next.low[7], first->wZ, rest->wZ);
    return coinf_priv_land(s, &next, plan);
}

int coinf_priv_rk4(coinf_state *s, coinf_priv_plan *plan,
                   const coinf_priv_stage *y)
{
    struct slope first, rest;
    return slopes(&first, &rest, plan, y) && change(s, &first, &rest, plan);
}
