/* SPDX-License-Identifier: MIT */
/* What can be read off a state, against the textbook's forms. */
#include "row.hpp"
#include "truth.hpp"

namespace
{
/* A call's arguments in the type of the function, and the moment they mean. */
template <class T, class R> struct asked {
    typename T::params p;
    typename T::state y;
    moment<R> at;
    R u = R(T::u), least = R(T::least);
    verdict<R> v;

    explicit asked(const scene &s)
        : p(params_of<T>(s)), y(state_of<T>(s)), at(p, y)
    {
    }

    /* Whether every product in a term is a normal number, as the laws ask. */
    bool is_normal() const
    {
        const R w[] = {at.wX, at.wY, at.wZ};
        const R few[] = {at.s, at.sph, at.cph, at.k1, at.k2, at.IX / at.J};
        R product = 1, part = 1;
        for (R x : w)
            for (R other : {R(1), w[0], w[1], w[2]})
                product = x * other == 0
                              ? product
                              : lesser(product, magnitude(x * other));
        for (R x : few)
            part *= x == 0 ? R(1) : lesser(R(1), magnitude(x));
        return product * part >= R(T::normal);
    }

    /* An output within so many u of its terms; below the normal numbers
     * within as many of the smallest. */
    void hold(typename T::real output, const terms<R> &truth, int ulps)
    {
        v.hold(R(output), truth.value, ulps * (u * truth.size + least));
    }
};

template <class T, class R> double energy(const scene &s, double)
{
    asked<T, R> q(s);
    const typename T::real E = T::energy(&q.y, &q.p);
    if (E != E || !q.is_normal())
        return NO_CLAIM;
    q.hold(E, energy_of(q.at), 8);
    return q.v.worst;
}

template <class T, class R> double fastest_rate(const scene &s, double)
{
    asked<T, R> q(s);
    const typename T::real W = T::fastest_rate(&q.y, &q.p);
    if (W != W || !q.is_normal())
        return NO_CLAIM;
    q.hold(W, terms<R>().add(fastest(q.at)), 8);
    return q.v.worst;
}

template <class T, class R> double integrals(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real K[2];
    if (T::integrals(&q.y, &q.p, K) != COIN_OK || !q.is_normal())
        return NO_CLAIM;
    terms<R> KY, KZ;
    integrals_of(q.at, &KY, &KZ);
    q.hold(K[0], KY, 16);
    q.hold(K[1], KZ, 16);
    return q.v.worst;
}

template <class T, class R> double reaction(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::force f;
    if (T::reaction(&q.y, &q.p, &f) != COIN_OK || !q.is_normal())
        return NO_CLAIM;
    const table_force<R> want = force_of(q.at);
    const R F = want.friction,
            allowed = 14 * (q.u * want.friction_size + q.least);
    const R normal = 14 * (q.u * want.normal.size + q.least);
    const R N = want.normal.value;
    q.hold(f.R[0], want.Rx, 14);
    q.hold(f.R[1], want.normal, 14);
    q.hold(f.R[2], want.Rz, 14);
    q.hold(f.normal, want.normal, 14);
    q.v.hold(R(f.friction), F, allowed);
    if (N > 2 * normal && F / N < R(1e30))
        q.v.hold(R(f.ratio), F / N,
                 (allowed + normal * F / N) / (N - normal) + q.u * F / N);
    return q.v.worst;
}

template <class T, class R> double rates(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::state d;
    if (T::rates(&q.y, &q.p, &d) != COIN_OK || !q.is_normal())
        return NO_CLAIM;
    terms<R> want[8];
    rates_of(q.at, want);
    for (int i = 0; i < 8; ++i)
        q.hold((&d.theta)[i], want[i], 12);
    return q.v.worst;
}

template <class T, class R> double center(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real r[3];
    if (T::center(&q.y, &q.p, r) != COIN_OK)
        return NO_CLAIM;
    q.hold(r[1], terms<R>().add(q.at.a * q.at.c), 4);
    q.v.equal(r[0] == q.y.x && r[2] == q.y.z);
    return q.v.worst;
}

template <class T, class R> double velocity(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real v[3];
    if (T::velocity(&q.y, &q.p, v) != COIN_OK || !q.is_normal())
        return NO_CLAIM;
    terms<R> d[8];
    rates_of(q.at, d);
    q.hold(v[0], d[3], 8);
    q.hold(v[1], terms<R>().add(-q.at.a * q.at.wX * q.at.s), 8); /* (20) */
    q.hold(v[2], d[4], 8);
    return q.v.worst;
}

template <class T, class R> double contact(const scene &s, double)
{
    asked<T, R> q(s);
    const moment<R> &y = q.at;
    typename T::real r[3], v[3];
    if (T::contact(&q.y, &q.p, r, v) != COIN_OK || !q.is_normal())
        return NO_CLAIM;
    terms<R> roll, d[8];
    rates_of(y, d);
    q.hold(r[0], terms<R>().add(y.x).add(-y.a * y.s * y.sph), 8); /* (21) */
    q.hold(r[2], terms<R>().add(y.z).add(-y.a * y.s * y.cph), 8); /* (21) */
    q.hold(v[0], terms<R>().add(d[2], -y.a * y.cph), 8);          /* (22) */
    q.hold(v[2], terms<R>().add(d[2], y.a * y.sph), 8);           /* (22) */
    q.v.equal(r[1] == 0 && v[1] == 0);
    return q.v.worst;
}

template <class R> void frame_of(const moment<R> &y, R e[9])
{
    const R rows[] = {
        y.cph,       0,           -y.sph, y.s * y.sph, y.c,
        y.s * y.cph, y.c * y.sph, -y.s,   y.c * y.cph,
    }; /* (7) */
    for (int i = 0; i < 9; ++i)
        e[i] = rows[i];
}

/* Of unit rows: 4 u of 1. */
template <class T, class R> double axes(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real e[9];
    R want[9];
    if (T::axes(&q.y, e) != COIN_OK)
        return NO_CLAIM;
    frame_of(q.at, want);
    for (int i = 0; i < 9; ++i)
        q.v.hold(R(e[i]), want[i], 4 * q.u);
    return q.v.worst;
}

/* (30) */
template <class R> void rotation_of(R theta, R phi, R psi, R q[4])
{
    const R C1 = cosine(phi / 2), S1 = sine(phi / 2);
    const R C2 = cosine(theta / 2), S2 = sine(theta / 2);
    const R C3 = cosine(psi / 2), S3 = sine(psi / 2);
    q[0] = C1 * C2 * C3 + S1 * S2 * S3;
    q[1] = C1 * S2 * C3 + S1 * C2 * S3;
    q[2] = S1 * C2 * C3 - C1 * S2 * S3;
    q[3] = C1 * C2 * S3 - S1 * S2 * C3;
}

template <class T, class R> double quaternion(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real out[4];
    R want[4];
    if (T::quaternion(&q.y, out) != COIN_OK)
        return NO_CLAIM;
    rotation_of(q.at.theta, q.at.phi, q.at.psi, want);
    for (int i = 0; i < 4; ++i)
        q.v.hold(R(out[i]), want[i], 4 * q.u);
    return q.v.worst;
}

template <class T, class R> double angular_velocity(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real omega[3];
    R e[9];
    if (T::angular_velocity(&q.y, omega) != COIN_OK)
        return NO_CLAIM;
    frame_of(q.at, e);
    for (int i = 0; i < 3; ++i)
        q.hold(omega[i],
               terms<R>()
                   .add(q.at.wX * e[i])
                   .add(q.at.wY * e[3 + i])
                   .add(q.at.wZ * e[6 + i]),
               8);
    return q.v.worst;
}

/* (90), of unit columns: 8 u of 1, and 4 u of the height. */
template <class T, class R> double matrix(const scene &s, double)
{
    asked<T, R> q(s);
    typename T::real m[16];
    R e[9];
    if (T::matrix(&q.y, &q.p, m) != COIN_OK)
        return NO_CLAIM;
    frame_of(q.at, e);
    const R cps = cosine(q.at.psi), sps = sine(q.at.psi);
    for (int i = 0; i < 3; ++i) {
        q.v.hold(R(m[i]), cps * e[i] + sps * e[3 + i], 8 * q.u);
        q.v.hold(R(m[4 + i]), cps * e[3 + i] - sps * e[i], 8 * q.u);
        q.v.hold(R(m[8 + i]), e[6 + i], 8 * q.u);
        q.v.equal(m[4 * i + 3] == 0);
    }
    q.hold(m[13], terms<R>().add(q.at.a * q.at.c), 4);
    q.v.equal(m[12] == q.y.x && m[14] == q.y.z && m[15] == 1);
    return q.v.worst;
}

/* The rotation of the scene's angles, each number off by a little. */
void near_a_rotation(scene *s, const double *)
{
    long double q[4];
    rotation_of<long double>(s->theta, s->phi, s->psi, q);
    for (int i = 0; i < 4; ++i)
        s->q[i] = double(q[i] * (1 + 1e-3 * s->q[i]));
}

template <class R> R turned_by(R a, R b)
{
    const R turn = 4 * half_pi<R>();
    R off = magnitude(a - b);
    while (off > turn / 2)
        off = magnitude(off - turn);
    return off;
}

/* 8 u in theta, 8 u/cos theta in phi and psi, and in the one of their sum and
 * difference that stays sharp, twice 8 u. */
template <class T, class R> double from_motion(const scene &s, double)
{
    using real = typename T::real;
    asked<T, R> a(s);
    const real q[] = {real(s.q[0]), real(s.q[1]), real(s.q[2]), real(s.q[3])};
    const real omega[] = {real(s.wX), real(s.wY), real(s.wZ)};
    typename T::state y;
    if (T::from_motion(&y, &a.p, q, omega, real(s.x), real(s.z)) != COIN_OK)
        return NO_CLAIM;
    const R w = q[0], x = q[1], k = q[2], l = q[3];
    const R A = root((w + x) * (w + x) + (k - l) * (k - l));
    const R B = root((w - x) * (w - x) + (k + l) * (k + l));
    const R minus = angle(k - l, w + x), plus = angle(k + l, w - x);
    const R n = w * w + x * x + k * k + l * l, c = A * B / n;
    const R theta = angle(2 * (w * x - k * l), A * B), bound = 8 * a.u;
    a.v.hold(R(y.theta), theta, bound);
    a.v.hold(turned_by(R(y.phi), plus + minus), 0, bound / c);
    a.v.hold(turned_by(R(y.psi), plus - minus), 0, bound / c);
    if (theta > 0)
        a.v.hold(turned_by(R(y.phi) - R(y.psi), 2 * minus), 0, 2 * bound);
    else
        a.v.hold(turned_by(R(y.phi) + R(y.psi), 2 * plus), 0, 2 * bound);
    return a.v.worst;
}

/* ---------------------------------------------------------------- check() */

/* A part off 1 by 1e-17 to 1, from a number of scene::q. */
double nearly(double q)
{
    return 1 + q;
}

constexpr double LIMITS[] = {0.35, 1, 0.08, 0.16};

template <class T> void at_the_limits(scene *s, const double *genes)
{
    if (T::u > 1e-10)
        s->method = s->method < 2 ? 0 : 2;
    if (genes[30] < 0.3)
        s->theta = 1.5607961601207294 + 0.01 * s->q[3];
    const asked<T, long double> q(*s);
    const table_force<long double> f = force_of(q.at);
    const double mu = double(f.friction / f.normal.value);
    s->tol = mu > 0 && std::isfinite(mu) ? mu * nearly(s->q[0]) : 0.3;
    const double W = double(fastest(q.at));
    s->t = LIMITS[int(s->method)] / W * nearly(s->q[1]);
}

/* A bit that is wrong, in parts of what rounding may do to its threshold. */
template <class R> void bit(verdict<R> *v, bool said, R beyond, R allowed)
{
    if (said != (beyond > 0))
        v->hold(beyond, 0, allowed);
}

template <class T, class R> double check(const scene &s, double)
{
    using real = typename T::real;
    asked<T, R> q(s);
    const int method = int(s.method);
    const real dt = real(s.t), mu = real(s.tol);
    const int32_t bits = T::check(&q.y, &q.p, method, dt, mu);
    if (bits < 0)
        return NO_CLAIM;
    const table_force<R> f = force_of(q.at);
    const R N = f.normal.value, few = 8 * q.u;
    bit<R>(&q.v, bits & COIN_LIFTS, -N, few * f.normal.size);
    if (!(bits & COIN_LIFTS))
        bit<R>(&q.v, bits & COIN_SLIPS, f.friction - R(mu) * N,
               few * (f.friction_size + R(mu) * f.normal.size));
    const R limit = R(typename T::real(LIMITS[method]));
    const R dtW = magnitude(R(dt)) * fastest(q.at);
    bit<R>(&q.v, bits & COIN_COARSE, dtW - limit, few * limit);
    bit<R>(&q.v, bits & COIN_NEARLY_FLAT, R(real(0.01)) - q.at.c,
           few * R(0.01));
    return q.v.worst;
}

/* ----------------------------------------------------------------- params */

/* (29), within 4 u. */
template <class T, class R> double params_ring(const scene &s, double)
{
    using real = typename T::real;
    const real M = real(s.M), a = real(s.a), g = real(s.g);
    const real b = s.q[0] < 0 ? 0 : real(a * real(s.q[0]));
    typename T::params p;
    if (T::ring(&p, M, a, b, g) != COIN_OK)
        return NO_CLAIM;
    verdict<R> v;
    const R IX = R(M) * (R(a) * a + R(b) * b) / 4, u = R(T::u);
    v.hold(R(p.inertia_X), IX, 4 * u * IX);
    v.hold(R(p.inertia_Z), 2 * IX, 4 * u * 2 * IX);
    v.equal(p.mass == M && p.radius == a && p.gravity == g);
    if (b == 0) {
        typename T::params disc;
        v.equal(T::disc(&disc, M, a, g) == COIN_OK &&
                disc.inertia_X == p.inertia_X && disc.inertia_Z == p.inertia_Z);
    }
    return v.worst;
}

#define ROW(name, law, function, edge)                                         \
    rows->push_back({"coin_" name, law, 1, false, edge(doubles),               \
                     function<doubles, long double>,                           \
                     function<doubles, quad>});                                \
    rows->push_back({"coinf_" name, law, 1, true, edge(floats),                \
                     function<floats, long double>, function<floats, quad>})
#define NO_EDGE(T) nullptr
#define ROTATION(T) near_a_rotation
#define THRESHOLDS(T) at_the_limits<T>
} // namespace

void add_observables(std::vector<row> *rows)
{
    ROW("params_ring", "4 u", params_ring, NO_EDGE);
    ROW("energy", "8 u", energy, NO_EDGE);
    ROW("fastest_rate", "8 u", fastest_rate, NO_EDGE);
    ROW("integrals", "16 u of the terms", integrals, NO_EDGE);
    ROW("reaction", "14 u of the terms", reaction, NO_EDGE);
    ROW("rates", "12 u of the terms", rates, NO_EDGE);
    ROW("center", "4 u", center, NO_EDGE);
    ROW("velocity", "8 u of the terms", velocity, NO_EDGE);
    ROW("contact", "8 u of the terms", contact, NO_EDGE);
    ROW("axes", "4 u", axes, NO_EDGE);
    ROW("quaternion", "4 u", quaternion, NO_EDGE);
    ROW("matrix", "8 u", matrix, NO_EDGE);
    ROW("angular_velocity", "8 u of the terms", angular_velocity, NO_EDGE);
    ROW("state_from_motion", "8 u; over cos theta in phi and psi", from_motion,
        ROTATION);
    ROW("check", "8 u of the terms of each threshold", check, THRESHOLDS);
}
