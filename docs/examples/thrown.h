/* SPDX-License-Identifier: MIT */
/* thrown.h: a coin that may slip and fly, in the demo: how it moves, and what
 * is printed. */
#ifndef EXAMPLE_THROWN_H
#define EXAMPLE_THROWN_H

#include "options.h"
#include "pictures.h"

#include <coin.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define SLIDE_TOL 1e-9

/* Kinetic friction is somewhat less than static friction.  The library refuses
 * a kinetic coefficient beyond 1.118 for a disc. */
static coin_table table_of(const options *o)
{
    const body *b = o->scene->body;
    coin_table f = {.mu_static = o->mu,
                    .mu_kinetic = fmin(0.9 * o->mu, 1),
                    .restitution = 0.5};

    if (o->thrown) {
        f.pull[0] = b->gravity * sin(o->thrown->slope);
        if (o->thrown->thickness > 0)
            f.restitution = 0; /* as Housner's block, it does not bounce */
        const double torque = b->mass * b->gravity * b->radius;
        f.losses.dry = o->thrown->dry * torque;
        f.losses.spin = o->thrown->spin * torque * sqrt(b->radius / b->gravity);
    }
    return f;
}

/* The start: its velocity is that of rolling, and what it is thrown with along
 * its plane, e_X, Eq. (7). */
static int32_t throw_it(coin_body *d, const motion *m, const options *o)
{
    const coin_state *s = &m->scene->start;
    const int32_t status = coin_body_from_state(d, s, &m->params);

    if (o->thrown) {
        d->vx += o->thrown->faster * cos(s->phi);
        d->vz -= o->thrown->faster * sin(s->phi);
        d->vy += o->thrown->up;
        d->y += o->thrown->high;
    }
    return status;
}

static void keep(motion *m, double t, const coin_body *d, int32_t status)
{
    const moment now = {t,     d->s, status > 0 ? status : 0, d->y, d->vx,
                        d->vy, d->vz};

    m->at[m->count++] = now;
}

/* Moves the coin and keeps up to MOMENTS + 1 states, evenly spread, or until it
 * rests, which m->end tells.  On an error the motion holds what came before it.
 */
static int32_t slide(motion *m, const options *o)
{
    const uint64_t kept = o->steps < MOMENTS ? o->steps : MOMENTS;
    const coin_table f = table_of(o);
    coin_body d;
    double t = 0;

    m->end = throw_it(&d, m, o);
    for (uint64_t k = 0; k <= kept && m->end >= 0; ++k) {
        const double goal = (double)(k * o->steps / kept) * o->dt;
        double moved = 0;
        m->end = coin_move(&d, &m->params, &f, goal - t, SLIDE_TOL, 0, &moved);
        if (m->end < 0)
            return m->end;
        t += moved;
        keep(m, t, &d, m->end);
        if (m->end & COIN_RESTS)
            return COIN_OK;
    }
    return m->end < 0 ? m->end : COIN_OK;
}

/* ------------------------------------------------------------- printing -- */

/* Zero if so many decimals would show it as -0.00. */
static double plain(double x, int decimals)
{
    return fabs(x) < 0.5 * pow(10, -decimals) ? 0 : x;
}

static coin_body body_at(const motion *m, size_t k)
{
    coin_body d;

    coin_body_from_state(&d, &m->at[k].state, &m->params);
    d.y = m->at[k].y;
    d.vx = m->at[k].vx;
    d.vy = m->at[k].vy;
    d.vz = m->at[k].vz;
    return d;
}

/* That of a slope included: its height is 0 where x is 0. */
static double energy_at(const motion *m, size_t k)
{
    const coin_body d = body_at(m, k);

    return coin_body_energy(&d, &m->params) - m->params.mass * m->pull * d.s.x;
}

/* The energy that is left of that at the start. */
static double energy_left(const motion *m, size_t k)
{
    return energy_at(m, k) / energy_at(m, 0);
}

static void print_slide_heading(const options *o)
{
    const coin_table f = table_of(o);

    printf("coin_move at %g, mu %g, and %g where it slips, restitution %g\n\n",
           SLIDE_TOL, f.mu_static, f.mu_kinetic, f.restitution);
}

static void print_slide_columns(const motion *m)
{
    const units *in = m->scene->body->in;

    printf("%9s %7s %8s %8s %8s %8s %7s %8s\n", "time", "lean", "heading", "x",
           "z", "energy", "N/(Mg)", "slip");
    printf("%9s %7s %8s %8s %8s %8s %7s %6s/%s\n", in->time, "deg", "deg",
           in->length, in->length, "left", "", in->length,
           in == &SI ? "s" : "t");
}

static const char *mode_of(const motion *m, size_t k)
{
    static const char *const faces[] = {"", "heads", "tails", "on its edge"};
    const coin_body d = body_at(m, k);

    if (flies(m, k))
        return "flies";
    if (m->at[k].bits & COIN_RESTS)
        return faces[coin_body_face(&d, &m->params)];
    return m->at[k].bits & COIN_SLIPS ? "slips" : "rolls";
}

static void print_slide_row(const motion *m, const options *o, size_t k)
{
    const coin_body d = body_at(m, k);
    const coin_table f = table_of(o);
    const double shown = m->scene->body->in->shown;
    coin_force R = {{0, 0, 0}, 0, 0, 0};
    double u[3] = {0, 0, 0};

    if (!flies(m, k))
        coin_body_contact(&d, &m->params, u);
    coin_body_reaction(&d, &m->params, &f, &R);
    printf("%9.3f %7.2f %8.1f %8.2f %8.2f ", m->at[k].t,
           plain(d.s.theta * DEGREES, 2), plain(d.s.phi * DEGREES, 1),
           plain(d.s.x * shown, 2), plain(d.s.z * shown, 2));
    printf("%8.4f %7.3f %8.2f  %s\n", energy_left(m, k),
           plain(R.normal / (m->params.mass * m->params.gravity), 3),
           hypot(u[0], u[2]) * shown, mode_of(m, k));
}

/* When slip and rolling follow each other, to a moment. */
static void print_slide_summary(const motion *m)
{
    enum { MOST = 8 };
    const char *before = "";
    size_t changes = 0;

    printf("\n");
    for (size_t k = 0; k < m->count; ++k) {
        const char *now = mode_of(m, k);
        if (strcmp(now, before) != 0 && ++changes <= MOST)
            printf("from %-10.4g %s\n", m->at[k].t, now);
        before = now;
    }
    if (changes > MOST)
        printf("and so on: %lu changes\n", (unsigned long)changes);
    printf("it lost         %.1f %% of its energy\n",
           plain(100 * (1 - energy_left(m, m->count - 1)), 1));
}

/* How it ends, in one line. */
static void print_verdict(const motion *m)
{
    const moment *last = &m->at[m->count - 1];
    const char *now = m->slides ? mode_of(m, m->count - 1) : "rolls";

    printf(m->slides && last->bits & COIN_RESTS ? "%s after %.2f %s\n"
                                                : "it %s on after %.2f %s\n",
           now, last->t, m->scene->body->in->time);
}

#endif
