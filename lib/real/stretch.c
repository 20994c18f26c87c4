/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "stretch.h"

/* The tau in which a stretch passes that lasts t.  t is the integral of cos
 * theta over tau, which the series at both ends give (Hermite).  Newton's
 * method solves that for tau. */
COIN_PRIV_INLINE double tau_between(const coin_priv_stretch *w,
                                    const double *weight, int terms, int times)
{
    const coin_priv_ends *const c = w->force.cth;
    double of[COIN_PRIV_FORCE_TERMS], h = w->tau / w->unit;
#pragma GCC unroll 8
    for (int k = 0; k < terms; ++k)
        of[k] = weight[k] *
                (k % 2 ? c[k].at[0] - c[k].at[1] : c[k].at[0] + c[k].at[1]);
    for (int i = 0; i < times; ++i) {
        double value = 0, slope = 0;
#pragma GCC unroll 8
        for (int k = terms - 1; k >= 0; --k) {
            slope = slope * h + (k + 1) * of[k];
            value = value * h + of[k];
        }
        h -= (value * h - w->t / w->unit) / slope;
    }
    return h * w->unit;
}

static double tau_of_stretch(const coin_priv_stretch *w, int terms)
{
    static const double all[] = {1.0 / 2,    3.0 / 26,   5.0 / 156,  5.0 / 572,
                                 3.0 / 1430, 1.0 / 2574, 1.0 / 24024};
    static const double some[] = {1.0 / 2, 1.0 / 9, 1.0 / 36, 1.0 / 168,
                                  1.0 / 1260};
    static const double few[] = {1.0 / 2, 1.0 / 10, 1.0 / 60};
    if (terms == COIN_PRIV_FORCE_FEW)
        return tau_between(w, few, COIN_PRIV_FORCE_FEW, 2);
    if (terms == COIN_PRIV_FORCE_SOME)
        return tau_between(w, some, COIN_PRIV_FORCE_SOME, 2);
    return tau_between(w, all, COIN_PRIV_FORCE_TERMS, 3);
}

void coin_priv_stretch_know(coin_priv_stretch *w, int terms)
{
    coin_priv_force_series_of(&w->force, &w->from.b, &w->from.g.y, &w->to,
                              w->unit, terms);
    if (w->t != 0)
        w->tau = tau_of_stretch(w, terms);
}
