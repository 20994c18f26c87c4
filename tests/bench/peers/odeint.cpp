/* SPDX-License-Identifier: MIT */
/* Boost.odeint: Fehlberg 7(8) and Dormand-Prince 5(4) under control, and
 * Fehlberg's order 8 at a fixed step. */
#include "rates.h"

#include <array>
#include <boost/numeric/odeint.hpp>

namespace odeint = boost::numeric::odeint;

using vector = std::array<double, 8>;
using rkf78 = odeint::runge_kutta_fehlberg78<vector>;
using dopri5 = odeint::runge_kutta_dopri5<vector>;
template <class Stepper>
using controlled = typename odeint::result_of::make_controlled<Stepper>::type;

static struct {
    const scene *c;
    peer_body b;
    vector y;
    double t, h;
    rkf78 fixed;
    controlled<rkf78> rkf;
    controlled<dopri5> dopri;
} at;

static void rates(const vector &y, vector &d, double)
{
    peer_rates(&at.b, y.data(), d.data());
}

static void begin(const solver *, const scene *c, double setting)
{
    at.c = c;
    at.b = peer_body_of(c);
    scene_to_natural(c, at.y.data());
    at.t = 0;
    at.h = 1e-3;
    at.rkf = odeint::make_controlled<rkf78>(setting, setting);
    at.dopri = odeint::make_controlled<dopri5>(setting, setting);
}

static int go_fixed(double t, unsigned long steps)
{
    const double h = t / at.c->unit / double(steps);
    for (unsigned long i = 0; i < steps; ++i)
        at.fixed.do_step(rates, at.y, 0, h);
    return 0;
}

/* Onto the end, with the step's last guess kept for the next time. */
template <class Controlled> static int go(Controlled &stepper, double t)
{
    const double end = at.t + t / at.c->unit;
    for (int i = 0; i < 10000000 && at.t < end; ++i) {
        const bool last = !(at.t + at.h < end);
        double h = last ? end - at.t : at.h;
        const double guess = at.h;
        const auto done = stepper.try_step(rates, at.y, at.t, h);
        if (last && done == odeint::success) {
            at.t = end;
            at.h = guess > h ? guess : h;
        } else {
            at.h = h;
        }
        if (!(at.h > 1e-15))
            return -1;
    }
    return at.t < end ? -1 : 0;
}

static int go_rkf78(double t, unsigned long)
{
    return go(at.rkf, t);
}

static int go_dopri5(double t, unsigned long)
{
    return go(at.dopri, t);
}

static coin_state state()
{
    return scene_from_natural(at.c, at.y.data());
}

int main(int argc, char **argv)
{
    static const solver list[] = {
        {"odeint rkf78", 0, 0, PEER_TOLERANCES, 20e6, 0, begin, go_rkf78,
         state},
        {"odeint dopri5", 0, 0, PEER_TOLERANCES, 20e6, 0, begin, go_dopri5,
         state},
        {"odeint rkf78 fixed", 0, 13, 1, 0.8408964152537145, 1e-4, 20e6, 0,
         begin, go_fixed, state},
    };
    return workprec(list, 3, argc, argv);
}
