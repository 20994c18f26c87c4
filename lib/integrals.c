/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "legendre.h"
#include "sincos.h"
#include "state.h"

#include <math.h>

/* The power series needs ever more terms as |u| -> 1, the flat one as |u| ->
 * 0; at 0.7 they take 50 and 20. */
#define CENTRAL_MAX 0.7

/* The pair p, wZ carried from u = sin theta to u = 0. */
static void from_central(double K[2], const coin_priv_body *b, double u,
                         double p, double wZ)
{
    const coin_priv_central c = coin_priv_legendre_central(b->k1 * b->k2, u);
    K[0] = c.We * p - b->k1 * c.Po * wZ; /* (35) */
    K[1] = c.Pe * wZ - b->k2 * c.Wo * p; /* (35) */
}

/* The same from close to the table, theta > 0: the flat solutions lead to
 * where the central ones begin.  delta = pi/2 - theta. */
static void from_flat(double K[2], const coin_priv_body *b, double delta,
                      double p, double wZ)
{
    const double half = coin_priv_sincos(delta / 2).s, v = half * half;
    const double kap = b->k1 * b->k2, k2 = b->k2, v_m = (1 - CENTRAL_MAX) / 2;
    /* ln v - ln v_m: nothing cancels where v is near to v_m. */
    const coin_priv_flat f = coin_priv_legendre_flat(kap, v, log(v / v_m));
    const coin_priv_flat m = coin_priv_legendre_flat(kap, v_m, 0);
    const double al = (k2 * p * f.S - wZ * f.PS) / 2; /* (38) */
    const double be = (wZ * f.PR - k2 * p * f.R) / 2; /* (38) */
    from_central(K, b, CENTRAL_MAX, (al * m.PR + be * m.PS) / k2,
                 al * m.R + be * m.S); /* (38) */
}

int32_t coin_integrals(const coin_state *s, const coin_params *p, double K[2])
{
    coin_priv_body b;
    const int32_t status = K ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_sc th = coin_priv_sincos(s->theta);
    const double pY = s->wY * th.c;
    if (fabs(th.s) <= CENTRAL_MAX) {
        from_central(K, &b, th.s, pY, s->wZ);
        return COIN_OK;
    }
    /* Mirrored, (theta, wZ) -> -(theta, wZ), a lean to the other side is this
     * one; never 1 - sin theta, which cancels. */
    const double delta =
        (COIN_PRIV_HALF_PI - fabs(s->theta)) + COIN_PRIV_HALF_PI_LOW;
    const double side = th.s > 0 ? 1 : -1;
    from_flat(K, &b, delta, pY, side * s->wZ);
    K[1] = side * K[1];
    return COIN_OK;
}
