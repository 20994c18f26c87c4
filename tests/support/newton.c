/* SPDX-License-Identifier: MIT */
#include "newton.h"

#include <math.h>
#include <string.h>

/* Below this slip speed a slip has ended. */
#define STOPPED 1e-11

/* Where a slip begins, the coin rolls on for h/WAIT of the time in which the
 * motion changes.  The acceleration of the slip grows in proportion to the
 * time, so that a trapezoid gives the slip gained to the third order. */
#define WAIT 4

/* A step of a slip is RELAXED h of the time in which its direction relaxes, and
 * at most 1 of it: RK4 is stable up to 2.7. */
#define RELAXED 16

/* Below this cosine of the lean a coin is nearly flat. */
#define FLAT 0.3

/* A slip that begins very slowly takes more steps than this. */
#define MOST_STEPS 20000

typedef struct vector {
    double x, y, z;
} vector;

/* The axis, the angular momentum about the centre, the horizontal velocity and
 * place of the centre, and two angles that count turns. */
enum { AXIS, L = 3, VX = 6, VZ, PX, PZ, PHI, PSI, SIZE };

struct coin {
    double IX, IZ, mu_static, mu;
    double y[SIZE];
};

static vector plus(vector a, double by, vector b)
{
    return (vector){a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

static double dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                    a.x * b.y - a.y * b.x};
}

static vector at(const double *y)
{
    return (vector){y[0], y[1], y[2]};
}

static double speed(vector u)
{
    return hypot(u.x, u.z);
}

/* ------------------------------------------------------------------ motion */
/* What a force at the contact does. */
struct result {
    double d[SIZE];
    vector u, du; /* the slip velocity, and its slope */
    double off;   /* y'' of a rim that keeps to the table, less that by F */
    double cth;
};

/* The angular velocity is L over the inertias: I_Z along the axis k. */
static vector turned(const struct coin *c, vector k, vector momentum)
{
    const double along = (1 / c->IZ - 1 / c->IX) * dot(momentum, k);
    return plus((vector){along * k.x, along * k.y, along * k.z}, 1 / c->IX,
                momentum);
}

static struct result under(const struct coin *c, vector F)
{
    struct result r;
    const double *y = c->y;
    const vector k = at(y + AXIS), up = {0, 1, 0}, none = {0, 0, 0};
    const vector w = turned(c, k, at(y + L)), dk = cross(w, k);
    const double high = sqrt(k.x * k.x + k.z * k.z); /* of the centre */
    const double rise = -k.y * dk.y / high;
    /* From the centre to the lowest point of the rim: down, across the axis. */
    const vector lever = plus(none, -1 / high, plus(up, -k.y, k));
    const vector d_lever = plus(
        plus(plus(none, dk.y / high, k), k.y / high, dk), -rise / high, lever);
    const vector torque = cross(lever, F);
    /* The slope of w: that of turned(), whose k turns too. */
    const double along = (1 / c->IZ - 1 / c->IX);
    const vector dw =
        plus(plus(turned(c, k, torque), along * dot(at(y + L), dk), k),
             along * dot(at(y + L), k), dk);
    const vector ddk = plus(cross(dw, k), 1, cross(w, dk));
    r.cth = high;
    r.off = -(dk.y * dk.y + k.y * ddk.y + rise * rise) / high - (F.y - 1);
    r.u = plus((vector){y[VX], 0, y[VZ]}, 1, cross(w, lever));
    r.du = plus(plus((vector){F.x, 0, F.z}, 1, cross(dw, lever)), 1,
                cross(w, d_lever));
    const double turn = (k.z * dk.x - k.x * dk.z) / (high * high);
    const double d[SIZE] = {dk.x,     dk.y,     dk.z, torque.x,
                            torque.y, torque.z, F.x,  F.z,
                            y[VX],    y[VZ],    turn, dot(w, k) - turn * k.y};
    memcpy(r.d, d, sizeof d);
    return r;
}

/* The force that keeps the contact without slip: three linear equations, by
 * Cramer's rule. */
