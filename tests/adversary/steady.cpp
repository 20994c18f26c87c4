/* SPDX-License-Identifier: MIT */
/* Steady motions and what is in closed form about them. */
#include "growth.hpp"
#include "recurrence.hpp"
#include "row.hpp"
#include "truth.hpp"

namespace
{
using at_rest = coin_state;

/* wY of a circle, (40): the root that nothing cancels in, and the product of
 * the two. */
template <class R> void roots_of(const moment<R> &y, R *large, R *slow)
{
    const R b = y.K * y.wZ, c = y.IX * y.T, d = y.Mga * y.s;
    const R root2 = root(b * b + 4 * c * d);
    const R q = -(b + (b < 0 ? -root2 : root2)) / 2;
    *large = q / c;
    *slow = -d / q;
}

template <class R> double spin(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    coin_state made;
    if (coin_steady_spin(&made, &p, s.theta) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, made);
    verdict<R> v;
    const R wY = root(y.Mga * y.c / y.IX); /* (42) */
    v.hold(R(made.wY), wY, 8 * R(doubles::u) * wY);
    v.equal(made.theta == s.theta && made.wX == 0 && made.wZ == 0);
    return v.worst;
}

template <class R> double circle(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    coin_state made;
    const int branch = s.method < 2 ? -1 : 1;
    if (coin_steady_circle(&made, &p, s.theta, s.wZ, branch) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, made);
    R large, slow;
    roots_of(y, &large, &slow);
    verdict<R> v;
    const R wY = (branch < 0) == (s.wZ >= 0) ? large : slow;
    v.hold(R(made.wY), wY, 8 * R(doubles::u) * magnitude(wY));
    v.equal(made.theta == s.theta && made.wX == 0 && made.wZ == s.wZ);
    return v.worst;
}

/* (93), of a circle of any size. */
template <class R> double turn(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const double radius = s.a * std::fabs(s.q[0] / s.q[1]);
    coin_state made;
    if (coin_steady_turn(&made, &p, s.theta, radius) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, made);
    const R sth = magnitude(y.s), r = R(radius) / y.a;
    const R wY = root(y.Mga * sth * y.c / (y.K * r + y.IX * sth));
    const R wZ = wY / y.c * r, few = 8 * R(doubles::u);
    verdict<R> v;
    v.hold(R(made.wY), wY, few * wY);
    v.hold(magnitude(R(made.wZ)), wZ, few * wZ);
    v.equal(made.theta == s.theta && made.wX == 0 &&
            made.wZ * made.theta >= 0);
    return v.worst;
}

/* Speed, radius, and (39). */
template <class R> double ride(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const double radius = s.a * std::fabs(s.q[0] / s.q[1]);
    const double speed = std::sqrt(s.g * s.a) * std::fabs(s.q[2] / s.q[3]);
    coin_state made;
    if (coin_steady_ride(&made, &p, speed, radius) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, made);
    const R u = R(doubles::u), G = y.a * y.wZ * y.c / y.wY;
    const R roll = y.K * y.wZ * y.wY, tilt = y.IX * y.wY * y.wY * y.T;
    verdict<R> v;
    v.hold(y.a * y.wZ, R(speed), (16 * u + u / y.c) * R(speed));
    v.hold(G, R(radius), 16 * u * R(radius));
    v.hold(roll + tilt, y.Mga * y.s, 24 * u * y.Mga * y.s);
    v.equal(made.wX == 0 && made.wY > 0 && made.theta > 0);
    return v.worst;
}

/* A steady state to rounding, or off by up to 1e-9. */
void steady_edge(scene *s, const double *g)
{
    const coin_params p = params_of<doubles>(*s);
    const moment<long double> y(p, state_of<doubles>(*s));
    long double large, slow;
    s->wX = 0;
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    if (g[28] < 0.15) {
        s->theta = 0;
        *(g[28] < 0.07 ? &s->wY : &s->wZ) = 0;
    } else if (g[28] < 0.3) {
        s->wZ = 0;
        s->wY = double(root(y.Mga * y.c / y.IX));
    } else {
        roots_of(y, &large, &slow);
        s->wY = double(g[28] < 0.7 ? slow : large);
    }
    if (g[29] < 0.5)
        s->wY *= 1 + 1e-9 * s->q[0];
    s->t = std::sqrt(s->a / s->g) * (g[22] < 0.5 ? 1 : -1) *
           std::pow(10, 8 * g[23] - 2);
}

template <class R> double radii(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state made = state_of<doubles>(s);
    double center, contact;
    if (coin_steady_radii(&made, &p, &center, &contact) != COIN_OK ||
        made.wY == 0)
        return NO_CLAIM;
    const moment<R> y(p, made);
    const R u = R(doubles::u), least = R(doubles::least);
    const R G = y.a * magnitude(y.wZ * y.c / y.wY);       /* (43) */
    const R C = y.a * magnitude(y.wZ * y.c / y.wY + y.s); /* (43) */
    verdict<R> v;
    if (G < R(DBL_MAX)) {
        v.hold(R(center), G, 8 * (u * G + least));
        v.hold(R(contact), C, 8 * (u * (G + y.a * magnitude(y.s)) + least));
    }
    return v.worst;
}

template <class R> double stability(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state made = state_of<doubles>(s);
    double lambda2;
    if (coin_stability(&made, &p, &lambda2) != COIN_OK)
        return NO_CLAIM;
    const terms<R> want = lambda2_of(moment<R>(p, made));
    verdict<R> v;
    v.hold(R(lambda2), want.value,
           16 * (R(doubles::u) * want.size + R(doubles::least)));
    return v.worst;
}

template <class R> double critical(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    if (coin_params_check(&p) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, at_rest{});
    verdict<R> v;
    const R roll = root(y.Mga * y.IX / y.IZ / y.K), few = 8 * R(doubles::u);
    const R upright = root(y.Mga / y.J);
    v.hold(R(coin_critical_roll(&p)), roll, few * roll);       /* (45) */
    v.hold(R(coin_critical_spin(&p)), upright, few * upright); /* (46) */
    return v.worst;
}

/* (56) */
template <class R> double steady_at(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state made = state_of<doubles>(s);
    coin_state out;
    if (coin_steady_at(&made, &p, s.t, &out) != COIN_OK)
        return NO_CLAIM;
    const moment<R> y(p, made);
    const R t = s.t, turn = y.wY / y.c * t, h = turn / 2;
    const R u6 = 6 * R(doubles::u), half = R(doubles::u);
    const R chord = -y.a * y.wZ * t * (h == 0 ? R(1) : sine(h) / h);
    const R psi = y.psi + (y.wZ + y.wY * y.T) * t;
    const R x = y.x + chord * cosine(y.phi + h),
            z = y.z - chord * sine(y.phi + h);
    const R rolled = (magnitude(y.wZ) + magnitude(y.wY * y.T)) * magnitude(t);
    const R path = y.a * magnitude(y.wZ * t);
    verdict<R> v;
    v.hold(R(out.phi), y.phi + turn,
           u6 * magnitude(turn) + half * magnitude(y.phi + turn));
    v.hold(R(out.psi), psi, u6 * rolled + half * magnitude(psi));
    v.hold(R(out.x), x, u6 * path + half * magnitude(x));
    v.hold(R(out.z), z, u6 * path + half * magnitude(z));
    v.equal(out.theta == made.theta && out.wX == 0);
    return v.worst;
}

} // namespace

#define STEADY(function, name, law, divisor, edge)                             \
    {                                                                          \
        name, law, divisor, false, edge, function<long double>, function<quad> \
    }

void add_steady(std::vector<row> *rows)
{
    const row made[] = {
        STEADY(spin, "coin_steady_spin", "8 u", 1, nullptr),
        STEADY(circle, "coin_steady_circle", "8 u", 1, nullptr),
        STEADY(turn, "coin_steady_turn", "8 u", 1, nullptr),
        STEADY(ride, "coin_steady_ride",
               "16 u + u/cos theta of the speed; 16 u of the radius", 1,
               nullptr),
        STEADY(radii, "coin_steady_radii", "8 u of the terms", 1, steady_edge),
        STEADY(stability, "coin_stability", "16 u of the terms", 1,
               steady_edge),
        STEADY(critical, "coin_critical_roll_and_spin", "8 u", 1, nullptr),
        STEADY(steady_at, "coin_steady_at", "6 u of the angles and path", 1,
               steady_edge),
    };
    for (const row &r : made)
        rows->push_back(r);
}
