/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "../motion/state.h"
#include "steady.h"
#include "wobble.h"

#include <math.h>

/* If |lambda^2| is below this, in units of g/a, it is replaced by minus this.
 * In the time t, in these units, that changes the lean by 1e-12 t^2/2 of
 * itself.
 */
#define CRITICAL 1e-12

/* If the leans of the neighbour and of the steady motion differ by more than
 * this [rad], the wobble does not count as small. */
#define NEIGHBOUR 0.1

/* The acceleration that the linear law leaves out may displace the lean by this
 * part of its reach.  In the long run that acceleration is then at most half of
 * this part of the linear one at the end of the reach.  So the full force has
 * no other zero within the reach, and the coin stays about its steady motion.
 */
#define DISPLACED 0.5

/* Rounding of the acceleration and of lambda^2, in parts of the terms. */
#define ROUNDING (128 * (DBL_EPSILON / 2))

/* exp(700) is near to the largest double. */
#define GROWTH_MAX 700.0

/* Beyond these a lean or a heading is out of range wherever it began. */
#define LEANT_MAX (2 * COIN_PRIV_HALF_PI)
#define TURNED_MAX (4 * COIN_PRIV_ANGLE_MAX)

/* If start and its neighbour differ in lean by more than FAR cos(theta) of
 * start, the wobble does not count as small.  No power of FAR overflows. */
#define FAR 1e3

/* What begins farther [rad] from an unstable steady motion than this is no
 * small wobble.  The powers of this distance do not overflow. */
#define FARTHEST 1e12

enum { TERMS = COIN_PRIV_WOBBLE_TERMS };

