/* SPDX-License-Identifier: MIT */
/* A coin on a table in ODE, Bullet and MuJoCo: a cylinder, in natural units,
 * since engines ask for bodies of about a metre.  C++. */
#ifndef ENGINES_H
#define ENGINES_H

#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mujoco/mujoco.h>
#include <ode/ode.h>

#include <coin.h>

/* What all engines are told. */
struct engine_scene {
    double half, IX, IZ; /* of the thickness; about a diameter, the axis */
    double mu, restitution, rolling;
};

/* What an engine tells of its coin. */
struct coin_seen {
    double axis[3], r[3], v[3], w[3];
};

/* That of lying flat is half of the thickness. */
inline double engine_energy(const engine_scene &c, const coin_seen &s)
{
    double vv = 0, ww = 0, wZ = 0;
    for (int i = 0; i < 3; ++i) {
        vv += s.v[i] * s.v[i];
        ww += s.w[i] * s.w[i];
        wZ += s.w[i] * s.axis[i];
    }
    return s.r[1] + (vv + c.IX * (ww - wZ * wZ) + c.IZ * wZ * wZ) / 2;
}

struct engine {
    virtual ~engine() {}
    virtual void begin(const coin_body &b) = 0;
    virtual void step(double dt) = 0;
    virtual coin_seen look() = 0;
};

/* --------------------------------------------------------------------- ODE */
struct ode_engine : engine {
    engine_scene c;
    bool at_rim; /* one contact, at the lowest point; else those it finds */
    dWorldID world = dWorldCreate();
    dSpaceID space = dSimpleSpaceCreate(0);
    dGeomID ground = dCreatePlane(space, 0, 1, 0, 0), coin;
    dBodyID body = dBodyCreate(world);
    dJointGroupID joints = dJointGroupCreate(0);

    ode_engine(const engine_scene &scene, bool gyroscopic, bool rim)
        : c(scene), at_rim(rim), coin(dCreateCylinder(space, 1, 2 * c.half))
    {
        dMass m;
        dWorldSetGravity(world, 0, -1, 0);
        dMassSetParameters(&m, 1, 0, 0, 0, c.IX, c.IX, c.IZ, 0, 0, 0);
        dBodySetMass(body, &m);
        dGeomSetBody(coin, body);
        dBodySetGyroscopicMode(body, gyroscopic);
    }
    void begin(const coin_body &b) override
    {
        double q[4], w[3];
        coin_quaternion(&b.s, q);
        coin_angular_velocity(&b.s, w);
        dBodySetPosition(body, b.s.x, b.y, b.s.z);
        dBodySetQuaternion(body, q);
        dBodySetLinearVel(body, b.vx, b.vy, b.vz);
        dBodySetAngularVel(body, w[0], w[1], w[2]);
    }
    /* Down the lower face from its centre. */
    int lowest(dContact *k)
    {
        const coin_seen s = look();
        const double *e = s.axis, side = e[1] > 0 ? -c.half : c.half;
        const double flat = std::hypot(e[0], e[2]);
        double *at = k->geom.pos;
        at[0] = s.r[0] + side * e[0] + e[1] * e[0] / flat;
        at[1] = s.r[1] + side * e[1] - flat;
        at[2] = s.r[2] + side * e[2] + e[1] * e[2] / flat;
        k->geom.normal[1] = 1;
        k->geom.depth = -at[1];
        return 1;
    }
    void step(double dt) override
    {
        dContact k[8] = {};
        const int n = at_rim ? lowest(k)
                             : dCollide(coin, ground, 8, &k[0].geom, sizeof *k);
        for (int i = 0; i < n; ++i) {
            dSurfaceParameters &s = k[i].surface;
            s.mode = dContactApprox1 |
                     (c.restitution > 0 ? dContactBounce : 0) |
                     (c.rolling > 0 ? dContactRolling : 0);
            s.mu = c.mu;
            s.bounce = c.restitution;
            s.rho = s.rho2 = c.rolling;
            s.bounce_vel = 0.01;
            dJointAttach(dJointCreateContact(world, joints, &k[i]), body, 0);
        }
        dWorldStep(world, dt);
        dJointGroupEmpty(joints);
    }
    coin_seen look() override
    {
        const double *R = dBodyGetRotation(body), *r = dBodyGetPosition(body);
        const double *v = dBodyGetLinearVel(body),
                     *w = dBodyGetAngularVel(body);
        return {{R[2], R[6], R[10]},
                {r[0], r[1], r[2]},
                {v[0], v[1], v[2]},
                {w[0], w[1], w[2]}};
    }
};

