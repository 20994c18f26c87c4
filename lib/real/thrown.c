/* SPDX-License-Identifier: MIT */
/* A coin on its way through all modes: in the air, in contact, flat. */
#include "../motion/pinned.h"

#include "coin_body.h"
#include "flat_slide.h"
#include "line.h"

/* No status: the way goes on. */
#define UNDER_WAY (1 << 20)

/* An impact at a smaller speed does not bounce, (114): a choice of the model,
 * which coin.h states.  A coin nearer to flat than `flat` lies down at it.
 * Measured: PLASTIC in tables.md. */
#define PLASTIC 1e-4

/* A coin that passes upright at less than this part of h stands on both rims: a
 * choice of the model.  It drops less than 1.3e-4 of the energy that it takes
 * to turn over. */
#define STANDS 1e-2

static void spend(coin_priv_moving *g, double t)
{
    g->changed = 1;
    coin_priv_spend(g, t, !(t < coin_priv_time_left(g)));
}

/* Sets g->c to another coin, if that is in range. */
static int32_t take(coin_priv_moving *g, const coin_priv_coin *to)
{
    if (!coin_priv_coin_in_range(to))
        return COIN_ERANGE;
    g->c = *to;
    g->changed = 1;
    return UNDER_WAY;
}

static void flight_of(coin_priv_flight *f, const coin_priv_moving *g)
{
    const coin_priv_law *const l = &g->law;
    coin_priv_flight_of(f, &g->c, l->IX, l->IZ, l->angular);
    f->pull[0] = l->pull[0];
    f->pull[1] = l->pull[1];
}

static int32_t decided(const coin_priv_moving *g)
{
    return g->stop & COIN_DECIDED && coin_priv_undecided(&g->c, &g->law) < 0
               ? COIN_DECIDED
               : 0;
}

/* Moves the coin for a time t, or until its mode ends, reads its energy, and
 * puts the coin, the time and the number of trials back.  It flies by *f; where
 * f is null, it is on its face or on both rims.  Returns the time moved.
 * *above: by how much the energy is above that of balancing, plus the rounding
 * of a body's members. */
static double try_for(coin_priv_moving *g, const coin_priv_flight *f, double t,
                      double *above)
{
    const coin_priv_coin c = g->c;
    const coin_priv_sum moved = g->moved;
    const double time = g->time;
    const int tries = g->tries;
    int why, over;
    g->time = moved.sum + t;
    if (f) {
        coin_priv_fly(&g->c, f, t);
    } else if (coin_priv_lies(&g->c)) {
        t = coin_priv_slide_flat(&g->c, g, t);
    } else {
        (void)coin_priv_move_on_line(g, &why, &over);
        t = g->moved.sum - moved.sum;
    }
    *above = coin_priv_undecided(&g->c, &g->law) + 4 * COIN_PRIV_BEYOND;
    g->c = c;
    g->moved = moved;
    g->time = time;
    g->tries = tries;
    return t;
}

/* The time until it is decided which side ends up; t if it is not within t. */
static double until_decided(coin_priv_moving *g, const coin_priv_flight *f,
                            double t)
{
    double above, a = 0;
    if (!(g->stop & COIN_DECIDED))
        return t;
    double b = try_for(g, f, t, &above);
    if (!(above < 0))
        return t;
    const double width = g->tol / 1024 + 4 * DBL_EPSILON * b;
    while (b - a > width) {
        const double x = (a + b) / 2;
        (void)try_for(g, f, x, &above);
        *(above < 0 ? &b : &a) = x;
    }
    return b;
}

/* Whether a coin stays in range while it flies for a time.  Its wX and wY turn
 * into each other. */
static int flies_within(const coin_priv_coin *c, const double pull[2], double t)
{
    const double rise = coin_priv_lesser(t, c->vy);
    coin_priv_coin to = *c;
    to.y = rise > 0 ? c->y + rise * (c->vy - rise / 2) : c->y;
    to.x.sum += t * (c->vx + pull[0] * t / 2);
    to.z.sum += t * (c->vz + pull[1] * t / 2);
    to.vx += pull[0] * t;
    to.vy -= t;
    to.vz += pull[1] * t;
    to.wX = sqrt(c->wX * c->wX + c->wY * c->wY);
    return coin_priv_coin_in_range(&to);
}

/* The normal speed of the lowest point, if it is on the table; else 0. */
static double normal_speed(const coin_priv_coin *c)
{
    return coin_priv_is_low(c) ? coin_priv_rim_of(c, coin_priv_lower_rim(c)).y
                               : 0;
}

/* Ends the call before an impact, if it is asked for. */
static void come_down(coin_priv_moving *g)
{
    if (g->stop & COIN_TOUCHES && normal_speed(&g->c) < -COIN_PRIV_SLIP_LEAST)
        coin_priv_end_here(g, COIN_TOUCHES);
}

/* Flies for a time, at the end of which the coin comes down on the table if
 * `touches`. */
