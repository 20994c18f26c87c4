/* SPDX-License-Identifier: MIT */
/* Between an engine with z up and the library: docs/games.md. */
#ifndef ENGINE_H
#define ENGINE_H

#include <coin.h>

/* What an engine's rigid body holds. */
struct rigid_body {
    double position[3], q[4], v[3], omega[3];
};

/* The engine's (x, y, z) is (x, z, -y) here. */
static void from_z_up(double v[3])
{
    const double y = v[1];
    v[1] = v[2];
    v[2] = -y;
}

/* The same turn, before that of the body.  Any norm will do. */
static void turn_from_z_up(double q[4])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    q[0] = w + x;
    q[1] = x - w;
    q[2] = y + z;
    q[3] = z - y;
}

/* The body of an engine's coin: from here the library moves it. */
static int32_t from_engine(coin_body *b, const coin_params *p,
                           struct rigid_body e)
{
    from_z_up(e.position);
    from_z_up(e.v);
    from_z_up(e.omega);
    turn_from_z_up(e.q);
    return coin_body_from_motion(b, p, e.q, e.omega, e.position, e.v);
}

/* And back: (x, y, z) becomes (x, -z, y). */
static void to_z_up(double m[16])
{
    for (int column = 0; column < 4; ++column) {
        const double y = m[4 * column + 1], z = m[4 * column + 2];
        m[4 * column + 1] = -z;
        m[4 * column + 2] = y;
    }
}

/* The matrix as a shader takes it. */
static int32_t draw(const coin_body *b, const coin_params *p, float out[16])
{
    double m[16];
    const int32_t status = coin_body_matrix(b, p, m);
    if (status != COIN_OK)
        return status;
    to_z_up(m);
    for (int i = 0; i < 16; ++i)
        out[i] = (float)m[i];
    return COIN_OK;
}

#endif
