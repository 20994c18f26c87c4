/* SPDX-License-Identifier: MIT */
#include "slides.h"

#include "check.h"
#include "methods.h"

#include <math.h>

coin_slide slide_at(const coin_state *s, double vX, double vh)
{
    const double sph = sin(s->phi), cph = cos(s->phi);
    const coin_slide d = {*s, vX * cph + vh * sph, vh * cph - vX * sph};
    return d;
}

coin_slide random_launch(struct random *r, const coin_params *p)
{
    coin_slide d;
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
    check_status(coin_slide_of(&d, &s, p), COIN_OK);
    if (rolls < 0.5) {
        d.vx = vx;
        d.vz = vz;
    }
    return d;
}

double slides_apart(const coin_slide *a, const coin_slide *b,
                    const coin_params *p)
{
    const double v = sqrt(p->gravity * p->radius);
    return fmax(states_apart(&a->s, &b->s, p),
                fmax(fabs(a->vx - b->vx), fabs(a->vz - b->vz)) / v);
}

double slip_speed(const coin_slide *d, const coin_params *p)
{
    double u[2];
    check_status(coin_slide_velocity(d, p, u), COIN_OK);
    return hypot(u[0], u[1]);
}
