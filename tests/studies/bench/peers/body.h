/* SPDX-License-Identifier: MIT */
/* A coin as an engine holds it, in natural units. */
#ifndef BODY_H
#define BODY_H

#include "rates.h"

#include <string.h>

/* Position of the centre, velocity, rotation body to table (w x y z), angular
 * velocity along the table's axes. */
struct peer_pose {
    double r[3], v[3], q[4], omega[3];
};

static inline struct peer_pose peer_pose_of(const scene *c)
{
    const coin_state *s = &c->row[0].s;
    const double a = c->p.radius, w = c->unit;
    struct peer_pose p;
    coin_center(s, &c->p, p.r);
    coin_velocity(s, &c->p, p.v);
    coin_quaternion(s, p.q);
    coin_angular_velocity(s, p.omega);
    for (int i = 0; i < 3; ++i) {
        p.r[i] /= a;
        p.v[i] *= w / a;
        p.omega[i] *= w;
    }
    return p;
}

static inline coin_state peer_state_of(const scene *c,
                                       const struct peer_pose *p)
{
    const double a = c->p.radius, w = c->unit;
    const double omega[3] = {p->omega[0] / w, p->omega[1] / w, p->omega[2] / w};
    coin_state s = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    coin_state_from_motion(&s, &c->p, p->q, omega, p->r[0] * a, p->r[2] * a);
    return s;
}

/* Engines take fixed steps and are first order on a contact: half the step,
 * half the error, and nobody waits longer than this for a run. */
#define PEER_ENGINE_STEPS 0.0625, 0.5, 1e-7, 200e6, 1

#endif
