/* SPDX-License-Identifier: MIT */
#include "slides.h"

#include "check.h"
#include "methods.h"

#include <math.h>

/* With the height and the normal velocity of one that touches the table, if
 * they can be computed. */
static coin_body touching(const coin_body *d, const coin_params *p)
{
    coin_body r = *d;
    double at[3], v[3];
    if (coin_center(&d->s, p, at) == COIN_OK &&
        coin_velocity(&d->s, p, v) == COIN_OK) {
        r.y = at[1];
        r.vy = v[1];
    }
    return r;
}

static coin_table with(const coin_table *f, const coin_losses *l)
{
    coin_table r = *f;
    if (l)
        r.losses = *l;
    return r;
}

int32_t slide(coin_body *d, const coin_params *p, const coin_table *f,
              const coin_losses *l, double t, double tol, double *reached)
{
    const coin_table table = with(f, l);
    const double least = tol > 0 && tol < 1e-12 ? 1e-12 : tol;
    coin_body b = touching(d, p);
    double moved = 0, sum = 0;
    int32_t status = coin_move(&b, p, &table, 0, least, 0, NULL);
    if (status != COIN_LIFTS) /* else a call would fly on */
        status = coin_move(&b, p, &table, t, least, COIN_LIFTS, &moved);
    for (int i = 0; i < 200 && status >= 0 && status & COIN_MORE; ++i) {
        sum += moved; /* a call is bounded, and the next goes on */
        status = coin_move(&b, p, &table, t - sum, least, COIN_LIFTS, &moved);
    }
    if (reached && (status >= 0 || moved > 0 || sum > 0))
        *reached = sum > 0 && status >= 0 && moved == t - sum ? t : sum + moved;
    d->s = b.s;
    d->vx = b.vx;
    d->vz = b.vz;
    return status;
}

double slide_energy(const coin_body *d, const coin_params *p)
{
    const coin_body b = touching(d, p);
    return coin_body_energy(&b, p);
}

int32_t slide_velocity(const coin_body *d, const coin_params *p, double u[2])
{
    const coin_body b = touching(d, p);
    double v[3];
    const int32_t status = coin_body_contact(&b, p, v);
    if (status == COIN_OK) {
        u[0] = v[0];
        u[1] = v[2];
    }
    return status;
}

int32_t slide_reaction(const coin_body *d, const coin_params *p,
                       const coin_table *f, const coin_losses *l,
                       coin_force *out)
{
    const coin_table table = with(f, l);
    const coin_body b = touching(d, p);
    return coin_body_reaction(&b, p, &table, out);
}

coin_body slide_at(const coin_state *s, double vX, double vh)
{
    const double sph = sin(s->phi), cph = cos(s->phi);
    const coin_body d = {
        .s = *s, .vx = vX * cph + vh * sph, .vz = vh * cph - vX * sph};
    return d;
}

coin_body random_launch(struct random *r, const coin_params *p)
{
    coin_body d;
    const coin_state s = {
        .theta = random_between(r, -1.4, 1.4),
        .phi = random_between(r, -3, 3),
        .wX = random_between(r, -1.5, 1.5),
        .wY = random_between(r, -1.5, 1.5),
        .wZ = random_between(r, -1.5, 1.5),
    };
    const double vx = random_between(r, -1, 1), vz = random_between(r, -1, 1);
    const double rolls = random_between(r, 0, 1);
    ++r->drawn;
    check_note("seed %llu, launch %u", (unsigned long long)r->seed, r->drawn);
    check_status(coin_body_from_state(&d, &s, p), COIN_OK);
    if (rolls < 0.5) {
        d.vx = vx;
        d.vz = vz;
    }
    return d;
}

double slides_apart(const coin_body *a, const coin_body *b,
                    const coin_params *p)
{
    const double v = sqrt(p->gravity * p->radius);
    return fmax(states_apart(&a->s, &b->s, p),
                fmax(fabs(a->vx - b->vx), fabs(a->vz - b->vz)) / v);
}

double slip_speed(const coin_body *d, const coin_params *p)
{
    double u[2];
    check_status(slide_velocity(d, p, u), COIN_OK);
    return hypot(u[0], u[1]);
}

/* While rolling needs a friction of mu N, and there is only mu_kinetic N, the
 * slip grows at (mu - mu_kinetic) N/M or more.  From the largest F/N until it
 * falls to the mean of both coefficients, but for a tenth of a natural unit at
 * most, so that the motion that rolls tells N.  A half of what that takes. */
static double least_loss(const coin_params *p, const coin_state *start,
                         const coin_table *f, double t)
{
    enum { LOOKS = 4000 };
    const double mean = (f->mu_static + f->mu_kinetic) / 2;
    double most = 0, time = 0, N = 0;
    int over = 0;
    coin_state s = *start;
    for (int i = 0; i <= LOOKS; ++i) {
        coin_force at;
        check_status(coin_reaction(&s, p, &at), COIN_OK);
        if (at.ratio > most) {
            most = at.ratio;
            time = 0;
            N = at.normal;
            over = 1;
        } else if (over && at.ratio > mean && time < natural_time(p) / 10) {
            time += t / LOOKS;
            N = fmin(N, at.normal);
        } else
            over = 0;
        check_status(coin_advance(&s, p, t / LOOKS, 1e-7, NULL), COIN_OK);
    }
    check(most > 0.999 * f->mu_static); /* as near as samples come */
    return N > 0 ? f->mu_kinetic * N * (mean - f->mu_kinetic) * N * time *
                       time / (4 * p->mass)
                 : 0;
}

int slips_as_it_must(const coin_params *p, const coin_state *s,
                     const coin_table *f, double t, double tol)
{
    const coin_table rough = {.mu_static = INFINITY, .mu_kinetic = 0};
    coin_body slips, rolls;
    check_status(coin_body_from_state(&slips, s, p), COIN_OK);
    rolls = slips;
    const int32_t got = slide(&slips, p, f, NULL, t, tol, NULL);
    if (got == COIN_LIFTS)
        return 1;
    check(got >= 0);
    check_status(slide(&rolls, p, &rough, NULL, t, tol, NULL), COIN_OK);
    const double lost = slide_energy(&rolls, p) - slide_energy(&slips, p);
    return lost > least_loss(p, s, f, t);
}
