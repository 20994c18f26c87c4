/* SPDX-License-Identifier: MIT */
/* What follows a motion by itself: advance and orbits. */
#include "growth.hpp"
#include "path.hpp"
#include "recurrence.hpp"
#include "row.hpp"
#include "truth.hpp"

namespace
{
/* The largest difference of the pose, in radians and radii. */
template <class R> R pose_apart(const path<R> &truth, const coin_state &s)
{
    R off[8], worst = 0;
    truth.apart(s, truth.fastest(), off);
    for (int i = 0; i < 5; ++i)
        worst = larger(worst, magnitude(off[i]));
    return worst;
}

double ratio_of(double error, double bound)
{
    return error <= 1e30 ? error / bound : BROKEN;
}

/* ---------------------------------------------------------------- advance */

template <class R> double advance(const scene &s, double enough)
{
    const coin_params p = params_of<doubles>(s);
    coin_state end = state_of<doubles>(s);
    path<R> truth(p, end);
    if (truth.is_long(R(s.t)) ||
        coin_advance(&end, &p, s.t, s.tol, nullptr) != COIN_OK)
        return NO_CLAIM;
    const R t = R(s.t), natural = magnitude(t) * truth.w;
    const R turned = natural * root(2 * truth.energy());
    if (!truth.follow(t))
        return NO_CLAIM;
    const R bound = 2 * R(s.tol) * (1 + turned) + R(1e-15) * natural +
                    16 * R(doubles::u) * truth.largest_of_pose();
    const double ratio =
        ratio_of(double(pose_apart(truth, end)), double(bound));
    if (bound >= 1)
        return NO_CLAIM;
    return unamplified(ratio, enough, [&](double most) {
        return growth(p, state_of<doubles>(s), s.t / 16, 16, most);
    });
}

/* By what part of mu F/N exceeds it on a path; where N <= 0 it is 1 if that is
 * asked for, else -1.  In natural units, M = a = g = 1. */
template <class R>
R excess(const path<R> &at, const coin_params &p, const R &mu, bool lifts)
{
    struct {
        R mass, radius, gravity, inertia_X, inertia_Z;
    } body = {1, 1, 1, 0, 0};
    struct {
        R theta, phi, psi, x, z, wX, wY, wZ;
    } y = {at.lean(), 0, 0, 0, 0, at.at()[5], at.at()[6], at.at()[7]};
    const R m = R(p.mass) * p.radius * p.radius;
    body.inertia_X = p.inertia_X / m;
    body.inertia_Z = p.inertia_Z / m;
    const table_force<R> f = force_of(moment<R>(body, y));
    return f.normal.value > 0 ? f.friction / (mu * f.normal.value) - 1
                              : R(lifts ? 1 : -1);
}

/* No excursion that exceeds mu by 1e-4 of it lies before the moment reached;
 * looked for at 48 moments, of motions that amplify errors little.  A lift-off
 * may be brief: where mu is large, there are 500. */
template <class R> double until(const scene &s, double)
{
    constexpr double TOL = 1e-12;
    const coin_params p = params_of<doubles>(s);
    const coin_state start = state_of<doubles>(s);
    const double t = std::fabs(s.t);
    coin_body end;
    coin_table table = {};
    table.mu_static = s.tol;
    table.mu_kinetic = lesser(s.tol, 0.1);
    path<R> truth(p, start);
    const int32_t bits = s.tol > 1e6 && int(s.steps) % 2 > 0
                             ? COIN_SLIPS
                             : COIN_SLIPS | COIN_LIFTS;
    double reached = 0;
    if (truth.is_long(R(t)) ||
        coin_body_from_state(&end, &start, &p) != COIN_OK ||
        coin_move(&end, &p, &table, t, TOL, bits, &reached) < 0)
        return NO_CLAIM;
    /* Next to N = 0 F/N changes fast. */
    const bool is_large = s.tol > 100;
    const int looks = is_large ? 500 : 48;
    const double late = is_large ? 1e-6 : 2 * TOL, most = is_large ? 1e5 : 1000;
    const R clear = R(reached) - late / truth.w;
    R worst = 0;
    for (int k = 0; k < looks && clear > 0; ++k) {
        if (!truth.follow(clear / looks) || truth.cos_theta() < 1 / R(most))
            return NO_CLAIM;
        worst = larger(worst, excess(truth, p, R(s.tol), bits & COIN_LIFTS));
    }
    if (worst > 0 && growth(p, start, reached / 16, 16, most + 1) > most)
        return NO_CLAIM;
    return double(worst / R(1e-4));
}

/* ------------------------------------------------------------------ orbits */

/* W at its largest in a period. */
template <class R> R fastest_ever(const path<R> &at, R period)
{
    path<R> ahead = at;
    ahead.follow(period);
    return ahead.most_W;
}

/* An error e in the angles is one of e (1 + radius_max/a) radii in the place
 * and of e W in the rates.  A far below 0 leaves out the place. */
template <class R>
double orbit_error(const path<R> &truth, const coin_state &out, R W, R far)
{
    R off[8], worst = 0;
    truth.apart(out, W, off);
    for (int i = 0; i < 8; ++i)
        if (i < 3 || i > 4 || far >= 0)
            worst = larger(worst, magnitude(off[i]) /
                                      (i == 3 || i == 4 ? 1 + far : R(1)));
    return double(worst);
}

/* What the residue of a steady motion, up to 8 u of its terms, does to the
 * lean, and to the heading in a natural time. */
template <class R>
R residue_of(const coin_params &p, const coin_state &s, R W, R time)
{
    const moment<R> y(p, s);
    const terms<R> dwX = dwX_of(y);
    const R L = magnitude(lambda2_of(y).value);
    const R lean = 16 * R(doubles::u) * larger(dwX.size, L) / L;
    return lean * (1 + 4 * W * time / y.c);
}

/* What is added to the error of the place for each period that an orbit repeats
 * with nearly the heading of the last, in radii: `sum` is the error of angles.
 */
inline double drift_of(const coin_orbit &o, double sum, double turn)
{
    const double b =
        std::fabs(std::remainder(o.heading_per_period, 6.283185307179586));
    const double swing = (o.theta_max - o.theta_min) * turn;
    return o.period > 0 ? std::fmin(sum / b, swing) : 0;
}

/* A state that an orbit tells of a time t, over the law of coin_orbit_at(). */
template <class R>
double told(const coin_orbit &o, const scene &s, double t,
            const coin_state &out, R far, double enough)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state start = state_of<doubles>(s);
    path<R> truth(p, start);
    const bool is_far = truth.is_long(R(t));
    if (!follow_far(&truth, R(t), R(o.period)))
        return NO_CLAIM;
    const double periods = o.period > 0 ? std::fabs(t) / o.period : 0;
    const double time = (std::fabs(t) + o.period) * double(truth.w);
    R W = truth.most_W;
    const R residue = o.period > 0 ? R(0) : residue_of(p, start, W, R(time));
    double amplified = 0;
    const auto ratio = [&] {
        const double bound = 1e-14 + 1e-15 * o.conditioning * periods +
                             4 * doubles::u * double(W) * time +
                             double(residue) + amplified;
        const double turn = double(W) * std::fabs(t) * double(truth.w);
        const R wide =
            far < 0 ? far : far + R(drift_of(o, bound, turn) / bound);
        return bound < 1 ? ratio_of(orbit_error(truth, out, W, wide), bound)
                         : NO_CLAIM;
    };
    if (!(ratio() > UNAMPLIFIED))
        return ratio();
    W = fastest_ever(truth, R(o.period));
    if (ratio() > larger(enough, UNAMPLIFIED))
        amplified =
            4 * doubles::u *
            (is_far ? (1 + periods) * growth(p, start, o.period / 16, 16, 1e30)
                    : growth(p, start, t / 16, 16, 1e30));
    return ratio();
}

