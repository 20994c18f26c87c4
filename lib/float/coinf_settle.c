/* SPDX-License-Identifier: MIT */
/* To rest in single precision: Runge-Kutta steps of order 4 in t, as long as
 * the state allows, and the last fall in closed form.  No step is refused and
 * done again: the cost of a frame is known beforehand. */
#include "step.h"

#include "../motion/rest.h"
#include "../real/hold.h"

/* The most steps of a call.  They take a second on a Cortex-M4F. */
#define STEPS_MAX 65536

/* A step is STRIDE tol^(1/4) divided by the fastest rate, so that the error
 * stays below tol per natural unit of time (test_float_settle).  LONGEST takes
 * the place of STRIDE tol^(1/4) where that is more; a longer step of RK4 would
 * be COIN_COARSE (motion/methods.h).  At tol = 1e-4, half of STRIDE takes 1.8
 * times as many steps, and twice makes the errors up to 45 times as large (make
 * tuning). */
#define STRIDE 1.6f
#define LONGEST 0.35f

/* The part of the rate of friction that is added to that of the coin.  A step
 * is then at most LONGEST/FRICTION = 1.2 relaxation times of friction; RK4 is
 * stable up to 2.7.  At tol = 1e-4, half of it takes 18 % fewer steps, twice 30
 * % more, and the errors of the time of rest stay the same (make tuning). */
#define FRICTION 0.3f

/* The part of the way to where the contact turns round, d(psi)/dt = 0, that a
 * step may go: friction is not smooth there.  At tol = 1e-4 half of it takes 8
 * % more steps for half the largest error.  Twice saves 4 %, and the largest
 * error is 8 times as large (make tuning). */
#define TURN_ROUND 0.5f

/* The part of the rates of a fall within which a contact has stopped: some
 * hundred times the rounding of those rates.  It is free from 1e-6 to 1e-4: the
 * times of rest stay the same, and the steps within 0.3 % (make tuning). */
#define STOPPED 1e-5f

/* Where cos theta is less than END and the coin hardly swings, the law of
 * losses that never stop the contact gives the time left.  By (75) the
 * energy of a coin without a swing is 1.5 M g a cos theta there.  It hardly
 * swings if its energy is below TOO_SLOW M g a cos theta.  By the rolling
 * moment alone a swing grows.  With 1e-5 for END or 5 for TOO_SLOW a quarter
 * that turns for 8 s rests up to 26 ms late; with 1e-7 or 1.6 it rests at the
 * same time.  Where cos theta is less than FLAT the coin lies flat: no float
 * below pi/2 is so near to it. */
#define END 1e-6f
#define TOO_SLOW 2
#define FLAT 3e-8f

/* A coin on its way to rest. */
struct settling {
    coinf_priv_body b;
    coinf_priv_losses l;
    coinf_state s;
    float rem, rem_low; /* the time still to go */
    float stride;
};

/* What the steps read, and the losses. */
struct lossy_plan {
    coinf_priv_plan ideal; /* first: it is what coinf_priv_slopes() hands on */
    const coinf_priv_losses *l;
};

/* The slope at a stage: the ideal coin's, and the losses. */
COIN_PRIV_NOINLINE coinf_priv_slope lossy_at(const coinf_priv_plan *plan,
                                             const coinf_priv_variables *y)
{
    const struct lossy_plan *with =
        (const struct lossy_plan *)(const void *)plan;
    const coinf_priv_slowing slow = coinf_priv_slowing_of(with->l, y);
    const float h = plan->f.h * y->q; /* dtau = dt/cos(theta) */
    coinf_priv_slope of = coinf_priv_slope_at(plan, y);
    of.wX += h * slow.wX;
    of.wY += h * slow.wY;
    of.wZ += h * slow.wZ;
    return of;
}

/* The longest step from here: a part of 1 over the rates of the coin and of
 * friction, and no further than half way to where the contact turns round. */
