/* SPDX-License-Identifier: MIT */
/* animation.h: a rosette that closes, and how a coin that rolls it looks at
 * every key of an animation.
 *
 * While its lean swings SWINGS times, the coin turns TURNS times about the
 * vertical, rolls ROLLS times about its axis, and is where it was.  The rates
 * that do this are found from the orbit, which also gives the state at every
 * key. */
#ifndef EXAMPLE_ANIMATION_H
#define EXAMPLE_ANIMATION_H

#include "camera.h"
#include "turning.h"

#include <stddef.h>

#define PI 3.14159265358979323846
#define DEGREES (180 / PI)

/* Mass, radius and gravity are 1.  A quarter's unit of time: sqrt(a/g). */
#define SECONDS_PER_UNIT sqrt(0.01213 / 9.80665)

#define LEAN 0.6       /* the largest [rad] */
#define THICKNESS 0.13 /* of the coin, in radii; the model has none */
#define SLOWER 6.0     /* than a real coin */

enum { SWINGS = 7, TURNS = 3, ROLLS = 8 };
enum { KEYS = 140, PIECES = 70, STILLS = 5 };
enum { LEFT = 556, RIGHT = 776, TOP = 80, BOTTOM = 280 }; /* of the graph */
enum { LEAN_AXIS = 40 };                                  /* its range [deg] */

/* What moves, at a key: angles in degrees, X, Y, SIZE, HEIGHT and the shadow in
 * pixels, lengths on the coin in half axes of its circle (SIZE). */
/* clang-format off */
enum {
    X, Y, SIZE, TILT,                /* the coin's circle: an ellipse */
    MINOR,                           /* its short half axis, < 0 from behind */
    FRONT, BACK,                     /* where its faces are along that axis */
    RIM_TOP, RIM_HEIGHT, RIM_ROUND,  /* its outline: a rectangle, rounded */
    ROLL,                            /* of what is on its faces */
    SHADE_FRONT, SHADE_BACK,         /* the light that they lack */
    SHADOW_X, SHADOW_Y, SHADOW_TILT, SHADOW_A, SHADOW_B,
    DRAWN,                           /* the part of the path, < 0 */
    HEIGHT,                          /* of the dot in the graph */
    MEMBERS
};
/* clang-format on */

static coin_params disc;
static coin_orbit orbit;
static coin_state state[KEYS + 1];
static double key[KEYS + 1][MEMBERS];
static double path[KEYS + 1][4]; /* of the contact: x, y, their rates per key */

static const camera CAMERA = {0.62, 0.7846, 15, {0, 0.2, 0}, {258, 190}, 63};
static const double LIGHT[3] = {-0.42, 0.85, 0.32}; /* where it comes from */

/* --------------------------------------------------------------- motion -- */

/* How far the orbit from these rates is from turning and rolling as asked. */
static void miss(double wY, double wZ, double by[2])
{
    const coin_state s = {LEAN, 0, 0, 0, 0, 0, wY, wZ};

    demand(coin_orbit_init(&orbit, &s, &disc));
    by[0] = orbit.heading_per_period - 2 * PI * TURNS / SWINGS;
    by[1] = orbit.roll_per_period - 2 * PI * ROLLS / SWINGS;
}

/* Newton's method, with slopes from differences. */
static void find_orbit(void)
{
    const double small = 1e-7;
    double wY = 0.72, wZ = 0.71, f[2], fY[2], fZ[2];

    for (int k = 0; k < 8; ++k) {
        miss(wY + small, wZ, fY);
        miss(wY, wZ + small, fZ);
        miss(wY, wZ, f);
        const double a = (fY[0] - f[0]) / small, b = (fZ[0] - f[0]) / small;
        const double c = (fY[1] - f[1]) / small, d = (fZ[1] - f[1]) / small;
        wY -= (d * f[0] - b * f[1]) / (a * d - b * c);
        wZ -= (a * f[1] - c * f[0]) / (a * d - b * c);
    }
    miss(wY, wZ, f);
}

/* The friction coefficient that a real coin needs. */
static double friction(void)
{
    double needed = 0;

    for (int k = 0; k <= KEYS; ++k) {
        coin_force force;
        demand(coin_reaction(&state[k], &disc, &force));
        needed = fmax(needed, force.ratio);
    }
    return needed;
}

/* ----------------------------------------------------------------- keys -- */

