/* SPDX-License-Identifier: MIT */
/* Open Dynamics Engine: a rigid body with one contact without slip, at the
 * lowest point of the rim, which the caller computes; dWorldStep. */
#include "body.h"

#include <ode/ode.h>

static struct {
    const scene *c;
    dWorldID world;
    dBodyID coin;
    dJointGroupID contacts;
} at;

static void begin(const solver *self, const scene *c, double setting)
{
    (void)self;
    (void)setting;
    const struct peer_body b = peer_body_of(c);
    const struct peer_pose p = peer_pose_of(c);
    dMass mass;
    if (at.world)
        dWorldDestroy(at.world);
    else
        at.contacts = dJointGroupCreate(0);
    at.c = c;
    at.world = dWorldCreate();
    dWorldSetGravity(at.world, 0, -1, 0);
    at.coin = dBodyCreate(at.world);
    dMassSetParameters(&mass, 1, 0, 0, 0, b.IX, b.IX, b.IZ, 0, 0, 0);
    dBodySetMass(at.coin, &mass);
    dBodySetPosition(at.coin, p.r[0], p.r[1], p.r[2]);
    dBodySetLinearVel(at.coin, p.v[0], p.v[1], p.v[2]);
    dBodySetQuaternion(at.coin, p.q);
    dBodySetAngularVel(at.coin, p.omega[0], p.omega[1], p.omega[2]);
}

/* The lowest point of the rim: down the coin's plane from the centre. */
static dContact touch(void)
{
    const dReal *r = dBodyGetPosition(at.coin);
    const dReal *R = dBodyGetRotation(at.coin); /* 3 rows of 4 */
    const double e[3] = {R[2], R[6], R[10]};    /* the axis */
    const double flat = sqrt(e[0] * e[0] + e[2] * e[2]);
    dContact k;
    memset(&k, 0, sizeof k);
    k.surface.mu = dInfinity;
    k.geom.pos[0] = r[0] + e[1] * e[0] / flat;
    k.geom.pos[1] = r[1] - flat;
    k.geom.pos[2] = r[2] + e[1] * e[2] / flat;
    k.geom.normal[1] = 1;
    k.geom.depth = -k.geom.pos[1];
    return k;
}

static int go(double t, unsigned long steps)
{
    const double h = t / at.c->unit / (double)steps;
    for (unsigned long i = 0; i < steps; ++i) {
        const dContact k = touch();
        dJointAttach(dJointCreateContact(at.world, at.contacts, &k), at.coin,
                     0);
        dWorldStep(at.world, h);
        dJointGroupEmpty(at.contacts);
    }
    return 0;
}

static coin_state state(void)
{
    const dReal *r = dBodyGetPosition(at.coin), *v = dBodyGetLinearVel(at.coin);
    const dReal *q = dBodyGetQuaternion(at.coin);
    const dReal *omega = dBodyGetAngularVel(at.coin);
    struct peer_pose p;
    memcpy(p.r, r, sizeof p.r);
    memcpy(p.v, v, sizeof p.v);
    memcpy(p.q, q, sizeof p.q);
    memcpy(p.omega, omega, sizeof p.omega);
    return peer_state_of(at.c, &p);
}

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"ODE rim contact", 0, 1, PEER_ENGINE_STEPS, begin, go, state},
    };
    dInitODE2(0);
    const int status = workprec(list, 1, argc, argv);
    dCloseODE();
    return status;
}
