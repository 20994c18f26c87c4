/* SPDX-License-Identifier: MIT */
/* What arguments are: how bytes become one, and what an output has to be. */
#include "fuzz.h"

#include <math.h>
#include <string.h>

int finite_all(const double *x, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

/* ------------------------------------------------------------- taking each */
static void take_p(struct bytes *b, const struct world *w, void *to)
{
    (void)b;
    memcpy(to, &w->p, sizeof w->p);
}

static void take_s(struct bytes *b, const struct world *w, void *to)
{
    (void)b;
    memcpy(to, &w->s, sizeof w->s);
}

/* A state like that of the world, or a little beside it. */
static void take_k(struct bytes *b, const struct world *w, void *to)
{
    coin_state s = w->s;
    const double part = take_part(b) * ldexp(1, -(take_byte(b) % 32));
    s.theta += part;
    s.wX += take_rate(b, w->W) * part;
    s.wZ += w->W * part;
    memcpy(to, &s, sizeof s);
}

/* A coin that spins, about a diameter that leans. */
static void take_spin(struct bytes *b, const struct world *w, void *to)
{
    coin_state s = w->s;
    (void)coin_steady_spin(&s, &w->p, take_lean(b));
    memcpy(to, &s, sizeof s);
}

/* Several, of which the first is the world's own. */
static void take_coins(struct bytes *b, const struct world *w, void *to)
{
    coin_state *const coins = to;
    take_s(b, w, coins);
    for (int k = 1; k < SAMPLES; ++k)
        take_k(b, w, coins + k);
}

static void take_numbers(struct bytes *b, double *x, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        x[i] = perhaps(b, 2 * take_part(b));
}

static void take_q(struct bytes *b, const struct world *w, void *to)
{
    (void)w;
    take_numbers(b, to, 4);
}

static void take_omega(struct bytes *b, const struct world *w, void *to)
{
    double *const omega = to;
    for (int i = 0; i < 3; ++i)
        omega[i] = take_rate(b, w->W);
}

/* Good ones, of up to the size of the coin's own torques; half of them none. */
static void take_losses(struct bytes *b, const struct world *w, void *to)
{
    const double w0 = sqrt(w->p.gravity / w->p.radius);
    const double torque = w->p.mass * w->p.gravity * w->p.radius;
    const double unit[] = {
        1,           torque, torque / w0, torque / (w0 * sqrt(w0)),
        torque / w0, torque, torque / w0, w0,
        w0};
    double x[12] = {0};
    for (int i = 0; i < 9; ++i) {
        const uint8_t how = take_byte(b);
        x[i] = how < 128 ? 0 : ldexp(fabs(take_part(b)), -(how % 40)) * unit[i];
    }
    x[9] = take_byte(b) < 128 ? 0 : ldexp(1, -7 - take_byte(b) % 33); /* flat */
    memcpy(to, x, sizeof x);
    if (coin_losses_check(to, &w->p) != COIN_OK)
        memset(to, 0, sizeof x);
}

/* Lies on either face, and slides or turns. */
static void lay_down(coin_body *d, const struct world *w)
{
    d->s.theta = copysign(nextafter(asin(1), 0), d->s.theta);
    d->s.wX = d->s.wY = d->vy = 0;
    d->y = w->p.radius * cos(d->s.theta);
}

/* Rolls, slips, lies flat, or flies up to a hundred radii high; now and then it
 * is none. */
static void take_body(struct bytes *b, const struct world *w, void *to)
{
    const double v = sqrt(w->p.gravity * w->p.radius);
    const uint8_t how = take_byte(b);
    coin_body d = {w->s, 0, 0, 0, 0, {0, 0, 0, 0}};
    if (coin_body_from_state(&d, &w->s, &w->p) == COIN_OK && how % 2) {
        d.vx += perhaps(b, v * take_part(b));
        d.vz += perhaps(b, v * take_part(b));
    }
    if (how % 16 >= 10) {
        d.y += ldexp(fabs(take_part(b)), 7 - take_byte(b) % 32) * w->p.radius;
        d.vy = take_rate(b, v);
    }
    if (how % 16 == 5)
        d.vy += perhaps(b, v * take_part(b));
    if (how % 16 == 7)
        lay_down(&d, w);
    if (how % 64 == 9)
        d.reserved[how / 64] = take_number(b);
    memcpy(to, &d, sizeof d);
}

static void take_table(struct bytes *b, const struct world *w, void *to)
{
    const double kinetic = fabs(take_part(b));
    const uint8_t how = take_byte(b);
    const double over[] = {1, 1.05, 1.5, INFINITY};
    coin_table f = {
        0, 0, 0, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0, 0}}};
    f.mu_kinetic = kinetic;
    f.mu_static = how % 4 == 3 ? INFINITY : kinetic * over[how % 4];
    f.restitution = perhaps(b, fabs(take_part(b)));
    if (how & 4)
        take_losses(b, w, &f.losses);
    if (how & 8)
        f.losses.damping = 0;
    memcpy(to, &f, sizeof f);
}

