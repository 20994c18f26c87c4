/* SPDX-License-Identifier: MIT */
#include "losses.h"

#include "check.h"

#include <math.h>
#include <stdio.h>

const coin_state spun = {.theta = 1.25, .wX = 0.05, .wY = 1.125};

const char *const loss_names[LAWS] = {"dry",     "viscous", "layer",  "gap",
                                      "rolling", "damping", "angular"};

coin_losses one_loss(int law, double m)
{
    coin_losses l = {0};
    double *const members[LAWS] = {&l.dry,     &l.viscous, &l.layer,  &l.gap,
                                   &l.rolling, &l.damping, &l.angular};
    *members[law] = m;
    return l;
}

/* d(wX)/dt = 0 where the losses slow wY and wZ: (39) keeps holding. */
coin_state slow_spin(const coin_params *p, const coin_losses *l, double angle)
{
    coin_state s, rates;
    check_status(coin_steady_spin(&s, p, 1.5707963267948966 - angle), COIN_OK);
    check_status(coin_losses_rates(&s, p, l, &rates), COIN_OK);
    const double IX = p->inertia_X,
                 K = p->inertia_Z + p->mass * p->radius * p->radius;
    const double T = tan(s.theta), c = cos(s.theta), wY = s.wY, wZ = s.wZ;
    const double FY = 2 * IX * T * wY + K * wZ, FZ = K * wY;
    const double Fth =
        IX * wY * wY / (c * c) - p->mass * p->gravity * p->radius * c;
    const double k2 = p->mass * p->radius * p->radius / K;
    s.wX = -(FY * rates.wY + FZ * rates.wZ) /
           (Fth + FY * (wY * T + p->inertia_Z / IX * wZ) + FZ * k2 * wY);
    return s;
}

coin_losses losses_in(const coin_losses *l, double M, double L, double T)
{
    const double torque = M * L * L / (T * T);
    const coin_losses r = {
        .damping = l->damping,
        .dry = l->dry * torque,
        .viscous = l->viscous * torque * T,
        .layer = l->layer * torque * T * sqrt(T),
        .gap = l->gap * torque * T,
        .rolling = l->rolling * torque,
        .spin = l->spin * torque * T,
        .angular = l->angular / T,
        .soft = l->soft / T,
        .flat = l->flat,
    };
    return r;
}

coin_state state_in(const coin_state *s, double L, double T)
{
    const coin_state r = {s->theta, s->phi,    s->psi,    s->x * L,
                          s->z * L, s->wX / T, s->wY / T, s->wZ / T};
    return r;
}

void check_losses_rows(const char *name, row_check *check_row,
                       const void *scene)
{
    const double units[][3] = {{1, 1, 1}, {0.00567, 0.01213, 0.0351}};
    struct table t;
    char file[64];
    snprintf(file, sizeof file, "losses/%s.csv", name);
    table_load(&t, file);
    for (size_t row = 0; row < t.rows; ++row)
        for (int u = 0; u < 2; ++u) {
            check_note("%s, row %zu, units %d", name, row, u);
            check_row(scene, &t, row, units[u]);
        }
}

int32_t settle(coin_state *s, const coin_params *p, const coin_losses *l,
               double tol, double *when)
{
    coin_losses near = *l;
    near.flat = near.flat > 0 ? near.flat : 1e-12;
    return coin_settle(s, p, &near, 1e6 * natural_time(p), tol, when);
}

coin_losses random_losses(struct random *r, const coin_params *p, double most)
{
    double *member;
    coin_losses l = {0};
    for (int i = 0; i < 8; ++i) {
        member = (double *)&l + i;
        if (random_between(r, 0, 1) < 0.4)
            *member = most * exp(random_between(r, -8, 0));
    }
    if (!(l.damping + l.dry + l.viscous + l.layer + l.gap + l.rolling > 0))
        l.dry = most * exp(random_between(r, -4, 0));
    const double T = natural_time(p);
    return losses_in(&l, p->mass, p->radius, T);
}
