/* SPDX-License-Identifier: MIT */
/* What can be read off a state, against the textbook's forms. */
#include "losses.hpp"
#include "row.hpp"

namespace
{
template <class T, class R> bool energy(trial<T, R> &q)
{
    const typename T::real E = T::energy(&q.y, &q.p);
    return q.holds(E == E, &E, 8, {energy_of(q.at)});
}

template <class T, class R> bool fastest_rate(trial<T, R> &q)
{
    const typename T::real W = T::fastest_rate(&q.y, &q.p);
    return q.holds(W == W, &W, 8, {fastest(q.at)});
}

template <class T, class R> bool integrals(trial<T, R> &q)
{
    typename T::real K[2];
    terms<R> KY, KZ;
    if (!q.reads(T::integrals(&q.y, &q.p, K) == COIN_OK))
        return false;
    integrals_of(q.at, &KY, &KZ);
    return q.holds(true, K, 16, {KY, KZ});
}

template <class T, class R> bool reaction(trial<T, R> &q)
{
    typename T::force f;
    if (!q.reads(T::reaction(&q.y, &q.p, &f) == COIN_OK))
        return false;
    const table_force<R> want = force_of(q.at);
    const R F = want.friction, N = want.normal.value;
    const R allowed = 14 * (q.u * want.friction_size + q.least);
    const R normal = 14 * (q.u * want.normal.size + q.least);
    q.holds(true, f.R, 14, {want.Rx, want.normal, want.Rz, want.normal});
    q.hold(R(f.friction), F, allowed);
    if (N > 2 * normal && F / N < R(1e30))
        q.hold(R(f.ratio), F / N,
               (allowed + normal * F / N) / (N - normal) + q.u * F / N);
    return true;
}

template <class T, class R> bool rates(trial<T, R> &q)
{
    typename T::state is;
    terms<R> d[8];
    rates_of(q.at, d);
    return q.holds(T::rates(&q.y, &q.p, &is) == COIN_OK, &is.theta, 12,
                   {d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7]});
}

template <class T, class R> bool center(trial<T, R> &q)
{
    typename T::real r[3];
    const bool done = T::center(&q.y, &q.p, r) == COIN_OK;
    q.hold(r[1], terms<R>(q.at.a * q.at.c), 4);
    q.equal(r[0] == q.y.x && r[2] == q.y.z);
    return done;
}

template <class T, class R> bool velocity(trial<T, R> &q)
{
    typename T::real v[3];
    terms<R> d[8];
    rates_of(q.at, d);
    return q.holds(T::velocity(&q.y, &q.p, v) == COIN_OK, v, 8,
                   {d[3], -q.at.a * q.at.wX * q.at.s, d[4]}); /* (20) */
}

