/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "series.h"

#include <string.h>

#define ELEMENT COIN_PRIV_ELEMENT
#define ADD_PRODUCT coin_priv_pair_add_product
#define BOTH coin_priv_pair_both

static inline coin_priv_pair times(coin_priv_pair a, double by)
{
    return ADD_PRODUCT(BOTH(0), a, BOTH(by));
}

/* 1/n, n up to the order. */
#define OVER4(n) 1.0 / (n), 1.0 / ((n) + 1), 1.0 / ((n) + 2), 1.0 / ((n) + 3)
static const double over_n[COIN_PRIV_ORDER + 1] = {
    0, OVER4(1), OVER4(5), OVER4(9), OVER4(13), OVER4(17), OVER4(21), OVER4(25),
};

/* The powers of the factors of the products in the equations of motion.  Both
 * numbers of a pair are the same where one factor multiplies two others. */
struct factors {
    coin_priv_pair th[COIN_PRIV_ORDER], wX[COIN_PRIV_ORDER];
    coin_priv_pair vY[COIN_PRIV_ORDER]; /* wY tan theta + k1 wZ, wY */
    coin_priv_pair r[COIN_PRIV_ORDER];  /* wY/cos theta */
    double u[COIN_PRIV_ORDER];          /* KJ wZ + XJ wY tan theta */
    double over;                        /* 1/cos theta at the point */
};

/* Computes power k + 1 of lean, angles and rates from the powers up to k.  The
 * loop leaves out the terms that contain power k of a factor.  They are added
 * as soon as that power is known.  If k = 0 such a product has one term, not
 * two: the factor that is not set yet is still 0. */
static void lean_power(coin_priv_series *s, struct factors *f,
                       const coin_priv_field *field, int k)
{
    const coin_priv_point *p = &s->at[k];
    const double wX = ELEMENT(p->row[1], 1);
    const double wY = ELEMENT(p->row[2], 0), wZ = ELEMENT(p->row[2], 1);
    coin_priv_pair thr = BOTH(0), thX = BOTH(0), vYX = BOTH(0);
    double uY = 0;
    for (int j = 1; j < k; ++j) {
        thr = ADD_PRODUCT(thr, f->th[j], f->r[k - j]);
        thX = ADD_PRODUCT(thX, f->th[j], f->wX[k - j]);
        vYX = ADD_PRODUCT(vYX, f->vY[j], f->wX[k - j]);
        uY += f->u[j] * ELEMENT(f->vY[k - j], 1);
    }
    f->th[k] = p->th;
    thr = ADD_PRODUCT(thr, f->th[k], f->r[0]);
    const double r = (wY - ELEMENT(thr, 0)) * f->over; /* (18) */
    const double rs =
        ELEMENT(thr, 1) + ELEMENT(f->th[0], 1) * r; /* wY tan theta */
    f->r[k] = BOTH(r);
    f->u[k] = field->KJ * wZ + field->XJ * rs;
    uY += f->u[k] * ELEMENT(f->vY[0], 1);
    f->vY[k] = coin_priv_pair_make(rs + field->k1 * wZ, wY);
    uY += f->u[0] * wY;
    thX = ADD_PRODUCT(thX, f->th[k], f->wX[0]);
    vYX = ADD_PRODUCT(vYX, f->vY[k], f->wX[0]);
    f->wX[k] = BOTH(wX);
    thX = ADD_PRODUCT(thX, f->th[0], f->wX[k]);
    vYX = ADD_PRODUCT(vYX, f->vY[0], f->wX[k]);
    const double by = over_n[k + 1];
    coin_priv_point *next = &s->at[k + 1];
    const double dwX = field->GJ * ELEMENT(p->th, 1) - uY; /* (14) */
    const double dwY = ELEMENT(vYX, 0);                    /* (15) */
    const double dwZ = field->k2 * ELEMENT(vYX, 1);        /* (16) */
    const double dpsi = wZ + rs;                           /* (19) */
    next->row[0] = times(coin_priv_pair_make(wX, r), by);
    next->row[1] = times(coin_priv_pair_make(dpsi, dwX), by);
    next->row[2] = times(coin_priv_pair_make(dwY, dwZ), by);
    next->th = times(coin_priv_pair_make(-ELEMENT(thX, 1), ELEMENT(thX, 0)),
                     by); /* (31) */
}

void coin_priv_series_expand(coin_priv_series *s, const coin_priv_field *field)
{
    struct factors f;
    memset(&f, 0, sizeof f);
    f.over = 1 / ELEMENT(s->at[0].th, 0);
    for (int k = 0; k < COIN_PRIV_ORDER; ++k)
        lean_power(s, &f, field, k);
}

/* The powers of phi' and of wX cos theta are those of the derivatives of phi
 * and sin theta. */