COIN_PRIV_NOINLINE float longest(const struct settling *g,
                                 const coinf_priv_variables *y)
{
    const coinf_priv_body *b = &g->b;
    const coinf_priv_losses *l = &g->l;
    const float sth = y->sth, cth = y->cth, wY = y->wY, wZ = y->wZ;
    const float rate =
        sqrtf(coinf_priv_rate2(b->g_a, y)) +
        FRICTION * coinf_priv_friction_rate(l, y) * y->q; /* (71) */
    const float dt = g->stride / rate;
    if (!(l->solid + l->layer + l->damping > 0))
        return dt;
    /* u = cos(theta) d(psi)/dt, and what carries it to 0: what the ideal coin
     * makes of it, and pivoting friction.  The ideal coin's part is
     * proportional to wX.  As wX may be 0 here, it is taken half a step on. */
    const float u = coinf_priv_roll_speed(wY, wZ, sth, cth);
    const float pivot = l->spin * (wY * cth - wZ * sth) * (sth * cth);
    const coinf_priv_field f = coinf_priv_field_of(b, 1);
    const float wX =
        fabsf(y->wX) + dt / 2 * fabsf(coinf_priv_slopes_at(&f, y).wX);
    const float du = wX * fabsf(wY * ((b->k2 + 1) * cth + sth * y->tth) +
                                wZ * sth * (b->k1 - 1)) +
                     fabsf(pivot / l->IX - pivot / l->K);
    const float way = TURN_ROUND * sqrtf(u * u + l->soft2 * (cth * cth));
    return way < du * dt ? way / du : dt;
}

/* One step; 0 if it would not be sound. */
COIN_PRIV_NOINLINE int lossy_step(struct settling *g,
                                  const coinf_priv_variables *y, float dt)
{
    const coinf_priv_body *b = &g->b;
    const struct lossy_plan plan = {
        {coinf_priv_field_of(b, dt), 0, b->a, b->g_a, b->w2_max,
         COIN_PRIV_LARGEST, COIN_PRIV_LARGEST},
        &g->l,
    };
    coinf_priv_slope first, rest;
    coinf_priv_variables last;
    coinf_priv_slopes(&first, &rest, &last, &plan.ideal, y, lossy_at);
    coinf_state next = g->s;
    coinf_priv_add_change(&next, &first, &rest);
    return coinf_priv_finish_step(&g->s, &next, &plan.ideal);
}

static void pass(struct settling *g, float time)
{
    if (time == g->rem)
        g->rem = 0;
    else
        coinf_priv_add_parts(&g->rem, &g->rem_low, -time, 0);
}

/* Sets the coin to the end of a part of a fall, in which its point of contact
 * stays where it is. */
static void put(struct settling *g, const coinf_priv_variables *from,
                const coinf_priv_held_fall *f, const coinf_priv_held_fall *to)
{
    coinf_state *s = &g->s;
    const float side = from->sth < 0 ? -1 : 1;
    const float turn = coinf_priv_fall_turn(to, &g->l);
    const coinf_priv_sc at = coinf_priv_sincos(to->x);
    coinf_priv_add_parts(&s->theta, &s->low[0], side * (f->x - to->x), 0);
    coinf_priv_add_parts(&s->phi, &s->low[1], to->phi, 0);
    coinf_priv_reduce(&s->phi, &s->low[1]);
    coinf_priv_reduce(&s->psi, &s->low[2]);
    const coinf_priv_sc ph = coinf_priv_sine_cosine_with_low(s->phi, s->low[1]);
    const float sth = side * at.c, a = g->b.a;
    coinf_priv_add_parts(&s->x, &s->low[3],
                         a * (sth * ph.s - from->sth * from->sph),
                         0); /* (21) */
    coinf_priv_add_parts(&s->z, &s->low[4],
                         a * (sth * ph.c - from->sth * from->cph),
                         0); /* (21) */
    s->wX = side * to->v;
    s->wY = at.s * turn;
    s->wZ = -sth * turn;
    s->low[5] = s->low[6] = s->low[7] = 0;
}

/* Lays the coin flat as it moves. */
static int32_t lay(struct settling *g)
{
    coinf_state *s = &g->s;
    const float side = s->theta < 0 ? -1 : 1;
    s->theta = side * COIN_PRIV_LAST_LEAN;
    s->low[0] = 0;
    s->wX = side * fabsf(s->wX);
    s->wY = 0;
    s->low[5] = s->low[6] = 0;
    return COIN_RESTS;
}

/* The fall, or a part of the rise, of a coin whose contact has stopped.
 * Returns COIN_ESTEP, and does nothing, if the losses do not hold the contact
 * until the end of that part. */