template <class T, class R> bool contact(trial<T, R> &q)
{
    const moment<R> &y = q.at;
    typename T::real r[3], v[3];
    terms<R> d[8], x = y.x, z = y.z;
    const bool done = T::contact(&q.y, &q.p, r, v) == COIN_OK;
    rates_of(y, d);
    q.holds(done, r, 8,
            {x.add(-y.a * y.s * y.sph), R(0),
             z.add(-y.a * y.s * y.cph)}); /* (21) */
    return q.holds(done, v, 8,
                   {terms<R>().add(d[2], -y.a * y.cph), R(0),
                    terms<R>().add(d[2], y.a * y.sph)}); /* (22) */
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
template <class T, class R> bool axes(trial<T, R> &q)
{
    typename T::real e[9];
    R w[9];
    frame_of(q.at, w);
    return q.near(T::axes(&q.y, e) == COIN_OK, e, 4,
                  {w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7], w[8]});
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

template <class T, class R> bool quaternion(trial<T, R> &q)
{
    typename T::real out[4];
    R w[4];
    rotation_of(q.at.theta, q.at.phi, q.at.psi, w);
    return q.near(T::quaternion(&q.y, out) == COIN_OK, out, 4,
                  {w[0], w[1], w[2], w[3]});
}

template <class T, class R> bool angular_velocity(trial<T, R> &q)
{
    typename T::real omega[3];
    R e[9];
    const bool done = T::angular_velocity(&q.y, omega) == COIN_OK;
    frame_of(q.at, e);
    for (int i = 0; i < 3; ++i)
        q.hold(omega[i],
               terms<R>()
                   .add(q.at.wX * e[i])
                   .add(q.at.wY * e[3 + i])
                   .add(q.at.wZ * e[6 + i]),
               8);
    return done;
}

/* (90), of unit columns: 8 u of 1, and 4 u of the height. */
template <class T, class R> bool matrix(trial<T, R> &q)
{
    typename T::real m[16];
    R e[9];
    if (T::matrix(&q.y, &q.p, m) != COIN_OK)
        return false;
    frame_of(q.at, e);
    const R cps = cosine(q.at.psi), sps = sine(q.at.psi);
    for (int i = 0; i < 3; ++i) {
        q.hold(R(m[i]), cps * e[i] + sps * e[3 + i], 8 * q.u);
        q.hold(R(m[4 + i]), cps * e[3 + i] - sps * e[i], 8 * q.u);
        q.hold(R(m[8 + i]), e[6 + i], 8 * q.u);
        q.equal(m[4 * i + 3] == 0);
    }
    q.hold(m[13], terms<R>().add(q.at.a * q.at.c), 4);
    q.equal(m[12] == q.y.x && m[14] == q.y.z && m[15] == 1);
    return true;
}

/* The rotation of the scene's angles, each number off by a little. */
void near_a_rotation(scene *s, const double *, int)
{
    long double q[4];
    rotation_of<long double>(s->theta, s->phi, s->psi, q);
    for (int i = 0; i < 4; ++i)
        s->q[i] = double(q[i] * (1 + 1e-3 * s->q[i]));
}

template <class R> R turned_by(R a, R b)
{
    const R turn = 4 * half_pi<R>;
    R off = magnitude(a - b);
    while (off > turn / 2)
        off = magnitude(off - turn);
    return off;
}

/* 8 u in theta, 8 u/cos theta in phi and psi, and in the one of their sum and
 * difference that stays sharp, twice 8 u. */
template <class T, class R> bool from_motion(trial<T, R> &a)
{
    using real = typename T::real;
    const scene &s = a.s;
    const real q[] = {real(s.q[0]), real(s.q[1]), real(s.q[2]), real(s.q[3])};
    const real omega[] = {real(s.wX), real(s.wY), real(s.wZ)};
    typename T::state y;
    if (T::from_motion(&y, &a.p, q, omega, real(s.x), real(s.z)) != COIN_OK)
        return false;
    const R w = q[0], x = q[1], k = q[2], l = q[3];
    const R A = root((w + x) * (w + x) + (k - l) * (k - l));
    const R B = root((w - x) * (w - x) + (k + l) * (k + l));
    const R minus = angle(k - l, w + x), plus = angle(k + l, w - x);
    const R n = w * w + x * x + k * k + l * l, c = A * B / n;
    const R theta = angle(2 * (w * x - k * l), A * B), bound = 8 * a.u;
    a.hold(R(y.theta), theta, bound);
    a.hold(turned_by(R(y.phi), plus + minus), 0, bound / c);
    a.hold(turned_by(R(y.psi), plus - minus), 0, bound / c);
    if (theta > 0)
        a.hold(turned_by(R(y.phi) - R(y.psi), 2 * minus), 0, 2 * bound);
    else
        a.hold(turned_by(R(y.phi) + R(y.psi), 2 * plus), 0, 2 * bound);
    return true;
}

/* ---------------------------------------------------------------- losses */

/* Holds an output within so many u of its terms, and of the normal numbers. */
template <class T, class R>
void holds_terms(trial<T, R> &q, double output, const terms<R> &truth,
                 int units = 16)
{
    q.hold(R(output), truth.value, units * (q.u * truth.size + 16 * q.normal));
}

template <class T, class R>
slowing<R> slowed(const trial<T, R> &q, const coin_losses &l)
{
    const moment<R> &y = q.at;
    const losses<R> of(l, softening(l, q.p), 1, 1, 1);
    return of.at(y.IX, y.IZ, y.J, y.K, y.s, y.c, y.wX, y.wY, y.wZ);
}

template <class T, class R> bool losses_power(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    const double P = coin_losses_power(&q.y, &q.p, &l);
    holds_terms(q, P, slowed(q, l).power, 24);
    return P == P;
}

template <class T, class R> bool losses_rates(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    coin_state d;
    if (coin_losses_rates(&q.y, &q.p, &l, &d) != COIN_OK)
        return false;
    const slowing<R> by = slowed(q, l);
    terms<R> want[8];
    rates_of(q.at, want);
    holds_terms(q, d.wX, want[5].add(by.wX, R(1)));
    holds_terms(q, d.wY, want[6].add(by.wY, R(1)));
    holds_terms(q, d.wZ, want[7].add(by.wZ, R(1)));
    return true;
}

template <class T, class R> bool losses_reaction(trial<T, R> &q)
{
    const coin_losses l = losses_of(q.s);
    coin_force f;
    if (coin_losses_reaction(&q.y, &q.p, &l, &f) != COIN_OK)
        return false;
    const slowing<R> by = slowed(q, l);
    const moment<R> &y = q.at;
    const R Ma = y.M * y.a;
    table_force<R> F = force_of(y);
    /* M a (-dwZ e_X + dwX e_Z) */
    F.Rx.add(by.wZ, -Ma * y.cph).add(by.wX, Ma * y.c * y.sph);
    F.normal.add(by.wX, -Ma * y.s);
    F.Rz.add(by.wZ, Ma * y.sph).add(by.wX, Ma * y.c * y.cph);
    holds_terms(q, f.R[0], F.Rx);
    holds_terms(q, f.normal, F.normal);
    holds_terms(q, f.R[2], F.Rz);
    return true;
}

/* Any state, and losses from 1e-8 to 0.1; soft, where it is not the usual, from
 * 1e-9 to 1. */
void some_losses(scene *s, const double *g, int)
{
    s->steps = std::floor(512 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 7 * g[26 + i] - 8);
    s->tol = std::pow(10, 9 * g[24] - 9);
}

/* ---------------------------------------------------------------- check() */

constexpr double LIMITS[] = {0.35, 1, 0.08, 0.16};

/* Off a threshold by a part of 1e-17 to 1. */
template <class T> void at_the_limits(scene *s, const double *genes, int)
{
    if (T::u > 1e-10)
        s->method = s->method < 2 ? 0 : 2;
    if (genes[30] < 0.3)
        s->theta = 1.5607961601207294 + 0.01 * s->q[3];
    const trial<T, long double> q(*s, 0, NO_CLAIM);
    const table_force<long double> f = force_of(q.at);
    const double mu = double(f.friction / f.normal.value);
    s->tol = mu > 0 && std::isfinite(mu) ? mu * (1 + s->q[0]) : 0.3;
    s->t = LIMITS[int(s->method)] / double(fastest(q.at)) * (1 + s->q[1]);
}

template <class T, class R> bool check(trial<T, R> &q)
{
    using real = typename T::real;
    const int method = int(q.s.method);
    const real dt = real(q.s.t), mu = real(q.s.tol);
    const int32_t bits = T::check(&q.y, &q.p, method, dt, mu);
    /* A bit that is wrong, in parts of what rounding may do to its threshold */
    const auto bit = [&](int32_t said, R beyond, R allowed) {
        if ((said != 0) != (beyond > 0))
            q.hold(beyond, 0, allowed);
    };
    const table_force<R> f = force_of(q.at);
    const R N = f.normal.value, few = 8 * q.u;
    const R limit = R(real(LIMITS[method]));
    bit(bits & COIN_LIFTS, -N, few * f.normal.size);
    if (!(bits & COIN_LIFTS))
        bit(bits & COIN_SLIPS, f.friction - R(mu) * N,
            few * (f.friction_size + R(mu) * f.normal.size));
    bit(bits & COIN_COARSE, magnitude(R(dt)) * fastest(q.at) - limit,
        few * limit);
    bit(bits & COIN_NEARLY_FLAT, R(real(0.01)) - q.at.c, few * R(0.01));
    return bits >= 0;
}

/* ----------------------------------------------------------------- params */

/* (29), within 4 u. */
template <class T, class R> bool params_ring(trial<T, R> &q)
{
    using real = typename T::real;
    const real M = q.p.mass, a = q.p.radius, g = q.p.gravity;
    const real b = q.s.q[0] < 0 ? 0 : real(a * real(q.s.q[0]));
    typename T::params p, disc;
    if (T::ring(&p, M, a, b, g) != COIN_OK)
        return false;
    const R IX = R(M) * (R(a) * a + R(b) * b) / 4;
    q.near(p.inertia_X, IX, 4);
    q.near(p.inertia_Z, 2 * IX, 4);
    q.equal(p.mass == M && p.radius == a && p.gravity == g);
    if (b == 0)
        q.equal(T::disc(&disc, M, a, g) == COIN_OK &&
                disc.inertia_X == p.inertia_X && disc.inertia_Z == p.inertia_Z);
    return true;
}

#define TWINS_LAW(name, bound, law) AT_EDGE(name, bound, nullptr, nullptr, law)
#define AT_EDGE(name, bound, edge, edge_of_floats, law)                        \
    LAW(doubles, "coin_" name, bound, 1, edge, 0, law),                        \
        LAW(floats, "coinf_" name, bound, 1, edge_of_floats, 0, law)
} // namespace