static int32_t fly_for(coin_priv_moving *g, const coin_priv_flight *f, double t,
                       int touches)
{
    if (!flies_within(&g->c, f->pull, t))
        return COIN_ERANGE;
    const double end = until_decided(g, f, t);
    coin_priv_fly(&g->c, f, end);
    coin_priv_set_upright(&g->c);
    coin_priv_turn_axes(&g->c);
    const double height = coin_priv_height(&g->c);
    g->c.y = touches && end == t ? height : coin_priv_larger(g->c.y, height);
    spend(g, end);
    come_down(g);
    return UNDER_WAY;
}

/* Flies to the next touch. */
static int32_t fly(coin_priv_moving *g, int leaves)
{
    coin_priv_flight f;
    flight_of(&f, g);
    const coin_priv_touch to =
        coin_priv_first_touch(&f, coin_priv_time_left(g), leaves);
    return fly_for(g, &f, to.t, to.touches);
}

/* Leaves the table with no normal speed.  For the time coin_priv_blind() the
 * gap below the rim that leaves is smaller than its rounding, and is not
 * computed.  The other rim may come down in that time; where it is down
 * already, the coin stays on both. */
static int32_t lift_off(coin_priv_moving *g)
{
    const double t =
        coin_priv_lesser(coin_priv_blind(g->step.y), coin_priv_time_left(g));
    const int upright = g->c.th.s == 0;
    coin_priv_touch to = {t, 0, 0};
    coin_priv_flight f;
    flight_of(&f, g);
    if (g->law.eta != 0)
        to = coin_priv_rim_touch(&f, -g->law.eta, t, upright);
    if (!(upright && to.touches && to.t <= DBL_EPSILON))
        return fly_for(g, &f, to.t, to.touches);
    g->c.wX = g->c.vy = 0;
    g->changed = 1;
    return UNDER_WAY;
}

static void lie_down(coin_priv_coin *c, const coin_priv_law *l)
{
    const coin_priv_sc ph = c->ph;
    const double side = copysign(l->half, c->th.s);
    const double AX = -side * c->wY, Ah = l->half * c->wX;
    const double UX = c->vx * ph.c - c->vz * ph.s - AX;
    const double Uh = c->vx * ph.s + c->vz * ph.c - Ah;
    const double P = coin_priv_larger(0, -c->vy);
    const double q =
        coin_priv_face_grip(l, UX * UX + Uh * Uh, AX * AX + Ah * Ah, P, c->wZ);
    c->vx -= q * (AX * ph.c + Ah * ph.s);
    c->vz -= q * (Ah * ph.c - AX * ph.s);
    c->th.s = copysign(1, c->th.s);
    c->th.c = c->wX = c->wY = c->vy = 0;
    c->y = coin_priv_height(c);
}

/* Ends rocking: a coin that is upright on one rim then stands on both.  Rocking
 * moves the centre at |wX| along e_h.  Friction takes up to that from the
 * velocity along e_h; on ice it takes nothing. */
static void stand(coin_priv_coin *c, double mu)
{
    const coin_priv_sc ph = c->ph;
    const double vh = c->vx * ph.s + c->vz * ph.c;
    const double part = coin_priv_lesser(fabs(vh), fabs(c->wX));
    const double dv = mu > 0 ? copysign(part, vh) : 0;
    c->vx -= dv * ph.s;
    c->vz -= dv * ph.c;
    c->vy = c->wX = 0;
}

/* The impact that is due.  up: the normal speed of the lowest point. */
static int32_t hit(coin_priv_moving *g, double up)
{
    const coin_priv_law *const l = &g->law;
    const int is_plastic = up > -PLASTIC; /* (114) */
    const coin_priv_bounce law = {
        is_plastic ? 0 : l->restitution,
        l->mu_static,
        l->mu_kinetic,
    };
    coin_priv_coin to = g->c;
    if (is_plastic && to.th.c < l->flat)
        lie_down(&to, l); /* (115) */
    else if (to.th.c <= COIN_PRIV_TOUCH_GAP && to.wX == 0)
        to.vy *= -law.restitution; /* no point is lowest */
    else
        coin_priv_impact(&to, coin_priv_lower_rim(&to), l->IX, l->IZ, &law);
    if (to.th.s == 0 && law.restitution == 0 && fabs(to.wX) < STANDS * l->half)
        stand(&to, law.mu_static); /* (128) */
    return take(g, &to);
}

static int32_t in_air(coin_priv_moving *g)
{
    const double up = normal_speed(&g->c);
    /* A coin that rocks from rim to rim does not leave the table. */
    if (!(up < 0 && g->was >= 0))
        coin_priv_moments(g, COIN_LIFTS | decided(g));
    if (!(coin_priv_time_left(g) > 0))
        return COIN_LIFTS;
    return up < 0 ? hit(g, up) : fly(g, up > 0);
}

