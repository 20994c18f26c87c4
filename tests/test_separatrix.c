/* SPDX-License-Identifier: MIT */
/* Motions between two kinds: on a separatrix, where rounding decides which way
 * they go on, and at the critical rates, where the linear theory decides
 * nothing. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"

#include "legendre.h"
#include "params.h"

#include <math.h>

/* ------------------------------------------------------------ separatrices */
/* A coin that climbs, with K_Y = 0, towards an upright roll too slow to be
 * stable, and would take for ever: its energy is that of upright. */
struct climb {
    coin_params p;
    double rate; /* at which it nears the top, and leaves it */
    coin_state start;
};

static struct climb climb_of(double inner, double theta)
{
    struct climb c = {.p = ring(inner)};
    coin_priv_constants b;
    b = coin_priv_constants_of(&c.p);
    const double wZ = coin_critical_roll(&c.p) / 2, u = sin(theta);
    const coin_priv_central f = coin_priv_legendre_central(b.k1 * b.k2, u);
    coin_state top;
    check_status(coin_steady_roll(&top, &c.p, wZ), COIN_OK);
    double lambda2;
    check_status(coin_stability(&top, &c.p, &lambda2), COIN_OK);
    c.rate = sqrt(lambda2);
    c.start.theta = theta;
    c.start.wY = b.k1 * wZ * f.Po / cos(theta);
    c.start.wZ = wZ * f.We;
    const double left = coin_energy(&top, &c.p) - coin_energy(&c.start, &c.p);
    c.start.wX = copysign(sqrt(2 * left / b.J), -theta);
    return c;
}

/* By a time t of one method, or of coin_advance() if it is METHODS. */
static void move(coin_state *s, const coin_params *p, int32_t method, double t)
{
    const uint64_t n = method == COIN_SYMPLECTIC2 ? 256 : 16;
    const int32_t status = method < METHODS
                               ? coin_run(s, p, method, t / (double)n, n, NULL)
                               : coin_advance(s, p, t, 1e-12, NULL);
    check_status(status, COIN_OK);
}

/* Within NEAR of upright the motion is the linear one, in which theta^2 -
 * (wX/rate)^2 is constant: m^2 or -m^2.  It stays for 2 ln(2 NEAR/m)/rate, and
 * m is what errors make of 0: the square root of the error of energy. */
#define NEAR 1e-3

static double stay(const struct climb *c, int32_t method, double *m)
{
    const double part = 0.25;
    coin_state s = c->start;
    double time = 0, least = INFINITY;
    for (int n = 0; n < 200 && fabs(s.theta) > NEAR; ++n)
        move(&s, &c->p, method, part);
    for (; fabs(s.theta) <= NEAR && time < 1000; time += part) {
        const double v = s.wX / c->rate, size = s.theta * s.theta + v * v;
        if (size < least) {
            least = size;
            *m = sqrt(fabs(s.theta * s.theta - v * v));
        }
        move(&s, &c->p, method, part);
    }
    return time;
}

/* As long as its error allows it to, each method stays near the top; which way
 * it leaves is chance.  Nothing is refused. */
TEST(a_separatrix_is_followed_until_rounding_decides)
{
    const double inner[] = {0, 0.5, 1};
    for (int i = 0; i < 3; ++i)
        for (int32_t method = 0; method <= METHODS; ++method) {
            const struct climb c = climb_of(inner[i], i == 1 ? -0.3 : 0.3);
            double m = 0;
            const double time = stay(&c, method, &m);
            check_note("b = %g, method %d: m = %g for %g", inner[i],
                       (int)method, m, time);
            check_within(m, 1e-12, method % METHODS == COIN_RK8 ? 1e-6 : 1e-3);
            check_near(time, 2 * log(2 * NEAR / m) / c.rate, 1);
        }
}

/* --------------------------------------------------------- critical rates */
/* The potential of a body at a critical rate is c4 theta^4, docs/physics.md,
 * "Criticality"; M = a = g = 1. */
struct quartic {
    coin_params p;
    double c4, J;
    coin_state upright;
};

static struct quartic quartic_of(double inner, int spin)
{
    struct quartic q = {.p = ring(inner)};
    const double X = q.p.inertia_X, Z = q.p.inertia_Z, J = X + 1, K = Z + 1;
    q.J = J;
    q.c4 = spin ? (9 * X * X * Z + 9 * X * X + 11 * X * Z + 5 * X + 4 * Z) /
                      (24 * X * J * K)
                : (9 * X * Z + 3 * X + 4 * Z) / (24 * X * K);
    check_status(
        spin ? coin_steady_upright_spin(&q.upright, &q.p,
                                        coin_critical_spin(&q.p))
             : coin_steady_roll(&q.upright, &q.p, coin_critical_roll(&q.p)),
        COIN_OK);
    return q;
}

/* Pushed out of upright towards a lean of m, how far the lean is off m after a
 * quarter of a period, and off 0 after a half, in m: the period is that of the
 * pure quartic, by the lemniscate's constant. */
static double quartic_error(const struct quartic *q, int32_t method, double m)
{
    const double quarter = 1.3110287771460599 * sqrt(q->J / (2 * q->c4)) / m;
    const int parts = (int)quarter;
    coin_state s = q->upright;
    s.wX = m * m * sqrt(2 * q->c4 / q->J);
    for (int i = 0; i < parts; ++i)
        move(&s, &q->p, method, quarter / parts);
    const double out = fabs(s.theta / m - 1);
    for (int i = 0; i < parts; ++i)
        move(&s, &q->p, method, quarter / parts);
    return fmax(out, fabs(s.theta / m));
}

/* The next term, theta^6, adds some m^2: four times less for half the lean. */
TEST(at_the_critical_rates_the_coin_swings_as_a_quartic)
{
    for (int i = 0; i < 6; ++i) {
        const struct quartic q = quartic_of(i / 2 * 0.5, i % 2);
        for (int32_t method = COIN_RK8; method <= METHODS; ++method) {
            if (method == COIN_SYMPLECTIC2)
                continue; /* its own error is larger than theta^4 */
            const double error = quartic_error(&q, method, 0.02);
            check_note("b = %g, %s, method %d", i / 2 * 0.5,
                       i % 2 ? "spin" : "roll", (int)method);
            check_within(error, 1e-5, 1e-2);
            check_within(error / quartic_error(&q, method, 0.01), 3.5, 4.5);
        }
    }
}

/* Just below, upright is a hill between two valleys: the coin leans out to
 * sqrt(-c2/c4) and comes back. */
TEST(just_below_it_leans_out_and_comes_back)
{
    for (int i = 0; i < 6; ++i) {
        const struct quartic q = quartic_of(i / 2 * 0.5, i % 2);
        const double below = 1e-4; /* so that 2 c2 is -2e-4 + 1e-8 */
        coin_state s = q.upright;
        s.wY *= 1 - below;
        s.wZ *= 1 - below;
        s.wX = 1e-8; /* not a lean, which would tilt the hill */
        double out = 0;
        for (int n = 0; n < 3000 && s.theta >= 0; ++n) {
            move(&s, &q.p, METHODS, 0.5);
            out = fmax(out, s.theta);
        }
        check_note("b = %g, %s", i / 2 * 0.5, i % 2 ? "spin" : "roll");
        check_near(out, sqrt(below / q.c4), 0.01 * out);
    }
}
