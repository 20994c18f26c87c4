/* SPDX-License-Identifier: MIT */
/* A coin_body from the motion of an engine's body. */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "coin_body.h"

/* A body that an engine set this many radii into the table is set on it. */
#define OVERLAP 0.1

/* The state of a coin whose face is horizontal: psi = 0, and theta is the last
 * lean before pi/2 with the sign that turns the face up or down. */
static void lay_flat(coin_state *s, const double q[4])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double norm = w * w + x * x + y * y + z * z;
    const coin_priv_sc ph = {
        2 * (w * y - x * z) / norm,
        (w * w + x * x - y * y - z * z) / norm,
    };
    s->theta = w * x - y * z > 0 ? COIN_PRIV_LAST_LEAN : -COIN_PRIV_LAST_LEAN;
    s->phi = coin_priv_angle(ph);
    s->psi = 0;
}

/* How far cos theta may be from 0 for a face that counts as horizontal. */
#define HORIZONTAL (2 * DBL_EPSILON)

static int is_horizontal(const double q[4])
{
    const double A = coin_priv_hypot(q[2] - q[3], q[0] + q[1]);
    const double B = coin_priv_hypot(q[2] + q[3], q[0] - q[1]);
    const double size2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    return coin_priv_size_in_range(size2) && A * B <= HORIZONTAL * size2;
}

/* The state of this motion; *s is the result.  What is flat is not checked. */
static int32_t state_of(coin_state *s, const coin_params *p, const double q[4],
                        const double omega[3], const double r[3])
{
    if (!is_horizontal(q))
        return coin_state_from_motion(s, p, q, omega, r[0], r[2]);
    lay_flat(s, q);
    const coin_priv_variables y = coin_priv_variables_of(s);
    double R[9];
    coin_priv_axes(&y, R);
    s->x = r[0];
    s->z = r[2];
    s->wX = omega[0] * R[0] + omega[1] * R[1] + omega[2] * R[2];
    s->wY = omega[0] * R[3] + omega[1] * R[4] + omega[2] * R[5];
    s->wZ = omega[0] * R[6] + omega[1] * R[7] + omega[2] * R[8];
    return COIN_OK;
}

int32_t coin_body_from_motion(coin_body *b, const coin_params *p,
                              const double q[4], const double omega[3],
                              const double r[3], const double v[3])
{
    coin_body made = {{0, 0, 0, 0, 0, 0, 0, 0}, 0, 0, 0, 0, {0, 0, 0, 0}};
    coin_priv_coin c;
    coin_priv_constants of;
    if (!b || !p || !q || !omega || !r || !v)
        return COIN_EARG;
    const int32_t status = state_of(&made.s, p, q, omega, r);
    if (status != COIN_OK)
        return status;
    const double a = p->radius;
    coin_priv_set_state(&c, &made.s, coin_priv_half_of(p));
    const double touching = a * coin_priv_height(&c);
    const double below = touching - r[1];
    made.y = below > 0 && below <= OVERLAP * a ? touching : r[1];
    made.vx = v[0];
    made.vy = v[1];
    made.vz = v[2];
    const int32_t good = coin_priv_check_coin_body(&c, &made, p, &of);
    if (good == COIN_OK)
        *b = made;
    return good;
}
