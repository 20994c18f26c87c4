/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "sincos.h"
#include "state.h"
#include "steady.h"
#include "wobble.h"

#include <math.h>

/* Nearer to critical than this, in units of g/a, the lean is given a period of
 * 6000 natural units.  Over t it changes by 1e-6 t^2/2 of itself: less than
 * what (60) leaves out, which is all that holds a critical coin. */
#define CRITICAL 1e-6

/* No wobble is small about a steady motion that is further off [rad]. */
#define NEIGHBOUR 0.1

/* S'' = L S with S = 0, S' = 1 at first; C = S'; C2 = (C - 1)/L, its integral.
 */
struct swing {
    double S, C, C2;
};

struct phasor {
    double re, im;
};

static struct phasor times(struct phasor a, struct phasor b)
{
    const struct phasor ab = {a.re * b.re - a.im * b.im,
                              a.re * b.im + a.im * b.re};
    return ab;
}

/* sinh(x) and cosh(x) - 1, by their series and doubling; NaN where they are
 * near to overflow. */
static struct phasor growth(double x)
{
    int doublings = 0;
    if (!(fabs(x) < 700))
        x = (double)NAN;
    for (; fabs(x) > 0.5; x /= 2)
        ++doublings;
    double odd = x, even = x * x / 2, sh = odd, ch1 = even;
    for (double n = 3; n < 16; n += 2) {
        odd *= x * x / ((n - 1) * n);
        even *= x * x / (n * (n + 1));
        sh += odd;
        ch1 += even;
    }
    for (; doublings > 0; --doublings) {
        const double twice = 2 * sh * sh;
        sh *= 2 * (1 + ch1);
        ch1 = twice;
    }
    const struct phasor both = {sh, ch1};
    return both;
}

static struct swing swing_of(double L, double t)
{
    const double rate = sqrt(fabs(L));
    struct swing w;
    if (L < 0) {
        const coin_priv_sc half = coin_priv_sincos(rate * t / 2);
        w.S = 2 * half.s * half.c / rate;
        w.C2 = 2 * half.s * half.s / -L;
    } else {
        const struct phasor g = growth(rate * t);
        w.S = g.re / rate;
        w.C2 = g.im / L;
    }
    w.C = 1 + L * w.C2;
    return w;
}

/* The mean of exp((x + i y) s) over 0 <= s <= 1: (exp(w) - 1)/w. */
static struct phasor mean_exp(double x, double y)
{
    const double norm2 = x * x + y * y;
    if (norm2 < 1e-32) { /* 1 + w/2 is 1 */
        const struct phasor one = {1, 0};
        return one;
    }
    const coin_priv_sc half = coin_priv_sincos(y / 2);
    const struct phasor still = {0, 0};
    const struct phasor g = x == 0 ? still : growth(x); /* often */
    const double grown = g.re + g.im, back = 2 * half.s * half.s;
    const struct phasor change = {grown * (1 - back) - back,
                                  (1 + grown) * 2 * half.s * half.c};
    const struct phasor over = {x / norm2, -y / norm2};
    return times(change, over);
}

/* The terms of Eq. (44) and their like, at the steady motion. */
static coin_priv_wobble respond(const coin_state *steady,
                                const coin_state *start,
                                const coin_priv_body *b, double lambda2)
{
    const coin_priv_sc th = coin_priv_sincos(steady->theta);
    const double wY = steady->wY, wZ = steady->wZ, T = th.s / th.c;
    const double lean = start->theta - steady->theta;
    const double FY = -b->KJ * wZ - 2 * b->XJ * wY * T;
    const double FZ = -b->KJ * wY;
    coin_priv_wobble r;
    r.L = fabs(lambda2) < CRITICAL * b->g_a ? -CRITICAL * b->g_a : lambda2;
    /* clang-format off */
    r.wY = wY * T + b->k1 * wZ;                             /* (60) */
    r.wZ = b->k2 * wY;                                      /* (60) */
    const double nY = start->wY - wY - r.wY * lean;         /* (60) */
    const double nZ = start->wZ - wZ - r.wZ * lean;         /* (60) */
    r.apart = -(FY * nY + FZ * nZ) / r.L;                   /* (60) */
    r.Y = lean - r.apart;
    r.phi = (wY * T + r.wY) / th.c;                         /* (62) */
    r.psi = r.wZ + r.wY * T + wY / (th.c * th.c);           /* (62) */
    r.dphi = (wY + nY) / th.c + r.phi * r.apart;            /* (62) */
    r.dpsi = wZ + nZ + (wY + nY) * T + r.psi * r.apart;     /* (62) */
    /* clang-format on */
    return r;
}

