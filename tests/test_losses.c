/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>

enum { MEMBERS = 9, TERMS = 8 }; /* of coin_losses; the last is soft */

static double *member(coin_losses *l, int i)
{
    double *const members[MEMBERS] = {
        &l->damping, &l->dry,  &l->viscous, &l->layer, &l->gap,
        &l->rolling, &l->spin, &l->angular, &l->soft,
    };
    return members[i];
}

/* The unit of each member, for mass, length and time. */
static double unit(int i, const coin_params *p)
{
    const double T = natural_time(p), a = p->radius;
    const double torque = p->mass * p->gravity * a;
    const double units[MEMBERS] = {
        1,          torque, torque * T, torque * sqrt(T * T * T),
        torque * T, torque, torque * T, 1 / T,
        1 / T};
    return units[i];
}

static coin_losses random_losses(struct random *r, const coin_params *p)
{
    coin_losses l = {0};
    for (int i = 0; i < TERMS; ++i)
        if (random_between(r, 0, 2) < 1)
            *member(&l, i) = unit(i, p) * exp(random_between(r, -12, -2));
    if (random_between(r, 0, 2) < 1)
        l.soft = unit(8, p) * exp(random_between(r, -9, -1));
    return l;
}

/* ------------------------------------------------------------- the torques */
struct torque {
    double X, Y, Z, terms;
};

/* The torque of the losses, term by term as physics.md has it, in time. */
static struct torque torque_of(const coin_state *s, const coin_params *p,
                               const coin_losses *l)
{
    const double c = cos(s->theta), sn = sin(s->theta), T = sn / c;
    const double roll = s->wZ + s->wY * T, rate = fabs(roll);
    const double soft =
        l->soft > 0 ? l->soft : sqrt(p->gravity / p->radius) / 1024;
    const double J = p->inertia_X + p->mass * p->radius * p->radius;
    const double K = p->inertia_Z + p->mass * p->radius * p->radius;
    const double sign = roll / hypot(roll, soft);
    const double Q =
        -(l->dry * sign + l->rolling * c * sign + l->viscous * roll +
          l->layer * roll * sqrt(rate) + l->gap * roll / c);
    const double wy = s->wY * c - s->wZ * sn;
    const double fade = l->damping * rate, all = l->angular;
    /* The terms of the roll may cancel. */
    const double roll_terms = fabs(s->wZ) + fabs(s->wY * T);
    const double Q_terms =
        roll_terms * ((l->dry + l->rolling * c) / hypot(roll, soft) +
                      l->viscous + l->layer * sqrt(rate) + l->gap / c);
    const struct torque t = {
        -fade * J * s->wX - all * p->inertia_X * s->wX,
        Q * T - l->spin * wy * c - (fade + all) * p->inertia_X * s->wY,
        Q + l->spin * wy * sn - fade * K * s->wZ - all * p->inertia_Z * s->wZ,
        Q_terms / c + fabs(l->spin) * (fabs(s->wY) + fabs(s->wZ)) +
            (fade + all) * (J * fabs(s->wX) + p->inertia_X * fabs(s->wY) +
                            K * fabs(s->wZ)),
    };
    return t;
}

/* A random coin with losses in some state. */
struct drawn {
    coin_params p;
    coin_losses l;
    coin_state s;
    double J, K;
};

static struct drawn draw(struct random *r)
{
    struct drawn d;
    d.p = random_coin(r);
    d.l = random_losses(r, &d.p);
    d.s = random_state(r, &d.p, 1.5);
    const double m = d.p.mass * d.p.radius * d.p.radius;
    d.J = d.p.inertia_X + m;
    d.K = d.p.inertia_Z + m;
    return d;
}

TEST(rates_differ_from_the_ideal_ones_by_the_torques)
{
    struct random r = random_begin(141);
    for (int i = 0; i < 2000; ++i) {
        const struct drawn of = draw(&r);
        const coin_params p = of.p;
        const coin_state s = of.s;
        const double J = of.J, K = of.K;
        coin_state ideal, got;
        check_status(coin_rates(&s, &p, &ideal), COIN_OK);
        check_status(coin_losses_rates(&s, &p, &of.l, &got), COIN_OK);
        const struct torque t = torque_of(&s, &p, &of.l);
        const double slack = 200 * U * t.terms;
        check(got.theta == ideal.theta && got.phi == ideal.phi &&
              got.psi == ideal.psi && got.x == ideal.x && got.z == ideal.z);
        check_near(J * (got.wX - ideal.wX), t.X,
                   slack + 8 * U * J * fabs(ideal.wX));
        check_near(p.inertia_X * (got.wY - ideal.wY), t.Y,
                   slack + 8 * U * p.inertia_X * fabs(ideal.wY));
        check_near(K * (got.wZ - ideal.wZ), t.Z,
                   slack + 8 * U * K * fabs(ideal.wZ));
    }
}

