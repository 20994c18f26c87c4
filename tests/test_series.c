/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/methods.h"
#include "support/random.h"

#include "series.h"

#include <math.h>

#define ELEMENT COIN_PRIV_ELEMENT

static coin_priv_field field_of(const coin_params *p)
{
    const double m = p->mass * p->radius * p->radius;
    const double J = p->inertia_X + m, K = p->inertia_Z + m;
    const coin_priv_field f = {
        1,
        p->mass * p->gravity * p->radius / J,
        K / J,
        p->inertia_X / J,
        p->inertia_Z / p->inertia_X,
        m / K,
    };
    return f;
}

static coin_priv_series series_of(const coin_state *s, const coin_params *p)
{
    const coin_priv_field f = field_of(p);
    coin_priv_series y;
    coin_priv_point *at = y.at;
    at->row[0] = coin_priv_pair_make(s->theta, s->phi);
    at->row[1] = coin_priv_pair_make(s->psi, s->wX);
    at->row[2] = coin_priv_pair_make(s->wY, s->wZ);
    at->row[3] = coin_priv_pair_make(s->z, s->x);
    at->th = coin_priv_pair_make(cos(s->theta), sin(s->theta));
    at->ph = coin_priv_pair_make(cos(s->phi), sin(s->phi));
    coin_priv_series_expand(&y, &f);
    coin_priv_series_expand_path(&y);
    return y;
}

static coin_params ring(struct random *r)
{
    coin_params p;
    check_status(coin_params_ring(&p, 1, 1, random_between(r, 0, 1), 1),
                 COIN_OK);
    return p;
}

/* The first power is the rate of change, as coin_rates() has it. */
TEST(the_first_power_is_the_rate)
{
    struct random r = random_begin(91);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = ring(&r);
        const coin_state s = random_state(&r, &p, 1);
        const coin_priv_series y = series_of(&s, &p);
        const coin_priv_point *d = y.at + 1;
        coin_state rates;
        check_status(coin_rates(&s, &p, &rates), COIN_OK);
        check_near(ELEMENT(d->row[0], 0), rates.theta, 0);
        check_near(ELEMENT(d->row[0], 1), rates.phi, 64 * U);
        check_near(ELEMENT(d->row[1], 0), rates.psi, 64 * U);
        check_near(ELEMENT(d->row[1], 1), rates.wX, 128 * U);
        check_near(ELEMENT(d->row[2], 0), rates.wY, 128 * U);
        check_near(ELEMENT(d->row[2], 1), rates.wZ, 64 * U);
        check_near(ELEMENT(d->row[3], 0), rates.z, 64 * U);
        check_near(ELEMENT(d->row[3], 1), rates.x, 64 * U);
    }
}

/* A tenth of a unit on, the point is where coin_advance() goes, and its pairs
 * are those of its angles. */
TEST(the_series_follows_the_motion)
{
    struct random r = random_begin(92);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = ring(&r);
        const coin_state s = random_state(&r, &p, 0.8);
        const coin_priv_series y = series_of(&s, &p);
        const double t = random_between(&r, -0.1, 0.1);
        const coin_priv_point at = coin_priv_series_at(&y, t);
        const coin_priv_pair path = coin_priv_series_path(&y, t);
        const coin_state got = {
            ELEMENT(at.row[0], 0), ELEMENT(at.row[0], 1), ELEMENT(at.row[1], 0),
            ELEMENT(path, 1),      ELEMENT(path, 0),      ELEMENT(at.row[1], 1),
            ELEMENT(at.row[2], 0), ELEMENT(at.row[2], 1),
        };
        coin_state want = s;
        check_status(coin_advance(&want, &p, t, 1e-13, NULL), COIN_OK);
        check_near(states_apart(&got, &want, &p), 0, 1e-13);
        check_near(ELEMENT(at.th, 0), cos(got.theta), 8 * U);
        check_near(ELEMENT(at.th, 1), sin(got.theta), 8 * U);
        check_same(&at.ph, &y.at[0].ph, sizeof at.ph);
        check_same(&at.row[3], &y.at[0].row[3], sizeof at.ph);
    }
}

/* The first power that is left out, or added, is worth t^33. */
TEST(the_order_is_that_of_its_highest_power)
{
    struct random r = random_begin(93);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = ring(&r);
        const coin_state s = random_state(&r, &p, 0.5);
        const coin_priv_series y = series_of(&s, &p);
        /* Powers fall off as those of one number, the circle's radius. */
        double last = 0, middle = 0;
        for (int k = 0; k < 8; ++k) {
            last =
                fmax(last, fabs(ELEMENT(y.at[COIN_PRIV_ORDER - k].row[2], 0)));
            middle =
                fmax(middle,
                     fabs(ELEMENT(y.at[COIN_PRIV_ORDER - 16 - k].row[2], 0)));
        }
        const double radius = pow(middle / last, 1.0 / 16);
        coin_state want = s;
        check_status(coin_advance(&want, &p, 0.25 * radius, 1e-13, NULL),
                     COIN_OK);
        const coin_priv_point at = coin_priv_series_at(&y, 0.25 * radius);
        check_within(radius, 0.1, 10);
        check_near(ELEMENT(at.row[2], 0), want.wY, 1e-12);
    }
}

/* Upright and rolling, a small wX obeys wX'' = lambda^2 wX: each power is that
 * of a sine or cosine.  The next terms are smaller by 1e-60, times 3^32. */
TEST(a_small_swing_has_the_powers_of_a_sine)
{
    const coin_params p = {1, 1, 1, 0.25, 0.5, 0, {0, 0}};
    const coin_state s = {1e-30, 0, 0, 0, 0, 1e-30, 0, 1.7};
    const coin_priv_field f = field_of(&p);
    const coin_priv_series y = series_of(&s, &p);
    const double lambda2 = f.GJ - f.KJ * f.k1 * s.wZ * s.wZ;
    for (int k = 0; k + 2 <= COIN_PRIV_ORDER; ++k) {
        const double want =
            lambda2 * ELEMENT(y.at[k].row[1], 1) / ((k + 1) * (k + 2));
        check_note("power %d", k + 2);
        check_near(ELEMENT(y.at[k + 2].row[1], 1), want, 64 * U * fabs(want));
    }
}
