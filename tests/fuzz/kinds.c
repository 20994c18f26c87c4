/* SPDX-License-Identifier: MIT */
/* What arguments are: how bytes become one, and what an output has to be. */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Whether all are finite. */
#define FINITE(name, type)                                                     \
    static int name(const void *of, size_t size, const struct world *w)        \
    {                                                                          \
        const type *const x = of;                                              \
        int good = 1;                                                          \
        (void)w;                                                               \
        for (size_t i = 0; i < size / sizeof *x; ++i)                          \
            good &= isfinite(x[i]) != 0;                                       \
        return good;                                                           \
    }
FINITE(doubles, double)
FINITE(floats, float)

/* ------------------------------------------------------------- taking each */
#define OF_THE_WORLD(name, member)                                             \
    static void take_##name(struct bytes *b, const struct world *w, void *to)  \
    {                                                                          \
        (void)b;                                                               \
        memcpy(to, &w->member, sizeof w->member);                              \
    }
OF_THE_WORLD(p, p)
OF_THE_WORLD(s, s)
OF_THE_WORLD(params_single, pf)
OF_THE_WORLD(state_single, sf)

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

/* Stands on its edge, and spins, rolls along it or slides. */
static void stand_up(coin_body *d, const struct world *w)
{
    d->s.theta = d->s.wX = d->s.wY = d->vy = 0;
    d->y = w->p.radius;
}

/* A state whose angles and places are not at the ends of their ranges: there
 * rounding may take those of a body out of them. */
static coin_state inner(const coin_state *s, const coin_params *p)
{
    coin_state t = *s;
    double *const angles[] = {&t.phi, &t.psi}, *const places[] = {&t.x, &t.z};
    for (int i = 0; i < 2; ++i) {
        *angles[i] /= fabs(*angles[i]) > 0x1p30 ? 4 : 1;
        *places[i] /= fabs(*places[i]) > 5e8 * p->radius ? 4 : 1;
    }
    return t;
}

/* Rolls, slips, stands, lies flat, or flies up to a hundred radii high; now and
 * then it is none. */