static void take_r(struct bytes *b, const struct world *w, void *to)
{
    double *const r = to;
    for (int i = 0; i < 3; ++i)
        r[i] = w->p.radius * (i == 1) + perhaps(b, w->p.radius * take_part(b));
}

static void take_d(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    (void)w;
    a->d = take_number(b);
}

static void take_angle(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    (void)w;
    a->d = take_lean(b);
}

static void take_omega_Z(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    a->d = take_rate(b, sqrt(w->p.gravity / w->p.radius));
}

/* From a thousandth of the coin's radius to a hundred radii. */
static void take_length(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const double part = ldexp(take_part(b), 7 - take_byte(b) % 18);
    a->d = perhaps(b, w->p.radius * part);
}

static void take_speed(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    take_omega_Z(b, w, to);
    a->d *= w->p.radius;
}

/* A step, from far too short to far too long for this state. */
static void take_dt(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const uint8_t how = take_byte(b);
    const double part = take_part(b);
    a->d = how < 232 ? ldexp(part, 2 - how % 24) / w->W : take_number(b);
}

/* A time: up to a few tens of such steps, or so long that it is refused; what
 * lies between would be moved, for hours. */
static void take_time(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    take_dt(b, w, to);
    const double units = fabs(a->d) * sqrt(w->p.gravity / w->p.radius);
    if (fabs(a->d) * w->W <= 4)
        a->d *= 8;
    else if (units <= 1e15)
        a->d = copysign(32 / w->W, a->d);
}

static void take_tol(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const uint8_t how = take_byte(b);
    (void)w;
    a->d = how < 240 ? ldexp(1, -(7 + how % 37)) : take_number(b);
}

/* The world's orbit, or that of a rolling coin if it has none; now and then
 * with another number before the pieces. */
static void take_orbit(struct bytes *b, const struct world *w, void *to)
{
    const coin_params p = {1, 1, 1, 0.25, 0.5, {0, 0, 0}};
    const coin_state s = {0.1, 0, 0, 0, 0, 0, 0, 1};
    if (coin_orbit_init(to, &w->s, &w->p) != COIN_OK)
        demand(coin_orbit_init(to, &s, &p) == COIN_OK);
    const size_t which = take_byte(b);
    const double any = take_number(b);
    if (which >= 192)
        memcpy((char *)to + (which - 192) * sizeof any, &any, sizeof any);
}

/* Methods, branches: near 0, or anything. */
static void take_i(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const uint8_t how = take_byte(b);
    (void)w;
    if (how < 224)
        a->i = how % 4;
    else if (how < 248)
        a->i = how % 8 - 2;
    else
        a->i = (int32_t)(0x01010101u * take_byte(b));
}

/* Bits of stop, or anything. */
#define STOP_BITS                                                              \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES)

static void take_bits(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const uint8_t how = take_byte(b);
    (void)w;
    a->i = how < 224 ? how & STOP_BITS : (int32_t)(0x01010101u * take_byte(b));
}

static void take_branch(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    take_i(b, w, to);
    a->i = a->i >= 0 && a->i < 4 ? a->i % 2 * 2 - 1 : a->i;
}

/* Few, or so many that sums are settled on the way. */
static void take_u(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    const uint8_t how = take_byte(b);
    (void)w;
    a->u = how < 224 ? how % 4 : 30 + how % 40;
}

static void take_count(struct bytes *b, const struct world *w, void *to)
{
    union argument *const a = to;
    (void)w;
    a->u = take_byte(b) % (SAMPLES + 1);
}

/* The name of a type, or nearly one. */
static void take_text(struct bytes *b, const struct world *w, void *to)
{
    char *const text = to;
    (void)w;
    memcpy(text, "coinf_params\0\0\0", 16);
    if (take_byte(b) % 2)
        memcpy(text, "coin_losses\0\0\0\0", 16);
    if (take_byte(b) % 4 == 0)
        text[take_byte(b) % 15] = (char)take_byte(b);
}

/* ------------------------------------------------------- what is an output */
static int sound_params(const void *of, const struct world *w)
{
    (void)w;
    return coin_params_check(of) == COIN_OK;
}

static int sound_state(const void *of, const struct world *w)
{
    return coin_state_check(of, &w->p) == COIN_OK;
}

static int sound_8(const void *of, const struct world *w)
{
    (void)w;
    return finite_all(of, 8);
}

static int sound_force(const void *of, const struct world *w)
{
    const coin_force *f = of;
    (void)w;
    return finite_all(f->R, 3) && f->normal == f->R[1] && f->friction >= 0 &&
           isfinite(f->friction) &&
           (f->normal > 0 ? f->ratio >= 0 : f->ratio == (double)INFINITY);
}

#define SOUND(count)                                                           \
    static int sound_##count(const void *of, const struct world *w)            \
    {                                                                          \
        (void)w;                                                               \
        return finite_all(of, count);                                          \
    }
