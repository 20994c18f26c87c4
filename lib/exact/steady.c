/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "steady.h"

#include <math.h>

/* A state is steady if (39) holds to this part of its terms: far above the
 * rounding of a long run, and far below a visible swing. */
#define STEADY 1e-9

/* The largest tan theta of coin_steady_ride().  Nearer to flat the rounding of
 * theta changes the speed by more than STEADY. */
#define STEEPEST 1e7

int32_t coin_priv_check_steady(const coin_state *s, const coin_params *p,
                               coin_priv_constants *b, coin_priv_sc *th)
{
    const int32_t status = coin_priv_check(s, p, b);
    if (status != COIN_OK)
        return status;
    *th = coin_priv_sincos(s->theta);
    const double wX = s->wX, wY = s->wY, wZ = s->wZ;
    /* clang-format off */
    const double roll = b->K * wZ * wY;                 /* (39) */
    const double turn = b->IX * wY * wY * th->s / th->c; /* (39) */
    const double fall = b->Mga * th->s;                 /* (39) */
    /* clang-format on */
    const double rate =
        coin_priv_larger(coin_priv_larger(fabs(wY), fabs(wZ)), sqrt(b->g_a));
    const double torque =
        coin_priv_larger(coin_priv_larger(fabs(roll), fabs(turn)), b->Mga);
    const int balanced = (fabs(wX) <= STEADY * rate) &
                         (fabs(roll + turn - fall) <= STEADY * torque);
    return balanced ? COIN_OK : COIN_EDOMAIN;
}

/* Makes *s the state with this lean and these rates, if they are in range. */
static int32_t steady(coin_state *s, const coin_params *p, double theta,
                      double wY, double wZ)
{
    const coin_state made = {theta, 0, 0, 0, 0, 0, wY, wZ};
    coin_priv_constants b;
    const int32_t status = s ? coin_priv_check(&made, p, &b) : COIN_EARG;
    if (status == COIN_OK)
        *s = made;
    return status;
}

int32_t coin_steady_roll(coin_state *s, const coin_params *p, double wZ)
{
    return steady(s, p, 0, 0, wZ);
}

int32_t coin_steady_upright_spin(coin_state *s, const coin_params *p, double wY)
{
    return steady(s, p, 0, wY, 0);
}

