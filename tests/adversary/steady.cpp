/* SPDX-License-Identifier: MIT */
/* Steady motions and what is in closed form about them. */
#include "row.hpp"

namespace
{
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

template <class T, class R> bool spin(trial<T, R> &q)
{
    coin_state made;
    if (coin_steady_spin(&made, &q.p, q.s.theta) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    q.near(made.wY, root(y.Mga * y.c / y.IX), 8); /* (42) */
    q.equal(made.theta == q.s.theta && made.wX == 0 && made.wZ == 0);
    return true;
}

template <class T, class R> bool circle(trial<T, R> &q)
{
    coin_state made;
    R large, slow;
    const scene &s = q.s;
    const int branch = s.method < 2 ? -1 : 1;
    if (coin_steady_circle(&made, &q.p, s.theta, s.wZ, branch) != COIN_OK)
        return false;
    roots_of(q.made(made).at, &large, &slow);
    q.near(made.wY, (branch < 0) == (s.wZ >= 0) ? large : slow, 8);
    q.equal(made.theta == s.theta && made.wX == 0 && made.wZ == s.wZ);
    return true;
}

/* (93), of a circle of any size. */
template <class T, class R> bool turn(trial<T, R> &q)
{
    const double radius = q.s.a * std::fabs(q.s.q[0] / q.s.q[1]);
    coin_state made;
    if (coin_steady_turn(&made, &q.p, q.s.theta, radius) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    const R sth = magnitude(y.s), r = R(radius) / y.a;
    const R wY = root(y.Mga * sth * y.c / (y.K * r + y.IX * sth));
    q.near(made.wY, wY, 8);
    q.near(std::fabs(made.wZ), wY / y.c * r, 8);
    q.equal(made.theta == q.s.theta && made.wX == 0 &&
            made.wZ * made.theta >= 0);
    return true;
}

/* Speed, radius, and (39). */
template <class T, class R> bool ride(trial<T, R> &q)
{
    const scene &s = q.s;
    const double radius = s.a * std::fabs(s.q[0] / s.q[1]);
    const double speed = std::sqrt(s.g * s.a) * std::fabs(s.q[2] / s.q[3]);
    coin_state made;
    if (coin_steady_ride(&made, &q.p, speed, radius) != COIN_OK)
        return false;
    const moment<R> &y = q.made(made).at;
    const R u = q.u, G = y.a * y.wZ * y.c / y.wY;
    const R roll = y.K * y.wZ * y.wY, tilt = y.IX * y.wY * y.wY * y.T;
    q.hold(y.a * y.wZ, R(speed), (16 * u + u / y.c) * R(speed));
    q.hold(G, R(radius), 16 * u * R(radius));
    q.hold(roll + tilt, y.Mga * y.s, 24 * u * y.Mga * y.s);
    q.equal(made.wX == 0 && made.wY > 0 && made.theta > 0);
    return true;
}

/* A steady state to rounding, or off by up to 1e-9. */
void steady_edge(scene *s, const double *g, int)
{
    const coin_params p = params_of<doubles>(*s);
    const moment<long double> y(p, state_of<doubles>(*s));
    long double large, slow;
    near_pose(s, g);
    s->wX = 0;
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

template <class T, class R> bool radii(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    double center, contact;
    if (coin_steady_radii(&q.y, &q.p, &center, &contact) != COIN_OK ||
        q.y.wY == 0)
        return false;
    const R G = y.a * magnitude(y.wZ * y.c / y.wY);       /* (43) */
    const R C = y.a * magnitude(y.wZ * y.c / y.wY + y.s); /* (43) */
    if (G < R(DBL_MAX)) {
        q.hold(R(center), G, 8 * (q.u * G + q.least));
        q.hold(R(contact), C, 8 * (q.u * (G + y.a * magnitude(y.s)) + q.least));
    }
    return true;
}

template <class T, class R> bool stability(trial<T, R> &q)
{
    double lambda2;
    if (coin_stability(&q.y, &q.p, &lambda2) != COIN_OK)
        return false;
    q.hold(lambda2, lambda2_of(q.at), 16);
    return true;
}

template <class T, class R> bool critical(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    if (coin_params_check(&q.p) != COIN_OK)
        return false;
    q.near(coin_critical_roll(&q.p), root(y.Mga * y.IX / y.IZ / y.K),
           8);                                              /* (45) */
    q.near(coin_critical_spin(&q.p), root(y.Mga / y.J), 8); /* (46) */
    return true;
}

/* (56) */
template <class T, class R> bool steady_at(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    coin_state out;
    if (coin_steady_at(&q.y, &q.p, q.s.t, &out) != COIN_OK)
        return false;
    const R t = q.s.t, turn = y.wY / y.c * t, h = turn / 2;
    const R chord = -y.a * y.wZ * t * (h == 0 ? R(1) : sine(h) / h);
    const R rolled = (magnitude(y.wZ) + magnitude(y.wY * y.T)) * magnitude(t);
    const R path = y.a * magnitude(y.wZ * t);
    /* 6 u of what changes, and half a unit of what comes out */
    const auto holds = [&](double is, R want, R change) {
        q.hold(R(is), want, q.u * (6 * change + magnitude(want)));
    };
    holds(out.phi, y.phi + turn, magnitude(turn));
    holds(out.psi, y.psi + (y.wZ + y.wY * y.T) * t, rolled);
    holds(out.x, y.x + chord * cosine(y.phi + h), path);
    holds(out.z, y.z - chord * sine(y.phi + h), path);
    q.equal(out.theta == q.y.theta && out.wX == 0);
    return true;
}

#define STEADY(name, bound, edge, law)                                         \
    LAW(doubles, "coin_" name, bound, 1, edge, 0, law)
} // namespace

std::vector<row> steady_motions()
{
    return {
        STEADY("steady_spin", "8 u", nullptr, spin),
        STEADY("steady_circle", "8 u", nullptr, circle),
        STEADY("steady_turn", "8 u", nullptr, turn),
        STEADY("steady_ride",
               "16 u + u/cos theta of the speed; 16 u of the radius", nullptr,
               ride),
        STEADY("steady_radii", "8 u of the terms", steady_edge, radii),
        STEADY("stability", "16 u of the terms", steady_edge, stability),
        STEADY("critical_roll_and_spin", "8 u", nullptr, critical),
        STEADY("steady_at", "6 u of the angles and path", steady_edge,
               steady_at),
    };
}
