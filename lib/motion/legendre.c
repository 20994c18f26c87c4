/* SPDX-License-Identifier: MIT */
#include "legendre.h"

/* sum of t_n u^n over n = n0, n0 + 2, ..., t_n0 = 1:
 *     t_{n+2} = t_n (n (n + shift) + kap)/((n + 1)(n + 2))            (34)
 * All terms have one sign: nothing cancels. */
static real power_series(real kap, real u, real n0, real shift)
{
    const real u2 = u * u;
    real term = n0 > 0 ? u : 1, sum = term, low = 0;
    for (real n = n0; FABS(term) > COIN_PRIV_NEGLIGIBLE * FABS(sum); n += 2) {
        term *= u2 * ((n * (n + shift) + kap) / ((n + 1) * (n + 2)));
        const real next = sum + term;
        low += term - (next - sum); /* what the sum rounds off, exactly */
        sum = next;
    }
    return sum + low;
}

PRIV(central) PRIV(legendre_central)(real kap, real u)
{
    const PRIV(central) c = {
        power_series(kap, u, 0, -1),
        power_series(kap, u, 1, -1),
        power_series(kap, u, 0, 1),
        power_series(kap, u, 1, 1),
    };
    return c;
}

/* R = sum r_n v^n and S = R ln v + sum s_n v^n, with their derivatives times
 * v; s_n is written without a division by kap, which may be small.  (36) */
PRIV(flat) PRIV(legendre_flat)(real kap, real v, real ln_v)
{
    real r = 1, s = 0; /* r_n v^n, s_n v^n */
    real r_sum = 0, vdR = 0, s_sum = 0, vds_sum = 0;
    /* (n + 1) v^n bounds the terms of every sum, whatever kap. */
    real power = 1;
    for (real n = 0; (n + 1) * power > COIN_PRIV_NEGLIGIBLE; ++n) {
        power *= v;
        const real rho = (n * (n + 1) + kap) / ((n + 1) * (n + 1));
        const real odd = (2 * n + 1) / ((n + 1) * (n + 1));
        s = v * (rho * s + r * (odd - 2 * rho / (n + 1)));
        r = v * (rho * r);
        r_sum += r;
        vdR += (n + 1) * r;
        s_sum += s;
        vds_sum += (n + 1) * s;
    }
    PRIV(flat) f;
    f.R = 1 + r_sum;
    f.S = f.R * ln_v + s_sum;
    f.PR = -2 * (1 - v) * vdR;                                  /* (37) */
    f.PS = -2 * (1 - v) * (1 + (r_sum + vdR * ln_v + vds_sum)); /* (37) */
    return f;
}
