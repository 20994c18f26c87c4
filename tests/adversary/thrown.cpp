/* SPDX-License-Identifier: MIT */
/* Thrown coins: flight, touch and impact beside Newton and Euler in the table's
 * frame, and whole ways by what they must not do. */
#include "law.hpp"

namespace
{
using vector = std::valarray<real>;

real dot(const vector &a, const vector &b)
{
    return (a * b).sum();
}
real size_of(const vector &a)
{
    return std::sqrt(dot(a, a));
}
vector cross(const vector &a, const vector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}
/* Turned about an axis of length 1. */
vector about(const vector &axis, real angle, const vector &a)
{
    const real c = std::cos(angle);
    return a * c + cross(axis, a) * std::sin(angle) +
           axis * ((1 - c) * dot(axis, a));
}

/* A symmetric top without a contact, in natural units: the centre falls, axis
 * and body turn about the angular momentum L, at rates that are proportional to
 * it.  The torque -slows L makes it fade: dL/dt = -slows L. */
struct top {
    real IX, IZ, slows;
    vector X, Z, L, r, v; /* an axis of the body in its plane, and its own */

    top(const coin_params &p, const coin_body &b, double angular = 0)
    {
        const moment y(p, b.s);
        const real w = std::sqrt(y.g / y.a), V = y.a * w;
        const frame e(y);
        IX = y.IX / y.m;
        IZ = y.IZ / y.m;
        slows = angular / w;
        Z = e.Z;
        X = about(Z, y.psi, e.X);
        L = (e.X * y.wX + e.Y * y.wY) * (IX / w) + Z * (IZ * y.wZ / w);
        r = {y.x / y.a, b.y / y.a, y.z / y.a};
        v = {b.vx / V, b.vy / V, b.vz / V};
    }

    /* The time in which L as it is now would turn the top as far. */
    real faded(real t) const
    {
        return slows > 0 ? -std::expm1(-slows * t) / slows : t;
    }

    void fly(real t)
    {
        const real size = size_of(L), own = (1 / IZ - 1 / IX) * dot(L, Z);
        const real turns = faded(t);
        const vector axis = size > 0 ? vector(L / size) : Z;
        X = about(axis, size / IX * turns, about(Z, own * turns, X));
        Z = about(axis, size / IX * turns, Z);
        L *= std::exp(-slows * t);
        r += v * t;
        r[1] -= t * t / 2;
        v[1] -= t;
    }

    vector omega() const
    {
        return L / IX + Z * ((1 / IZ - 1 / IX) * dot(L, Z));
    }

    /* From the centre to the lowest point, its height, and its velocity. */
    vector lowest() const
    {
        const real h = std::hypot(Z[0], Z[2]);
        return {Z[1] * Z[0] / h, -h, Z[1] * Z[2] / h};
    }
    real gap() const
    {
        return r[1] - std::hypot(Z[0], Z[2]);
    }
    vector speed() const
    {
        return v + cross(omega(), lowest());
    }

    /* An impulse at the lowest point. */
    void push(const vector &p)
    {
        v += p;
        L += cross(lowest(), p);
    }
    /* Column j of the matrix from such an impulse to the change of the point's
     * velocity. */
    vector answer(int j) const
    {
        top by = *this;
        vector p(3);
        p[size_t(j)] = 1;
        by.push(p);
        return by.speed() - speed();
    }

