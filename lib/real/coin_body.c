/* SPDX-License-Identifier: MIT */
/* A coin_body: its ranges, its units and its mode. */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "coin_body.h"

int coin_priv_body_in_range(const coin_body *b, double length, double rate)
{
    const double far = COIN_PRIV_PLACE_MAX * length;
    const double most = COIN_PRIV_RATE_MAX * rate, fast = most * length;
    return coin_priv_members_in_range(&b->s, far, most * most) &
           (fabs(b->y) <= far) & (fabs(b->vx) <= fast) & (fabs(b->vy) <= fast) &
           (fabs(b->vz) <= fast);
}

int coin_priv_coin_in_range(const coin_priv_coin *c)
{
    const double far = COIN_PRIV_PLACE_MAX, fast = COIN_PRIV_RATE_MAX;
    return (fabs(c->psi.sum) <= COIN_PRIV_ANGLE_MAX) & (fabs(c->x.sum) <= far) &
           (fabs(c->z.sum) <= far) & (fabs(c->y) <= far) &
           (fabs(c->wX) <= fast) & (fabs(c->wY) <= fast) &
           (fabs(c->wZ) <= fast) & (fabs(c->vx) <= fast) &
           (fabs(c->vy) <= fast) & (fabs(c->vz) <= fast);
}

void coin_priv_turn_axes(coin_priv_coin *c)
{
    const double side = c->th.s < 0 ? -1 : 1;
    const double w = sqrt(c->wX * c->wX + c->wY * c->wY);
    if (!(c->th.c <= COIN_PRIV_TOUCH_GAP && w > 0))
        return;
    const coin_priv_sc by = {c->wY / w, -side * (c->wX / w)}, ph = c->ph;
    const double angle = coin_priv_angle(by);
    coin_priv_add(&c->phi, angle);
    coin_priv_add(&c->psi, side * angle);
    c->ph.s = ph.s * by.c + ph.c * by.s;
    c->ph.c = ph.c * by.c - ph.s * by.s;
    c->wX = -side * w;
    c->wY = 0;
}

int32_t coin_priv_coin_of(coin_priv_coin *c, const coin_body *b,
                          const coin_priv_constants *of, double half)
{
    const double w0 = sqrt(of->g_a), per = 1 / (of->a * w0);
    if (!coin_priv_body_in_range(b, of->a, w0) ||
        !coin_priv_are_zero(b->reserved, 4))
        return COIN_ESTATE;
    coin_state s = b->s;
    coin_priv_scale(&s, 1 / of->a, 1 / w0);
    coin_priv_set_state(c, &s, half);
    coin_priv_turn_axes(c);
    c->y = b->y / of->a;
    c->vx = b->vx * per;
    c->vy = b->vy * per;
    c->vz = b->vz * per;
    return coin_priv_gap(c) >= -COIN_PRIV_TOUCH_GAP * (1 + half) ? COIN_OK
                                                                 : COIN_ESTATE;
}

void coin_priv_body_of(coin_body *b, const coin_priv_coin *c,
                       const coin_priv_constants *of)
{
    const double a = of->a, w0 = sqrt(of->g_a);
    coin_priv_get_state(&b->s, c);
    coin_priv_scale(&b->s, a, w0);
    b->y = a * c->y;
    b->vx = a * w0 * c->vx;
    b->vy = a * w0 * c->vy;
    b->vz = a * w0 * c->vz;
}

void coin_priv_set_on_table(coin_body *b, double a, double half, double tips,
                            int slips)
{
    coin_priv_coin c;
    coin_priv_set_state(&c, &b->s, half);
    const double lower = coin_priv_lower_rim(&c);
    coin_priv_set_rolling(&c, lower != 0 ? lower : tips);
    b->y = a * c.y;
    b->vy = a * c.vy;
    b->vx = slips ? b->vx : a * c.vx;
    b->vz = slips ? b->vz : a * c.vz;
}

/* Whether a coin that lies and hardly moves stays where it is. */
static int holds_on(const coin_priv_law *l)
{
    return coin_priv_pull(l) <= l->mu_static; /* (127) */
}

/* Whether a coin stands on its edge and nothing leans it. */
static int stands(const coin_priv_coin *c, const coin_priv_law *l, double v)
{
    return c->th.s == 0 && c->wX == 0 && c->wY == 0 && coin_priv_pull(l) == 0 &&
           coin_priv_larger(v, fabs(c->wZ)) < COIN_PRIV_SLIP_LEAST;
}

int coin_priv_coin_mode(const coin_priv_coin *c, const coin_priv_law *l,
                        double u[2])
{
    u[0] = u[1] = 0;
    if (!coin_priv_is_low(c))
        return COIN_PRIV_AIR;
    const double eta = coin_priv_lower_rim(c), roll = fabs(c->wZ);
    const coin_priv_rim rim = coin_priv_rim_of(c, eta);
    const double turns = fabs(c->wX) + roll + (eta != 0 ? fabs(c->wY) : 0);
    const double rounding = COIN_PRIV_TOUCH_GAP * (1 + c->half) * turns;
    if (fabs(rim.y) > COIN_PRIV_SLIP_LEAST + rounding)
        return COIN_PRIV_AIR;
    const double v = sqrt(c->vx * c->vx + c->vz * c->vz);
    if (coin_priv_lies(c))
        return v + roll <= COIN_PRIV_SLIP_LEAST && holds_on(l) ? COIN_PRIV_RESTS
                                                               : COIN_PRIV_LIES;
    if (stands(c, l, v))
        return COIN_PRIV_RESTS;
    if (c->half > 0 && eta == 0)
        return COIN_PRIV_LINE;
    if (sqrt(rim.X * rim.X + rim.h * rim.h) <= COIN_PRIV_SLIP_LEAST + rounding)
        return 0;
    u[0] = rim.X;
    u[1] = rim.h;
    return COIN_PRIV_SLIPS;
}

int coin_priv_tip_mode(const coin_priv_coin *c, double eta, double u[2])
{
    const coin_priv_rim rim = coin_priv_rim_of(c, eta);
    u[0] = rim.X;
    u[1] = rim.h;
    return sqrt(u[0] * u[0] + u[1] * u[1]) > COIN_PRIV_SLIP_LEAST
               ? COIN_PRIV_SLIPS
               : 0;
}

int32_t coin_priv_check_coin_body(coin_priv_coin *c, const coin_body *b,
                                  const coin_params *p, coin_priv_constants *of)
{
    if (!b || !p)
        return COIN_EARG;
    if (coin_priv_check_thick(of, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_coin_of(c, b, of, coin_priv_half_of(p));
}

int32_t coin_body_from_state(coin_body *b, const coin_state *s,
                             const coin_params *p)
{
    coin_priv_constants of;
    if (!b || !s || !p)
        return COIN_EARG;
    if (coin_priv_check_thick(&of, p) != COIN_OK)
        return COIN_EPARAMS;
    if (!coin_priv_state_in_range(s, &of))
        return COIN_ESTATE;
    const double half = coin_priv_half_of(p);
    coin_body made = {*s, 0, 0, 0, 0, {0, 0, 0, 0}};
    coin_priv_coin c;
    coin_priv_set_on_table(&made, of.a, half, 0, 0);
    const int32_t good = coin_priv_coin_of(&c, &made, &of, half);
    if (good == COIN_OK)
        *b = made;
    return good;
}
