/* SPDX-License-Identifier: MIT */
/* A coin_body: its checks, and what can be read off it. */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "coin_body.h"
#include "flat_slide.h"

/* A body that an engine set this many radii into the table is set on it. */
#define OVERLAP 0.1

void coin_priv_set_rolling(coin_body *b, const coin_priv_attitude *at, double a)
{
    const coin_priv_variables y = coin_priv_attitude_variables(&b->s, at);
    double v[3];
    coin_priv_velocity_of(v, a, &y);
    b->y = a * at->th.c;
    b->vx = v[0];
    b->vy = v[1];
    b->vz = v[2];
}

int coin_priv_members_hold(const coin_body *b, double length, double rate)
{
    const double far = COIN_PRIV_PLACE_MAX * length;
    const double turn = COIN_PRIV_RATE_MAX * rate, fast = turn * length;
    return coin_priv_state_within(&b->s, far, turn * turn) &
           (fabs(b->y) <= far) & (fabs(b->vx) <= fast) & (fabs(b->vy) <= fast) &
           (fabs(b->vz) <= fast);
}

void coin_priv_scale_body(coin_body *b, double length, double rate)
{
    coin_priv_scale(&b->s, length, rate);
    b->y *= length;
    b->vx *= length * rate;
    b->vy *= length * rate;
    b->vz *= length * rate;
}

int32_t coin_priv_natural_body(coin_body *natural, coin_priv_attitude *at,
                               const coin_body *b, const coin_priv_body *of)
{
    const double w0 = sqrt(of->g_a);
    if (!coin_priv_members_hold(b, of->a, w0) ||
        !coin_priv_are_zero(b->reserved, 4))
        return COIN_ESTATE;
    *natural = *b;
    coin_priv_scale_body(natural, 1 / of->a, 1 / w0);
    *at = coin_priv_attitude_of(&b->s);
    return natural->y - at->th.c >= -COIN_PRIV_TOUCHES ? COIN_OK : COIN_ESTATE;
}

static int lies_flat(const coin_body *b)
{
    return fabs(b->s.theta) >= COIN_PRIV_LAST_LEAN && b->s.wX == 0 &&
           b->s.wY == 0;
}

int coin_priv_body_mode(const coin_body *b, const coin_priv_attitude *at,
                        double u[2])
{
    u[0] = u[1] = 0;
    if (b->y - at->th.c > COIN_PRIV_TOUCHES)
        return COIN_PRIV_AIR;
    const coin_priv_rim rim = coin_priv_rim_of(b, at);
    const double turn = fabs(b->s.wZ), turns = fabs(b->s.wX) + turn;
    if (fabs(rim.y) > COIN_PRIV_SLIP_LEAST)
        return COIN_PRIV_AIR;
    if (lies_flat(b)) {
        const double v = sqrt(b->vx * b->vx + b->vz * b->vz);
        return v + turn <= COIN_PRIV_SLIP_LEAST ? COIN_PRIV_RESTS
                                                : COIN_PRIV_LIES;
    }
    if (sqrt(rim.X * rim.X + rim.h * rim.h) <=
        COIN_PRIV_SLIP_LEAST + COIN_PRIV_TOUCHES * turns)
        return 0;
    u[0] = rim.X;
    u[1] = rim.h;
    return COIN_PRIV_SLIPS;
}

/* The checks of a body, in natural units if they pass: COIN_OK, *of and the
 * attitude; or COIN_EARG, COIN_EPARAMS, COIN_ESTATE in this order. */