SOUND(1)
SOUND(2)
SOUND(3)
SOUND(4)
SOUND(9)
SOUND(16)

static int sound_radius(const void *of, const struct world *w)
{
    const double *r = of;
    (void)w;
    return *r >= 0;
}

/* Of an orbit's own coin, which need not be the world's. */
static int sound_members(const void *of, const struct world *w)
{
    double R[9];
    (void)w;
    return coin_axes(of, R) == COIN_OK;
}

static int sound_losses(const void *of, const struct world *w)
{
    return coin_losses_check(of, &w->p) == COIN_OK;
}

static int sound_body(const void *of, const struct world *w)
{
    double u[2];
    return coin_body_slip(of, &w->p, u) == COIN_OK;
}

static int sound_orbit(const void *of, const struct world *w)
{
    const coin_orbit *o = of;
    (void)w;
    return finite_all(&o->period, 5) && finite_all(o->drift, 2) &&
           o->period >= 0 && o->theta_min <= o->theta_max &&
           !(o->radius_min > o->radius_max) && o->conditioning >= 1;
}

static const struct kind kinds[] = {
    {'p', READ, sizeof(coin_params), take_p, NULL},
    {'P', WRITTEN, sizeof(coin_params), NULL, sound_params},
    {'s', READ, sizeof(coin_state), take_s, NULL},
    {'E', READ, sizeof(coin_state), take_spin, NULL},
    {'S', MOVED, sizeof(coin_state), take_s, sound_state},
    {'X', MOVED, SAMPLES * sizeof(coin_state), take_coins, NULL},
    {'O', WRITTEN, sizeof(coin_state), NULL, sound_state},
    {'R', WRITTEN, sizeof(coin_state), NULL, sound_8}, /* rates */
    {'F', WRITTEN, sizeof(coin_force), NULL, sound_force},
    {'A', WRITTEN, SAMPLES * sizeof(coin_state), NULL, NULL},
    {'Y', WRITTEN, sizeof(coin_orbit), NULL, sound_orbit},
    {'V', WRITTEN, sizeof(coin_state), NULL, sound_members},
    {'y', READ, sizeof(coin_orbit), take_orbit, NULL},
    {'l', READ, sizeof(coin_losses), take_losses, NULL},
    {'L', MOVED, sizeof(coin_losses), take_losses, sound_losses},
    {'<', READ, sizeof(coin_body), take_body, NULL},
    {'=', MOVED, sizeof(coin_body), take_body, sound_body},
    {'>', WRITTEN, sizeof(coin_body), NULL, sound_body},
    {'%', READ, sizeof(coin_table), take_table, NULL},
    {'-', READ, 3 * sizeof(double), take_r, NULL},
    {'q', READ, 4 * sizeof(double), take_q, NULL},
    {'w', READ, 3 * sizeof(double), take_omega, NULL},
    {'1', WRITTEN, sizeof(double), NULL, sound_1},
    {'2', WRITTEN, 2 * sizeof(double), NULL, sound_2},
    {'3', WRITTEN, 3 * sizeof(double), NULL, sound_3},
    {'4', WRITTEN, 4 * sizeof(double), NULL, sound_4},
    {'9', WRITTEN, 9 * sizeof(double), NULL, sound_9},
    {'M', WRITTEN, 16 * sizeof(double), NULL, sound_16},
    {'I', WRITTEN, sizeof(double), NULL, sound_radius},
    {'n', PROGRESS, sizeof(uint64_t), NULL, NULL},
    {'z', PROGRESS, sizeof(size_t), NULL, NULL},
    {'Z', PROGRESS, SAMPLES * sizeof(int32_t), NULL, NULL},
    {'r', PROGRESS, sizeof(double), NULL, sound_1},
    {'$', READ, 16, take_text, NULL},
    {'d', SCALAR, 0, take_d, NULL},
    {'a', SCALAR, 0, take_angle, NULL},
    {'v', SCALAR, 0, take_omega_Z, NULL},
    {'~', SCALAR, 0, take_length, NULL},
    {'^', SCALAR, 0, take_speed, NULL},
    {'t', SCALAR, 0, take_dt, NULL},
    {'T', SCALAR, 0, take_time, NULL},
    {'e', SCALAR, 0, take_tol, NULL},
    {'i', SCALAR, 0, take_i, NULL},
    {'b', SCALAR, 0, take_branch, NULL},
    {'x', SCALAR, 0, take_bits, NULL},
    {'u', SCALAR, 0, take_u, NULL},
    {'c', SCALAR, 0, take_count, NULL},
};

const struct kind *kind_of(char letter)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i)
        if (kinds[i].letter == letter)
            return &kinds[i];
    for (size_t i = 0; i < single_kind_count; ++i)
        if (single_kinds[i].letter == letter)
            return &single_kinds[i];
    return NULL;
}
