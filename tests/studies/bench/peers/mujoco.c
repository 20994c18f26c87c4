/* SPDX-License-Identifier: MIT */
/* MuJoCo: the coin as an ellipsoid of 1/10000 of its radius, which touches the
 * table in one point at any lean; its RK4, the stiffest contact it allows. */
#include "body.h"

#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>

static const char model_xml[] =
    "<mujoco><option gravity='0 0 -1' integrator='RK4' cone='elliptic'"
    " impratio='10' tolerance='1e-12' iterations='50' timestep='1e-3'/>"
    "<worldbody><geom type='plane' size='0 0 1' friction='100 0 0'/>"
    "<body><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>"
    "<geom type='ellipsoid' size='1 1 1e-4' friction='100 0 0' condim='3'/>"
    "</body></worldbody></mujoco>";

static struct {
    const scene *c;
    mjModel *m;
    mjData *d;
} at;

/* MuJoCo reads models from files alone, which need not be on a disk. */
static void set_up(void)
{
    char error[256] = "";
    mjVFS files;
    mj_defaultVFS(&files);
    mj_makeEmptyFileVFS(&files, "coin.xml", (int)strlen(model_xml));
    memcpy(files.filedata[0], model_xml, strlen(model_xml));
    at.m = mj_loadXML("coin.xml", &files, error, sizeof error);
    if (!at.m) {
        fprintf(stderr, "mujoco: %s\n", error);
        exit(1);
    }
    mj_deleteVFS(&files);
    at.d = mj_makeData(at.m);
}

/* Its z is up: the table frame turned about x. */
static void z_up(double to[3], const double from[3])
{
    const double v[3] = {from[0], -from[2], from[1]};
    memcpy(to, v, sizeof v);
}

static void y_up(double to[3], const double from[3])
{
    const double v[3] = {from[0], from[2], -from[1]};
    memcpy(to, v, sizeof v);
}

static const double turned[4] = {0.7071067811865476, 0.7071067811865476, 0, 0};

static void begin(const solver *self, const scene *c, double setting)
{
    (void)self;
    if (!at.m)
        set_up();
    const struct peer_body b = peer_body_of(c);
    const struct peer_pose p = peer_pose_of(c);
    double omega[3], back[4];
    at.c = c;
    at.m->opt.timestep = setting;
    at.m->body_inertia[3] = at.m->body_inertia[4] = b.IX;
    at.m->body_inertia[5] = b.IZ;
    /* The least time constant that it takes, two steps, and no softness. */
    for (int i = 0; i < at.m->ngeom; ++i) {
        const double ref[2] = {2 * setting, 1};
        const double imp[5] = {0.9999, 0.9999, 0.001, 0.5, 2};
        memcpy(at.m->geom_solref + i * mjNREF, ref, sizeof ref);
        memcpy(at.m->geom_solimp + i * mjNIMP, imp, sizeof imp);
    }
    mj_setConst(at.m, at.d);
    mj_resetData(at.m, at.d);
    z_up(at.d->qpos, p.r);
    mju_mulQuat(at.d->qpos + 3, turned, p.q);
    z_up(at.d->qvel, p.v);
    z_up(omega, p.omega); /* which it keeps along the body's axes */
    mju_negQuat(back, at.d->qpos + 3);
    mju_rotVecQuat(at.d->qvel + 3, omega, back);
}

static int go(double t, unsigned long steps)
{
    at.m->opt.timestep = t / at.c->unit / (double)steps;
    for (unsigned long i = 0; i < steps; ++i)
        mj_step(at.m, at.d);
    return 0;
}

static coin_state state(void)
{
    struct peer_pose p;
    double back[4], omega[3];
    mju_negQuat(back, turned);
    mju_mulQuat(p.q, back, at.d->qpos + 3);
    y_up(p.r, at.d->qpos);
    y_up(p.v, at.d->qvel);
    mju_rotVecQuat(omega, at.d->qvel + 3, at.d->qpos + 3);
    y_up(p.omega, omega);
    return peer_state_of(at.c, &p);
}

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"MuJoCo ellipsoid", 0, 4, PEER_ENGINE_STEPS, begin, go, state},
    };
    return workprec(list, 1, argc, argv);
}