/* The power is minus the torque times the angular velocity; and it is the rate
 * at which coin_energy() falls, by the chain rule. */
TEST(the_power_is_what_the_energy_loses)
{
    struct random r = random_begin(142);
    for (int i = 0; i < 2000; ++i) {
        const struct drawn of = draw(&r);
        const coin_params p = of.p;
        const coin_state s = of.s;
        const double J = of.J, K = of.K;
        coin_state d;
        const double P = coin_losses_power(&s, &p, &of.l);
        check(P >= 0);
        const struct torque t = torque_of(&s, &p, &of.l);
        const double w = fabs(s.wX) + fabs(s.wY) + fabs(s.wZ);
        check_near(P, -(t.X * s.wX + t.Y * s.wY + t.Z * s.wZ),
                   200 * U * t.terms * w);
        check_status(coin_losses_rates(&s, &p, &of.l, &d), COIN_OK);
        const double terms[] = {
            J * s.wX * d.wX, p.inertia_X * s.wY * d.wY, K * s.wZ * d.wZ,
            -p.mass * p.gravity * p.radius * sin(s.theta) * s.wX};
        double rate = 0, size = 0;
        for (int k = 0; k < 4; ++k) {
            rate += terms[k];
            size += fabs(terms[k]);
        }
        check_near(-rate, P, 200 * U * (t.terms * w + size));
    }
}

/* R = M (dv/dt + g e_y), dv/dt by the product rule from the rates. */
TEST(the_reaction_accelerates_the_centre)
{
    struct random r = random_begin(143);
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_losses l = random_losses(&r, &p);
        const coin_state s = random_state(&r, &p, 1.5);
        coin_state d;
        coin_force f, ideal;
        check_status(coin_losses_rates(&s, &p, &l, &d), COIN_OK);
        check_status(coin_losses_reaction(&s, &p, &l, &f), COIN_OK);
        check_status(coin_reaction(&s, &p, &ideal), COIN_OK);
        const double st = sin(s.theta), ct = cos(s.theta);
        const double sp = sin(s.phi), cp = cos(s.phi);
        const double Ma = p.mass * p.radius;
        const double g = d.wX * ct - s.wX * s.wX * st;
        const double want[3] = {Ma * (g * sp + s.wX * ct * cp * d.phi -
                                      d.wZ * cp + s.wZ * sp * d.phi),
                                p.mass * p.gravity -
                                    Ma * (d.wX * st + s.wX * s.wX * ct),
                                Ma * (g * cp - s.wX * ct * sp * d.phi +
                                      d.wZ * sp + s.wZ * cp * d.phi)};
        const double size =
            p.mass * p.gravity +
            Ma * (fabs(d.wX) + fabs(d.wZ) + fabs(s.wX * d.phi) +
                  fabs(s.wZ * d.phi) + s.wX * s.wX + fabs(s.wY * s.wZ) / ct);
        for (int k = 0; k < 3; ++k)
            check_near(f.R[k], want[k], 200 * U * size);
        check(f.normal == f.R[1]);
        check_near(f.friction, hypot(f.R[0], f.R[2]), 8 * U * size);
        check(f.normal > 0 ? f.ratio == f.friction / f.normal : isinf(f.ratio));
    }
}

TEST(without_losses_the_rates_are_the_ideal_ones)
{
    const coin_losses none = {0};
    struct random r = random_begin(144);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.57);
        coin_state d, ideal;
        check_status(coin_rates(&s, &p, &ideal), COIN_OK);
        check_status(coin_losses_rates(&s, &p, &none, &d), COIN_OK);
        check(d.wX == ideal.wX && d.wY == ideal.wY && d.wZ == ideal.wZ);
        check(coin_losses_power(&s, &p, &none) == 0);
    }
}

TEST(a_soft_of_0_stands_for_one_1024th)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.3, .wY = 0.002, .wZ = -0.001};
    const coin_losses none = {.dry = 0.1}, same = {.dry = 0.1, .soft = 0x1p-10};
    const coin_losses tiny = {.dry = 0.1, .soft = 0x1p-30};
    check(coin_losses_power(&s, &p, &none) == coin_losses_power(&s, &p, &same));
    check(coin_losses_power(&s, &p, &tiny) > coin_losses_power(&s, &p, &none));
}

