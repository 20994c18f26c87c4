/* SPDX-License-Identifier: MIT */
/* What a step of one coin adds, and of many abreast: included by
 * lib/float/rk4.c, and by lib/float/lanes.c with a vector for each float. */

/* h d/dt of a state's members, or a part of their change. */
struct slope {
    float theta, phi, psi, x, z, wX, wY, wZ;
};

/* a + w b, member by member. */
static inline coinf_priv_stage add(const coinf_priv_stage *a,
                                   coinf_priv_shared w,
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
static inline void gather(struct slope *rest, coinf_priv_shared w,
                          const struct slope *of, const struct slope *first)
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
    const float fall = coinf_priv_fall_low(plan, y), none = {0};
    const struct slope low = {
        none, phi, phi * y->sth, none, none, fall, none, none,
    };
    return low;
}

/* The classical Runge-Kutta step, as the first slope and the rest of the
 * change: ((f2 - f1) + (f3 - f1))/3 + (f4 - f1)/6.  Rounding a weight to a
 * float then costs a part of the rest only; in a steady motion it would add up.
 * *last is the last stage, which stands for the end of the step. */
static void slopes(struct slope *first, struct slope *rest,
                   coinf_priv_stage *last, const coinf_priv_plan *plan,
                   const coinf_priv_stage *y1)
{
    static const coinf_priv_shared reach[] = {0.5f, 0.5f, 1};
    static const coinf_priv_shared weight[] = {1.0f / 3, 1.0f / 3, 1.0f / 6};
    coinf_priv_stage d;
    *first = slope_at(&d, plan, y1);
    *rest = left_out(first, plan, y1);
    for (int i = 0; i < 3; ++i) {
        *last = add(y1, reach[i], &d);
        const struct slope of = slope_at(&d, plan, last);
        gather(rest, weight[i], &of, first);
    }
}

/* Adds the change of a step to a state. */
static inline void change(coinf_state *s, const struct slope *first,
                          const struct slope *rest)
{
    coinf_priv_add(&s->theta, &s->low[0], first->theta, rest->theta);
    coinf_priv_add(&s->phi, &s->low[1], first->phi, rest->phi);
    coinf_priv_add(&s->psi, &s->low[2], first->psi, rest->psi);
    coinf_priv_add(&s->x, &s->low[3], first->x, rest->x);
    coinf_priv_add(&s->z, &s->low[4], first->z, rest->z);
    coinf_priv_add(&s->wX, &s->low[5], first->wX, rest->wX);
    coinf_priv_add(&s->wY, &s->low[6], first->wY, rest->wY);
    coinf_priv_add(&s->wZ, &s->low[7], first->wZ, rest->wZ);
}
