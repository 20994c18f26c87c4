/* SPDX-License-Identifier: MIT */
#include "legendre.h"

/* sum of t_n u^n over n = n0, n0 + 2, ..., t_n0 = 1:
 *     t_{n+2} = t_n (n (n + shift) + kap)/((n + 1)(n + 2))            (34)
 * All terms have one sign: nothing cancels. */
static number power_series(number kap, number u, number n0, number shift)
{
    const number u2 = u * u;
    number term = n0 > 0 ? u : 1, sum = term, low = 0;
    for (number n = n0; FABS(term) > COIN_PRIV_NEGLIGIBLE * FABS(sum); n += 2) {
        term *= u2 * ((n * (n + shift) + kap) / ((n + 1) * (n + 2)));
        const number next = sum + term;
        low += term - (next - sum); /* what the sum rounds off, exactly */
        sum = next;
    }
    return sum + low;
}

coin_priv_central coin_priv_legendre_central(number kap, number u)
{
    const coin_priv_central c = {
        power_series(kap, u, 0, -1),
        power_series(kap, u, 1, -1),
        power_series(kap, u, 0, 1),
        power_series(kap, u, 1, 1),
    };
    return c;
}

/* R = sum r_n v^n and S = R ln v + sum s_n v^n, with their derivatives times
 * v; s_n is written without a division by kap, which may be small.  (36) */
coin_priv_flat coin_priv_legendre_flat(number kap, number v, number ln_v)
{
    number r = 1, s = 0; /* r_n v^n, s_n v^n */
    number r_sum = 0, vdR = 0, s_sum = 0, vds_sum = 0;
    /* (n + 1) v^n bounds the terms of every sum, whatever kap. */
    number power = 1;
    for (number n = 0; (n + 1) * power > COIN_PRIV_NEGLIGIBLE; ++n) {
        power *= v;
        const number rho = (n * (n + 1) + kap) / ((n + 1) * (n + 1));
        const number odd = (2 * n + 1) / ((n + 1) * (n + 1));
        s = v * (rho * s + r * (odd - 2 * rho / (n + 1)));
        r = v * (rho * r);
        r_sum += r;
        vdR += (n + 1) * r;
        s_sum += s;
        vds_sum += (n + 1) * s;
    }
    coin_priv_flat f;
    f.R = 1 + r_sum;
    f.S = f.R * ln_v + s_sum;
    f.PR = -2 * (1 - v) * vdR;                                  /* (37) */
    f.PS = -2 * (1 - v) * (1 + (r_sum + vdR * ln_v + vds_sum)); /* (37) */
    return f;
}
