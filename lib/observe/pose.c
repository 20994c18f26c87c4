/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t coin_center(const coin_state *s, const coin_params *p, number r[3])
{
    coin_priv_constants b;
    const int32_t status = r ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    r[0] = s->x;
    r[1] = b.a * coin_priv_sincos(s->theta).c;
    r[2] = s->z;
    return COIN_OK;
}

int32_t coin_velocity(const coin_state *s, const coin_params *p, number v[3])
{
    coin_priv_constants b;
    const int32_t status = v ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_variables y = coin_priv_variables_of(s);
    coin_priv_velocity_of(v, b.a, &y);
    return COIN_OK;
}

int32_t coin_contact(const coin_state *s, const coin_params *p, number r[3],
                     number v[3])
{
    coin_priv_constants b;
    const int32_t status = r && v ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_field field = coin_priv_field_of(&b, 1);
    const coin_priv_variables y = coin_priv_variables_of(s);
    const number a_dpsi = b.a * coin_priv_pose_slopes(&field, &y).psi;
    r[0] = s->x - b.a * y.sth * y.sph; /* (21) */
    r[1] = 0;
    r[2] = s->z - b.a * y.sth * y.cph; /* (21) */
    v[0] = -a_dpsi * y.cph;            /* (22) */
    v[1] = 0;
    v[2] = a_dpsi * y.sph; /* (22) */
    return COIN_OK;
}

int32_t coin_axes(const coin_state *s, number R[9])
{
    if (!s || !R)
        return COIN_EARG;
    if (!coin_priv_state_in_some_range(s))
        return COIN_ESTATE;
    const coin_priv_variables f = coin_priv_variables_of(s);
    coin_priv_axes(&f, R);
    return COIN_OK;
}

int32_t coin_angular_velocity(const coin_state *s, number omega[3])
{
    number R[9];
    const int32_t status = omega ? coin_axes(s, R) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    for (int i = 0; i < 3; ++i)
        omega[i] = s->wX * R[i] + s->wY * R[3 + i] + s->wZ * R[6 + i];
    return COIN_OK;
}

int32_t coin_quaternion(const coin_state *s, number q[4])
{
    if (!s || !q)
        return COIN_EARG;
    if (!coin_priv_state_in_some_range(s))
        return COIN_ESTATE;
    const coin_priv_sc ph = coin_priv_sincos(s->phi / 2);
    const coin_priv_sc th = coin_priv_sincos(s->theta / 2);
    const coin_priv_sc ps = coin_priv_sincos(s->psi / 2);
    /* clang-format off */
    q[0] = ph.c * th.c * ps.c + ph.s * th.s * ps.s; /* (30) */
    q[1] = ph.c * th.s * ps.c + ph.s * th.c * ps.s; /* (30) */
    q[2] = ph.s * th.c * ps.c - ph.c * th.s * ps.s; /* (30) */
    q[3] = ph.c * th.c * ps.s - ph.s * th.s * ps.c; /* (30) */
    /* clang-format on */
    return COIN_OK;
}

int32_t coin_matrix(const coin_state *s, const coin_params *p, number m[16])
{
    coin_priv_constants b;
    const int32_t status = m ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    number R[9];
    const coin_priv_variables y = coin_priv_variables_of(s);
    const coin_priv_sc ps = coin_priv_sincos(s->psi);
    const number center[] = {s->x, b.a * y.cth, s->z};
    coin_priv_axes(&y, R);
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
static number angle_of(number s, number c)
{
    const number norm = coin_priv_hypot(s, c);
    const coin_priv_sc unit = {s / norm, c / norm};
    const number angle = coin_priv_angle(unit);
    return angle == -2 * COIN_PRIV_HALF_PI ? -angle : angle;
}

/* The angles of a rotation, from Eq. (30).  With C2, S2 the cosine and sine of
 * theta/2, A is C2 + S2 times the cosine and sine of (phi - psi)/2, and B is C2
 * - S2 times those of (phi + psi)/2.  Both keep their accuracy where the coin
 * is nearly flat and phi, psi lose theirs.  NaN if q is 0 or not finite. */
static void angles_of(coin_state *s, const number q[4])
{
    const number Ac = q[0] + q[1], As = q[2] - q[3];
    const number Bc = q[0] - q[1], Bs = q[2] + q[3];
    const number A = coin_priv_hypot(As, Ac), B = coin_priv_hypot(Bs, Bc);
    const number sine = 2 * (q[0] * q[1] - q[2] * q[3]);
    s->theta = angle_of(sine, A * B);
    s->phi = angle_of(Bs * Ac + Bc * As, Bc * Ac - Bs * As);
    s->psi = angle_of(Bs * Ac - Bc * As, Bc * Ac + Bs * As);
}

int32_t coin_state_from_motion(coin_state *s, const coin_params *p,
                               const number q[4], const number omega[3],
                               number x, number z)
{
    coin_priv_constants b;
    coin_state made = {0, 0, 0, x, z, 0, 0, 0 COIN_PRIV_NO_LOW};
    if (!s || !p || !q || !omega)
        return COIN_EARG;
    if (coin_priv_check_thick(&b, p) != COIN_OK)
        return COIN_EPARAMS;
    const number size2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!coin_priv_size_in_range(size2))
        return COIN_ESTATE;
    angles_of(&made, q);
    number R[9];
    const coin_priv_variables f = coin_priv_variables_of(&made);
    coin_priv_axes(&f, R);
    made.wX = omega[0] * R[0] + omega[1] * R[1] + omega[2] * R[2];
    made.wY = omega[0] * R[3] + omega[1] * R[4] + omega[2] * R[5];
    made.wZ = omega[0] * R[6] + omega[1] * R[7] + omega[2] * R[8];
    const int32_t status = coin_state_check(&made, p);
    if (status == COIN_OK)
        *s = made;
    return status;
}