int32_t coin_steady_spin(coin_state *s, const coin_params *p, double theta)
{
    coin_priv_constants b;
    /* The checks of a coin at rest with this lean find every error except a
     * spin out of range, which steady() finds. */
    const coin_state rest = {theta, 0, 0, 0, 0, 0, 0, 0};
    const int32_t status = s ? coin_priv_check(&rest, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double cth = coin_priv_sincos(theta).c;
    return steady(s, p, theta, sqrt(b.Mga / b.IX * cth), 0); /* (42) */
}

int32_t coin_steady_circle(coin_state *s, const coin_params *p, double theta,
                           double wZ, int32_t branch)
{
    coin_priv_constants b;
    const coin_state asked = {theta, 0, 0, 0, 0, 0, 0, wZ};
    int32_t status = s && (branch == 1 || branch == -1)
                         ? coin_priv_check(&asked, p, &b)
                         : COIN_EARG;
    if (status == COIN_OK && theta == 0)
        status = COIN_EDOMAIN;
    if (status != COIN_OK)
        return status;
    /* A wY^2 + wZ wY - G = 0: Eq. (39) over K; root^2 = wZ^2 + 4 A G. */
    const coin_priv_sc th = coin_priv_sincos(theta);
    const double A = b.IX / b.K * (th.s / th.c), G = b.Mga / b.K * th.s;
    const double rest = sqrt(b.IX / b.K * (b.Mga / b.K) / th.c);
    const double root = coin_priv_hypot(wZ, 2 * th.s * rest);
    /* q/A, where nothing cancels, is the root f- of (40), or f+ if wZ < 0. */
    const double q = -(wZ + (wZ < 0 ? -root : root)) / 2; /* (40) */
    const int large = (branch < 0) == !(wZ < 0);
    if (q == 0) /* wZ = 0, and theta is next to 0 */
        return COIN_EDOMAIN;
    const double wY = large ? q / A : -G / q; /* (41) */
    return steady(s, p, theta, wY, wZ);
}

int32_t coin_steady_turn(coin_state *s, const coin_params *p, double theta,
                         double radius)
{
    coin_priv_constants b;
    const coin_state asked = {theta, 0, 0, 0, 0, 0, 0, 0};
    const int32_t status =
        s && radius >= 0 ? coin_priv_check(&asked, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (theta == 0 || !(radius <= COIN_PRIV_PLACE_MAX * b.a))
        return COIN_EDOMAIN;
    if (radius == 0)
        return coin_steady_spin(s, p, theta);
    const coin_priv_sc th = coin_priv_sincos(theta);
    const double sth = fabs(th.s), r = radius / b.a;
    const double part = sth / (r + b.IX / b.K * sth);
    const double wY = sqrt(b.Mga / b.K) * sqrt(th.c * part); /* (93) */
    const double wZ = wY / th.c * r;
    return steady(s, p, theta, wY, theta < 0 ? -wZ : wZ);
}

/* tan theta of (94), at a given roll and rate of turning.  Newton's method from
 * above: the left side minus the right one is convex, so that the tangents
 * decrease until rounding ends that.  1 - B cos theta is computed as (1 - B +
 * e) cos theta, e = 1/cos theta - 1, in which nothing cancels for small and for
 * large leans. */
static double tangent_of(const coin_priv_constants *b, double wZ, double turn)
{
    const double A = b->K / b->Mga * wZ * turn;    /* (94) */
    const double B = b->IX / b->Mga * turn * turn; /* (94) */
    double T = A + B;
    for (;;) {
        const double q = sqrt(1 + T * T), e = T * T / (q + 1);
        const double excess = T * (1 - B + e) / q - A; /* (94) */
        const double slope = (1 - B + e * (q * q + q + 1)) / (q * q * q);
        const double next = T - excess / slope;
        if (!(next < T))
            return next;
        T = next;
    }
}

int32_t coin_steady_ride(coin_state *s, const coin_params *p, double speed,
                         double radius)
{
    coin_priv_constants b;
    int32_t status = s && speed > 0 && radius > 0 && p
                         ? coin_priv_check_params(&b, p)
                         : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_state asked = {0, 0, 0, 0, 0, 0, 0, speed / b.a};
    status = coin_priv_check(&asked, p, &b);
    if (status != COIN_OK)
        return status;
    /* 1/cos theta > B, so that T is above STEEPEST where B is. */
    if (!(radius >= speed / sqrt(STEEPEST * b.Mga / b.IX)))
        return COIN_EDOMAIN;
    const double T = tangent_of(&b, asked.wZ, speed / radius);
    if (!(T <= STEEPEST))
        return COIN_EDOMAIN;
    const double q = sqrt(1 + T * T);
    const coin_priv_sc th = {T / q, 1 / q};
    return coin_steady_turn(s, p, coin_priv_angle(th), radius);
}

int32_t coin_steady_radii(const coin_state *s, const coin_params *p,
                          double *center, double *contact)
{
    coin_priv_constants b;
    coin_priv_sc th;
    const int32_t status =
        center && contact ? coin_priv_check_steady(s, p, &b, &th) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double wY = s->wY, wZ = s->wZ;
    const int straight = fabs(wY) * COIN_PRIV_PLACE_MAX <= fabs(wZ * th.c);
    *center =
        straight ? (double)INFINITY : b.a * fabs(wZ * th.c / wY); /* (43) */
    *contact = straight ? (double)INFINITY
                        : b.a * fabs(wZ * th.c / wY + th.s); /* (43) */
    return COIN_OK;
}