/* -------------------------------------------------------------- bad input */
/* What no wheel has more of: dry and rolling, in M g a, and the others. */
static double most_of(int i)
{
    coin_losses l;
    const double *const at = member(&l, i);
    return at == &l.dry || at == &l.rolling ? 1 : 1e3;
}

TEST(every_member_is_checked)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.5, .wY = 1, .wZ = 1};
    double bad[] = {-1e-300, -1, NAN, INFINITY, 0.99e-12, 1.01e3};
    for (int i = 0; i < MEMBERS; ++i)
        for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
            coin_losses l = {0};
            bad[5] = 1.01 * most_of(i);
            coin_state out = {.phi = 7};
            coin_force f = {.ratio = 7};
            *member(&l, i) = bad[k];
            check_note("member %d is %g", i, bad[k]);
            check_status(coin_losses_check(&l, &p), COIN_EPARAMS);
            check(isnan(coin_losses_power(&s, &p, &l)));
            check_status(coin_losses_rates(&s, &p, &l, &out), COIN_EPARAMS);
            check_status(coin_losses_reaction(&s, &p, &l, &f), COIN_EPARAMS);
            check(out.phi == 7 && f.ratio == 7);
            *member(&l, i) = k % 2 ? 1.01e-12 : 0.99 * most_of(i);
            check_status(coin_losses_check(&l, &p), COIN_OK);
        }
    const coin_losses none = {0};
    check_status(coin_losses_check(&none, &p), COIN_OK);
}

/* In natural units of any coin; and `flat` is an angle. */
TEST(the_ranges_are_those_of_natural_units)
{
    coin_params p;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    for (int i = 0; i < MEMBERS; ++i) {
        const double most = most_of(i);
        const double sizes[] = {0.99e-12, 1.01e-12, 0.99 * most, 1.01 * most};
        for (int k = 0; k < 4; ++k) {
            coin_losses l = {0};
            *member(&l, i) = sizes[k] * unit(i, &p);
            check_note("member %d is %g units", i, sizes[k]);
            check_status(coin_losses_check(&l, &p),
                         k == 1 || k == 2 ? COIN_OK : COIN_EPARAMS);
        }
    }
    const coin_losses too_soft = {.soft = 0x1p-1074};
    check_status(coin_losses_check(&too_soft, &p), COIN_EPARAMS);
    const double flats[] = {-1e-9, 0.99e-12, NAN, 1.01e-2, 0, 1e-12, 1e-2};
    for (int k = 0; k < 7; ++k) {
        const coin_losses l = {.flat = flats[k]};
        check_note("flat %g", flats[k]);
        check_status(coin_losses_check(&l, &p), k < 4 ? COIN_EPARAMS : COIN_OK);
    }
}

TEST(errors_come_in_their_order)
{
    const coin_params good = disc();
    const coin_params bad = {.mass = -1};
    const coin_losses none = {0};
    const coin_losses wrong = {.dry = -1};
    const coin_state s = {0}, flat = {.theta = 2};
    coin_state out;
    coin_force f;
    check_status(coin_losses_check(NULL, &good), COIN_EARG);
    check_status(coin_losses_check(&none, NULL), COIN_EARG);
    check_status(coin_losses_check(&none, &bad), COIN_EPARAMS);
    check_status(coin_losses_rates(&s, &good, &none, NULL), COIN_EARG);
    check_status(coin_losses_rates(NULL, &good, &none, &out), COIN_EARG);
    check_status(coin_losses_rates(&s, NULL, &none, &out), COIN_EARG);
    check_status(coin_losses_rates(&s, &good, NULL, &out), COIN_EARG);
    check_status(coin_losses_rates(&flat, &bad, &none, &out), COIN_EPARAMS);
    check_status(coin_losses_rates(&flat, &good, &wrong, &out), COIN_EPARAMS);
    check_status(coin_losses_rates(&flat, &good, &none, &out), COIN_ESTATE);
    check_status(coin_losses_reaction(&s, &good, &none, NULL), COIN_EARG);
    check_status(coin_losses_reaction(&flat, &good, &none, &f), COIN_ESTATE);
    check(isnan(coin_losses_power(NULL, &good, &none)));
    check(isnan(coin_losses_power(&flat, &good, &none)));
}
