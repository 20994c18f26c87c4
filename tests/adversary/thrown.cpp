/* SPDX-License-Identifier: MIT */
/* Thrown coins: flight, touch and impact beside Newton and Euler, and whole
 * ways by what they must not do. */
#include "newton.hpp"
#include "row.hpp"
#include "slides.hpp"

#include <algorithm>

namespace
{
/* A body q[0] radii above the table, its velocity q[1], q[2], q[3] in parts of
 * sqrt(g a), and a table: restitution, mu_kinetic and mu_static over it. */
struct throwing {
    coin_params p;
    coin_body b;
    coin_table f;

    explicit throwing(const scene &s) : p(params_of<doubles>(s)), b(), f()
    {
        const double v = std::sqrt(s.g * s.a);
        b.s = state_of<doubles>(s);
        b.y = s.a * (std::cos(s.theta) + s.q[0]);
        b.vx = s.q[1] * v;
        b.vy = s.q[2] * v;
        b.vz = s.q[3] * v;
        f.restitution = s.steps;
        f.mu_kinetic = s.tol;
        f.mu_static = s.tol * s.method;
    }
    int32_t move(double t, int32_t stop, double *reached)
    {
        return coin_move(&b, &p, &f, t, 1e-9, stop, reached);
    }
};

void tossed(scene *s, const double *g)
{
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3 * g[22] - 2);
    s->steps = g[23];
    s->tol = 1.2 * g[24];
    s->method = g[25] > 0.8 ? double(INFINITY) : 1 + g[25];
    s->q[0] = std::pow(10, 5 * g[26] - 3);
    for (int i = 1; i < 4; ++i)
        s->q[i] = 6 * g[26 + i] - 3;
}

/* The radians that a body turns by until t, and what its centre moves by; the
 * truth is dear where it turns often. */
constexpr double MOST_TURN = 20;

template <class R> R turned(const newton<R> &n, R t)
{
    return n.speed() * (1 + magnitude(1 - n.IZ / n.IX)) * t;
}

template <class R> R way(const newton<R> &n, R t)
{
    R sum = magnitude(n.r[1]) + t * t;
    for (int i = 0; i < 3; ++i)
        sum += magnitude(n.v[i]) * t;
    return sum;
}

/* The difference of pose and motion, in parts of `turn` for what turns, of
 * `centre` for what the centre does. */
template <class R>
double apart(const newton<R> &is, const newton<R> &want, R turn, R centre)
{
    verdict<R> v;
    R om[2][3], size = want.speed();
    is.omega(om[0]);
    want.omega(om[1]);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            v.hold(is.A[i][j], want.A[i][j], turn);
        v.hold(om[0][i], om[1][i], turn * size + R(doubles::normal));
        v.hold(is.r[i], want.r[i],
               centre + 4 * R(doubles::u) * magnitude(want.r[i]));
        v.hold(is.v[i], want.v[i],
               centre + 4 * R(doubles::u) * magnitude(want.v[i]));
    }
    return v.worst;
}

/* 1e-15 a radian, and the rounding of units. */
template <class R> double flies(const scene &s, double)
{
    throwing c(s);
    newton<R> n(c.p, c.b);
    const R w0 = root(R(s.g) / s.a), t = s.t * w0, turn = turned(n, t);
    if (!(turn < R(MOST_TURN)))
        return NO_CLAIM;
    double reached = 0;
    if (c.move(s.t, COIN_TOUCHES, &reached) != COIN_LIFTS || reached != s.t)
        return NO_CLAIM;
    const R centre = 16 * R(doubles::u) * way(n, t);
    n.fly(t);
    return apart(newton<R>(c.p, c.b), n, R(1e-15) * (2 + turn), centre);
}

/* The moment of a touch is one at which the gap is 0 to rounding, and before
 * which it was not negative. */
constexpr int LOOKS = 50;

template <class R> double touches(const scene &s, double)
{
    throwing c(s);
    newton<R> n(c.p, c.b);
    const R w0 = root(R(s.g) / s.a);
    double reached = 0;
    const int32_t status = c.move(s.t, COIN_TOUCHES, &reached);
    const R t = reached * w0, turn = turned(n, t);
    if (status < 0 || !(turn < R(MOST_TURN)))
        return NO_CLAIM;
    const R rounding = R(1e-15) * (1 + turn) + 16 * R(doubles::u) * way(n, t);
    R least = 0;
    for (int i = 1; i < LOOKS; ++i) {
        n.fly(t / LOOKS);
        least = lesser(least, n.gap());
    }
    n.fly(t / LOOKS);
    const R off = status & COIN_TOUCHES ? magnitude(n.gap()) : -n.gap();
    return double(larger(off, -least) / rounding);
}