/* The orbit of a scene; its period is 0 where there is none. */
const coin_orbit &orbit_of(const scene &s, bool is_far = false)
{
    static coin_orbit o;
    const coin_params p = params_of<doubles>(s);
    const coin_state start = state_of<doubles>(s);
    if (path<long double>(p, start).is_long(s.t) != is_far ||
        coin_orbit_init(&o, &start, &p) != COIN_OK)
        o = coin_orbit();
    return o;
}

/* At times that are followed, or farther. */
template <class R, bool IS_FAR> double orbit(const scene &s, double enough)
{
    const coin_orbit &o = orbit_of(s, IS_FAR);
    coin_state out;
    if ((IS_FAR && !(o.period > 0)) || coin_orbit_at(&o, s.t, &out) != COIN_OK)
        return NO_CLAIM;
    const R far = o.radius_max > 0 ? R(o.radius_max) / s.a : R(0);
    return told<R>(o, s, s.t, out, far, enough);
}

/* After a period lean and rates are those of the start, and heading and roll
 * have gained what the orbit states. */
template <class R> double orbit_init(const scene &s, double enough)
{
    const coin_orbit &o = orbit_of(s);
    coin_state out = state_of<doubles>(s);
    if (!(o.period > 0))
        return NO_CLAIM;
    out.phi += o.heading_per_period;
    out.psi += o.roll_per_period;
    return told<R>(o, s, o.period, out, R(-1), enough);
}

