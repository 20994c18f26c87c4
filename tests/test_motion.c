/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/observable.h"
#include "support/random.h"

#include "equations.h"

#include <math.h>
#include <string.h>

enum { LEAN, HEADING, ROLL, X, Z, TILT, TURN, SPIN, RATES };

static void values(const coin_state *s, const coin_params *p, double *out)
{
    coin_state d;
    check_status(coin_rates(s, p, &d), COIN_OK);
    const double of[RATES] = {d.theta, d.phi, d.psi, d.x,
                              d.z,     d.wX,  d.wY,  d.wZ};
    memcpy(out, of, sizeof of);
}

static void terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    out[LEAN] = r.wX;
    out[HEADING] = r.wY / r.cth;
    out[ROLL] = r.wZ + r.wY * r.tth;
    out[X] = r.a * (r.wZ * r.cph + r.wX * r.cth * r.sph);
    out[Z] = r.a * (r.wZ * r.sph + r.wX * r.cth * r.cph);
    out[TILT] = r.dwX;
    out[TURN] = r.wX * (r.wY * r.tth + r.IZ / r.IX * r.wZ);
    out[SPIN] = r.m / r.K * r.wX * r.wY;
}

TEST(the_rates_are_those_of_newton_and_euler)
{
    const struct observable rates = {
        values,
        terms,
        8,
        {"dtheta", "dphi", "dpsi", "dx", "dz", "dwX", "dwY", "dwZ"},
    };
    observable_at_exact_states(&rates);
}

/* A stage at a random state, its slopes times h, and coin_rates(). */
struct slopes {
    coin_state s, rates;
    double h;
    coin_priv_constants b;
    coin_priv_variables y, d;
};

static struct slopes random_slopes(struct random *r)
{
    struct slopes k;
    const coin_params p = random_coin(r);
    k.s = random_state(r, &p, 1.57);
    k.h = natural_time(&p) * random_between(r, -1, 1);
    k.b = coin_priv_constants_of(&p);
    const coin_priv_field f = coin_priv_field_of(&k.b, k.h);
    k.y = coin_priv_variables_of(&k.s);
    k.d = coin_priv_slopes_at(&f, &k.y);
    check_status(coin_rates(&k.s, &p, &k.rates), COIN_OK);
    return k;
}

/* The stage carries sines, cosines and 1/cos theta as variables: the chain
 * rule ties their rates to those of the angles.  Bound: 8 u of the one term.
 */
TEST(the_carried_functions_obey_the_chain_rule)
{
    struct random r = random_begin(7);
    for (int i = 0; i < 500; ++i) {
        const struct slopes k = random_slopes(&r);
        const double dth = k.h * k.rates.theta, dph = k.h * k.rates.phi;
        const double c = cos(k.s.theta), sine = sin(k.s.theta);
        const double want[] = {c * dth, -sine * dth, sine / (c * c) * dth,
                               cos(k.s.phi) * dph, -sin(k.s.phi) * dph};
        const double got[] = {k.d.sth, k.d.cth, k.d.q, k.d.sph, k.d.cph};
        for (int n = 0; n < 5; ++n)
            check_near(got[n], want[n], 8 * U * fabs(want[n]));
    }
}

/* Folded into the coefficients, h is a factor and nothing else. */
TEST(slopes_are_the_rates_times_h)
{
    struct random r = random_begin(46);
    for (int i = 0; i < 500; ++i) {
        const struct slopes k = random_slopes(&r);
        const coin_params p = {
            k.b.M, k.b.a, k.b.Mga / (k.b.M * k.b.a), k.b.IX, k.b.IZ, 0, {0, 0}};
        double size[OBSERVABLE_MAX];
        terms(&k.s, &p, size);
        const double h = fabs(k.h);
        check_near(k.d.wX, k.h * k.rates.wX, 12 * U * h * size[TILT]);
        check_near(k.d.wY, k.h * k.rates.wY, 12 * U * h * size[TURN]);
        check_near(k.d.wZ, k.h * k.rates.wZ, 12 * U * h * size[SPIN]);
    }
}

TEST(w_is_the_fastest_of_the_rates)
{
    struct random r = random_begin(8);
    for (int i = 0; i < 500; ++i) {
        const struct slopes k = random_slopes(&r);
        const double c = cos(k.s.theta), wX = k.s.wX, wY = k.s.wY;
        const double want =
            (wX * wX + wY * wY) / (c * c) + k.s.wZ * k.s.wZ + k.b.g_a / c;
        check_near(coin_priv_rate2(k.b.g_a, &k.y), want, 8 * U * want);
    }
}