/* The integral of psi' exp(i (phi - phi0)) over t, to first order in the lean
 * Y and its rate V: three exponentials. */
static struct phasor rolled(const coin_priv_wobble *r, double Y, double V,
                            double t)
{
    const double rate = sqrt(fabs(r->L)), angle = r->dphi * t;
    const double sway = r->dpsi * r->phi;
    const struct phasor still = {r->dpsi, -sway * V / r->L};
    struct phasor sum = times(still, mean_exp(0, angle));
    for (double side = -1; side <= 1; side += 2) {
        const double v = side * V / rate, k = side * sway / rate;
        const struct phasor waves = {Y / 2, -v / 2}, grows = {(Y + v) / 2, 0};
        const struct phasor swung = {r->psi + k, 0}, swerved = {r->psi, k};
        const struct phasor part =
            r->L < 0 ? times(times(waves, swung),
                             mean_exp(0, angle + side * rate * t))
                     : times(times(grows, swerved),
                             mean_exp(side * rate * t, angle));
        sum.re += part.re;
        sum.im += part.im;
    }
    const struct phasor whole = {sum.re * t, sum.im * t}; /* (63) */
    return whole;
}

static coin_state wobble(const coin_priv_wobble *r, const coin_state *start,
                         double a, double t)
{
    const double Y = r->Y, V = start->wX;
    const struct swing w = swing_of(r->L, t);
    const double swung = Y * w.S + V * w.C2;
    const double leant = r->L * Y * w.C2 + V * w.S;
    const struct phasor path = rolled(r, Y, V, t);
    const coin_priv_sc turn = coin_priv_sincos(start->phi);
    const struct phasor heading = {turn.c, turn.s};
    const struct phasor way = times(heading, path);
    const double from = a * coin_priv_sincos(start->theta).s;
    coin_state s;
    /* clang-format off */
    s.theta = start->theta + leant;                   /* (61) */
    s.wX = r->L * Y * w.S + V * w.C;                  /* (61) */
    s.wY = start->wY + r->wY * leant;                 /* (60) */
    s.wZ = start->wZ + r->wZ * leant;                 /* (60) */
    s.phi = start->phi + (r->dphi * t + r->phi * swung); /* (62) */
    s.psi = start->psi + (r->dpsi * t + r->psi * swung); /* (62) */
    const coin_priv_sc ph = coin_priv_sincos(s.phi);
    const double to = a * coin_priv_sincos(s.theta).s;
    s.x = start->x - a * way.re + (to * ph.s - from * turn.s); /* (63) */
    s.z = start->z + a * way.im + (to * ph.c - from * turn.c); /* (63) */
    /* clang-format on */
    return s;
}

int32_t coin_priv_wobble_begin(coin_priv_wobble *w, const coin_state *steady,
                               const coin_state *start, const coin_priv_body *b,
                               double lambda2)
{
    *w = respond(steady, start, b, lambda2);
    return fabs(w->apart) <= NEIGHBOUR ? COIN_OK : COIN_EDOMAIN;
}

int32_t coin_priv_wobble_move(const coin_priv_wobble *w,
                              const coin_state *start, const coin_priv_body *b,
                              double t, coin_state *out)
{
    const coin_state then = wobble(w, start, b->a, t);
    if (coin_priv_check_state(&then, b) != COIN_OK)
        return COIN_ESTEP;
    *out = then;
    return COIN_OK;
}

int32_t coin_wobble_at(const coin_state *steady, const coin_params *p,
                       const coin_state *start, double t, coin_state *out)
{
    coin_priv_body b;
    coin_priv_sc th;
    coin_priv_wobble w;
    if (!out || !start)
        return COIN_EARG;
    const int32_t settled = coin_priv_check_steady(steady, p, &b, &th);
    if (settled != COIN_OK && settled != COIN_EDOMAIN)
        return settled;
    if (coin_priv_check_state(start, &b) != COIN_OK)
        return COIN_ESTATE;
    if (!(t - t == 0))
        return COIN_ESTEP;
    if (settled != COIN_OK)
        return settled;
    const double lambda2 = coin_priv_lambda2(steady, &b, &th);
    if (coin_priv_wobble_begin(&w, steady, start, &b, lambda2) != COIN_OK)
        return COIN_EDOMAIN;
    return coin_priv_wobble_move(&w, start, &b, t, out);
}