/* ------------------------------------------------------------------ Bullet */
struct bullet_engine : engine {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broad;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broad, &solver, &configuration};
    btStaticPlaneShape plane{btVector3(0, 1, 0), 0};
    btCylinderShapeZ cylinder;
    btRigidBody ground{
        btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane)};
    btRigidBody coin;

    /* gyroscopic: a btRigidBodyFlags.  Friction acts along the slip alone
     * unless told otherwise. */
    bullet_engine(const engine_scene &c, int gyroscopic, bool two_directions)
        : cylinder(btVector3(1, 1, btScalar(c.half))),
          coin(btRigidBody::btRigidBodyConstructionInfo(
              1, nullptr, &cylinder,
              btVector3(btScalar(c.IX), btScalar(c.IX), btScalar(c.IZ))))
    {
        cylinder.setMargin(1e-4f); /* by which its rims are rounded */
        world.setGravity(btVector3(0, -1, 0));
        ground.setRestitution(1); /* of two bodies their product acts */
        ground.setFriction(1);
        coin.setRestitution(btScalar(c.restitution));
        coin.setFriction(btScalar(c.mu));
        coin.setRollingFriction(btScalar(c.rolling)); /* times ground's 1 */
        coin.setActivationState(DISABLE_DEACTIVATION);
        coin.setFlags(gyroscopic);
        if (two_directions)
            world.getSolverInfo().m_solverMode |=
                SOLVER_USE_2_FRICTION_DIRECTIONS;
        world.addRigidBody(&ground);
        world.addRigidBody(&coin);
    }
    ~bullet_engine() override
    {
        world.removeRigidBody(&coin);
        world.removeRigidBody(&ground);
    }
    static btVector3 vector(double x, double y, double z)
    {
        return btVector3(btScalar(x), btScalar(y), btScalar(z));
    }
    void begin(const coin_body &b) override
    {
        double q[4], w[3];
        coin_quaternion(&b.s, q);
        coin_angular_velocity(&b.s, w);
        btTransform at;
        at.setRotation(btQuaternion(btScalar(q[1]), btScalar(q[2]),
                                    btScalar(q[3]), btScalar(q[0])));
        at.setOrigin(vector(b.s.x, b.y, b.s.z));
        coin.setCenterOfMassTransform(at);
        coin.setLinearVelocity(vector(b.vx, b.vy, b.vz));
        coin.setAngularVelocity(vector(w[0], w[1], w[2]));
        coin.clearForces();
        broad.getOverlappingPairCache()->cleanProxyFromPairs(
            coin.getBroadphaseHandle(), &dispatcher);
    }
    void step(double dt) override
    {
        world.stepSimulation(btScalar(dt), 0);
    }
    coin_seen look() override
    {
        const btTransform &at = coin.getWorldTransform();
        const btVector3 &v = coin.getLinearVelocity(),
                        &w = coin.getAngularVelocity(), &r = at.getOrigin(),
                        n = at.getBasis().getColumn(2);
        return {{n[0], n[1], n[2]},
                {r[0], r[1], r[2]},
                {v[0], v[1], v[2]},
                {w[0], w[1], w[2]}};
    }
};

/* ------------------------------------------------------------------ MuJoCo */
/* Its z is up: the table's frame turned about x.  It has no coefficient of
 * restitution, but a spring in the contact: one so little damped that it gives
 * back the same part of a speed. */
