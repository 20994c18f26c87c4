/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "gbs.h"
#include "hold.h"

/* Only at a smaller cos theta may the contact have stopped.  By (72) the angle
 * from flat is then proportional to the cosine of an angle that grows to a
 * right angle at most, however fast the coin turns.  So one extrapolated step
 * can do the whole fall, unless pivoting friction is strong. */
#define NEAR_FLAT K(0.05)

/* In a fall u would grow as 1/cos theta.  DECAY times the torque that keeps u
 * constant makes it decay at least as fast. */
#define DECAY 2

/* Pivoting friction makes the turn decay at the rate b/K at most.  One step of
 * a fall is at most DECAYED over that rate.  A fall that would take more than
 * MOST_PARTS of them does not count as held. */
#define DECAYED K(0.5)
#define MOST_PARTS 1000

/* The inertia D of (72) about the vertical through the contact. */
static real inertia(const PRIV(losses) * l, real cth)
{
    return l->K - (l->K - l->IX) * (cth * cth);
}

real PRIV(fall_turn)(const PRIV(held_fall) * f, const PRIV(losses) * l)
{
    return f->L / inertia(l, PRIV(sincos)(f->x).s);
}

PRIV(held_fall) PRIV(fall_of)(const PRIV(losses) * l, const PRIV(variables) * y)
{
    const PRIV(sc) from_flat = {y->cth, FABS(y->sth)};
    const real turn = -y->wZ / y->sth; /* as d(psi)/dt = 0 */
    const PRIV(held_fall) f = {
        PRIV(angle)(from_flat),
        y->sth < 0 ? -y->wX : y->wX,
        inertia(l, y->cth) * turn,
        0,
    };
    return f;
}

/* d/dt. */
static PRIV(held_fall) slope(const PRIV(held_fall) * f, const PRIV(losses) * l,
                             const PRIV(body) * b)
{
    const PRIV(sc) at = PRIV(sincos)(f->x); /* s = cos theta */
    const real D = inertia(l, at.s), turn = f->L / D;
    const PRIV(held_fall) d = {
        -f->v,
        at.c * (b->Mga + (l->K - l->IX) * at.s * turn * turn) / l->J, /* (72) */
        -l->spin * turn,                                              /* (72) */
        turn,
    };
    return d;
}

struct problem {
    const PRIV(losses) * l;
    const PRIV(body) * b;
};

static void slopes(real *dy, const real *y, const void *problem)
{
    const struct problem *of = (const struct problem *)problem;
    const PRIV(held_fall) f = {y[0], y[1], y[2], y[3]};
    const PRIV(held_fall) d = slope(&f, of->l, of->b);
    dy[0] = d.x;
    dy[1] = d.v;
    dy[2] = d.L;
    dy[3] = d.phi;
}

void PRIV(fall_by)(PRIV(held_fall) * f, const PRIV(losses) * l,
                   const PRIV(body) * b, real t)
{
    const struct problem of = {l, b};
    real y[] = {f->x, f->v, f->L, f->phi};
    const int parts = 1 + (int)(FABS(t) * l->spin / (DECAYED * l->K));
    for (int i = 0; i < parts; ++i)
        (void)PRIV(gbs)(y, 4, slopes, &of, t / (real)parts);
    f->x = y[0];
    f->v = y[1];
    f->L = y[2];
    f->phi = y[3];
}

/* The time of the fall if its first acceleration stayed. */
static real first_guess(const PRIV(held_fall) * f, const PRIV(losses) * l,
                        const PRIV(body) * b)
{
    const real A = slope(f, l, b).v;
    return 2 * f->x / (f->v + SQRT(f->v * f->v + 2 * A * f->x));
}

real PRIV(fall_time)(const PRIV(held_fall) * f, const PRIV(losses) * l,
                     const PRIV(body) * b)
{
    real t = first_guess(f, l, b);
    for (int i = 0; i < 4; ++i) { /* Newton: x = 0 */
        PRIV(held_fall) at = *f;
        PRIV(fall_by)(&at, l, b, t);
        t += at.x / at.v;
    }
    return t;
}

real PRIV(rise_time)(const PRIV(held_fall) * f, const PRIV(losses) * l,
                     const PRIV(body) * b)
{
    const real v = f->v, A = slope(f, l, b).v; /* A > 0: it is held */
    const real least = COIN_PRIV_EPSILON * SQRT(f->x / A);
    return f->x * A < 2 * v * v ? -f->x / v : PRIV(larger)(-2 * v / A, least);
}

int PRIV(is_held)(const PRIV(losses) * l, const PRIV(body) * b,
                  const PRIV(variables) * y, real eps)
{
    const real cth = y->cth, wX = y->wX;
    const real u = PRIV(roll_speed)(y->wY, y->wZ, y->sth, cth);
    const real small2 = PRIV(stopped_speed2)(b, y, eps);
    if (!(cth < NEAR_FLAT && u * u <= small2))
        return 0;
    /* The torque along e_Z that it takes to hold the contact, at its largest,
     * must not exceed the torque that the losses give as long as u is small. */
    const PRIV(held_fall) f = PRIV(fall_of)(l, y);
    const real D = PRIV(lesser)(inertia(l, cth), l->K), turn = f.L / D;
    const real lift = (l->K - l->IX) * cth * (turn * turn);
    if (!(b->Mga + 2 * lift > 0)) /* it might not fall: K < I_X */
        return 0;
    const real A = (b->Mga + PRIV(larger)(lift, 0)) / l->J;
    const real fastest = SQRT(wX * wX + 2 * A * f.x);
    const real time = 2 * f.x / (FABS(wX) + fastest);
    if (!(l->spin * time <= MOST_PARTS * DECAYED * l->K))
        return 0;
    const real lever = l->K / D * (2 * l->IX - b->IZ) +
                       cth * cth * (b->IZ / D) * (l->K - l->IX);
    const real pivot = l->spin / D * (l->K - l->IX) * (cth * cth);
    const real growth = (l->K * l->IX + cth * cth * b->IZ * (l->K - l->IX)) / D;
    const real grows = u == 0 ? 0 : DECAY * growth * fastest * SQRT(small2);
    const real need = FABS(turn * lever) * cth * fastest + FABS(turn * pivot) +
                      grows; /* (73) */
    return need <= PRIV(holding_torque)(l, small2, cth);
}
