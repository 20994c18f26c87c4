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

#include "animated.h"
#include "turning.h"

/* Mass, radius and gravity are 1.  A quarter's unit of time: sqrt(a/g). */
#define SECONDS_PER_UNIT sqrt(0.01213 / 9.80665)

#define LEAN 0.6   /* the largest [rad] */
#define SLOWER 6.0 /* than a real coin */

enum { SWINGS = 7, TURNS = 3, ROLLS = 8 };
enum { KEYS = 140, PIECES = 70, STILLS = 5 };
enum { LEFT = 556, RIGHT = 776, TOP = 80, BOTTOM = 280 }; /* of the graph */
enum { LEAN_AXIS = 40 };                                  /* its range [deg] */

enum {
    DRAWN = OWN, /* the part of the path, < 0 */
    HEIGHT       /* of the dot in the graph */
};

static coin_params disc;
static coin_orbit orbit;
static coin_state state[KEYS + 1];
static double path[KEYS + 1][4]; /* of the contact: x, y, their rates per key */

static const camera CAMERA = {0.62, 0.7846, 15, {0, 0.2, 0}, {258, 190}, 63};

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

    view = CAMERA;
    keys = KEYS;
    seconds =
        floor(100 * orbit.period * SWINGS * SECONDS_PER_UNIT * SLOWER + 0.5) /
        100;
    for (int k = 0; k <= KEYS; ++k) {
        double m[16], r[3], v[3], *now = key[k];
        const double *last = key[k > 0 ? k - 1 : 0];
        coin_state *s = &state[k];
        demand(coin_orbit_at(&orbit, k * dt, s));
        s->x -= orbit.center[0];
        s->z -= orbit.center[1];
        demand(coin_matrix(s, &disc, m));
        coin_at(now, last, m);
        shadow_at(now, last, m);
        demand(coin_contact(s, &disc, r, v));
        camera_point(&view, r, v, path[k], path[k] + 2);
        path[k][2] *= dt;
        path[k][3] *= dt;
        now[DRAWN] = k > 0 ? last[DRAWN] - piece_length(k) : 0;
        now[HEIGHT] = graph_y(s->theta * DEGREES);
    }
    const double whole = -key[KEYS][DRAWN];
    for (int k = 0; k <= KEYS; ++k)
        key[k][DRAWN] /= whole;
}

#endif