    /* The radians that it turns by until t, and what its centre moves by. */
    real turned(real t) const
    {
        return size_of(omega()) * (1 + std::fabs(1 - IZ / IX)) * faded(t);
    }
    real way(real t) const
    {
        return std::fabs(r[1]) + t * t + std::abs(v).sum() * t;
    }
};

/* Each component to `allowed`, and a part of itself. */
void hold(trial<doubles> *q, const vector &is, const vector &truth,
          real allowed, real part = 0)
{
    for (size_t i = 0; i < 3; ++i)
        q->hold(is[i], truth[i], allowed + part * std::fabs(truth[i]));
}

void tossed(scene *s, const double *g)
{
    horizon(s, g, -2, 1);
    s->tol = 1e-9;
    s->which = 0;
}

/* The turn fades: within any part of the flight, or hardly. */
void fading(scene *s, const double *g)
{
    tossed(s, g);
    s->which = 256;
    s->loss[3] = power_of_ten(g[LOSS], g[LOSS + 1] < 0.5 ? -2 : -11.9, 2.9);
}

/* What a pose errs by where the face is within 16 u of horizontal: the library
 * takes it for horizontal, which may move it to the other side of that. */
real level(const top &n)
{
    return std::hypot(n.Z[0], n.Z[2]) <= 16 * doubles::u ? 32 * doubles::u : 0;
}

/* 1e-15 a radian of what turns, and the rounding of units of what the centre
 * does. */
bool flies(trial<doubles> &q)
{
    top n(q.p, q.b, q.table.losses.angular);
    const real t = q.s.t / real(unit_of(q.s)), fast = size_of(n.omega());
    double reached = 0;
    if (q.move(&q.b, q.s.t, COIN_TOUCHES, &reached) != COIN_LIFTS ||
        reached != q.s.t)
        return false;
    const real way = 16 * q.u * n.way(t);
    real turn = 1e-15L * (2 + n.turned(t)) + level(n);
    n.fly(t);
    turn += level(n);
    const top is(q.p, q.b);
    hold(&q, is.X, n.X, turn);
    hold(&q, is.Z, n.Z, turn);
    hold(&q, is.omega(), n.omega(), turn * fast + q.normal);
    hold(&q, is.r, n.r, way, 4 * q.u);
    hold(&q, is.v, n.v, way, 4 * q.u);
    return true;
}

/* The moment of a touch is one at which the gap is 0 to rounding, and before
 * which it was not negative. */
constexpr int LOOKS = 50;

bool touches(trial<doubles> &q)
{
    top n(q.p, q.b, q.table.losses.angular);
    double reached = 0;
    const int32_t status = q.move(&q.b, q.s.t, COIN_TOUCHES, &reached);
    if (status < 0)
        return false;
    const real t = reached / real(unit_of(q.s));
    const real rounding =
        1e-15L * (1 + n.turned(t)) + 16 * q.u * n.way(t) + level(n);
    real least = 0;
    for (int i = 1; i < LOOKS; ++i) {
        n.fly(t / LOOKS);
        least = std::min(least, n.gap());
    }
    n.fly(t / LOOKS);
    const real off = status & COIN_TOUCHES ? std::fabs(n.gap()) : -n.gap();
    return q.is(double(std::max(off, -least) / rounding));
}

/* P, with W P = b; the columns of W are given. */
vector solve(const vector W[3], const vector &b)
{
    const vector c = cross(W[1], W[2]);
    return vector{dot(b, c), dot(W[0], cross(b, W[2])),
                  dot(W[0], cross(W[1], b))} /
           dot(W[0], c);
}

/* The law of Chatterjee and Ruina; false where rounding decides whether it
 * sticks. */
bool hit(top *n, const coin_table &f)
{
    const vector u = n->speed(),
                 W[] = {n->answer(0), n->answer(1), n->answer(2)};
    const real smooth = -u[1] / W[1][1], N = (1 + f.restitution) * smooth;
    vector P = solve(W, -u);
    P[1] -= smooth;
    const real T = std::hypot(P[0], P[2]);
    const real mu = f.mu_static, over = mu > DBL_MAX ? -T : T - mu * (N + P[1]);
    if (std::fabs(over) < 1e-9L * T)
        return false;
    const real part =
        over > 0 ? f.mu_kinetic * N / (T - f.mu_kinetic * P[1]) : 1;
    P *= part;
    P[1] += N;
    n->push(P);
    return true;
}

/* From a touch over an impact, and for a moment on. */
constexpr double SOON = 1e-18;
bool hits(trial<doubles> &q)
{
    if (q.move(&q.b, double(INFINITY), COIN_TOUCHES) !=
        (COIN_LIFTS | COIN_TOUCHES))
        return false;
    top n(q.p, q.b);
    const vector u = n.speed();
    const real size = size_of(n.omega()) + size_of(n.v) + size_of(u);
    if (!(u[1] < -1e-3L) || !(q.table.restitution > 1e-3) ||
        !hit(&n, q.table) || q.move(&q.b, SOON * unit_of(q.s), 0) < 0)
        return false;
    const real turn = 1e-15L + SOON * size_of(n.omega());
    const real rounding = turn * size * (1 + 1 / n.IX + 1 / n.IZ);
    const top is(q.p, q.b);
    hold(&q, is.v, n.v, rounding);
    hold(&q, is.omega(), n.omega(), rounding);
    return true;
}

/* All the way: it stays above the table and gains no energy but the error of
 * tol a natural unit. */
bool tosses(trial<doubles> &q)
{
    const double before = coin_body_energy(&q.b, &q.p);
    double reached = 0;
    if (q.move(&q.b, q.s.t, 0, &reached) < 0)
        return false;
    const double gained = coin_body_energy(&q.b, &q.p) - before;
    const double sunk = std::cos(q.b.s.theta) - q.b.y / q.s.a;
    q.is(gained / before / (q.s.tol * (1 + reached / unit_of(q.s))));
    return q.is(sunk / (20 * double(q.u)));
}

const char *const FLIES = "1e-15 a radian + 16 u of the way";
const char *const TOUCHES = "a gap of 1e-15 a radian + 16 u of the way";
} // namespace

const std::vector<row> THROWS = {
    {"coin_move_flies", FLIES, 25, tossed, judged(flies)},
    {"coin_move_fades", FLIES, 25, fading, judged(flies)},
    {"coin_move_touches", TOUCHES, 25, tossed, judged(touches)},
    {"coin_move_touches_faded", TOUCHES, 25, fading, judged(touches)},
    {"coin_move_hits", "1e-15 of the speeds over I_X and I_Z", 25, tossed,
     judged(hits)},
    {"coin_move_tosses", "tol of the energy a natural unit; 20 u below", 25,
     tossed, judged(tosses)},
};
