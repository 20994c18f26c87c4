/* SPDX-License-Identifier: MIT */
/* What arguments of coinf.h are: the world in single precision. */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <string.h>

static int finite_floats(const void *of, size_t count)
{
    const float *const x = of;
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

/* Beyond a float's range: infinite. */
static float single(double x)
{
    return fabs(x) > FLT_MAX ? (float)(x > 0 ? INFINITY : -INFINITY) : (float)x;
}

/* ------------------------------------------------------------- taking each */
static void take_params(struct bytes *b, const struct world *w, void *to)
{
    (void)b;
    memcpy(to, &w->pf, sizeof w->pf);
}

static void take_state(struct bytes *b, const struct world *w, void *to)
{
    (void)b;
    memcpy(to, &w->sf, sizeof w->sf);
}

static void take_q(struct bytes *b, const struct world *w, void *to)
{
    float *const q = to;
    (void)w;
    for (int i = 0; i < 4; ++i)
        q[i] = single(perhaps(b, 2 * take_part(b)));
}

static void take_omega(struct bytes *b, const struct world *w, void *to)
{
    float *const omega = to;
    for (int i = 0; i < 3; ++i)
        omega[i] = single(take_rate(b, w->W));
}

/* What is left out of a float; now and then more than that. */
static float take_low(struct bytes *b, float of)
{
    const uint8_t how = take_byte(b);
    if (how < 128)
        return 0;
    return how < 250 ? of * 0x1p-24f * (float)take_part(b)
                     : single(take_number(b));
}

void take_single(struct world *w, struct bytes *b)
{
    const coin_params *p = &w->p;
    const coin_state *s = &w->s;
    const coinf_params pf = {
        single(p->mass),      single(p->radius),
        single(p->gravity),   single(p->inertia_X),
        single(p->inertia_Z), {single(p->reserved[0]), 0, 0},
    };
    coinf_state sf = {
        single(s->theta), single(s->phi), single(s->psi),
        single(s->x),     single(s->z),   single(s->wX),
        single(s->wY),    single(s->wZ),  {0},
    };
    const float member[] = {sf.theta, sf.phi, sf.psi, sf.x,
                            sf.z,     sf.wX,  sf.wY,  sf.wZ};
    for (int i = 0; i < 8; ++i)
        sf.low[i] = take_low(b, member[i]);
    w->pf = pf;
    w->sf = sf;
}

/* ------------------------------------------------------- what is an output */
static int sound_params(const void *of, const struct world *w)
{
    (void)w;
    return coinf_params_check(of) == COIN_OK;
}

static int sound_state(const void *of, const struct world *w)
{
    return coinf_state_check(of, &w->pf) == COIN_OK;
}

static int sound_force(const void *of, const struct world *w)
{
    const coinf_force *f = of;
    (void)w;
    return finite_floats(f, 5) && f->normal == f->R[1] && f->friction >= 0 &&
           (f->normal > 0 ? f->ratio >= 0 : f->ratio == (float)INFINITY);
}

#define SOUND(count)                                                           \
    static int sound_##count(const void *of, const struct world *w)            \
    {                                                                          \
        (void)w;                                                               \
        return finite_floats(of, count);                                       \
    }
SOUND(1)
SOUND(2)
SOUND(3)
SOUND(4)
SOUND(9)
SOUND(16)

const struct kind single_kinds[] = {
    {'f', READ, sizeof(coinf_params), take_params, NULL},
    {'G', WRITTEN, sizeof(coinf_params), NULL, sound_params},
    {'g', READ, sizeof(coinf_state), take_state, NULL},
    {'H', MOVED, sizeof(coinf_state), take_state, sound_state},
    {'h', WRITTEN, sizeof(coinf_state), NULL, sound_state},
    {'j', WRITTEN, sizeof(coinf_state), NULL, sound_16}, /* rates */
    {'m', WRITTEN, sizeof(coinf_force), NULL, sound_force},
    {'Q', READ, 4 * sizeof(float), take_q, NULL},
    {'W', READ, 3 * sizeof(float), take_omega, NULL},
    {'B', WRITTEN, 2 * sizeof(float), NULL, sound_2},
    {'C', WRITTEN, 3 * sizeof(float), NULL, sound_3},
    {'D', WRITTEN, 4 * sizeof(float), NULL, sound_4},
    {'K', PROGRESS, sizeof(float), NULL, sound_1},
    {'N', WRITTEN, 9 * sizeof(float), NULL, sound_9},
    {'U', WRITTEN, 16 * sizeof(float), NULL, sound_16},
};
const size_t single_kind_count = sizeof single_kinds / sizeof *single_kinds;