/* ------------------------------------------------------------------- edges */

/* The pose of order one, and a horizon of 0.01 to 60 natural units. */
void horizon(scene *s, const double *g)
{
    const double unit = std::sqrt(s->a / s->g);
    const double part = g[22] < 0.5 ? 2 * g[22] : 2 * g[22] - 1;
    s->t = unit * (g[22] < 0.5 ? 1 : -1) * std::pow(10, 3.8 * part - 2);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
}

/* The friction coefficient; a large one also of coins so slow that they fall,
 * bounce near flat and lift off. */
void until_it_slips(scene *s, const double *g)
{
    horizon(s, g);
    s->tol = std::pow(10, 4 * g[24] - 2);
    if (g[24] < 0.7)
        return;
    const double w = std::sqrt(s->g / s->a);
    s->tol = std::pow(10, 40 * g[24] - 28);
    s->theta = 2 * g[8] - 1;
    s->wX = w * (2 * g[11] - 1);
    s->wY = w * (g[12] - 0.5) * (g[15] < 0.5);
    s->wZ = w * (g[13] - 0.5) * (g[16] < 0.5);
}

/* The same, and most beside a steady circle: the leans and rolls between which
 * some are unstable. */
void about_circles(scene *s, const double *g)
{
    horizon(s, g);
    s->tol = std::pow(10, 6 * g[24] - 7);
    if (g[28] > 0.7)
        return;
    const double m = s->M * s->a * s->a, K = s->IZ + m,
                 Mga = s->M * s->g * s->a;
    const double w = std::sqrt(s->g / s->a);
    s->t = (g[22] < 0.5 ? 70 : -70) * g[23] / w;
    s->theta = 0.01 + 0.4 * g[8];
    s->wX = w * (g[29] < 0.5 ? 0 : std::pow(10, -16 * g[30]));
    s->wZ = w * 0.7 * g[9];
    const double sth = std::sin(s->theta), T = std::tan(s->theta);
    const double b = K * s->wZ;
    s->wY = 2 * Mga * sth / (b + std::sqrt(b * b + 4 * s->IX * Mga * sth * T));
    if (g[31] > 0.5)
        s->wY *= 1 + std::pow(10, -17 * g[27]);
}

/* Times of up to 1e6 natural units. */
void for_long(scene *s, const double *g)
{
    about_circles(s, g);
    const double units = std::pow(10, 7 * g[23] - 1);
    s->t = (g[22] < 0.5 ? units : -units) * std::sqrt(s->a / s->g);
}
} // namespace

#define MOTION(function, name, law, divisor, edge)                             \
    {                                                                          \
        name, law, divisor, false, edge, function<long double>, function<quad> \
    }

#define ORBIT(is_far, name, law, divisor, edge)                                \
    {                                                                          \
        name, law, divisor, false, edge, orbit<long double, is_far>,           \
            orbit<quad, is_far>                                                \
    }

void add_motions(std::vector<row> *rows)
{
    const row made[] = {
        MOTION(advance, "coin_advance", "2 tol a radius of speed + rounding", 5,
               horizon),
        MOTION(until, "coin_move_until", "F/N over mu by 1e-4 of mu", 2,
               until_it_slips),
        ORBIT(false, "coin_orbit_at",
              "1e-14 + 1e-15 conditioning a period + 4 u W (abs(t) + period) "
              "+ 4 u amplified",
              10, about_circles),
        ORBIT(true, "coin_orbit_at_far", "the same; up to 1e6 units", 10,
              for_long),
        MOTION(orbit_init, "coin_orbit_init",
               "lean; rates; heading and roll after a period as coin_orbit_at",
               10, about_circles),
    };
    for (const row &r : made)
        rows->push_back(r);
}