static vector sticking(const struct coin *c)
{
    const vector unit[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    vector row[4];
    for (int i = 0; i < 4; ++i) {
        const struct result r = under(c, unit[i]);
        row[i] = (vector){r.du.x, r.off, r.du.z};
    }
    for (int i = 1; i < 4; ++i)
        row[i] = plus(row[i], -1, row[0]);
    const double det = -dot(row[1], cross(row[2], row[3]));
    return (vector){dot(row[0], cross(row[2], row[3])) / det,
                    dot(row[1], cross(row[0], row[3])) / det,
                    dot(row[1], cross(row[2], row[0])) / det};
}

/* The force against a slip in direction n, which is horizontal. */
static vector sliding(const struct coin *c, vector n)
{
    const vector one = {-c->mu * n.x, 1, -c->mu * n.z}, none = {0, 0, 0};
    const double off = under(c, none).off;
    return plus(none, off / (off - under(c, one).off), one);
}

static vector direction(vector u)
{
    const double size = speed(u);
    return (vector){u.x / size, 0, u.z / size};
}

static struct result moves(const struct coin *c, int slips)
{
    const vector none = {0, 0, 0};
    return under(c,
                 slips ? sliding(c, direction(under(c, none).u)) : sticking(c));
}

static struct coin step(const struct coin *c, int slips, double h)
{
    static const double to[] = {0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
    struct coin end = *c, mid;
    struct result r = moves(c, slips);
    for (int k = 0;; ++k) {
        for (int i = 0; i < SIZE; ++i)
            end.y[i] += h / 6 * weight[k] * r.d[i];
        if (k == 3)
            return end;
        mid = *c;
        for (int i = 0; i < SIZE; ++i)
            mid.y[i] += h * to[k] * r.d[i];
        r = moves(&mid, slips);
    }
}

/* ------------------------------------------------------------------ events */
/* Above 0 as long as the mode lasts: mu N - F of a coin that rolls, N of one
 * that slips. */
static double left(const struct coin *c, int slips)
{
    const vector none = {0, 0, 0};
    if (slips)
        return sliding(c, direction(under(c, none).u)).y;
    const vector F = sticking(c);
    return c->mu_static * F.y - speed(F);
}

/* The step that ends where nothing is left; nothing is at h. */
static double bisected(const struct coin *c, int slips, double h)
{
    double low = 0, high = h;
    for (int i = 0; i < 60; ++i) {
        const double mid = (low + high) / 2;
        const struct coin end = step(c, slips, mid);
        *(left(&end, slips) < 0 ? &high : &low) = mid;
    }
    return high;
}

/* The time in which the motion changes. */
static double period(const struct coin *c)
{
    const vector k = at(c->y + AXIS), w = turned(c, k, at(c->y + L));
    const double high = hypot(k.x, k.z);
    return 1 / sqrt(dot(w, w) / (high * high) + 1 / high);
}

/* How a slip that begins would turn away from a direction, by its angle. */
static double turns_away(const struct coin *c, double angle)
{
    const vector n = {cos(angle), 0, sin(angle)};
    const vector du = under(c, sliding(c, n)).du;
    return du.x * n.z - du.z * n.x;
}

/* The direction in which a slip grows against its own friction: by secants,
 * from that against the force of sticking. */
static vector onset(const struct coin *c)
{
    const vector F = sticking(c);
    double a0 = atan2(-F.z, -F.x), a1 = a0 + 1e-3;
    double off0 = turns_away(c, a0), off1 = turns_away(c, a1);
    for (int i = 0; i < 30 && off1 != off0 && fabs(a1 - a0) > 1e-15; ++i) {
        const double a2 = a1 - off1 * (a1 - a0) / (off1 - off0);
        a0 = a1;
        off0 = off1;
        a1 = a2;
        off1 = turns_away(c, a1);
    }
    return (vector){cos(a1), 0, sin(a1)};
}

/* Adds to a coin half of what a slip, beginning at another, would change in a
 * time. */
static void push(struct coin *to, const struct coin *at, double time)
{
    const struct result rolls = moves(at, 0);
    const struct result slips = under(at, sliding(at, onset(at)));
    for (int i = 0; i < SIZE; ++i)
        to->y[i] += time / 2 * (slips.d[i] - rolls.d[i]);
}

/* Where the slip is 0: whether the coin rolls on, or a slip begins. */
static int begun(struct coin *c)
{
    if (left(c, 0) >= 0)
        return NEWTON_ROLLS;
    push(c, c, 2e-9);
    return left(c, 1) > 0 ? NEWTON_SLIPS : NEWTON_LIFTS;
}

/* ------------------------------------------------------------------- modes */
/* A coin that leaves the cone rolls on for a wait, and gains the slip of that
 * time, by trapezoids. */
static double leave(struct coin *c, double most, double used, double wait,
                    int *mode)
{
    const double when = bisected(c, 0, used);
    const struct coin from = step(c, 0, when);
    const double waits = fmin(most - when, wait);
    struct coin end = step(c, 0, when + waits);
    if (left(&end, 0) < 0) {
        const struct coin rolled = end;
        push(&end, &from, waits);
        push(&end, &rolled, waits);
        *mode = left(&end, 1) > 0 ? NEWTON_SLIPS : NEWTON_LIFTS;
    }
    *c = end;
    return when + waits;
}

/* A step of a coin that rolls; its length. */
static double roll(struct coin *c, double most, double h, int *mode)
{
    const double used = fmin(most, h * period(c));
    const struct coin end = step(c, 0, used);
    if (left(&end, 0) < 0)
        return leave(c, most, used, h / WAIT * period(c), mode);
    *c = end;
    return used;
}

/* A step of a coin that slips. */
static double slip(struct coin *c, double most, double h, int *mode)
{
    const struct result r = moves(c, 1);
    const double fast = fmax(speed(r.du), c->mu * (1 + 1 / c->IX));
    if (speed(r.u) < STOPPED && (left(c, 0) >= 0 || dot(r.u, r.du) < 0)) {
        *mode = begun(c);
        return 0;
    }
    double used = fmin(fmin(most, h * period(c)),
                       fmin(1, RELAXED * h) * speed(r.u) / fast);
    struct coin end = step(c, 1, used);
    if (left(&end, 1) < 0) {
        used = bisected(c, 1, used);
        end = step(c, 1, used);
        *mode = NEWTON_LIFTS;
    }
    *c = end;
    return used;
}

/* ------------------------------------------------------- slides, and theirs */
static struct coin coin_of(const coin_body *d, const coin_params *p,
                           const coin_table *f)
{
    const coin_state *s = &d->s;
    const double st = sin(s->theta), ct = cos(s->theta);
    const double sp = sin(s->phi), cp = cos(s->phi);
    const vector eX = {cp, 0, -sp}, eY = {st * sp, ct, st * cp},
                 eZ = {ct * sp, -st, ct * cp}, none = {0, 0, 0};
    const double IX = p->inertia_X, IZ = p->inertia_Z;
    const vector momentum =
        plus(plus(plus(none, IX * s->wX, eX), IX * s->wY, eY), IZ * s->wZ, eZ);
    const struct coin c = {IX,
                           IZ,
                           f->mu_static,
                           f->mu_kinetic,
                           {eZ.x, eZ.y, eZ.z, momentum.x, momentum.y,
                            momentum.z, d->vx, d->vz, s->x, s->z, s->phi,
                            s->psi}};
    return c;
}

static void slide_of(coin_body *d, const struct coin *c)
{
    const vector k = at(c->y + AXIS), w = turned(c, k, at(c->y + L));
    const double sp = sin(c->y[PHI]), cp = cos(c->y[PHI]);
    const double ct = hypot(k.x, k.z), theta = -atan2(k.y, ct);
    const vector eX = {cp, 0, -sp}, eY = {sin(theta) * sp, ct, sin(theta) * cp};
    d->s = (coin_state){theta,    c->y[PHI],  c->y[PSI],  c->y[PX],
                        c->y[PZ], dot(w, eX), dot(w, eY), dot(w, k)};
    d->vx = c->y[VX];
    d->vz = c->y[VZ];
}

int newton(coin_body *d, const coin_params *p, const coin_table *f, double t,
           double h, double *reached)
{
    struct coin c = coin_of(d, p, f);
    const vector none = {0, 0, 0};
    int mode = NEWTON_SLIPS;
    if (speed(under(&c, none).u) < STOPPED)
        mode = begun(&c);
    else if (!(left(&c, 1) > 0))
        mode = NEWTON_LIFTS;
    double rem = t;
    for (int i = 0; rem > 0 && mode <= NEWTON_SLIPS; ++i) {
        rem -= mode == NEWTON_ROLLS ? roll(&c, rem, h, &mode)
                                    : slip(&c, rem, h, &mode);
        if (under(&c, none).cth < FLAT)
            mode = NEWTON_FLAT;
        if (i == MOST_STEPS)
            mode = NEWTON_COSTLY;
    }
    slide_of(d, &c);
    *reached = t - rem;
    return mode;
}
