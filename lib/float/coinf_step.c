/* SPDX-License-Identifier: MIT */
/* A step in single precision.
 *
 * Each addition to a float loses up to 6e-8 of it, and a firmware loop adds
 * thousands of steps.  So a state keeps what the rounding of its members left
 * out, and a step computes changes instead of values.  A step takes its sines
 * and cosines anew from the angles.  So a run of n steps is n runs of one step,
 * to the bit. */
#include "floats.h"

#include "../motion/methods.h"
#include "../motion/state.h"

/* In a state, low[0] to low[7] are the remainders of theta, phi, psi, x, z, wX,
 * wY, wZ: what their rounding left out. */

/* What the steps of a run share: the equations of motion times dt, and the
 * limits on W^2, Eq. (47), where a step begins and ends. */
typedef struct coinf_priv_stepper {
    coin_priv_field f;
    float KJ_low; /* what KJ lacks of GJ K/(M g a), by balance() */
    float a, g_a, w2_max;
    float coarse2, most2; /* coarse2 <= most2 */
} coinf_priv_stepper;

/* ------------------------------------------------------ compensated sums -- */

/* Adds a part and its own remainder, `small`, to a sum and its remainder. */
COIN_PRIV_INLINE void coinf_priv_add_parts(float *sum, float *low, float part,
                                           float small)
{
    const float large = *sum + part, of_part = large - *sum;
    const float off = (*sum - (large - of_part)) + (part - of_part);
    const float rest = (*low + small) + off;
    *sum = large + rest;
    *low = rest - (*sum - large);
}

/* A float as two of 12 bits. */
typedef struct coinf_priv_halves {
    float upper, lower;
} coinf_priv_halves;

COIN_PRIV_INLINE coinf_priv_halves coinf_priv_halves_of(float a)
{
    const float t = 4097 * a, high = t - (t - a); /* 4097 = 2^12 + 1 */
    const coinf_priv_halves h = {high, a - high};
    return h;
}

/* What the rounding of a b leaves out, to the bit: Dekker's product. */
COIN_PRIV_NOINLINE float coinf_priv_residue(float a, float b)
{
    const coinf_priv_halves x = coinf_priv_halves_of(a),
                            y = coinf_priv_halves_of(b);
    const float off = x.upper * y.upper - a * b;
    return ((off + x.upper * y.lower) + x.lower * y.upper) + x.lower * y.lower;
}

/* ---------------------------------------------------------------- angles -- */

/* Sine and cosine of an angle and its remainder. */
COIN_PRIV_NOINLINE coin_priv_sc coinf_priv_sine_cosine_with_low(float angle,
                                                                float low)
{
    const coin_priv_sc near = coin_priv_sine_cosine(angle);
    const coin_priv_sc pair = {near.s + near.c * low, near.c - near.s * low};
    return pair;
}

/* The variables of an angular velocity and of the pairs of lean and heading. */
COIN_PRIV_INLINE coin_priv_variables coinf_priv_variables_from(
    float wX, float wY, float wZ, coin_priv_sc th, coin_priv_sc ph)
{
    const float q = 1 / th.c;
    const coin_priv_variables y = {
        wX, wY, wZ, th.s, th.c, q, th.s * q, ph.s, ph.c,
    };
    return y;
}

/* A state as the equations read it. */
COIN_PRIV_NOINLINE coin_priv_variables
coinf_priv_variables_with_low(const coinf_state *s)
{
    const coin_priv_sc th =
        coinf_priv_sine_cosine_with_low(s->theta, s->low[0]);
    const coin_priv_sc ph = coinf_priv_sine_cosine_with_low(s->phi, s->low[1]);
    return coinf_priv_variables_from(s->wX, s->wY, s->wZ, th, ph);
}

