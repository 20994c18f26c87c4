/* SPDX-License-Identifier: MIT */
/* What is the same for one coin and for many abreast: lib/float/carry.c defines
 * PART, what each of its functions begins with, and
 * TRUTH, what a comparison gives; so does lib/float/lanes.c, with a
 * vector for each float. */

/* A float as two of 12 bits. */
struct halves {
    float high, low;
};

static inline struct halves split(float a)
{
    const float t = 4097.0f * a, high = t - (t - a); /* 4097 = 2^12 + 1 */
    const struct halves h = {high, a - high};
    return h;
}

/* Dekker's product. */
PART float coinf_priv_residue(float a, float b)
{
    const struct halves x = split(a), y = split(b);
    const float off = x.high * y.high - a * b;
    return ((off + x.high * y.low) + x.low * y.high) + x.low * y.low;
}

PART coinf_priv_sc coinf_priv_pair(float angle, float low)
{
    const coinf_priv_sc of = coinf_priv_sincos(angle);
    const coinf_priv_sc pair = {of.s + of.c * low, of.c - of.s * low};
    return pair;
}

PART void coinf_priv_stage_at(coinf_priv_stage *y, const coinf_state *s)
{
    const coinf_priv_sc th = coinf_priv_pair(s->theta, s->low[0]);
    y->sth = th.s;
    y->cth = th.c;
    y->q = 1 / th.c;
    y->tth = th.s * y->q;
    const coinf_priv_sc ph = coinf_priv_pair(s->phi, s->low[1]);
    y->sph = ph.s;
    y->cph = ph.c;
    y->wX = s->wX;
    y->wY = s->wY;
    y->wZ = s->wZ;
}

#define PI (2 * COINF_PRIV_HALF_PI)

/* Takes whole turns off an angle, by the parts of pi/2. */
static void take_turns_off(float *angle, float *low)
{
    const float turns =
        (*angle * (0.5f / PI) + COINF_PRIV_ROUNDER) - COINF_PRIV_ROUNDER;
    const float none = {0};
    coinf_priv_add(angle, low, turns * (-4 * COINF_PRIV_P1), none);
    coinf_priv_add(angle, low, turns * (-4 * COINF_PRIV_P2), none);
    coinf_priv_add(angle, low, turns * (-4 * COINF_PRIV_P3), none);
}

/* Whether a step may end here; with NaN none may. */
static inline TRUTH holds(const coinf_state *s, const coinf_priv_plan *plan)
{
    const float wX = s->wX, wY = s->wY, wZ = s->wZ;
    const float pose =
        fabsf(s->phi) + fabsf(s->psi) + fabsf(s->x) + fabsf(s->z);
    return (fabsf(s->theta) < COINF_PRIV_HALF_PI) & (pose <= FLT_MAX) &
           (wX * wX + wY * wY + wZ * wZ <= plan->most2);
}