/* The angle nearest to another, of those that differ by whole turns. */
static double continued(double angle, double near)
{
    return angle + 2 * PI * floor((near - angle) / (2 * PI) + 0.5);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How far the coin has rolled, as an angle of its ellipse. */
static void roll_at(double *now, const double last[], const double r[3],
                    const coin_state *s, const double R[9])
{
    double rim[3], at[2];

    for (int i = 0; i < 3; ++i)
        rim[i] = r[i] + cos(s->psi) * R[i] + sin(s->psi) * R[3 + i];
    camera_point(&CAMERA, rim, NULL, at, NULL);
    const double dx = at[0] - now[X], dy = at[1] - now[Y];
    const double cos_t = cos(now[TILT]), sin_t = sin(now[TILT]);
    now[ROLL] = continued(
        atan2((cos_t * dy - sin_t * dx) / now[MINOR], cos_t * dx + sin_t * dy),
        last[ROLL]);
}

/* The faces stand off the circle by half the thickness.  (A camera sees that
 * along the short axis, nearly.) */
static void coin_at(double *now, const double last[], const coin_state *s)
{
    double r[3], R[9], at[2], out[2], eye[3];

    demand(coin_center(s, &disc, r));
    demand(coin_axes(s, R));
    const ellipse e = camera_circle(&CAMERA, r, R, R + 3, last[TILT]);
    camera_point(&CAMERA, r, R + 6, at, out);
    for (int i = 0; i < 3; ++i)
        eye[i] = CAMERA.target[i] - r[i];
    eye[1] += CAMERA.distance * CAMERA.sth;
    eye[2] += CAMERA.distance * CAMERA.cth;
    now[X] = e.x;
    now[Y] = e.y;
    now[SIZE] = e.major;
    now[TILT] = e.tilt;
    now[MINOR] = copysign(e.minor / e.major, dot(R + 6, eye));
    now[FRONT] =
        THICKNESS / 2 / e.major * (cos(e.tilt) * out[1] - sin(e.tilt) * out[0]);
    now[BACK] = -now[FRONT];
    now[RIM_TOP] = -fabs(now[FRONT]) - fabs(now[MINOR]);
    now[RIM_HEIGHT] = -2 * now[RIM_TOP];
    now[RIM_ROUND] = fabs(now[MINOR]);
    now[SHADE_FRONT] = 0.22 - 0.22 * dot(R + 6, LIGHT);
    now[SHADE_BACK] = 0.22 + 0.22 * dot(R + 6, LIGHT);
    roll_at(now, last, r, s, R);
}

/* The shadow of a point or of a direction. */
static void cast(const double r[3], double on[3])
{
    on[0] = r[0] - r[1] * LIGHT[0] / LIGHT[1];
    on[1] = 0;
    on[2] = r[2] - r[1] * LIGHT[2] / LIGHT[1];
}

static void shadow_at(double *now, const double last[], const coin_state *s)
{
    double r[3], R[9], at[3], u[3], v[3];

    demand(coin_center(s, &disc, r));
    demand(coin_axes(s, R));
    cast(r, at);
    cast(R, u);
    cast(R + 3, v);
    const ellipse e = camera_circle(&CAMERA, at, u, v, last[SHADOW_TILT]);
    now[SHADOW_X] = e.x;
    now[SHADOW_Y] = e.y;
    now[SHADOW_TILT] = e.tilt;
    now[SHADOW_A] = e.major;
    now[SHADOW_B] = fmax(e.minor, THICKNESS / 2 * e.major);
}

/* A piece of a cubic from key k - 1 to k: its length, by chords. */
static double piece_length(int k)
{
    enum { CHORDS = 64 };
    const double *a = path[k - 1], *b = path[k];
    double length = 0, x = a[0], y = a[1];

    for (int i = 1; i <= CHORDS; ++i) {
        const double t = (double)i / CHORDS, s = 1 - t;
        double at[2];
        for (int j = 0; j < 2; ++j)
            at[j] = s * s * (1 + 2 * t) * a[j] + t * t * (3 - 2 * t) * b[j] +
                    s * t * (s * a[j + 2] - t * b[j + 2]);
        length += hypot(at[0] - x, at[1] - y);
        x = at[0], y = at[1];
    }
    return length;
}

/* A height in the graph of the lean [degrees]. */
static double graph_y(double lean)
{
    return BOTTOM - (BOTTOM - TOP) * lean / LEAN_AXIS;
}

static void set_keys(void)
{
    const double dt = orbit.period * SWINGS / KEYS;

    for (int k = 0; k <= KEYS; ++k) {
        double r[3], v[3], *now = key[k];
        const double *last = key[k > 0 ? k - 1 : 0];
        coin_state *s = &state[k];
        demand(coin_orbit_at(&orbit, k * dt, s));
        s->x -= orbit.center[0];
        s->z -= orbit.center[1];
        coin_at(now, last, s);
        shadow_at(now, last, s);
        demand(coin_contact(s, &disc, r, v));
        camera_point(&CAMERA, r, v, path[k], path[k] + 2);
        path[k][2] *= dt;
        path[k][3] *= dt;
        now[DRAWN] = k > 0 ? last[DRAWN] - piece_length(k) : 0;
        now[HEIGHT] = graph_y(s->theta * DEGREES);
    }
    const double whole = -key[KEYS][DRAWN];
    for (int k = 0; k <= KEYS; ++k) {
        key[k][DRAWN] /= whole;
        key[k][TILT] *= DEGREES;
        key[k][ROLL] *= DEGREES;
        key[k][SHADOW_TILT] *= DEGREES;
    }
}

#endif