static int32_t on_face(coin_priv_moving *g)
{
    coin_priv_moments(g, COIN_SLIPS | COIN_NEARLY_FLAT | decided(g));
    if (!(coin_priv_time_left(g) > 0))
        return COIN_SLIPS;
    coin_priv_coin to = g->c;
    const double end = until_decided(g, 0, coin_priv_time_left(g));
    const double t = coin_priv_slide_flat(&to, g, end);
    const int32_t status = take(g, &to);
    if (status == UNDER_WAY)
        spend(g, t);
    return status;
}

/* Stops what is left of the motion. */
static int32_t at_rest(coin_priv_moving *g)
{
    coin_priv_coin *const c = &g->c;
    const int moves =
        c->wY != 0 || c->wZ != 0 || c->vx != 0 || c->vy != 0 || c->vz != 0;
    const int32_t low = c->th.c < COIN_PRIV_NEARLY_FLAT ? COIN_NEARLY_FLAT : 0;
    c->wY = c->wZ = c->vx = c->vy = c->vz = 0;
    coin_priv_moments(g, COIN_RESTS | low | decided(g));
    g->changed |= moves && g->time > 0;
    return COIN_RESTS;
}

/* On the rim at eta. */
static int32_t in_contact(coin_priv_moving *g, int mode, double eta,
                          const double u[2])
{
    const int before = g->changed;
    g->law.eta = eta;
    g->changed = 0;
    coin_priv_begin(g, mode, u);
    const int32_t status = coin_priv_go(g);
    const int changed = g->changed;
    g->changed |= before;
    if (status != COIN_OK)
        return status;
    if (g->mode & COIN_PRIV_LIES)
        lie_down(&g->c, &g->law);
    if (g->mode & COIN_PRIV_AIR && coin_priv_time_left(g) > 0)
        return lift_off(g);
    if (g->mode & COIN_PRIV_ROCKS) {
        come_down(g);
        if (normal_speed(&g->c) >= -COIN_PRIV_SLIP_LEAST)
            stand(&g->c, g->law.mu_static); /* no impact is due */
    }
    /* What it does where it has come to, its members say. */
    return changed ? UNDER_WAY : g->was & (COIN_SLIPS | COIN_LIFTS);
}

/* Over a rim of a coin on both. */
static int32_t tip(coin_priv_moving *g, double eta)
{
    double u[2];
    const int mode = coin_priv_tip_mode(&g->c, eta, u);
    return in_contact(g, mode, eta, u);
}

/* On both rims. */
static int32_t on_line(coin_priv_moving *g)
{
    g->law.eta = 0; /* it is not on one rim, unless it tips */
    const int tips = coin_priv_tips(&g->c, &g->law);
    if (tips)
        return tip(g, tips * g->law.half);
    const int mode = coin_priv_line_mode(&g->c, &g->law);
    if (mode & COIN_PRIV_RESTS)
        return at_rest(g);
    const int32_t slips = mode & COIN_PRIV_SLIPS ? COIN_SLIPS : 0;
    coin_priv_moments(g, slips | decided(g));
    if (!(coin_priv_time_left(g) > 0))
        return slips;
    const double left = coin_priv_time_left(g), end = until_decided(g, 0, left);
    if (end < left)
        g->time = g->moved.sum + end;
    int why, over;
    const int32_t status = coin_priv_move_on_line(g, &why, &over);
    if (status != COIN_OK)
        return status;
    return why == COIN_PRIV_LINE_TIPS ? tip(g, over * g->law.half) : UNDER_WAY;
}

/* Whether a coin lies and slides: its face does not stick. */
static int slides_on_face(const coin_priv_moving *g, int mode)
{
    return mode & COIN_PRIV_LIES && g->law.mu_static <= DBL_MAX;
}

/* One mode. */
static int32_t move_on(coin_priv_moving *g)
{
    double u[2];
    coin_priv_turn_axes(&g->c);
    const int mode = coin_priv_coin_mode(&g->c, &g->law, u);
    if (mode & COIN_PRIV_AIR)
        return in_air(g);
    if (slides_on_face(g, mode))
        return on_face(g);
    if (mode & (COIN_PRIV_RESTS | COIN_PRIV_LIES))
        return at_rest(g);
    return mode & COIN_PRIV_LINE
               ? on_line(g)
               : in_contact(g, mode, coin_priv_lower_rim(&g->c), u);
}

int32_t coin_priv_go_on(coin_priv_moving *g)
{
    int32_t status;
    if (coin_priv_undecided(&g->c, &g->law) < 0) /* it is decided already */
        g->stop &= ~COIN_DECIDED;
    do {
        if (--g->tries <= 0 && coin_priv_time_left(g) > 0)
            coin_priv_end_here(g, COIN_MORE);
        status = move_on(g);
    } while (status == UNDER_WAY);
    if (status & COIN_RESTS)
        g->found &= ~COIN_MORE;
    return status < 0 ? status : status | g->found;
}
