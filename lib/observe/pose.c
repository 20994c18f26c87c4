/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t COIN(center)(const COIN(state) * s, const COIN(params) * p, real r[3])
{
    PRIV(body) b;
    const int32_t status = r ? PRIV(check)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    r[0] = s->x;
    r[1] = b.a * PRIV(sincos)(s->theta).c;
    r[2] = s->z;
    return COIN_OK;
}

int32_t COIN(velocity)(const COIN(state) * s, const COIN(params) * p, real v[3])
{
    PRIV(body) b;
    const int32_t status = v ? PRIV(check)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const PRIV(variables) y = PRIV(variables_of)(s);
    PRIV(velocity_of)(v, b.a, &y);
    return COIN_OK;
}

int32_t COIN(contact)(const COIN(state) * s, const COIN(params) * p, real r[3],
                      real v[3])
{
    PRIV(body) b;
    const int32_t status = r && v ? PRIV(check)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const PRIV(field) field = PRIV(field_of)(&b, 1);
    const PRIV(variables) y = PRIV(variables_of)(s);
    const real a_dpsi = b.a * PRIV(pose_slopes)(&field, &y).psi;
    r[0] = s->x - b.a * y.sth * y.sph; /* (21) */
    r[1] = 0;
    r[2] = s->z - b.a * y.sth * y.cph; /* (21) */
    v[0] = -a_dpsi * y.cph;            /* (22) */
    v[1] = 0;
    v[2] = a_dpsi * y.sph; /* (22) */
    return COIN_OK;
}

int32_t COIN(axes)(const COIN(state) * s, real R[9])
{
    if (!s || !R)
        return COIN_EARG;
    if (PRIV(check_members)(s) != COIN_OK)
        return COIN_ESTATE;
    const PRIV(variables) f = PRIV(variables_of)(s);
    PRIV(axes)(&f, R);
    return COIN_OK;
}

int32_t COIN(angular_velocity)(const COIN(state) * s, real omega[3])
{
    real R[9];
    const int32_t status = omega ? COIN(axes)(s, R) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    real w[3];
    int good = 1;
    for (int i = 0; i < 3; ++i) {
        w[i] = s->wX * R[i] + s->wY * R[3 + i] + s->wZ * R[6 + i]; /* (7) */
        good &= w[i] - w[i] == 0;
    }
    if (!good)
        return COIN_ESTATE;
    for (int i = 0; i < 3; ++i)
        omega[i] = w[i];
    return COIN_OK;
}

int32_t COIN(quaternion)(const COIN(state) * s, real q[4])
{
    if (!s || !q)
        return COIN_EARG;
    if (PRIV(check_members)(s) != COIN_OK)
        return COIN_ESTATE;
    const PRIV(sc) ph = PRIV(sincos)(s->phi / 2);
    const PRIV(sc) th = PRIV(sincos)(s->theta / 2);
    const PRIV(sc) ps = PRIV(sincos)(s->psi / 2);
    /* clang-format off */
    q[0] = ph.c * th.c * ps.c + ph.s * th.s * ps.s; /* (30) */
    q[1] = ph.c * th.s * ps.c + ph.s * th.c * ps.s; /* (30) */
    q[2] = ph.s * th.c * ps.c - ph.c * th.s * ps.s; /* (30) */
    q[3] = ph.c * th.c * ps.s - ph.s * th.s * ps.c; /* (30) */
    /* clang-format on */
    return COIN_OK;
}

int32_t COIN(matrix)(const COIN(state) * s, const COIN(params) * p, real m[16])
{
    PRIV(body) b;
    const int32_t status = m ? PRIV(check)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    real R[9];
    const PRIV(variables) y = PRIV(variables_of)(s);
    const PRIV(sc) ps = PRIV(sincos)(s->psi);
    const real center[] = {s->x, b.a * y.cth, s->z};
    PRIV(axes)(&y, R);
    for (int i = 0; i < 3; ++i) {
        m[i] = ps.c * R[i] + ps.s * R[3 + i];     /* (90) */
        m[4 + i] = ps.c * R[3 + i] - ps.s * R[i]; /* (90) */
        m[8 + i] = R[6 + i];                      /* (90) */
        m[12 + i] = center[i];
    }
    m[3] = m[7] = m[11] = 0;
    m[15] = 1;
    return COIN_OK;
}

/* The angle of (s, c) in (-pi, pi], whatever its norm; NaN if that is 0 or not
 * finite. */
static real angle_of(real s, real c)
{
    const real norm = PRIV(hypot)(s, c);
    const PRIV(sc) unit = {s / norm, c / norm};
    const real angle = PRIV(angle)(unit);
    return angle == -2 * COIN_PRIV_HALF_PI ? -angle : angle;
}

/* The angles of a rotation, by Eq. (30).  With C2, S2 the cosine and sine of
 * theta/2, A is C2 + S2 times the cosine and sine of (phi - psi)/2, and B is C2
 * - S2 times those of (phi + psi)/2.  Both keep their accuracy where the coin
 * is nearly flat and phi, psi lose theirs.  NaN if q is 0 or not finite. */
static void angles_of(COIN(state) * s, const real q[4])
{
    const real Ac = q[0] + q[1], As = q[2] - q[3];
    const real Bc = q[0] - q[1], Bs = q[2] + q[3];
    const real A = PRIV(hypot)(As, Ac), B = PRIV(hypot)(Bs, Bc);
    const real sine = 2 * (q[0] * q[1] - q[2] * q[3]);
    s->theta = angle_of(sine, A * B);                        /* (30) */
    s->phi = angle_of(Bs * Ac + Bc * As, Bc * Ac - Bs * As); /* (30) */
    s->psi = angle_of(Bs * Ac - Bc * As, Bc * Ac + Bs * As); /* (30) */
}

int32_t COIN(state_from_motion)(COIN(state) * s, const COIN(params) * p,
                                const real q[4], const real omega[3], real x,
                                real z)
{
    PRIV(body) b;
    COIN(state) made = {0, 0, 0, x, z, 0, 0, 0 COIN_PRIV_NO_LOW};
    if (!s || !p || !q || !omega)
        return COIN_EARG;
    if (PRIV(check_body)(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    const real size2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!PRIV(is_ordinary)(size2))
        return COIN_ESTATE;
    angles_of(&made, q);
    real R[9];
    const PRIV(variables) f = PRIV(variables_of)(&made);
    PRIV(axes)(&f, R);
    made.wX = omega[0] * R[0] + omega[1] * R[1] + omega[2] * R[2]; /* (7) */
    made.wY = omega[0] * R[3] + omega[1] * R[4] + omega[2] * R[5]; /* (7) */
    made.wZ = omega[0] * R[6] + omega[1] * R[7] + omega[2] * R[8]; /* (7) */
    const int32_t status = PRIV(check)(&made, p, &b);
    if (status == COIN_OK)
        *s = made;
    return status;
}
