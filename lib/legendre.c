/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "legendre.h"

#include <math.h>

/* sum of t_n u^n over n = n0, n0 + 2, ..., t_n0 = 1:
 *     t_{n+2} = t_n (n (n + shift) + kap)/((n + 1)(n + 2))            (34)
 * All terms have one sign: nothing cancels. */
static double power_series(double kap, double u, double n0, double shift)
{
    const double u2 = u * u;
    double term = n0 > 0 ? u : 1, sum = term, low = 0;
    for (double n = n0; fabs(term) > COIN_PRIV_NEGLIGIBLE * fabs(sum); n += 2) {
        term *= u2 * ((n * (n + shift) + kap) / ((n + 1) * (n + 2)));
        const double next = sum + term;
        low += term - (next - sum); /* what the sum rounds off, exactly */
        sum = next;
    }
    return sum + low;
}

coin_priv_central coin_priv_legendre_central(double kap, double u)
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
coin_priv_flat coin_priv_legendre_flat(double kap, double v, double ln_v)
{
    double r = 1, s = 0; /* r_n v^n, s_n v^n */
    double r_sum = 0, vdR = 0, s_sum = 0, vds_sum = 0;
    /* (n + 1) v^n bounds the terms of every sum, whatever kap. */
    double power = 1;
    for (double n = 0; (n + 1) * power > COIN_PRIV_NEGLIGIBLE; ++n) {
        power *= v;
        const double rho = (n * (n + 1) + kap) / ((n + 1) * (n + 1));
        const double odd = (2 * n + 1) / ((n + 1) * (n + 1));
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
