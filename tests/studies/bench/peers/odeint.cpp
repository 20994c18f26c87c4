/* SPDX-License-Identifier: MIT */
/* Boost.odeint: Fehlberg 7(8) and Dormand-Prince 5(4) under control, and
 * Fehlberg's order 8 at a fixed step. */
#include "rates.h"

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cstring>

namespace odeint = boost::numeric::odeint;

using vector = std::array<double, PEER_SIZE>;
using free_vector = std::array<double, PEER_FREE_SIZE>;
using rkf78 = odeint::runge_kutta_fehlberg78<vector>;
using free_rkf78 = odeint::runge_kutta_fehlberg78<free_vector>;
using dopri5 = odeint::runge_kutta_dopri5<vector>;
template <class Stepper>
using controlled = typename odeint::result_of::make_controlled<Stepper>::type;

static struct {
    const scene *c;
    peer_body b;
    vector y;
    free_vector free_y; // without sines
    double t, h;
    rkf78 fixed;
    free_rkf78 free_fixed;
    controlled<rkf78> rkf;
    controlled<dopri5> dopri;
} at;

static void rates(const vector &y, vector &d, double)
{
    peer_rates(&at.b, y.data(), d.data());
}

static void free_rates(const free_vector &y, free_vector &d, double)
{
    peer_free_rates(&at.b, y.data(), d.data());
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

static void begin_free(const solver *, const scene *c, double)
{
    at.c = c;
    at.b = peer_body_of(c);
    peer_free_start(c, at.free_y.data());
}

static int go_free(double t, unsigned long steps)
{
    const double h = t / at.c->unit / double(steps);
    for (unsigned long i = 0; i < steps; ++i)
        at.free_fixed.do_step(free_rates, at.free_y, 0, h);
    return 0;
}

static coin_state free_state()
{
    return peer_free_state(at.c, at.free_y.data());
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
        {"sine-free odeint rkf78 fixed", 0, 13, 1, 0.8408964152537145, 1e-4,
         20e6, 0, begin_free, go_free, free_state},
    };
    const bool mapped = argc > 1 && std::strcmp(argv[1], "atlas") == 0;
    return workprec(list, mapped ? 3 : 4, argc, argv);
}