struct mujoco_engine : engine {
    mjModel *m = nullptr;
    mjData *d = nullptr;
    double damping, at_step = 0;

    /* It reads models from files alone, which need not be on a disk. */
    mujoco_engine(const engine_scene &c, const char *integrator)
    {
        char xml[1000], error[256] = "";
        std::snprintf(
            xml, sizeof xml,
            "<mujoco><option gravity='0 0 -1' integrator='%s' cone='elliptic'"
            " impratio='10' tolerance='1e-12' iterations='50'/><worldbody>"
            "<geom type='plane' size='0 0 1' friction='%g 0 %g' condim='%d'/>"
            "<body><freejoint/><inertial pos='0 0 0' mass='1'"
            " diaginertia='%.17g %.17g %.17g'/><geom type='cylinder'"
            " size='1 %.17g' friction='%g 0 %g' condim='%d'/></body>"
            "</worldbody></mujoco>",
            integrator, c.mu, c.rolling, c.rolling > 0 ? 6 : 3, c.IX, c.IX,
            c.IZ, c.half, c.mu, c.rolling, c.rolling > 0 ? 6 : 3);
        static mjVFS files;
        mj_defaultVFS(&files);
        mj_makeEmptyFileVFS(&files, "coin.xml", (int)std::strlen(xml));
        std::memcpy(files.filedata[0], xml, std::strlen(xml));
        m = mj_loadXML("coin.xml", &files, error, sizeof error);
        mj_deleteVFS(&files);
        if (!m) {
            std::fprintf(stderr, "mujoco: %s\n", error);
            std::exit(1);
        }
        d = mj_makeData(m);
        const double bounce = std::log(c.restitution);
        damping = c.restitution > 0 ? -bounce / std::hypot(M_PI, bounce) : 1;
    }
    ~mujoco_engine() override
    {
        mj_deleteData(d);
        mj_deleteModel(m);
    }
    static void turned(double *to, const double *from, int way)
    {
        const double v[3] = {from[0], -way * from[2], way * from[1]};
        std::memcpy(to, v, sizeof v);
    }
    void begin(const coin_body &b) override
    {
        static const double up[4] = {M_SQRT1_2, M_SQRT1_2, 0, 0};
        const double r[3] = {b.s.x, b.y, b.s.z}, v[3] = {b.vx, b.vy, b.vz};
        double q[4], w[3], back[4];
        mj_resetData(m, d);
        coin_quaternion(&b.s, q);
        coin_angular_velocity(&b.s, w);
        turned(d->qpos, r, 1);
        mju_mulQuat(d->qpos + 3, up, q);
        turned(d->qvel, v, 1);
        turned(w, w, 1);
        mju_negQuat(back, d->qpos + 3); /* along the body's axes */
        mju_rotVecQuat(d->qvel + 3, w, back);
    }
    /* The stiffest spring that it takes, and no softness. */
    void stiffen(double dt)
    {
        const double ref[2] = {2 * dt / damping, damping};
        const double imp[5] = {0.9999, 0.9999, 0.001, 0.5, 2};
        for (int i = 0; i < m->ngeom; ++i) {
            std::memcpy(m->geom_solref + i * mjNREF, ref, sizeof ref);
            std::memcpy(m->geom_solimp + i * mjNIMP, imp, sizeof imp);
        }
        m->opt.timestep = at_step = dt;
    }
    void step(double dt) override
    {
        if (dt != at_step)
            stiffen(dt);
        mj_step(m, d);
    }
    coin_seen look() override
    {
        static const double z[3] = {0, 0, 1};
        double axis[3], w[3];
        coin_seen s;
        mju_rotVecQuat(axis, z, d->qpos + 3);
        mju_rotVecQuat(w, d->qvel + 3, d->qpos + 3);
        turned(s.axis, axis, -1);
        turned(s.r, d->qpos, -1);
        turned(s.v, d->qvel, -1);
        turned(s.w, w, -1);
        return s;
    }
};

#endif
