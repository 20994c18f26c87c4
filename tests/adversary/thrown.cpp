/* SPDX-License-Identifier: MIT */
/* Thrown coins: flight, touch and impact beside Newton and Euler, and whole
 * ways by what they must not do. */
#include "body.hpp"
#include "newton.hpp"
#include "row.hpp"

namespace
{
/* A body q[0] radii above the table, its velocity q[1], q[2], q[3] in parts of
 * sqrt(g a), and a table: restitution, mu_kinetic and mu_static over it. */
struct throwing : given {
    explicit throwing(const scene &s) : given(s, 1e-9)
    {
        const double v = std::sqrt(s.g * s.a);
        b.y = s.a * (std::cos(s.theta) + s.q[0]);
        b.vx = s.q[1] * v;
        b.vy = s.q[2] * v;
        b.vz = s.q[3] * v;
        table.restitution = s.steps;
        table.mu_kinetic = s.tol;
        table.mu_static = s.tol * s.method;
    }
};

void tossed(scene *s, const double *g, int)
{
    near_pose(s, g);
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
    for (R v : n.v)
        sum += magnitude(v) * t;
    return sum;
}

/* 1e-15 a radian of what turns, and the rounding of units of what the centre
 * does. */
template <class T, class R> bool flies(trial<T, R> &q)
{
    throwing c(q.s);
    newton<R> n(c.p, c.b);
    const R t = q.s.t * root(R(q.s.g) / q.s.a), turns = turned(n, t);
    double reached = 0;
    if (!(turns < R(MOST_TURN)) ||
        c.move(&c.b, q.s.t, COIN_TOUCHES, &reached) != COIN_LIFTS ||
        reached != q.s.t)
        return false;
    const R turn = R(1e-15) * (2 + turns), centre = 16 * q.u * way(n, t);
    n.fly(t);
    const newton<R> is(c.p, c.b);
    R om[2][3];
    is.omega(om[0]);
    n.omega(om[1]);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            q.hold(is.A[i][j], n.A[i][j], turn);
        q.hold(om[0][i], om[1][i], turn * n.speed() + q.normal);
        q.hold(is.r[i], n.r[i], centre + 4 * q.u * magnitude(n.r[i]));
        q.hold(is.v[i], n.v[i], centre + 4 * q.u * magnitude(n.v[i]));
    }
    return true;
}

/* The moment of a touch is one at which the gap is 0 to rounding, and before
 * which it was not negative. */
constexpr int LOOKS = 50;

template <class T, class R> bool touches(trial<T, R> &q)
{
    throwing c(q.s);
    newton<R> n(c.p, c.b);
    double reached = 0;
    const int32_t status = c.move(&c.b, q.s.t, COIN_TOUCHES, &reached);
    const R t = reached * root(R(q.s.g) / q.s.a), turns = turned(n, t);
    if (status < 0 || !(turns < R(MOST_TURN)))
        return false;
    const R rounding = R(1e-15) * (1 + turns) + 16 * q.u * way(n, t);
    R least = 0;
    for (int i = 1; i < LOOKS; ++i) {
        n.fly(t / LOOKS);
        least = lesser(least, n.gap());
    }
    n.fly(t / LOOKS);
    const R off = status & COIN_TOUCHES ? magnitude(n.gap()) : -n.gap();
    return q.is(double(larger(off, -least) / rounding));
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
        P[i] = part * d[i] + (i == 1 ? N : R(0));
    n->push(P);
    return true;
}

/* From a touch over an impact. */
template <class T, class R> bool hits(trial<T, R> &q)
{
    throwing c(q.s);
    const double soon = 1e-18 * std::sqrt(q.s.a / q.s.g);
    if (c.move(&c.b, double(INFINITY), COIN_TOUCHES) !=
        (COIN_LIFTS | COIN_TOUCHES))
        return false;
    newton<R> n(c.p, c.b);
    R d[3], u[3];
    n.lowest(d, u);
    if (!(u[1] < R(-1e-3)) || !(q.s.steps > 1e-3) || !hit(&n, c.table, u) ||
        c.move(&c.b, soon, 0) < 0)
        return false;
    R size = n.speed();
    for (int i = 0; i < 3; ++i)
        size += magnitude(n.v[i]) + magnitude(u[i]);
    const R rounding = R(1e-15) * size * (1 + 1 / n.IX + 1 / n.IZ);
    const newton<R> is(c.p, c.b);
    for (int i = 0; i < 3; ++i) {
        q.hold(is.v[i], n.v[i], rounding);
        q.hold(is.w[i], n.w[i], rounding);
    }
    return true;
}

/* All the way: it stays above the table and gains no energy but the error of
 * tol a natural unit. */
template <class T, class R> bool tosses(trial<T, R> &q)
{
    throwing c(q.s);
    const double before = coin_body_energy(&c.b, &c.p);
    double reached = 0;
    if (c.move(&c.b, q.s.t, 0, &reached) < 0)
        return false;
    const double natural = reached * std::sqrt(q.s.g / q.s.a);
    const double gained = coin_body_energy(&c.b, &c.p) - before;
    const double sunk = std::cos(c.b.s.theta) - c.b.y / q.s.a;
    return q.is(larger(gained / before / (1e-9 * (1 + natural)),
                       sunk / (20 * doubles::u)));
}

} // namespace

std::vector<row> throws()
{
    return {
        ROW("move_flies", "1e-15 a radian + 16 u of the way", 25, tossed, 0,
            flies),
        ROW("move_touches", "a gap of 1e-15 a radian + 16 u of the way", 25,
            tossed, 0, touches),
        ROW("move_hits", "1e-15 of the speeds over I_X and I_Z", 25, tossed, 0,
            hits),
        ROW("move_tosses", "tol of the energy a natural unit; 20 u below", 25,
            tossed, 0, tosses),
    };
}
