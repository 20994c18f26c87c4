/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "series.h"

#include <string.h>

#define OF COIN_PRIV_OF
#define ADD coin_priv_pair_add
#define BOTH coin_priv_pair_both

static inline coin_priv_pair times(coin_priv_pair a, double by)
{
    return ADD(BOTH(0), a, BOTH(by));
}

/* 1/n, n up to the order. */
#define OVER4(n) 1.0 / (n), 1.0 / ((n) + 1), 1.0 / ((n) + 2), 1.0 / ((n) + 3)
static const double over_n[COIN_PRIV_ORDER + 1] = {
    0,         OVER4(1),  OVER4(5),  OVER4(9),  OVER4(13),
    OVER4(17), OVER4(21), OVER4(25), OVER4(29),
};

/* The factors of the products that the equations of motion are made of, power
 * by power; a factor of two numbers stands twice. */
struct factors {
    coin_priv_pair th[COIN_PRIV_ORDER], ph[COIN_PRIV_ORDER];
    coin_priv_pair vY[COIN_PRIV_ORDER]; /* wY tan theta + k1 wZ, wY */
    coin_priv_pair wX[COIN_PRIV_ORDER], wZ[COIN_PRIV_ORDER];
    coin_priv_pair r[COIN_PRIV_ORDER]; /* wY/cos theta */
    coin_priv_pair g[COIN_PRIV_ORDER]; /* wX cos theta */
    double u[COIN_PRIV_ORDER];         /* KJ wZ + XJ wY tan theta */
    double over;                       /* 1/cos theta at the point */
};

/* Power k + 1 of lean, angles and rates from the powers up to k.  The sums
 * leave out the terms with a factor's power k: those come with it. */
static void lean_power(coin_priv_series *s, struct factors *f,
                       const coin_priv_law *law, int k)
{
    const coin_priv_point *p = &s->at[k];
    const double wX = OF(p->row[1], 1);
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    const int is_first = k == 0;
    coin_priv_pair thr = BOTH(0), thX = BOTH(0), vYX = BOTH(0);
    double uY = 0;
    for (int j = 1; j < k; ++j) {
        thr = ADD(thr, f->th[j], f->r[k - j]);
        thX = ADD(thX, f->th[j], f->wX[k - j]);
        vYX = ADD(vYX, f->vY[j], f->wX[k - j]);
        uY += f->u[j] * OF(f->vY[k - j], 1);
    }
    f->th[k] = p->th;
    f->wX[k] = BOTH(wX);
    f->wZ[k] = BOTH(wZ);
    if (!is_first)
        thr = ADD(thr, f->th[k], f->r[0]);
    const double r = (wY - OF(thr, 0)) * f->over;       /* (18) */
    const double rs = OF(thr, 1) + OF(f->th[0], 1) * r; /* wY tan theta */
    f->r[k] = BOTH(r);
    f->u[k] = law->KJ * wZ + law->XJ * rs;
    f->vY[k] = coin_priv_pair_of(rs + law->k1 * wZ, wY);
    thX = ADD(thX, f->th[0], f->wX[k]);
    vYX = ADD(vYX, f->vY[0], f->wX[k]);
    uY += f->u[0] * wY;
    if (!is_first) {
        thX = ADD(thX, f->th[k], f->wX[0]);
        vYX = ADD(vYX, f->vY[k], f->wX[0]);
        uY += f->u[k] * OF(f->vY[0], 1);
    }
    f->g[k] = BOTH(OF(thX, 0));
    const double by = over_n[k + 1];
    coin_priv_point *next = &s->at[k + 1];
    const double dwX = law->GJ * OF(p->th, 1) - uY; /* (14) */
    const double dwY = OF(vYX, 0);                  /* (15) */
    const double dwZ = law->k2 * OF(vYX, 1);        /* (16) */
    const double dpsi = wZ + rs;                    /* (19) */
    next->row[0] = times(coin_priv_pair_of(wX, r), by);
    next->row[1] = times(coin_priv_pair_of(dpsi, dwX), by);
    next->row[2] = times(coin_priv_pair_of(dwY, dwZ), by);
    next->th = times(coin_priv_pair_of(-OF(thX, 1), OF(thX, 0)), by); /* (31) */
}

/* Power k + 1 of path and heading's pair; lean_power() has come before. */
static void path_power(coin_priv_series *s, struct factors *f, int k)
{
    const coin_priv_point *p = &s->at[k];
    coin_priv_pair phr = BOTH(0), phg = phr, phZ = phr;
    f->ph[k] = p->ph;
    for (int j = 0; j <= k; ++j) {
        phr = ADD(phr, f->ph[j], f->r[k - j]);
        phg = ADD(phg, f->ph[j], f->g[k - j]);
        phZ = ADD(phZ, f->ph[j], f->wZ[k - j]);
    }
    const double by = over_n[k + 1];
    const double dx = OF(phg, 1) - OF(phZ, 0); /* (20) */
    const double dz = OF(phg, 0) + OF(phZ, 1); /* (20) */
    s->at[k + 1].row[COIN_PRIV_PATH] = times(coin_priv_pair_of(dz, dx), by);
    s->at[k + 1].ph =
        times(coin_priv_pair_of(-OF(phr, 1), OF(phr, 0)), by); /* (31) */
}

void coin_priv_series_fill(coin_priv_series *s, const coin_priv_law *law)
{
    struct factors f;
    memset(&f, 0, sizeof f); /* no need, but gcc's analyzer cannot tell */
    f.over = 1 / OF(s->at[0].th, 0);
    for (int k = 0; k < COIN_PRIV_ORDER; ++k) {
        lean_power(s, &f, law, k);
        if (k + 1 < COIN_PRIV_TERMS)
            path_power(s, &f, k);
    }
}

coin_priv_pair coin_priv_series_path(const coin_priv_series *s, double t)
{
    coin_priv_pair sum = BOTH(0);
    for (int k = COIN_PRIV_TERMS; k-- > 0;)
        sum = ADD(s->at[k].row[COIN_PRIV_PATH], sum, BOTH(t));
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
        angles = ADD(p->row[0], angles, by);
        roll = ADD(p->row[1], roll, by);
        spin = ADD(p->row[2], spin, by);
        th = ADD(p->th, th, by);
    }
    coin_priv_point sum = s->at[0];
    sum.row[0] = angles;
    sum.row[1] = roll;
    sum.row[2] = spin;
    sum.th = th;
    return sum;
}
