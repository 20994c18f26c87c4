/* SPDX-License-Identifier: MIT */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define HALF_PI 1.5707963267948966

uint8_t take_byte(struct bytes *b)
{
    return b->at < b->end ? *b->at++ : 0;
}

static double take_raw(struct bytes *b)
{
    uint64_t bits = 0;
    double x;
    for (int i = 0; i < 8; ++i)
        bits |= (uint64_t)take_byte(b) << (8 * i);
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Within +-1. */
double take_part(struct bytes *b)
{
    const uint8_t low = take_byte(b);
    return (double)(int8_t)take_byte(b) / 128 + (double)low / 32768;
}

double take_number(struct bytes *b)
{
    static const double special[] = {
        0,           NAN,     INFINITY, 0x1p-1074, DBL_MIN, DBL_MAX,
        DBL_EPSILON, HALF_PI, 0x1p31,   1e-300,    1e300,   1e-154,
        1e154,       1e-9,    1e9,      0.01,      1,       HALF_PI / 2,
    };
    enum { SPECIAL = sizeof special / sizeof *special };
    const uint8_t how = take_byte(b);
    const double sign = how & 1 ? -1 : 1;
    const double x = special[(how >> 2) % SPECIAL];
    switch (how >> 1 & 1 ? take_byte(b) & 7 : 0) {
    case 1:
        return sign * nextafter(x, INFINITY);
    case 2:
        return sign * nextafter(x, 0);
    case 3:
        return take_raw(b);
    case 4:
    case 5:
        return ldexp(take_part(b), (int8_t)take_byte(b) * 8);
    case 6:
    case 7:
        return 4 * take_part(b);
    default:
        return sign * x;
    }
}

/* Mostly the moderate one. */
double perhaps(struct bytes *b, double moderate)
{
    return take_byte(b) < 240 ? moderate : take_number(b);
}

/* Any ring, in units of any size. */
static coin_params take_ring(struct bytes *b, double M, double a, double g)
{
    const double inner = a * (take_byte(b) / 255.0);
    const double IX = M * (a * a + inner * inner) / 4;
    const coin_params p = {M, a, g, IX, 2 * IX, 0, {0, 0}};
    return p;
}

/* Up to 2^50: at the ends of the range, and beyond. */
static double take_scale(struct bytes *b)
{
    return ldexp(1.5 + 0.4 * take_part(b), (int8_t)take_byte(b) * 50 / 127);
}

static coin_params take_params(struct bytes *b)
{
    const uint8_t how = take_byte(b);
    coin_params p = take_ring(b, 1, 1, 1);
    if (how >= 96)
        p = take_ring(b, 0.00567, 0.01213, 9.80665);
    if (how >= 144)
        p = take_ring(b, take_scale(b), take_scale(b), take_scale(b));
    if (how >= 192)
        p.inertia_Z = p.inertia_X * (1 + take_part(b));
    if (how % 16 == 5)
        p.thickness = 4 * p.radius * fabs(take_part(b));
    double *const member[] = {
        &p.mass,      &p.radius,    &p.gravity,     &p.inertia_X,
        &p.inertia_Z, &p.thickness, &p.reserved[0], &p.reserved[1],
    };
    if (how >= 240)
        *member[take_byte(b) % 8] = take_number(b);
    return p;
}

/* Often near the table: to a last bit of pi/2. */
double take_lean(struct bytes *b)
{
    const uint8_t how = take_byte(b);
    const double part = take_part(b);
    const double side = part < 0 ? -1 : 1;
    if (how < 144)
        return 1.5 * part;
    if (how < 232)
        return side * (HALF_PI - ldexp(fabs(part), -(how % 54)));
    return take_number(b);
}

double take_rate(struct bytes *b, double unit)
{
    const uint8_t how = take_byte(b);
    const double part = take_part(b);
    if (how < 160)
        return 4 * unit * part;
    if (how < 232)
        return unit * ldexp(part, (how - 196) * 2);
    return take_number(b);
}

static coin_state take_state(struct bytes *b, const coin_params *p)
{
    const double unit = sqrt(p->gravity / p->radius);
    coin_state s;
    s.theta = take_lean(b);
    s.wX = take_rate(b, unit);
    s.wY = take_rate(b, unit);
    s.wZ = take_rate(b, unit);
    s.phi = perhaps(b, 8 * take_part(b));
    s.psi = perhaps(b, 8 * take_part(b));
    s.x = perhaps(b, p->radius * take_part(b));
    s.z = perhaps(b, p->radius * take_part(b));
    return s;
}

struct world take_world(struct bytes *b)
{
    struct world w;
    w.p = take_params(b);
    w.s = take_state(b, &w.p);
    const double cth = cos(w.s.theta), wX = w.s.wX, wY = w.s.wY, wZ = w.s.wZ;
    w.W = sqrt((wX * wX + wY * wY) / (cth * cth) + wZ * wZ +
               w.p.gravity / w.p.radius);
    return w;
}
