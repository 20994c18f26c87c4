/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "state.h"
#include "stepper.h"

#include <math.h>

/* A run under way. */
struct run {
    coin_priv_body b;
    coin_priv_carry c;
    coin_priv_limits limits;
    double dt;
    coin_state start;
    double lean_x, lean_z; /* from contact to centre there, in radii: (21) */
    uint64_t moved; /* steps so far */
};

static double squared(double x)
{
    return x * x;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* Checks everything, then computes what the steps share. */
static int32_t open_run(struct run *r, const coin_state *s,
                        const coin_params *p, int32_t method, double dt)
{
    const int32_t status = coin_priv_method_known(method)
                               ? coin_priv_check(s, p, &r->b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(dt - dt == 0))
        return COIN_ESTEP;
    const coin_priv_pose pose = {s->phi, s->psi, 0, 0};
    r->c.y = coin_priv_stage_of(s);
    r->c.pose = pose;
    r->start = *s;
    r->moved = 0;
    r->lean_x = r->c.y.sth * r->c.y.sph;
    r->lean_z = r->c.y.sth * r->c.y.cph;
    r->dt = dt;
    r->limits.coarse2 = squared(coin_priv_method_coarse(method) / dt);
    r->limits.most2 = smaller(squared(coin_priv_method_most(method) / dt),
                              r->b.w2_max);
    r->limits.warnings = COIN_OK;
    return COIN_OK;
}

/* phi from the pair that the steps turned; pose.phi is within half a turn of
 * it, and tells which. */
static double heading(const coin_priv_carry *c)
{
    const coin_priv_stage *y = &c->y;
    const coin_priv_sc at = coin_priv_sincos(c->pose.phi);
    const coin_priv_sc off = {
        y->sph * at.c - y->cph * at.s,
        y->cph * at.c + y->sph * at.s,
    };
    return c->pose.phi + coin_priv_angle(off);
}

/* So often pose.phi is set to the pair's angle, counted from the start of the
 * run, so that a run's bits do not depend on where it is looked at.  In
 * between the sum of phi's rates, and the pair that the same rates turn,
 * cannot come half a turn apart: RK4 turns a pair by z - z^5/120 for z, and
 * no step has z > 1.4. */
#define BLOCK 32

/* Up to n steps; returns how many were done. */
static uint64_t advance(struct run *r, uint64_t n)
{
    if (r->dt == 0)
        return n;
    uint64_t done = 0, asked = 0;
    while (done == asked && done < n) {
        const uint64_t room = BLOCK - r->moved % BLOCK;
        const uint64_t block = n - done < room ? n - done : room;
        const uint64_t now =
            coin_priv_rk4(&r->c, &r->b, &r->limits, r->dt, block);
        asked += block;
        done += now;
        r->moved += now;
        if (r->moved % BLOCK == 0)
            r->c.pose.phi = heading(&r->c);
    }
    return done;
}

/* Where the run is.  A run that has not moved is where it began, to the bit. */
static coin_state state_of(const struct run *r)
{
    if (r->moved == 0)
        return r->start;
    const coin_priv_pose *pose = &r->c.pose;
    const coin_priv_stage *y = &r->c.y;
    const coin_priv_sc lean = {y->sth, y->cth};
    const double lean_x = y->sth * y->sph - r->lean_x; /* (21) */
    const double lean_z = y->sth * y->cph - r->lean_z; /* (21) */
    const coin_state s = {
        coin_priv_angle(lean),
        heading(&r->c),
        pose->psi,
        r->start.x + r->b.a * (pose->x + lean_x),
        r->start.z + r->b.a * (pose->z + lean_z),
        y->wX,
        y->wY,
        y->wZ,
    };
    return s;
}

int32_t coin_run(coin_state *s, const coin_params *p, int32_t method,
                 double dt, uint64_t steps, uint64_t *done)
{
    struct run r;
    const int32_t status = open_run(&r, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    uint64_t n = advance(&r, steps);
    const coin_state end = state_of(&r);
    if (coin_priv_check_members(&end) == COIN_OK)
        *s = end;
    else
        n = 0; /* a path so long that x or z overflowed */
    if (done)
        *done = n;
    return n < steps ? COIN_ESTEP : r.limits.warnings;
}

int32_t coin_step(coin_state *s, const coin_params *p, double dt)
{
    return coin_run(s, p, COIN_RK4, dt, 1, NULL);
}

int32_t coin_sample(const coin_state *start, const coin_params *p,
                    int32_t method, double dt, uint64_t steps_per_sample,
                    size_t count, coin_state *out, size_t *done)
{
    struct run r;
    const uint64_t n = steps_per_sample;
    const int32_t status =
        out ? open_run(&r, start, p, method, dt) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    size_t k = 0;
    for (; k < count && (k == 0 || advance(&r, n) == n); ++k) {
        const coin_state sample = state_of(&r);
        if (coin_priv_check_members(&sample) != COIN_OK)
            break;
        out[k] = sample;
    }
    if (done)
        *done = k;
    return k < count ? COIN_ESTEP : r.limits.warnings;
}