/* Subtracts whole turns from an angle, by the parts of pi/2. */
COIN_PRIV_NOINLINE void coinf_priv_reduce(float *angle, float *low)
{
    const float turns =
        (*angle * (0.25f / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER) -
        COIN_PRIV_ROUNDER;
    coinf_priv_add_parts(angle, low, turns * (-4 * COIN_PRIV_P1), 0);
    coinf_priv_add_parts(angle, low, turns * (-4 * COIN_PRIV_P2), 0);
    coinf_priv_add_parts(angle, low, turns * (-4 * COIN_PRIV_P3), 0);
}

/* ---------------------------------------------------------------- slopes -- */

/* h d/dt of a state's members, or a part of their change. */
typedef struct coinf_priv_slope {
    float theta, phi, psi, x, z, wX, wY, wZ;
} coinf_priv_slope;

/* What KJ_low adds to h d(wX)/dt of (14), in KJ wZ wY. */
COIN_PRIV_INLINE float coinf_priv_fall_low(const coinf_priv_stepper *stepper,
                                           const coin_priv_variables *y)
{
    return -(stepper->KJ_low * y->wZ * y->wY);
}

/* The slope at a stage.  psi' is computed as wZ + phi' sin theta, so that the
 * remainder of phi' gives that of psi'. */
COIN_PRIV_INLINE coinf_priv_slope coinf_priv_slope_at(
    const coinf_priv_stepper *stepper, const coin_priv_variables *y)
{
    const coin_priv_field *f = &stepper->f;
    const coin_priv_variables d = coin_priv_slopes_at(f, y);
    const float phi = coin_priv_pose_slopes(f, y).phi;
    float v[3];
    coin_priv_velocity_of(v, f->h * stepper->a, y);
    const coinf_priv_slope slope = {
        f->h * y->wX, phi,  f->h * y->wZ + phi * y->sth, /* (19) */
        v[0],         v[2], d.wX,
        d.wY,         d.wZ,
    };
    return slope;
}

/* A stage: the start plus a part w of a slope.  It is the textbook's stage: the
 * pairs are turned by what is added to the angles, and 1/cos theta is computed
 * by a division.  As the start plus a part of a slope, pairs have errors of
 * z^2/2 for a turn z, and 1/cos theta of tan^2 theta z^2. */
COIN_PRIV_INLINE coin_priv_variables coinf_priv_stage_along(
    const coin_priv_variables *y1, float w, const coinf_priv_slope *slope)
{
    const coin_priv_sc lean = {y1->sth, y1->cth}, heading = {y1->sph, y1->cph};
    const coin_priv_sc th = coin_priv_turned_a_little(lean, w * slope->theta);
    const coin_priv_sc ph = coin_priv_turned_a_little(heading, w * slope->phi);
    return coinf_priv_variables_from(y1->wX + w * slope->wX,
                                     y1->wY + w * slope->wY,
                                     y1->wZ + w * slope->wZ, th, ph);
}

/* rest + w (of - first). */
COIN_PRIV_INLINE void coinf_priv_gather(coinf_priv_slope *rest, float w,
                                        const coinf_priv_slope *slope,
                                        const coinf_priv_slope *first)
{
    rest->theta += w * (slope->theta - first->theta);
    rest->phi += w * (slope->phi - first->phi);
    rest->psi += w * (slope->psi - first->psi);
    rest->x += w * (slope->x - first->x);
    rest->z += w * (slope->z - first->z);
    rest->wX += w * (slope->wX - first->wX);
    rest->wY += w * (slope->wY - first->wY);
    rest->wZ += w * (slope->wZ - first->wZ);
}

/* What the rounding of the first slope left out.  It is computed only for those
 * parts that are the same in each step of a steady motion: their errors would
 * add up. */
COIN_PRIV_INLINE coinf_priv_slope coinf_priv_left_out(
    const coinf_priv_slope *first, const coinf_priv_stepper *stepper,
    const coin_priv_variables *y)
{
    const float h = stepper->f.h, cth = y->cth;
    const float off =
        coinf_priv_residue(h, y->wY) - coinf_priv_residue(first->phi, cth);
    const float phi =
        y->q * ((h * y->wY - first->phi * cth) + off); /* from (18) */
    const float fall = coinf_priv_fall_low(stepper, y);
    const coinf_priv_slope low = {
        0, phi, phi * y->sth, 0, 0, fall, 0, 0,
    };
    return low;
}

/* The classical Runge-Kutta step, as the first slope f1 and the rest of the
 * change, ((f2 - f1) + (f3 - f1))/3 + (f4 - f1)/6.  The rounded weights then
 * multiply the rest only, which is small.  If they multiplied f1, their errors
 * would add up in a steady motion.
 * *last becomes the last stage, which stands for the end of the step. */
COIN_PRIV_INLINE void coinf_priv_slopes(coinf_priv_slope *first,
                                        coinf_priv_slope *rest,
                                        coin_priv_variables *last,
                                        const coinf_priv_stepper *stepper,
                                        const coin_priv_variables *y1)
{
    static const float reach[] = {0.5f, 0.5f, 1};
    static const float weight[] = {1.0f / 3, 1.0f / 3, 1.0f / 6};
    coinf_priv_slope slope = *first = coinf_priv_slope_at(stepper, y1);
    *rest = coinf_priv_left_out(first, stepper, y1);
    for (int i = 0; i < 3; ++i) {
        *last = coinf_priv_stage_along(y1, reach[i], &slope);
        slope = coinf_priv_slope_at(stepper, last);
        coinf_priv_gather(rest, weight[i], &slope, first);
    }
}

/* Adds the change of a step to a state. */
COIN_PRIV_INLINE void coinf_priv_add_change(coinf_state *s,
                                            const coinf_priv_slope *first,
                                            const coinf_priv_slope *rest)
{
    coinf_priv_add_parts(&s->theta, &s->low[0], first->theta, rest->theta);
    coinf_priv_add_parts(&s->phi, &s->low[1], first->phi, rest->phi);
    coinf_priv_add_parts(&s->psi, &s->low[2], first->psi, rest->psi);
    coinf_priv_add_parts(&s->x, &s->low[3], first->x, rest->x);
    coinf_priv_add_parts(&s->z, &s->low[4], first->z, rest->z);
    coinf_priv_add_parts(&s->wX, &s->low[5], first->wX, rest->wX);
    coinf_priv_add_parts(&s->wY, &s->low[6], first->wY, rest->wY);
    coinf_priv_add_parts(&s->wZ, &s->low[7], first->wZ, rest->wZ);
}

/* Whether a step may end here; not if a number is NaN.  Whole turns have not
 * been subtracted yet. */
COIN_PRIV_INLINE int coinf_priv_end_in_range(const coinf_state *s,
                                             const coinf_priv_stepper *stepper)
{
    const float wX = s->wX, wY = s->wY, wZ = s->wZ;
    const float far = COIN_PRIV_PLACE_MAX * stepper->a;
    return (fabsf(s->theta) < COIN_PRIV_HALF_PI) &
           (fabsf(s->phi) <= COIN_PRIV_ANGLE_MAX + 16) &
           (fabsf(s->psi) <= COIN_PRIV_ANGLE_MAX + 16) & (fabsf(s->x) <= far) &
           (fabsf(s->z) <= far) &
           (wX * wX + wY * wY + wZ * wZ <= stepper->most2) &
           (wX * wX <= stepper->w2_max) & (wY * wY <= stepper->w2_max) &
           (wZ * wZ <= stepper->w2_max);
}

/* ----------------------------------------------------------------- steps -- */

/* KJ_low, with which KJ + KJ_low is K/(M g a) = (a + I_Z/(M a))/g times GJ in
 * twice a float's digits, but for the rounding of the sum.  In a steady motion
 * the terms with KJ and with GJ balance.  An error of the ratio of KJ and GJ
 * makes the heading drift; an error common to both does not. */
static float balance(const coin_priv_field *f, const coin_priv_constants *b,
                     float g)
{
    const float sum = b->a + b->IZ / (b->M * b->a), ratio = sum / g;
    const float ratio_low =
        ((sum - ratio * g) - coinf_priv_residue(ratio, g)) / g;
    return (f->GJ * ratio - f->KJ) +
           (coinf_priv_residue(f->GJ, ratio) + f->GJ * ratio_low);
}

/* Checks everything, then computes what the steps share. */
static int32_t coinf_priv_stepper_of(coinf_priv_stepper *stepper,
                                     const coinf_state *s,
                                     const coinf_params *p, int32_t method,
                                     float dt)
{
    coin_priv_constants b;
    const int32_t status = coin_priv_method_is_known(method)
                               ? coin_priv_check(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_in_range(dt, &b))
        return COIN_ESTEP;
    const coin_priv_limits limits = coin_priv_limits_of(&b, method, dt);
    stepper->f = coin_priv_field_of(&b, dt);
    stepper->a = b.a;
    stepper->g_a = b.g_a;
    stepper->w2_max = b.w2_max;
    stepper->most2 = limits.most2;
    stepper->coarse2 = limits.coarse2;
    stepper->KJ_low = balance(&stepper->f, &b, p->gravity);
    return COIN_OK;
}

/* Notes COIN_COARSE if W^2 is beyond coarse2.  Returns 0, a refusal, if it is
 * beyond most2 or NaN. */
COIN_PRIV_INLINE int coinf_priv_admit_rate(int32_t *warnings,
                                           const coinf_priv_stepper *stepper,
                                           const coin_priv_variables *y)
{
    const float rate2 = coin_priv_rate2(stepper->g_a, y);
    if (!(rate2 <= stepper->coarse2))
        *warnings = COIN_COARSE;
    return rate2 <= stepper->most2;
}

/* Ends a step.  If *next is a sound state, *s becomes *next, with heading and
 * roll brought within half a turn.  Else returns 0 and leaves *s untouched. */
COIN_PRIV_NOINLINE int coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                                              const coinf_priv_stepper *stepper)
{
    if (!coinf_priv_end_in_range(next, stepper))
        return 0;
    if (fabsf(next->phi) > 2 * COIN_PRIV_HALF_PI)
        coinf_priv_reduce(&next->phi, &next->low[1]);
    if (fabsf(next->psi) > 2 * COIN_PRIV_HALF_PI)
        coinf_priv_reduce(&next->psi, &next->low[2]);
    *s = *next;
    return 1;
}

