/* SPDX-License-Identifier: MIT */
#include "../motion/angles.h"
#include "../motion/legendre.h"
#include "../motion/state.h"

/* The power series needs ever more terms as |u| -> 1, the flat one as |u| ->
 * 0; at 0.7 they take 50 and 20. */
#define CENTRAL_MAX K(0.7)

/* K_Y and K_Z, the pair at u = 0, from p and wZ at u = sin theta. */
static void from_central(number K[2], const coin_priv_constants *b, number u,
                         number p, number wZ)
{
    const coin_priv_central c = coin_priv_legendre_central(b->k1 * b->k2, u);
    K[0] = c.We * p - b->k1 * c.Po * wZ; /* (35) */
    K[1] = c.Pe * wZ - b->k2 * c.Wo * p; /* (35) */
}

/* K_Y and K_Z of a coin near the table, theta > 0, with delta = pi/2 - theta.
 * The flat solutions give p and wZ at u = CENTRAL_MAX, and the central ones
 * give K_Y and K_Z from these. */
static void from_flat(number K[2], const coin_priv_constants *b, number delta,
                      number p, number wZ)
{
    const number half = coin_priv_sincos(delta / 2).s, v = half * half;
    const number kap = b->k1 * b->k2, k2 = b->k2, v_m = (1 - CENTRAL_MAX) / 2;
    /* ln v - ln v_m: nothing cancels where v is near to v_m. */
    const coin_priv_flat f = coin_priv_legendre_flat(kap, v, LOG(v / v_m));
    const coin_priv_flat m = coin_priv_legendre_flat(kap, v_m, 0);
    const number al = (k2 * p * f.S - wZ * f.PS) / 2; /* (38) */
    const number be = (wZ * f.PR - k2 * p * f.R) / 2; /* (38) */
    from_central(K, b, CENTRAL_MAX, (al * m.PR + be * m.PS) / k2,
                 al * m.R + be * m.S); /* (38) */
}

int32_t coin_integrals(const coin_state *s, const coin_params *p, number K[2])
{
    coin_priv_constants b;
    const int32_t status = K ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_sc th = coin_priv_sincos(s->theta);
    const number pY = s->wY * th.c;
    if (FABS(th.s) <= CENTRAL_MAX) {
        from_central(K, &b, th.s, pY, s->wZ);
        return COIN_OK;
    }
    /* A lean to the other side is mirrored: (theta, wZ) -> -(theta, wZ).  delta
     * is not computed from 1 - sin theta, which would cancel. */
    const number delta =
        (COIN_PRIV_HALF_PI - FABS(s->theta)) + COIN_PRIV_HALF_PI_LOW;
    const number side = th.s > 0 ? 1 : -1;
    from_flat(K, &b, delta, pY, side * s->wZ);
    K[1] = side * K[1];
    return COIN_OK;
}
