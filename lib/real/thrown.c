/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "flat_slide.h"
#include "thrown.h"

/* No status: the way goes on. */
#define UNDER_WAY (1 << 20)

/* An impact at a smaller speed does not bounce, (114): a choice of the model,
 * which coin.h states.  A coin nearer to flat than `flat` lies down at it. Half
 * or twice of it makes other tosses that cost the same (make tuning). */
#define PLASTIC 1e-4

static double time_left(const coin_priv_thrown *w)
{
    return (w->time - w->moved.sum) - w->moved.low;
}

/* Adds a time that has been moved, at most `left`. */
static void spend(coin_priv_thrown *w, double t, double left)
{
    w->changed = 1;
    if (t < left) {
        coin_priv_add(&w->moved, t);
    } else {
        w->moved.sum = w->time;
        w->moved.low = 0;
    }
}

/* Takes another body, or returns `refusal` if one of its members is out of
 * range. */
static int32_t take(coin_priv_thrown *w, const coin_body *to,
                    const coin_priv_attitude *at, int32_t refusal)
{
    if (!coin_priv_members_hold(to, 1, 1))
        return refusal;
    w->b = *to;
    w->at = *at;
    w->changed = 1;
    return UNDER_WAY;
}

static void flight_of(coin_priv_flight *f, const coin_priv_thrown *w)
{
    coin_priv_flight_of(f, &w->b, &w->at, w->g.law.IX, w->g.law.IZ);
}

/* Whether a body stays in range while it flies for a time.  Its wX and wY turn
 * into each other. */
static int32_t check_flight(const coin_body *b, double t)
{
    const double rise = coin_priv_lesser(t, b->vy), wX = b->s.wX, wY = b->s.wY;
    const double top = rise > 0 ? b->y + rise * (b->vy - rise / 2) : b->y;
    if (!(fabs(b->s.x + b->vx * t) <= COIN_PRIV_PLACE_MAX &&
          fabs(b->s.z + b->vz * t) <= COIN_PRIV_PLACE_MAX &&
          top <= COIN_PRIV_PLACE_MAX))
        return COIN_ERANGE;
    return sqrt(wX * wX + wY * wY) <= COIN_PRIV_RATE_MAX &&
                   t - b->vy <= COIN_PRIV_RATE_MAX
               ? UNDER_WAY
               : COIN_ESTEP;
}

/* Flies for a time.  The coin comes down on the table if `touches`, or if
 * rounding took it there. */
static int32_t fly_for(coin_priv_thrown *w, const coin_priv_flight *f, double t,
                       int touches)
{
    const double left = time_left(w);
    const int32_t status = check_flight(&w->b, t);
    if (status != UNDER_WAY)
        return status;
    coin_priv_fly(&w->b, &w->at, f, t);
    if (touches || w->b.y < w->at.th.c) {
        w->b.y = w->at.th.c;
        w->event = COIN_TOUCHES;
    }
    spend(w, t, left);
    return UNDER_WAY;
}

/* Flies to the next touch. */
static int32_t fly(coin_priv_thrown *w, int leaves)
{
    coin_priv_flight f;
    flight_of(&f, w);
    const coin_priv_touch to = coin_priv_first_touch(&f, time_left(w), leaves);
    return fly_for(w, &f, to.t, to.touches);
}

/* Leaves the table with no normal speed.  The gap is looked at after a time:
 * until then it is rounding.  A touch that this misses is less than 1e-12
 * deep. */
static int32_t lift_off(coin_priv_thrown *w)
{
    const double t =
        coin_priv_lesser(coin_priv_blind(w->g.step.y), time_left(w));
    coin_priv_flight f;
    flight_of(&f, w);
    return fly_for(w, &f, t, 0);
}

static void lie_down(coin_body *b, coin_priv_attitude *at)
{
    b->s.theta = copysign(COIN_PRIV_LAST_LEAN, b->s.theta);
    b->s.wX = b->s.wY = b->vy = 0;
    *at = coin_priv_attitude_of(&b->s);
    b->y = at->th.c;
}

/* The impact that is due.  up: the normal speed of the lowest point. */
static int32_t hit(coin_priv_thrown *w, double up)
{
    const coin_priv_law *const l = &w->g.law;
    const int slow = up > -PLASTIC; /* (114) */
    const coin_priv_bounce law = {
        slow ? 0 : w->restitution,
        l->mu_static,
        l->mu_kinetic,
    };
    coin_body to = w->b;
    coin_priv_attitude at = w->at;
    if (slow && at.th.c < l->flat)
        lie_down(&to, &at); /* (115) */
    else
        coin_priv_impact(&to, &at, l->IX, l->IZ, &law);
    w->event = COIN_ROLLS; /* counts if it rolls then, not if it bounces */
    return take(w, &to, &at, COIN_ESTEP);
}