std::vector<row> observables()
{
    const char *turns = "8 u; over cos theta in phi and psi";
    const char *bits = "8 u of the terms of each threshold";
    return {
        TWINS_LAW("params_ring", "4 u", params_ring),
        TWINS_LAW("energy", "8 u", energy),
        TWINS_LAW("fastest_rate", "8 u", fastest_rate),
        TWINS_LAW("integrals", "16 u of the terms", integrals),
        TWINS_LAW("reaction", "14 u of the terms", reaction),
        TWINS_LAW("rates", "12 u of the terms", rates),
        TWINS_LAW("center", "4 u", center),
        TWINS_LAW("velocity", "8 u of the terms", velocity),
        TWINS_LAW("contact", "8 u of the terms", contact),
        TWINS_LAW("axes", "4 u", axes),
        TWINS_LAW("quaternion", "4 u", quaternion),
        TWINS_LAW("matrix", "8 u", matrix),
        TWINS_LAW("angular_velocity", "8 u of the terms", angular_velocity),
        AT_EDGE("state_from_motion", turns, near_a_rotation, near_a_rotation,
                from_motion),
        ROW("losses_power", "24 u of the terms", 1, some_losses, 0,
            losses_power),
        ROW("losses_rates", "16 u of the terms", 1, some_losses, 0,
            losses_rates),
        ROW("losses_reaction", "16 u of the terms", 1, some_losses, 0,
            losses_reaction),
        AT_EDGE("check", bits, at_the_limits<doubles>, at_the_limits<floats>,
                check),
    };
}