static int32_t check(coin_body *natural, coin_priv_attitude *at,
                     const coin_body *b, const coin_params *p,
                     coin_priv_body *of)
{
    if (!b || !p)
        return COIN_EARG;
    if (coin_priv_check_body(of, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_natural_body(natural, at, b, of);
}

int32_t coin_body_from_state(coin_body *b, const coin_state *s,
                             const coin_params *p)
{
    coin_priv_body of;
    const int32_t status = b ? coin_priv_check(s, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    coin_body made = {*s, 0, 0, 0, 0, {0, 0, 0, 0}}, natural;
    coin_priv_attitude at = coin_priv_attitude_of(s);
    coin_priv_set_rolling(&made, &at, of.a);
    const int32_t good = coin_priv_natural_body(&natural, &at, &made, &of);
    if (good == COIN_OK)
        *b = made;
    return good;
}

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
    return coin_priv_is_ordinary(size2) && A * B <= HORIZONTAL * size2;
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
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    if (!b || !p || !q || !omega || !r || !v)
        return COIN_EARG;
    const int32_t status = state_of(&made.s, p, q, omega, r);
    if (status != COIN_OK)
        return status;
    const double a = p->radius;
    const double touching = a * coin_priv_sincos(made.s.theta).c;
    const double below = touching - r[1];
    made.y = below > 0 && below <= OVERLAP * a ? touching : r[1];
    made.vx = v[0];
    made.vy = v[1];
    made.vz = v[2];
    const int32_t good = check(&natural, &at, &made, p, &of);
    if (good == COIN_OK)
        *b = made;
    return good;
}

double coin_body_energy(const coin_body *b, const coin_params *p)
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    if (check(&natural, &at, b, p, &of) != COIN_OK)
        return (double)NAN;
    const coin_state *s = &b->s;
    const double v2 = b->vx * b->vx + b->vy * b->vy + b->vz * b->vz;
    const double turn =
        of.IX * (s->wX * s->wX + s->wY * s->wY) + of.IZ * s->wZ * s->wZ;
    return (of.M * v2 + turn) / 2 + of.Mg * b->y; /* (88) */
}

int32_t coin_body_slip(const coin_body *b, const coin_params *p, double u[2])
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    const int32_t status = u ? check(&natural, &at, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const int lies = lies_flat(b);
    const double uX = of.a * b->s.wZ, uh = -of.a * (b->s.wX * at.th.c);
    u[0] = b->vx + (lies ? 0 : uX * at.ph.c + uh * at.ph.s);
    u[1] = b->vz + (lies ? 0 : uh * at.ph.c - uX * at.ph.s);
    return COIN_OK;
}

int32_t coin_body_matrix(const coin_body *b, const coin_params *p, double m[16])
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    const int32_t status = m ? check(&natural, &at, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double y = b->y;
    (void)coin_matrix(&b->s, p, m);
    m[13] = y;
    return COIN_OK;
}

/* The force on a coin that touches the table, in natural units. */
static coin_priv_push touching_force(const coin_body *b,
                                     const coin_priv_attitude *at,
                                     const coin_priv_law *l, int mode,
                                     const double u[2])
{
    coin_priv_moving g;
    g.law = *l;
    const coin_priv_variables v = coin_priv_attitude_variables(&b->s, at);
    coin_priv_begin(&g, &b->s, &v, 0, 1);
    g.step.y[COIN_PRIV_UX] = u[0];
    g.step.y[COIN_PRIV_UH] = u[1];
    g.mode = mode;
    const int next = coin_priv_next_mode(&g);
    const coin_priv_push none = {0, 0, 0};
    if (next & COIN_PRIV_AIR)
        return none;
    coin_priv_push F =
        coin_priv_push_of(g.step.y, l, mode | (next & COIN_PRIV_IDLE));
    if (next & ~mode & COIN_PRIV_SLIPS) {
        const coin_priv_direction n = coin_priv_onset(g.step.y, l, 0, F);
        F = coin_priv_slopes(0, g.step.y, l, COIN_PRIV_SLIPS, n);
    }
    const coin_priv_push r = {F.N / g.step.y[COIN_PRIV_C],
                              F.X / g.step.y[COIN_PRIV_C],
                              F.h / g.step.y[COIN_PRIV_C]};
    return r;
}

/* The force on a coin that slides on its face, in natural units. */
static coin_priv_push sliding_force(const coin_body *b, coin_priv_sc ph,
                                    const coin_priv_law *l)
{
    const double v = sqrt(b->vx * b->vx + b->vz * b->vz);
    const double drag = coin_priv_flat_drag(l->IZ, v, fabs(b->s.wZ));
    const double per = v > 0 ? l->mu_kinetic * drag / v : 0;
    const coin_priv_push r = {
        1,
        -per * (b->vx * ph.c - b->vz * ph.s),
        -per * (b->vx * ph.s + b->vz * ph.c),
    };
    return r;
}

int32_t coin_body_reaction(const coin_body *b, const coin_params *p,
                           const coin_table *table, coin_force *out)
{
    coin_priv_body of;
    coin_priv_law law;
    double u[2];
    if (!b || !p || !table || !out)
        return COIN_EARG;
    if (coin_priv_check_body(&of, p) != COIN_OK ||
        coin_priv_table_law(&law, table, &of) != COIN_OK)
        return COIN_EPARAMS;
    coin_body natural;
    coin_priv_attitude at;
    const int32_t status = coin_priv_natural_body(&natural, &at, b, &of);
    if (status != COIN_OK)
        return status;
    const int mode = coin_priv_body_mode(&natural, &at, u);
    coin_priv_push F = {0, 0, 0};
    if (mode == COIN_PRIV_RESTS)
        F.N = 1;
    else if (mode == COIN_PRIV_LIES)
        F = sliding_force(&natural, at.ph, &law);
    else if (mode != COIN_PRIV_AIR)
        F = touching_force(&natural, &at, &law, mode, u);
    const coin_priv_sc ph = at.ph;
    coin_force r;
    r.R[0] = of.Mg * (F.X * ph.c + F.h * ph.s);
    r.R[1] = r.normal = of.Mg * F.N;
    r.R[2] = of.Mg * (F.h * ph.c - F.X * ph.s);
    r.friction = of.Mg * sqrt(F.X * F.X + F.h * F.h);
    r.ratio = r.normal > 0 ? r.friction / r.normal : (double)INFINITY;
    *out = r;
    return COIN_OK;
}