/* One step of *s from its variables *y, the W of which is admitted.  *warnings
 * becomes COIN_COARSE if the step was coarse.  Returns 0 and leaves *s
 * untouched if the step is refused.
 *
 * The cos theta of the stages is not checked: where that of one is near 0 or
 * below it, the W of the last stage is above the limit. */
COIN_PRIV_NOINLINE int coinf_priv_step_from(coinf_state *s, int32_t *warnings,
                                            const coinf_priv_stepper *stepper,
                                            const coin_priv_variables *y)
{
    coinf_priv_slope first, rest;
    coin_priv_variables last;
    coinf_priv_slopes(&first, &rest, &last, stepper, y);
    if (!coinf_priv_admit_rate(warnings, stepper, &last))
        return 0;
    coinf_state next = *s;
    coinf_priv_add_change(&next, &first, &rest);
    return coinf_priv_finish_step(s, &next, stepper);
}

/* One step of *s, as coinf_priv_step_from().  Inline, since it would take 24
 * bytes of stack more as a function. */
COIN_PRIV_INLINE int coin_priv_step(coinf_state *s, int32_t *warnings,
                                    const coinf_priv_stepper *stepper)
{
    const coin_priv_variables y = coinf_priv_variables_with_low(s);
    return coinf_priv_admit_rate(warnings, stepper, &y) &&
           coinf_priv_step_from(s, warnings, stepper, &y);
}

int32_t coinf_step(coinf_state *s, const coinf_params *p, float dt)
{
    coinf_priv_stepper stepper;
    int32_t warnings = COIN_OK;
    const int32_t status = coinf_priv_stepper_of(&stepper, s, p, COIN_RK4, dt);
    if (status != COIN_OK || dt == 0)
        return status;
    return coin_priv_step(s, &warnings, &stepper)
               ? warnings
               : coin_priv_refusal(s, stepper.a);
}

int32_t coinf_run(coinf_state *s, const coinf_params *p, int32_t method,
                  float dt, uint64_t steps, uint64_t *done)
{
    coinf_priv_stepper stepper;
    int32_t warnings = COIN_OK;
    const int32_t status = coinf_priv_stepper_of(&stepper, s, p, method, dt);
    if (status != COIN_OK)
        return status;
    uint64_t n = dt == 0 ? steps : 0;
    while (n < steps && coin_priv_step(s, &warnings, &stepper))
        ++n;
    if (done)
        *done = n;
    return n < steps ? coin_priv_refusal(s, stepper.a) : warnings;
}