/* sin x and cos x - 1, or sinh x and cosh x - 1. */
struct swing {
    double s, c1;
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

/* sinh(x) and cosh(x) - 1, by their series and doubling; |x| <= GROWTH_MAX. */
static struct swing growth(double x)
{
    int doublings = 0;
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
    const struct swing both = {sh, ch1};
    return both;
}

static struct swing swing_of(double L, double x)
{
    if (L > 0)
        return growth(x);
    const coin_priv_sc half = coin_priv_sincos(x / 2);
    const struct swing w = {2 * half.s * half.c, -2 * half.s * half.s};
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
    const struct swing still = {0, 0};
    const struct swing g = x == 0 ? still : growth(x); /* x is often 0 */
    const double grown = g.s + g.c1, back = 2 * half.s * half.s;
    const struct phasor change = {grown * (1 - back) - back,
                                  (1 + grown) * 2 * half.s * half.c};
    const struct phasor over = {x / norm2, -y / norm2};
    return times(change, over);
}

/* Computes the neighbour, and the derivatives of all rates by the lean, taken
 * at the steady motion.  F is what is left of (39): the motion given need not
 * be steady to the bit. */
static void respond(coin_priv_wobble *w, const coin_state *steady,
                    const coin_priv_body *b, const coin_priv_sc *th)
{
    const double wY = steady->wY, wZ = steady->wZ, T = th->s / th->c;
    const double lean = w->start.theta - steady->theta;
    const double FY = -b->KJ * wZ - 2 * b->XJ * wY * T;
    const double FZ = -b->KJ * wY;
    const double F = b->GJ * th->s - (b->KJ * wZ + b->XJ * wY * T) * wY;
    /* clang-format off */
    w->wY = wY * T + b->k1 * wZ;                            /* (60) */
    w->wZ = b->k2 * wY;                                     /* (60) */
    const double nY = w->start.wY - wY - w->wY * lean;      /* (60) */
    const double nZ = w->start.wZ - wZ - w->wZ * lean;      /* (60) */
    w->apart = -(F + FY * nY + FZ * nZ) / w->L;             /* (60) */
    w->phi = (wY * T + w->wY) / th->c;                      /* (62) */
    w->psi = w->wZ + w->wY * T + wY / (th->c * th->c);      /* (62) */
    w->dphi = (wY + nY) / th->c + w->phi * w->apart;        /* (62) */
    w->dpsi = wZ + nZ + (wY + nY) * T + w->psi * w->apart;  /* (62) */
    /* clang-format on */
    w->Y = lean - w->apart;
}

/* The rates and d(wX)/dt along a leaf, as power series about a lean, in powers
 * of (theta - lean)/cos(lean).  With this variable the coefficients do not grow
 * as the lean comes near the table. */
struct leaf {
    double wY[TERMS], wZ[TERMS], dwX[TERMS];
    double size; /* of the terms of dwX[0] */
};

static void expand(struct leaf *f, const coin_priv_body *b, double theta,
                   double wY, double wZ)
{
    const coin_priv_sc th = coin_priv_sincos(theta);
    double s[TERMS] = {th.s}, c[TERMS] = {th.c}, T[TERMS] = {th.s / th.c};
    double u[TERMS];
    f->wY[0] = wY;
    f->wZ[0] = wZ;
    for (int k = 0;; ++k) {
        double TT = k == 0, wYT = 0, wYu = 0;
        for (int j = 0; j <= k; ++j) {
            TT += T[j] * T[k - j];
            wYT += f->wY[j] * T[k - j];
        }
        u[k] = b->KJ * f->wZ[k] + b->XJ * wYT;
        for (int j = 0; j <= k; ++j)
            wYu += f->wY[j] * u[k - j];
        f->dwX[k] = b->GJ * s[k] - wYu; /* (14) */
        if (k + 1 == TERMS)
            break;
        const double h = th.c / (k + 1);
        s[k + 1] = h * c[k];
        c[k + 1] = -h * s[k];
        T[k + 1] = h * TT;
        f->wY[k + 1] = h * (wYT + b->k1 * f->wZ[k]); /* (15) over wX */
        f->wZ[k + 1] = h * (b->k2 * f->wY[k]);       /* (16) over wX */
    }
    f->size = fabs(b->GJ * th.s) + fabs(wY * b->KJ * wZ) +
              fabs(b->XJ * wY * wY * T[0]);
}

static double sum_at(const double terms[TERMS], double x)
{
    double sum = 0;
    for (int k = TERMS; k-- > 0;)
        sum = sum * x + terms[k];
    return sum;
}

/* Sets w->left_out: what the linear law leaves out of the acceleration of the
 * lean, as powers about the neighbour.  Returns 0 if the start is too
 * far from the neighbour, beside its distance from flat. */
static int leave_out(coin_priv_wobble *w, const coin_priv_body *b)
{
    const double from = coin_priv_sincos(w->start.theta).c;
    if (!(fabs(w->Y) < FAR * from))
        return 0;
    const double neighbour = w->start.theta - w->Y;
    struct leaf f;
    expand(&f, b, w->start.theta, w->start.wY, w->start.wZ);
    const double wY = sum_at(f.wY, -w->Y / from);
    const double wZ = sum_at(f.wZ, -w->Y / from);
    expand(&f, b, neighbour, wY, wZ);
    w->cth = coin_priv_sincos(neighbour).c;
    w->rounding = ROUNDING * f.size;
    for (int k = 0; k < TERMS; ++k)
        w->left_out[k] = fabs(k == 1 ? f.dwX[1] - w->L * w->cth : f.dwX[k]);
    return 1;
}

/* The largest distance of the lean from the neighbour's within t, plus the
 * neighbour's from that of the steady motion. */
static double reach_of(const coin_priv_wobble *w, double x, double leant)
{
    const double Y = fabs(w->Y), end = fabs(w->Y + leant);
    if (w->L > 0)
        return fabs(w->apart) + (end > Y ? end : Y);
    const double within = Y + fabs(w->v * x), ever = coin_priv_hypot(Y, w->v);
    return fabs(w->apart) + (within < ever ? within : ever);
}

/* The acceleration that the linear law leaves out at the distance `reach`. */
static double left_out_at(const coin_priv_wobble *w, double reach)
{
    const double d = sum_at(w->left_out, reach / w->cth) - w->rounding;
    return d > 0 ? d : 0;
}

/* Whether the linear law can stand for the full equations: what it leaves out
 * displaces the lean by at most DISPLACED of its reach.  An acceleration of d
 * displaces it by d t^2/2 at first, and by 2 d/|lambda^2| in the long run; an
 * unstable lean also grows from what displaced it at the beginning. */
static int is_small(const coin_priv_wobble *w, double x, double reach,
                    double grown)
{
    const double first = fabs(w->apart) + fabs(w->Y) + fabs(w->v);
    if (w->L > 0 && !(first < FARTHEST))
        return 0;
    const double begun = w->L > 0 ? grown * left_out_at(w, first) : 0;
    const double time2 = x * x < 4 ? x * x / 2 : 2; /* in 1/|lambda^2| */
    return begun + time2 * left_out_at(w, reach) <=
           DISPLACED * fabs(w->L) * reach;
}

/* The integral of psi' exp(i (phi - phi0)) over t, to first order in Y and v of
 * the start: a sum of three exponentials. */
static struct phasor rolled(const coin_priv_wobble *w, double t)
{
    const double angle = w->dphi * t, x = w->rate * t;
    const double sway = w->dpsi * w->phi / w->rate;
    const struct phasor still = {w->dpsi,
                                 w->L < 0 ? sway * w->v : -sway * w->v};
    struct phasor sum = times(still, mean_exp(0, angle));
    for (double side = -1; side <= 1; side += 2) {
        const double v = side * w->v, k = side * sway;
        const struct phasor waves = {w->Y / 2, -v / 2};
        const struct phasor grows = {(w->Y + v) / 2, 0};
        const struct phasor swung = {w->psi + k, 0}, swerved = {w->psi, k};
        const struct phasor part =
            w->L < 0 ? times(times(waves, swung), mean_exp(0, angle + side * x))
                     : times(times(grows, swerved), mean_exp(side * x, angle));
        sum.re += part.re;
        sum.im += part.im;
    }
    const struct phasor whole = {sum.re * t, sum.im * t}; /* (63) */
    return whole;
}

/* COIN_OK and *out, or COIN_ESTEP if that leaves the range of a state.  The
 * pose and the rates are checked before anything is computed of them, so that
 * no unstable lean overflows. */
static int32_t wobble(const coin_priv_wobble *w, const coin_priv_body *b,
                      const struct swing *g, double leant, double t,
                      coin_state *out)
{
    if (!(fabs(leant) <= LEANT_MAX && fabs(w->dphi * t) <= TURNED_MAX))
        return COIN_ESTEP;
    const coin_state *const start = &w->start;
    const double a = w->a, Y = w->Y, v = w->v, sign = w->L < 0 ? -1 : 1;
    const double swung = (Y * g->s + sign * v * g->c1) / w->rate;
    const double gained = w->dphi * t + w->phi * swung;
    coin_state s = *start;
    /* clang-format off */
    s.theta = start->theta + leant;                              /* (61) */
    s.wX = start->wX + w->rate * (sign * Y * g->s + v * g->c1);  /* (61) */
    s.wY = start->wY + w->wY * leant;                            /* (60) */
    s.wZ = start->wZ + w->wZ * leant;                            /* (60) */
    s.phi = start->phi + gained;                                 /* (62) */
    s.psi = start->psi + (w->dpsi * t + w->psi * swung);         /* (62) */
    /* clang-format on */
    if (coin_priv_check_state(&s, b) != COIN_OK)
        return COIN_ESTEP;
    const struct phasor path = rolled(w, t);
    const coin_priv_sc turn = coin_priv_sincos(start->phi);
    const struct phasor heading = {turn.c, turn.s};
    const struct phasor way = times(heading, path);
    const double from = a * coin_priv_sincos(start->theta).s;
    /* The sum s.phi is rounded.  Its sine and cosine come from its terms. */
    const coin_priv_sc half = coin_priv_sincos(gained / 2);
    const struct phasor by = {half.c, half.s};
    const struct phasor ph = times(heading, times(by, by));
    const double to = a * coin_priv_sincos(s.theta).s;
    s.x = start->x - a * way.re + (to * ph.im - from * turn.s); /* (63) */
    s.z = start->z + a * way.im + (to * ph.re - from * turn.c); /* (63) */
    *out = s;
    return coin_priv_path_holds(&s) ? COIN_OK : COIN_ESTEP;
}

int32_t coin_priv_wobble_begin(coin_priv_wobble *w, const coin_state *steady,
                               const coin_state *start, const coin_priv_body *b,
                               const coin_priv_sc *th)
{
    const double L = coin_priv_stability(steady, b, th);
    const double critical = CRITICAL * b->g_a;
    w->start = *start;
    w->a = b->a;
    w->L = fabs(L) < critical ? -critical : L;
    w->rate = sqrt(fabs(w->L));
    respond(w, steady, b, th);
    w->v = start->wX / w->rate;
    if (!(fabs(w->apart) <= NEIGHBOUR) ||
        !(fabs(start->theta - w->Y) < COIN_PRIV_HALF_PI))
        return COIN_EDOMAIN;
    return leave_out(w, b) ? COIN_OK : COIN_EDOMAIN;
}

int32_t coin_priv_wobble_at(const coin_priv_wobble *w, const coin_priv_body *b,
                            double t, coin_state *out)
{
    const double most = w->L > 0 ? GROWTH_MAX : COIN_PRIV_ANGLE_MAX;
    if (!(fabs(t) <= most / w->rate))
        return COIN_ESTEP;
    const double x = w->rate * t;
    const struct swing g = swing_of(w->L, x);
    const double leant = w->Y * g.c1 + w->v * g.s;
    coin_state then;
    if (wobble(w, b, &g, leant, t, &then) != COIN_OK)
        return COIN_ESTEP;
    if (!is_small(w, x, reach_of(w, x, leant), g.c1))
        return COIN_EDOMAIN;
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
    int32_t status = coin_priv_check_steady(steady, p, &b, &th);
    if (status != COIN_OK && status != COIN_EDOMAIN)
        return status;
    if (coin_priv_check_state(start, &b) != COIN_OK)
        return COIN_ESTATE;
    if (!(t - t == 0))
        return COIN_ESTEP;
    if (status == COIN_OK)
        status = coin_priv_wobble_begin(&w, steady, start, &b, &th);
    return status == COIN_OK ? coin_priv_wobble_at(&w, &b, t, out) : status;
}