static int32_t in_air(coin_priv_thrown *w)
{
    const int32_t bits = w->stop & (COIN_LIFTS | (w->event & COIN_TOUCHES));
    w->event = 0;
    if (bits || !(time_left(w) > 0))
        return COIN_LIFTS | bits;
    const int low = w->b.y - w->at.th.c <= COIN_PRIV_TOUCH_GAP;
    const double up = low ? coin_priv_rim_of(&w->b, &w->at).y : 0;
    return up < 0 ? hit(w, up) : fly(w, low);
}

static int32_t on_face(coin_priv_thrown *w)
{
    const double left = time_left(w);
    const int32_t bits =
        w->stop & (COIN_SLIPS | COIN_NEARLY_FLAT | (w->event & COIN_TOUCHES));
    if (bits || !(left > 0))
        return COIN_SLIPS | bits;
    coin_body to = w->b;
    to.y = w->at.th.c;
    const double t = coin_priv_slide_flat(&to, &w->g, left);
    const int32_t status = take(w, &to, &w->at, COIN_ERANGE);
    if (status == UNDER_WAY)
        spend(w, t, left);
    return status;
}

/* Sets *b to where the contact has come to. */
static void end_contact(coin_priv_thrown *w)
{
    coin_body *const b = &w->b;
    const coin_priv_moving *const g = &w->g;
    const double uX = g->step.y[COIN_PRIV_UX], uh = g->step.y[COIN_PRIV_UH];
    coin_priv_end(g, &b->s);
    if (g->mode & COIN_PRIV_RESTS)
        b->s.wX = b->s.wY = 0;
    w->at = coin_priv_attitude_of(&b->s);
    coin_priv_set_rolling(b, &w->at, 1);
    if (g->mode & (COIN_PRIV_SLIPS | COIN_PRIV_RESTS)) {
        const coin_priv_sc ph = w->at.ph;
        b->vx += uX * ph.c + uh * ph.s;
        b->vz += uh * ph.c - uX * ph.s;
    }
}

static int32_t in_contact(coin_priv_thrown *w, int mode, const double u[2])
{
    coin_priv_moving *const g = &w->g;
    const double left = time_left(w);
    double unused[2];
    const coin_priv_variables v = coin_priv_attitude_variables(&w->b.s, &w->at);
    coin_priv_begin(g, &w->b.s, &v, mode, u, left, w->tol);
    const int32_t status = coin_priv_go(g, w->stop, w->event);
    w->event = 0;
    if (g->changed) {
        const double after = coin_priv_time_left(g);
        end_contact(w);
        spend(w, after > 0 ? g->pose[4].sum + g->pose[4].low : left, left);
    }
    if (status < 0)
        return status;
    if (g->mode & COIN_PRIV_RESTS)
        return UNDER_WAY;
    if (g->mode & COIN_PRIV_AIR) {
        /* damping is for coins that roll */
        const int ends = status || !(time_left(w) > 0) || g->law.damping > 0;
        return ends ? COIN_LIFTS | status : lift_off(w);
    }
    /* A slip may be so slow that the body does not show it. */
    if (g->mode & COIN_PRIV_SLIPS &&
        coin_priv_body_mode(&w->b, &w->at, unused) & COIN_PRIV_SLIPS)
        return COIN_SLIPS | status;
    return status;
}

/* One mode. */
static int32_t move_on(coin_priv_thrown *w)
{
    double u[2];
    const int mode = coin_priv_body_mode(&w->b, &w->at, u);
    if (mode & COIN_PRIV_AIR)
        return in_air(w);
    if (mode & COIN_PRIV_RESTS) {
        w->b.s.wZ = w->b.vx = w->b.vy = w->b.vz = 0;
        return COIN_RESTS;
    }
    return mode & COIN_PRIV_LIES ? on_face(w) : in_contact(w, mode, u);
}

int32_t coin_priv_go_on(coin_priv_thrown *w)
{
    int32_t status = UNDER_WAY;
    while (status == UNDER_WAY)
        status = --w->g.tries > 0 ? move_on(w) : COIN_ESTEP;
    return status;
}
