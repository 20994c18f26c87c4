/* SPDX-License-Identifier: MIT */
/* A coin_body: its ranges, its units and its mode. */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "coin_body.h"

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
    return natural->y - at->th.c >= -COIN_PRIV_TOUCH_GAP ? COIN_OK
                                                         : COIN_ESTATE;
}

int coin_priv_body_lies(const coin_body *b)
{
    return fabs(b->s.theta) >= COIN_PRIV_LAST_LEAN && b->s.wX == 0 &&
           b->s.wY == 0;
}

int coin_priv_body_mode(const coin_body *b, const coin_priv_attitude *at,
                        double u[2])
{
    u[0] = u[1] = 0;
    if (b->y - at->th.c > COIN_PRIV_TOUCH_GAP)
        return COIN_PRIV_AIR;
    const coin_priv_rim rim = coin_priv_rim_of(b, at);
    const double turn = fabs(b->s.wZ), turns = fabs(b->s.wX) + turn;
    if (fabs(rim.y) > COIN_PRIV_SLIP_LEAST)
        return COIN_PRIV_AIR;
    if (coin_priv_body_lies(b)) {
        const double v = sqrt(b->vx * b->vx + b->vz * b->vz);
        return v + turn <= COIN_PRIV_SLIP_LEAST ? COIN_PRIV_RESTS
                                                : COIN_PRIV_LIES;
    }
    if (sqrt(rim.X * rim.X + rim.h * rim.h) <=
        COIN_PRIV_SLIP_LEAST + COIN_PRIV_TOUCH_GAP * turns)
        return 0;
    u[0] = rim.X;
    u[1] = rim.h;
    return COIN_PRIV_SLIPS;
}

int32_t coin_priv_check_coin_body(coin_body *natural, coin_priv_attitude *at,
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