void coin_priv_series_expand_path(coin_priv_series *s)
{
    coin_priv_pair r[COIN_PRIV_ORDER], g[COIN_PRIV_ORDER], wZ[COIN_PRIV_ORDER];
    for (int k = 0; k < COIN_PRIV_ORDER; ++k) {
        const coin_priv_point *next = &s->at[k + 1];
        coin_priv_pair phr = BOTH(0), phg = phr, phZ = phr;
        r[k] = BOTH((k + 1) * ELEMENT(next->row[0], 1));
        g[k] = BOTH((k + 1) * ELEMENT(next->th, 1));
        wZ[k] = BOTH(ELEMENT(s->at[k].row[2], 1));
        for (int j = 0; j <= k; ++j) {
            const coin_priv_pair ph = s->at[j].ph;
            phr = ADD_PRODUCT(phr, ph, r[k - j]);
            phg = ADD_PRODUCT(phg, ph, g[k - j]);
            phZ = ADD_PRODUCT(phZ, ph, wZ[k - j]);
        }
        const double by = over_n[k + 1];
        const double dx = ELEMENT(phg, 1) - ELEMENT(phZ, 0); /* (20) */
        const double dz = ELEMENT(phg, 0) + ELEMENT(phZ, 1); /* (20) */
        s->at[k + 1].row[COIN_PRIV_PATH] =
            times(coin_priv_pair_make(dz, dx), by);
        s->at[k + 1].ph =
            times(coin_priv_pair_make(-ELEMENT(phr, 1), ELEMENT(phr, 0)),
                  by); /* (31) */
    }
}

coin_priv_pair coin_priv_series_path(const coin_priv_series *s, double t)
{
    coin_priv_pair sum = BOTH(0);
    for (int k = COIN_PRIV_ORDER + 1; k-- > 0;)
        sum = ADD_PRODUCT(s->at[k].row[COIN_PRIV_PATH], sum, BOTH(t));
    return sum;
}

coin_priv_point coin_priv_series_at(const coin_priv_series *s, double t)
{
    const coin_priv_pair by = BOTH(t);
    const coin_priv_point *p = &s->at[COIN_PRIV_ORDER];
    coin_priv_pair angles = p->row[0];
    coin_priv_pair roll = p->row[1];
    coin_priv_pair spin = p->row[2], th = p->th;
    while (p-- != s->at) {
        angles = ADD_PRODUCT(p->row[0], angles, by);
        roll = ADD_PRODUCT(p->row[1], roll, by);
        spin = ADD_PRODUCT(p->row[2], spin, by);
        th = ADD_PRODUCT(p->th, th, by);
    }
    coin_priv_point sum = s->at[0];
    sum.row[0] = angles;
    sum.row[1] = roll;
    sum.row[2] = spin;
    sum.th = th;
    return sum;
}

/* Removes the powers above degree from polynomials on [-1, 1], three pairs for
 * each power (Lanczos' economization).  From the highest down, each power is
 * replaced by lower ones so that the difference is a multiple of a Chebyshev
 * polynomial. */
static void economize(coin_priv_pair (*b)[3], int degree)
{
    for (int n = COIN_PRIV_ORDER - 1; n > degree; --n) {
        double m = 1; /* T_n/2^(n-1) = x^n + m x^(n-2) + ... */
        for (int j = 1; 2 * j <= n; ++j) {
            coin_priv_pair *lower = b[n - 2 * j];
            m *= -0.25 * ((n - 2 * j + 2) * (n - 2 * j + 1)) *
                 (over_n[j] * over_n[n - j]);
            for (int i = 0; i < 3; ++i)
                lower[i] = ADD_PRODUCT(lower[i], b[n][i], BOTH(-m));
        }
    }
}

/* The rates are economized, and then integrated, because queries also compute
 * derivatives. */
void coin_priv_series_economized(const coin_priv_series *s, double reach,
                                 double *rows)
{
    static const int from[3] = {0, 1, COIN_PRIV_PATH};
    static const int to[3][2] = {
        {COIN_PRIV_THETA, COIN_PRIV_PHI},
        {COIN_PRIV_PSI, -1},
        {COIN_PRIV_Z, COIN_PRIV_X},
    };
    coin_priv_pair b[COIN_PRIV_ORDER][3];
    double power = 1, over[COIN_PRIV_TERMS] = {0};
    for (int k = 0; k < COIN_PRIV_ORDER; ++k, power *= reach) {
        for (int i = 0; i < 3; ++i)
            b[k][i] = times(s->at[k + 1].row[from[i]], (k + 1) * power);
        if (k + 1 < COIN_PRIV_TERMS)
            over[k + 1] = over_n[k + 1] / power;
    }
    economize(b, COIN_PRIV_TERMS - 2);
    for (int i = 0; i < 3; ++i)
        for (int half = 0; half < 2 && to[i][half] >= 0; ++half) {
            double *row = rows + COIN_PRIV_TERMS * to[i][half];
            row[0] = ELEMENT(s->at[0].row[from[i]], half);
            for (int k = 1; k < COIN_PRIV_TERMS; ++k)
                row[k] = ELEMENT(b[k - 1][i], half) * over[k];
        }
}