static void take_body(struct bytes *b, const struct world *w, void *to)
{
    const double v = sqrt(w->p.gravity * w->p.radius);
    const uint8_t how = take_byte(b);
    const coin_state s = inner(&w->s, &w->p);
    coin_body d = {s, 0, 0, 0, 0, {0, 0, 0, 0}};
    if (coin_body_from_state(&d, &s, &w->p) == COIN_OK && how % 2) {
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
    if (how % 16 == 3)
        stand_up(&d, w);
    if (how % 64 == 9)
        d.reserved[how / 64] = take_number(b);
    memcpy(to, &d, sizeof d);
}

/* Now and then one member is any number. */
static void take_table(struct bytes *b, const struct world *w, void *to)
{
    const double kinetic = fabs(take_part(b));
    const uint8_t how = take_byte(b);
    const double over[] = {1, 1.05, 1.5, INFINITY};
    coin_table f = {0};
    f.mu_kinetic = kinetic;
    f.mu_static = how % 4 == 3 ? INFINITY : kinetic * over[how % 4];
    f.restitution = perhaps(b, fabs(take_part(b)));
    if (how & 4)
        take_losses(b, w, &f.losses);
    f.losses.damping = 0;
    for (int i = 0; how & 8 && i < 2; ++i)
        f.pull[i] = perhaps(b, 2 * w->p.gravity * take_part(b));
    memcpy(to, &f, sizeof f);
    if (how >= 240)
        ((double *)to)[take_byte(b) % (sizeof f / sizeof(double))] =
            take_number(b);
}

static void take_r(struct bytes *b, const struct world *w, void *to)
{
    double *const r = to;
    for (int i = 0; i < 3; ++i)
        r[i] = w->p.radius * (i == 1) + perhaps(b, w->p.radius * take_part(b));
}

/* The world's orbit, or that of a rolling coin if it has none; now and then
 * with another number before the pieces. */
static void take_orbit(struct bytes *b, const struct world *w, void *to)
{
    const coin_params p = {1, 1, 1, 0.25, 0.5, 0, {0, 0}};
    const coin_state s = {0.1, 0, 0, 0, 0, 0, 0, 1};
    if (coin_orbit_init(to, &w->s, &w->p) != COIN_OK)
        demand(coin_orbit_init(to, &s, &p) == COIN_OK);
    const size_t which = take_byte(b);
    const double any = take_number(b);
    if (which >= 192)
        memcpy((char *)to + (which - 192) * sizeof any, &any, sizeof any);
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

/* ----------------------------------------------------------------- scalars */
static double natural_rate(const struct world *w)
{
    return sqrt(w->p.gravity / w->p.radius);
}

/* A step, from far too short to far too long for this state. */
static double step(struct bytes *b, const struct world *w)
{
    const uint8_t how = take_byte(b);
    const double part = take_part(b);
    return how < 232 ? ldexp(part, 2 - how % 24) / w->W : take_number(b);
}

/* A time: up to a few tens of such steps, or so long that it is refused; what
 * lies between would be moved, for hours. */
static double time_of(struct bytes *b, const struct world *w)
{
    const double t = step(b, w);
    if (fabs(t) * w->W <= 4)
        return 8 * t;
    return fabs(t) * natural_rate(w) <= 1e15 ? copysign(32 / w->W, t) : t;
}

/* From a thousandth of the coin's radius to a hundred radii. */
static double length(struct bytes *b, const struct world *w)
{
    const double part = ldexp(take_part(b), 7 - take_byte(b) % 18);
    return perhaps(b, w->p.radius * part);
}

static double tolerance(struct bytes *b)
{
    const uint8_t how = take_byte(b);
    return how < 240 ? ldexp(1, -(7 + how % 37)) : take_number(b);
}

/* Methods: near 0, or anything. */
static int32_t method(struct bytes *b)
{
    const uint8_t how = take_byte(b);
    if (how < 248)
        return how < 224 ? how % 4 : how % 8 - 2;
    return (int32_t)(0x01010101u * take_byte(b));
}

/* Bits of stop, or anything. */
static int32_t stop_bits(struct bytes *b)
{
    const int32_t stop =
        COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES;
    const uint8_t how = take_byte(b);
    return how < 224 ? how & stop : (int32_t)(0x01010101u * take_byte(b));
}

static int32_t branch(struct bytes *b)
{
    const int32_t i = method(b);
    return i >= 0 && i < 4 ? i % 2 * 2 - 1 : i;
}

/* Few, or so many that sums are settled on the way. */
static uint64_t steps(struct bytes *b)
{
    const uint8_t how = take_byte(b);
    return how < 224 ? how % 4 : 30 + how % 40;
}

#define SCALAR_OF(name, type, value)                                           \
    static void take_##name(struct bytes *b, const struct world *w, void *to)  \
    {                                                                          \
        (void)w;                                                               \
        *(type *)to = value;                                                   \
    }
SCALAR_OF(d, double, take_number(b))
SCALAR_OF(angle, double, take_lean(b))
SCALAR_OF(omega_Z, double, take_rate(b, natural_rate(w)))
SCALAR_OF(speed, double, take_rate(b, natural_rate(w)) * w->p.radius)
SCALAR_OF(length, double, length(b, w))
SCALAR_OF(dt, double, step(b, w))
SCALAR_OF(time, double, time_of(b, w))
SCALAR_OF(tol, double, tolerance(b))
SCALAR_OF(i, int32_t, method(b))
SCALAR_OF(branch, int32_t, branch(b))
SCALAR_OF(bits, int32_t, stop_bits(b))
SCALAR_OF(u, uint64_t, steps(b))
SCALAR_OF(count, uint64_t, take_byte(b) % (SAMPLES + 1))

/* -------------------------------------------------------- single precision */
/* Beyond a float's range: infinite. */
static void narrow(void *to, const double *x, size_t count)
{
    float *const f = to;
    for (size_t i = 0; i < count; ++i)
        f[i] = fabs(x[i]) > FLT_MAX ? (float)copysign(INFINITY, x[i])
                                    : (float)x[i];
}

static void take_q_single(struct bytes *b, const struct world *w, void *to)
{
    double q[4];
    take_q(b, w, q);
    narrow(to, q, 4);
}

static void take_omega_single(struct bytes *b, const struct world *w, void *to)
{
    double omega[3];
    take_omega(b, w, omega);
    narrow(to, omega, 3);
}

/* What is left out of a float: nothing, half a unit at most, or any number. */
void take_single(struct world *w, struct bytes *b)
{
    float member[8];
    narrow(&w->pf, &w->p.mass, 8);
    narrow(member, &w->s.theta, 8);
    memset(&w->sf, 0, sizeof w->sf);
    memcpy(&w->sf, member, sizeof member);
    for (int i = 0; i < 8; ++i) {
        const uint8_t how = take_byte(b);
        const double any =
            how < 250 ? member[i] * 0x1p-24 * take_part(b) : take_number(b);
        if (how >= 128)
            narrow(&w->sf.low[i], &any, 1);
    }
}

/* ------------------------------------------------------- what is an output */
#define SOUND(name, is_so)                                                     \
    static int sound_##name(const void *of, size_t size,                       \
                            const struct world *w)                             \
    {                                                                          \
        (void)size;                                                            \
        (void)w;                                                               \
        return is_so;                                                          \
    }
SOUND(params, coin_params_check(of) == COIN_OK)
SOUND(params_single, coinf_params_check(of) == COIN_OK)
SOUND(state, coin_state_check(of, &w->p) == COIN_OK)
SOUND(single, coinf_state_check(of, &w->pf) == COIN_OK)
SOUND(losses, coin_losses_check(of, &w->p) == COIN_OK)
SOUND(body, coin_body_contact(of, &w->p, (double[3]){0}) == COIN_OK)
SOUND(radius, *(const double *)of >= 0)
/* Of an orbit's own coin, which need not be the world's. */
SOUND(members, coin_axes(of, (double[9]){0}) == COIN_OK)

/* All but the ratio finite. */
#define IS_FORCE(f, kind, finite)                                              \
    (finite((f)->R, offsetof(kind, ratio), w) && (f)->normal == (f)->R[1] &&   \
     (f)->friction >= 0 &&                                                     \
     ((f)->normal > 0 ? (f)->ratio >= 0                                        \
                      : isinf((f)->ratio) && (f)->ratio > 0))

static int sound_force(const void *of, size_t size, const struct world *w)
{
    const coin_force *const f = of;
    const coinf_force *const s = of;
    return size == sizeof *f ? IS_FORCE(f, coin_force, doubles)
                             : IS_FORCE(s, coinf_force, floats);
}

static int sound_orbit(const void *of, size_t size, const struct world *w)
{
    const coin_orbit *o = of;
    (void)size;
    return doubles(&o->period, 5 * sizeof(double), w) &&
           doubles(o->drift, 2 * sizeof(double), w) && o->period >= 0 &&
           o->theta_min <= o->theta_max && !(o->radius_min > o->radius_max) &&
           o->conditioning >= 1;
}

static const struct kind kinds[] = {
    {'p', READ, sizeof(coin_params), take_p, NULL},
    {'P', WRITTEN, sizeof(coin_params), NULL, sound_params},
    {'s', READ, sizeof(coin_state), take_s, NULL},
    {'E', READ, sizeof(coin_state), take_spin, NULL},
    {'S', MOVED, sizeof(coin_state), take_s, sound_state},
    {'X', MOVED, SAMPLES * sizeof(coin_state), take_coins, NULL},
    {'O', WRITTEN, sizeof(coin_state), NULL, sound_state},
    {'R', WRITTEN, sizeof(coin_state), NULL, doubles}, /* rates */
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
    {'1', WRITTEN, sizeof(double), NULL, doubles},
    {'2', WRITTEN, 2 * sizeof(double), NULL, doubles},
    {'3', WRITTEN, 3 * sizeof(double), NULL, doubles},
    {'4', WRITTEN, 4 * sizeof(double), NULL, doubles},
    {'9', WRITTEN, 9 * sizeof(double), NULL, doubles},
    {'M', WRITTEN, 16 * sizeof(double), NULL, doubles},
    {'I', WRITTEN, sizeof(double), NULL, sound_radius},
    {'n', PROGRESS, sizeof(uint64_t), NULL, NULL},
    {'z', PROGRESS, sizeof(size_t), NULL, NULL},
    {'Z', PROGRESS, SAMPLES * sizeof(int32_t), NULL, NULL},
    {'r', PROGRESS, sizeof(double), NULL, doubles},
    {'$', READ, 16, take_text, NULL},
    {'f', READ, sizeof(coinf_params), take_params_single, NULL},
    {'G', WRITTEN, sizeof(coinf_params), NULL, sound_params_single},
    {'g', READ, sizeof(coinf_state), take_state_single, NULL},
    {'H', MOVED, sizeof(coinf_state), take_state_single, sound_single},
    {'h', WRITTEN, sizeof(coinf_state), NULL, sound_single},
    {'j', WRITTEN, sizeof(coinf_state), NULL, floats}, /* rates */
    {'m', WRITTEN, sizeof(coinf_force), NULL, sound_force},
    {'Q', READ, 4 * sizeof(float), take_q_single, NULL},
    {'W', READ, 3 * sizeof(float), take_omega_single, NULL},
    {'B', WRITTEN, 2 * sizeof(float), NULL, floats},
    {'C', WRITTEN, 3 * sizeof(float), NULL, floats},
    {'D', WRITTEN, 4 * sizeof(float), NULL, floats},
    {'K', PROGRESS, sizeof(float), NULL, floats},
    {'N', WRITTEN, 9 * sizeof(float), NULL, floats},
    {'U', WRITTEN, 16 * sizeof(float), NULL, floats},
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
    return NULL;
}