/* P, with W P = b. */
template <class R> void solve(R P[3], const R W[3][3], const R b[3])
{
    const auto det = [&](int with) {
        R m[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                m[i][j] = j == with ? b[i] : W[j][i];
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    for (int i = 0; i < 3; ++i)
        P[i] = det(i) / det(3);
}

/* The law of Chatterjee and Ruina; false where rounding decides whether it
 * sticks. */
template <class R> bool hit(newton<R> *n, const coin_table &f, const R u[3])
{
    R W[3][3], P[3];
    const R by[] = {-u[0], -u[1], -u[2]};
    for (int j = 0; j < 3; ++j)
        n->answer(W[j], j);
    solve(P, W, by);
    const R smooth = -u[1] / W[1][1], e = f.restitution;
    const R d[] = {P[0], P[1] - smooth, P[2]};
    const R T = root(d[0] * d[0] + d[2] * d[2]), N = (1 + e) * smooth;
    const R over = T - R(f.mu_static) * (N + d[1]);
    if (magnitude(over) < R(1e-9) * T)
        return false;
    const R part =
        !(over > 0) ? R(1) : R(f.mu_kinetic) * N / (T - R(f.mu_kinetic) * d[1]);
    for (int i = 0; i < 3; ++i)
        P[i] = part * d[i] + (i == 1 ? N : 0);
    n->push(P);
    return true;
}

/* From a touch over an impact. */
template <class R> double hits(const scene &s, double)
{
    throwing c(s);
    const double soon = 1e-18 * std::sqrt(s.a / s.g);
    const int32_t at = COIN_LIFTS | COIN_TOUCHES;
    if (c.move(double(INFINITY), COIN_TOUCHES, nullptr) != at)
        return NO_CLAIM;
    newton<R> n(c.p, c.b);
    R d[3], u[3];
    n.lowest(d, u);
    if (!(u[1] < R(-1e-3)) || !(s.steps > 1e-3) || !hit(&n, c.f, u))
        return NO_CLAIM;
    if (c.move(soon, 0, nullptr) < 0)
        return NO_CLAIM;
    R size = n.speed();
    for (int i = 0; i < 3; ++i)
        size += magnitude(n.v[i]) + magnitude(u[i]);
    const R rounding = R(1e-15) * size * (1 + 1 / n.IX + 1 / n.IZ);
    verdict<R> v;
    const newton<R> is(c.p, c.b);
    for (int i = 0; i < 3; ++i) {
        v.hold(is.v[i], n.v[i], rounding);
        v.hold(is.w[i], n.w[i], rounding);
    }
    return v.worst;
}

/* All the way: it stays above the table and gains no energy but the error of
 * tol a natural unit. */
template <class R> double tosses(const scene &s, double)
{
    throwing c(s);
    const double before = coin_body_energy(&c.b, &c.p);
    double reached = 0;
    if (c.move(s.t, 0, &reached) < 0)
        return NO_CLAIM;
    const double natural = reached * std::sqrt(s.g / s.a);
    const double gained = coin_body_energy(&c.b, &c.p) - before;
    const double sunk = std::cos(c.b.s.theta) - c.b.y / s.a;
    return std::max(gained / before / (1e-9 * (1 + natural)),
                    sunk / (20 * doubles::u));
}

template <judge quick, judge exact>
row row_of(const char *name, const char *law)
{
    return {name, law, 25, false, tossed, quick, exact};
}
} // namespace

void add_thrown(std::vector<row> *rows)
{
    rows->push_back(row_of<flies<long double>, flies<quad>>(
        "coin_move_flies", "1e-15 a radian + 16 u of the way"));
    rows->push_back(row_of<touches<long double>, touches<quad>>(
        "coin_move_touches", "a gap of 1e-15 a radian + 16 u of the way"));
    rows->push_back(row_of<hits<long double>, hits<quad>>(
        "coin_move_hits", "1e-15 of the speeds over I_X and I_Z"));
    rows->push_back(row_of<tosses<double>, tosses<double>>(
        "coin_move_tosses", "tol of the energy a natural unit; 20 u below"));
}
