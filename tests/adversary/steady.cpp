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

/* Steady as coin_steady_radii() asks.  Both integrals are kept to 96 u of
 * their terms, and what rates off by 8 u/cos theta of both do to them. */
template <class R> double near(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state start = state_of<doubles>(s);
    coin_state out;
    if (coin_steady_near(&start, &p, &out) != COIN_OK)
        return NO_CLAIM;
    const moment<R> from(p, start), y(p, out);
    terms<R> KY, KZ, KY1, KZ1;
    integrals_of(from, &KY, &KZ);
    integrals_of(y, &KY1, &KZ1);
    const R roll = y.K * y.wZ * y.wY, turn = y.IX * y.wY * y.wY * y.T;
    const R most = larger(larger(magnitude(roll), magnitude(turn)), y.Mga);
    verdict<R> v;
    v.hold(roll + turn, y.Mga * y.s, R(1e-9) * most); /* (39) */
    const R size = KY.size + KZ.size + KY1.size + KZ1.size;
    moment<R> off = y;
    terms<R> KY2, KZ2;
    off.wY = off.wZ = 8 / y.c * larger(magnitude(y.wY), magnitude(y.wZ));
    integrals_of(off, &KY2, &KZ2);
    const R u = R(doubles::u), few = 96 * size + R(1e-300);
    v.hold(KY1.value, KY.value, u * (few + KY2.size));
    v.hold(KZ1.value, KZ.value, u * (few + KZ2.size));
    v.equal(out.phi == start.phi && out.psi == start.psi && out.wX == 0);
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

/* ------------------------------------------------------------ small wobbles */

/* A steady state without nudge, and a start beside it. */
void wobble_edge(scene *s, const double *g)
{
    steady_edge(s, g);
    const double w = std::sqrt(s->g / s->a);
    for (int i = 0; i < 4; ++i)
        s->q[i] = (s->q[i] < 0 ? -1 : 1) * std::pow(10, 5 * g[24] - 6) *
                  std::pow(10, -2 * g[26 + i]) * (i == 0 ? 1 : w);
}

/* The answer, and what its laws read. */
template <class R> struct swing {
    coin_state start, out;
    int32_t status;
    R rate;        /* sqrt |lambda^2| */
    R apart, turn; /* lean of the neighbour minus that of the steady motion;
                      its phi': (60), (62) */
    R reach;       /* how far the lean comes from the steady motion within t */

    swing(const scene &s, const coin_params &p)
    {
        const coin_state steady = state_of<doubles>(s);
        const moment<R> y(p, steady);
        const R lambda2 = lambda2_of(y).value;
        start = steady;
        start.theta += s.q[0];
        start.wX += s.q[1];
        start.wY += s.q[2];
        start.wZ += s.q[3];
        status = lambda2 < 0 ? coin_wobble_at(&steady, &p, &start, s.t, &out)
                             : int32_t(COIN_EDOMAIN);
        rate = root(magnitude(lambda2));
        const R wY_y = y.wY * y.T + y.k1 * y.wZ, wZ_y = y.k2 * y.wY;
        const R nY = R(s.q[2]) - wY_y * R(s.q[0]);
        const R nZ = R(s.q[3]) - wZ_y * R(s.q[0]);
        const R FY = -(y.K * y.wZ + 2 * y.IX * y.wY * y.T) / y.J;
        const R FZ = -y.K * y.wY / y.J;
        apart = -(FY * nY + FZ * nZ) / lambda2;
        turn = (y.wY + nY + (y.wY * y.T + wY_y) * apart) / y.c;
        const R Y = R(s.q[0]) - apart, v = R(s.q[1]) / rate;
        reach =
            magnitude(apart) + lesser(magnitude(Y) + magnitude(R(s.q[1]) * s.t),
                                      root(Y * Y + v * v));
    }
    bool follow(path<R> *truth, R t) const
    {
        return follow_far(truth, t, 4 * half_pi<R>() / rate);
    }
    /* The time until the path drifts no farther. */
    R drift(R t) const
    {
        const R slowest =
            lesser(magnitude(turn), magnitude(magnitude(turn) - rate));
        return magnitude(t) * slowest < 1 ? magnitude(t) : 1 / slowest;
    }
};

/* 4 (A^2 + 1e-14) (1 + |t| W) W^2/|lambda^2| where the lean does not grow; A in
 * parts of cos theta.  In x and z 1 + W times the time of drift as much. */
template <class R> double wobble(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const swing<R> by(s, p);
    if (by.status != COIN_OK)
        return NO_CLAIM;
    path<R> truth(p, by.start);
    const R W = truth.fastest() * truth.w, t = s.t, shallow = W / by.rate;
    R A = larger(by.reach, magnitude(R(s.q[0])));
    for (int i = 1; i < 4; ++i)
        A = larger(A, magnitude(R(s.q[i])) / truth.w);
    A /= cosine(R(s.theta));
    const R bound = 4 * (A * A + R(1e-14)) * (1 + magnitude(t) * W) *
                    larger(R(1), shallow * shallow);
    if (!(bound < 1) || !by.follow(&truth, t))
        return NO_CLAIM;
    R off[8], worst = 0;
    truth.apart(by.out, W / truth.w, off);
    off[3] /= 1 + W * by.drift(t);
    off[4] /= 1 + W * by.drift(t);
    for (R o : off)
        worst = larger(worst, magnitude(o));
    return double(worst / bound);
}

/* The lean stays within three times its reach. */
template <class R> double wobble_lean(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const swing<R> by(s, p);
    path<R> truth(p, by.start);
    if (by.status != COIN_OK || !by.follow(&truth, R(s.t)))
        return NO_CLAIM;
    R off[8];
    truth.apart(by.out, R(1), off);
    return double(magnitude(off[0]) / (3 * by.reach + R(1e-11)));
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
        STEADY(radii, "coin_steady_radii", "8 u of the terms", 1, steady_edge),
        STEADY(stability, "coin_stability", "16 u of the terms", 1,
               steady_edge),
        STEADY(critical, "coin_critical_roll_and_spin", "8 u", 1, nullptr),
        STEADY(near, "coin_steady_near",
               "1e-9 of (39); 96 u of K + 8 u/cos theta of the rates", 1,
               nullptr),
        STEADY(steady_at, "coin_steady_at", "6 u of the angles and path", 1,
               steady_edge),
        STEADY(
            wobble, "coin_wobble_at",
            "4 (A^2 + 1e-14) (1 + abs(t) W) W^2/abs(lambda^2); 1 + W d times "
            "that in x and z",
            5, wobble_edge),
        STEADY(wobble_lean, "coin_wobble_at_lean", "3 reach", 5, wobble_edge),
    };
    for (const row &r : made)
        rows->push_back(r);
}
