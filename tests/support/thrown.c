/* SPDX-License-Identifier: MIT */
#include "thrown.h"

#include "check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define TURN 6.283185307179586

coin_params thrown_params(double IX, double IZ)
{
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, IX, IZ), COIN_OK);
    return p;
}

coin_priv_coin coin_of(const coin_body *b, double half)
{
    coin_priv_coin c;
    coin_priv_set_state(&c, &b->s, half);
    c.y = b->y;
    c.vx = b->vx;
    c.vy = b->vy;
    c.vz = b->vz;
    return c;
}

coin_body body_of(const coin_priv_coin *c)
{
    coin_body b = {.y = c->y, .vx = c->vx, .vy = c->vy, .vz = c->vz};
    coin_priv_get_state(&b.s, c);
    return b;
}

coin_body body_in_row(const struct table *t, size_t row, const char *suffix)
{
    static const char *const names[BODY_NUMBERS] = {
        "theta", "phi", "psi", "x",  "z",  "wX",
        "wY",    "wZ",  "y",   "vx", "vy", "vz"};
    coin_body b;
    char name[16];
    memset(&b, 0, sizeof b);
    for (int i = 0; i < BODY_NUMBERS; ++i) {
        snprintf(name, sizeof name, "%s%s", names[i], suffix);
        ((double *)&b)[i] = table_at(t, row, name);
    }
    return b;
}

double bodies_apart(const coin_body *a, const coin_body *b)
{
    double most = 0;
    for (int i = 0; i < BODY_NUMBERS; ++i) {
        const double d = ((const double *)a)[i] - ((const double *)b)[i];
        most = fmax(most, fabs(i == 1 || i == 2 ? remainder(d, TURN) : d));
    }
    return most;
}

coin_params random_body(struct random *r)
{
    const double kind = random_between(r, 0, 3);
    const double b = random_between(r, 0, 1);
    const double IX = random_between(r, 0.1, 0.5);
    if (kind < 1)
        return thrown_params(0.25, 0.5);
    if (kind < 2)
        return thrown_params((1 + b * b) / 4, (1 + b * b) / 2);
    return thrown_params(IX, IX * random_between(r, 0.3, 2));
}

coin_params cylinder(double half)
{
    coin_params p;
    check_status(coin_params_cylinder(&p, 1, 1, 2 * half, 1), COIN_OK);
    return p;
}

coin_params random_cylinder(struct random *r, double low, double high)
{
    return cylinder(low * pow(high / low, random_between(r, 0, 1)));
}

coin_body rolling(const coin_state *s, const coin_params *p)
{
    coin_body b;
    check_status(coin_body_from_state(&b, s, p), COIN_OK);
    return b;
}

coin_body random_throw(struct random *r, double high, double spin)
{
    coin_body b;
    memset(&b, 0, sizeof b);
    const double w = random_between(r, 0, spin);
    double d[3], size = 0;
    for (int i = 0; i < 3; ++i) {
        d[i] = random_between(r, -1, 1);
        size += d[i] * d[i];
    }
    const double per = w / sqrt(size);
    b.s.theta = asin(random_between(r, -1, 1));
    b.s.phi = random_between(r, -3, 3);
    b.s.psi = random_between(r, -3, 3);
    b.s.wX = per * d[0];
    b.s.wY = per * d[1];
    b.s.wZ = per * d[2];
    b.y = cos(b.s.theta) + random_between(r, 0, high) + 1e-3;
    b.vx = random_between(r, -3, 3);
    b.vy = random_between(r, -5, 5);
    b.vz = random_between(r, -3, 3);
    return b;
}

coin_body random_toss(struct random *r, const coin_params *p, double high,
                      double spin)
{
    coin_body b = random_throw(r, high, spin);
    b.y += p->thickness / 2 * fabs(sin(b.s.theta));
    return b;
}

coin_table random_table(struct random *r, const coin_params *p)
{
    const double half = p->thickness / 2;
    const double k = p->inertia_X / (1 + half * half);
    const double mu = random_between(r, 0.1, 1);
    const double bound = 0.98 * 2 * sqrt(k * (1 + k)); /* of Painleve */
    coin_table t;
    memset(&t, 0, sizeof t);
    t.mu_kinetic = fmin(mu, bound);
    t.mu_static = 1.1 * t.mu_kinetic;
    t.restitution = random_between(r, 0, 0.9);
    t.losses.dry = 3e-3 * pow(10, random_between(r, 0, 1));
    t.losses.spin = random_between(r, 0.01, 0.06);
    t.losses.viscous = 1e-3 * pow(100, random_between(r, 0, 1));
    if (random_between(r, 0, 1) < 0.5)
        t.losses.viscous = 0;
    return t;
}

double gap(const coin_body *b)
{
    return b->y - cos(b->s.theta);
}

double rim_gap(const coin_body *b, const coin_params *p)
{
    return gap(b) - p->thickness / 2 * fabs(sin(b->s.theta));
}