COIN_PRIV_NOINLINE int32_t fall_or_rise(struct settling *g,
                                        const coinf_priv_variables *y)
{
    const coinf_priv_held_fall f = coinf_priv_fall_of(&g->l, y);
    const int rises = f.v < 0;
    const float whole = rises ? coinf_priv_rise_time(&f, &g->l, &g->b)
                              : coinf_priv_fall_time(&f, &g->l, &g->b);
    const float time = whole < g->rem ? whole : g->rem;
    const struct settling before = *g;
    coinf_priv_held_fall to = f;
    coinf_priv_fall_by(&to, &g->l, &g->b, time);
    const int flat = !rises && (whole <= g->rem || to.x < FLAT);
    if (flat)
        to.x = 0;
    put(g, y, &f, &to);
    pass(g, time);
    if (flat)
        return lay(g);
    const coinf_priv_variables at = coinf_priv_variables_with_low(&g->s);
    if (!rises || coinf_priv_is_held(&g->l, &g->b, &at, STOPPED))
        return COIN_OK;
    *g = before;
    return COIN_ESTEP;
}

/* Lets the time pass until the coin lies flat, at t0, if it is too flat and too
 * slow to rise again and its losses never stop the contact.  Its energy is then
 * proportional to (t0 - t)^2.  Returns 0, and does nothing, for other coins, or
 * if the time left is shorter. */
COIN_PRIV_NOINLINE int end(struct settling *g, const coinf_priv_variables *y)
{
    const float Mgac = g->b.Mga * y->cth;
    const float E =
        (g->l.J * y->wX * y->wX + g->l.IX * y->wY * y->wY) / 2 + Mgac;
    if (!(y->cth < END && E < TOO_SLOW * Mgac))
        return 0;
    const float power = coinf_priv_endless_power(&g->l, y);
    if (!(power > 0 && 2 * E * y->cth <= power * g->rem))
        return 0;
    pass(g, 2 * E * y->cth / power);
    return 1;
}

/* Moves the coin until the time is over, or it rests, or a step fails or is one
 * too many. */
static int32_t approach(struct settling *g)
{
    for (int32_t steps = 0; g->rem > 0; ++steps) {
        const coinf_priv_variables y = coinf_priv_variables_with_low(&g->s);
        if (y.cth < FLAT || end(g, &y))
            return lay(g);
        if (coinf_priv_is_held(&g->l, &g->b, &y, STOPPED)) {
            const int32_t status = fall_or_rise(g, &y);
            if (status == COIN_RESTS)
                return status;
            if (status == COIN_OK)
                continue;
        }
        const float full = longest(g, &y);
        const float dt = full < g->rem ? full : g->rem;
        if (steps == STEPS_MAX || !lossy_step(g, &y, dt))
            return COIN_ESTEP;
        pass(g, dt);
    }
    return COIN_OK;
}

int32_t coinf_settle(coinf_state *s, const coinf_params *p,
                     const coinf_losses *l, float t, float tol, float *reached)
{
    struct settling g;
    if (!s || !p || !l || !(tol >= 1e-6f && tol <= 1e-2f))
        return COIN_EARG;
    if (coinf_losses_check(l, p) != COIN_OK)
        return COIN_EPARAMS;
    int32_t status = coinf_priv_check(s, p, &g.b);
    if (status != COIN_OK)
        return status;
    if (!(t >= 0 && coinf_priv_time_holds(t, &g.b)))
        return COIN_ESTEP;
    const float stride = STRIDE * sqrtf(sqrtf(tol));
    g.s = *s;
    g.rem = t;
    g.rem_low = 0;
    g.stride = stride < LONGEST ? stride : LONGEST;
    (void)coinf_priv_losses_of(&g.l, l, &g.b);
    status = coinf_priv_lies_flat(s) ? COIN_RESTS : approach(&g);
    /* For a body next to the limits of coinf_params the rates of a fall may
     * exceed what a state may have. */
    const int lost = !coinf_priv_state_holds(&g.s, &g.b);
    if (!lost)
        *s = g.s;
    if (reached)
        *reached = lost ? 0 : g.rem > 0 ? (t - g.rem) - g.rem_low : t;
    return lost || status == COIN_ESTEP ? coinf_priv_refusal(s, g.b.a) : status;
}
