/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "gbs.h"
#include "hold.h"

/* Nearer to flat than this a fall is looked at.  By (72) the angle from flat is
 * then as the cosine of an angle that grows to a right one at most, however
 * fast the coin turns: one step takes the whole of it. */
#define NEAR_FLAT 0.05

/* The inertia D of (72) about the vertical through the contact. */
static double inertia(const coin_priv_losses *l, double cth)
{
    return l->K - (l->K - l->IX) * (cth * cth);
}

double coin_priv_fall_turn(const coin_priv_held_fall *f,
                           const coin_priv_losses *l)
{
    return f->L / inertia(l, coin_priv_sincos(f->x).s);
}

coin_priv_held_fall coin_priv_fall_of(const coin_priv_losses *l,
                                      const coin_priv_variables *y)
{
    const coin_priv_sc from_flat = {y->cth, fabs(y->sth)};
    const double turn = -y->wZ / y->sth; /* as d(psi)/dt = 0 */
    const coin_priv_held_fall f = {
        coin_priv_angle(from_flat),
        y->sth < 0 ? -y->wX : y->wX,
        inertia(l, y->cth) * turn,
        0,
    };
    return f;
}

/* d/dt. */
static coin_priv_held_fall slope(const coin_priv_held_fall *f,
                                 const coin_priv_losses *l,
                                 const coin_priv_body *b)
{
    const coin_priv_sc at = coin_priv_sincos(f->x); /* s = cos theta */
    const double D = inertia(l, at.s), turn = f->L / D;
    const coin_priv_held_fall d = {
        -f->v,
        at.c * (b->Mga + (l->K - l->IX) * at.s * turn * turn) / l->J, /* (72) */
        -l->spin * turn,                                              /* (72) */
        turn,
    };
    return d;
}

struct problem {
    const coin_priv_losses *l;
    const coin_priv_body *b;
};

static void slopes(double *dy, const double *y, const void *problem)
{
    const struct problem *of = (const struct problem *)problem;
    const coin_priv_held_fall f = {y[0], y[1], y[2], y[3]};
    const coin_priv_held_fall d = slope(&f, of->l, of->b);
    dy[0] = d.x;
    dy[1] = d.v;
    dy[2] = d.L;
    dy[3] = d.phi;
}

coin_priv_held_fall coin_priv_fall_at(const coin_priv_held_fall *f,
                                      const coin_priv_losses *l,
                                      const coin_priv_body *b, double t)
{
    const struct problem of = {l, b};
    double y[] = {f->x, f->v, f->L, f->phi};
    (void)coin_priv_gbs(y, 4, slopes, &of, t);
    const coin_priv_held_fall to = {y[0], y[1], y[2], y[3]};
    return to;
}

/* With the acceleration it begins with. */
static double first_guess(const coin_priv_held_fall *f,
                          const coin_priv_losses *l, const coin_priv_body *b)
{
    const double A = slope(f, l, b).v;
    return 2 * f->x / (f->v + sqrt(f->v * f->v + 2 * A * f->x));
}

double coin_priv_fall_time(const coin_priv_held_fall *f,
                           const coin_priv_losses *l, const coin_priv_body *b)
{
    double t = first_guess(f, l, b);
    for (int i = 0; i < 4; ++i) { /* Newton: x = 0 */
        const coin_priv_held_fall at = coin_priv_fall_at(f, l, b, t);
        t += at.x / at.v;
    }
    return t;
}

double coin_priv_rise_time(const coin_priv_held_fall *f,
                           const coin_priv_losses *l, const coin_priv_body *b)
{
    const double twice = -f->x / f->v, back = -2 * f->v / slope(f, l, b).v;
    return twice < back ? twice : back;
}

/* The u = cos(theta) d(psi)/dt below which the contact counts as stopped. */
static double stopped(const coin_priv_losses *l, const coin_priv_body *b,
                      const coin_priv_variables *y, double eps)
{
    return eps * sqrt((l->J * y->wX * y->wX + b->Mga * y->cth) / l->IX);
}

double coin_priv_hold(const coin_priv_losses *l, const coin_priv_body *b,
                      const coin_priv_variables *y, double eps)
{
    const double small = stopped(l, b, y, eps);
    return small * coin_priv_grip(l, small, y->cth);
}

int coin_priv_held(const coin_priv_losses *l, const coin_priv_body *b,
                   const coin_priv_variables *y, double eps)
{
    const double sth = y->sth, cth = y->cth, wX = y->wX;
    const double u = cth * y->wZ + sth * y->wY;
    if (!(cth < NEAR_FLAT && fabs(u) <= stopped(l, b, y, eps)))
        return 0;
    /* The torque along e_Z that holds the contact, at its most, and what the
     * losses give as long as u is small. */
    const coin_priv_held_fall f = coin_priv_fall_of(l, y);
    const double turn = f.L / inertia(l, cth);
    const double A = slope(&f, l, b).v;
    const double fastest = sqrt(wX * wX + 2 * A * f.x);
    const double lever =
        2 * sth * sth * l->K * (l->K - l->IX) / inertia(l, cth) - l->K - b->m;
    const double need = fabs(turn * lever) * cth * fastest; /* (73) */
    return need <= coin_priv_hold(l, b, y, eps);
}
