/* SPDX-License-Identifier: MIT */
/* Coins with a thickness, a pull and a blow, beside Newton's and Euler's laws
 * along the coin's own axes: linear equations, solved as they stand.  The
 * formulas of docs/physics.md tell only how large their terms are. */
#include "law.hpp"

namespace
{
using vector = std::valarray<real>;

vector cross(const vector &a, const vector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}
real dot(const vector &a, const vector &b)
{
    return (a * b).sum();
}

/* The solution of n equations, each with its right side at its end. */
vector solution(std::vector<vector> e)
{
    const size_t n = e.size();
    for (size_t k = 0; k < n; ++k) {
        for (size_t i = k + 1; i < n; ++i)
            if (std::fabs(e[i][k]) > std::fabs(e[k][k]))
                std::swap(e[i], e[k]);
        e[k] /= real(e[k][k]);
        for (size_t i = 0; i < n; ++i)
            if (i != k)
                e[i] -= real(e[i][k]) * e[k];
    }
    vector x(n);
    for (size_t i = 0; i < n; ++i)
        x[i] = e[i][n];
    return x;
}

/* A part of the force on a rim, of unknown size along `by`, which keeps the
 * material there, at d from the centre, from moving along `held`. */
struct push {
    vector d, by, held;
};

/* A body on a table in units of M, a and g, along X, Y and Z: of its lowest
 * point the place d from the centre, and its velocity u; `turn` is the angular
 * velocity of the axes. */
struct thick {
    real IX, IZ, h, eta, s, c, T, P, Y, size_P;
    vector w, turn, d, up, along, pull, u;
    terms uX, uh;

    thick(const moment &y, const coin_params &p, const coin_body &b,
          const coin_table &t)
        : IX(y.IX / y.m), IZ(y.IZ / y.m), h(p.thickness / 2 / y.a), s(y.s),
          c(y.c), T(y.T)
    {
        const real rate = std::sqrt(y.g / y.a), speed = rate * y.a;
        const real lower = y.s != 0 ? y.s : y.wX;
        const real X = b.vx / speed, Z = b.vz / speed;
        eta = lower > 0 ? h : lower < 0 ? -h : 0;
        P = s - eta * c;
        Y = c + eta * s;
        size_P = std::fabs(s) + h * c;
        w = vector{y.wX, y.wY, y.wZ} / rate;
        turn = {w[0], w[1], -w[1] * T};
        d = {0, -1, eta};
        up = {0, c, -s};
        along = {0, s, c};
        const vector wd = cross(w, d);
        uX = terms(X * y.cph).add(-Z * y.sph).add(w[2]).add(eta * w[1]);
        uh = terms(X * y.sph).add(Z * y.cph).add(-w[0] * Y);
        u = {X * y.cph - Z * y.sph + wd[0],
             X * y.sph + Z * y.cph + dot(wd, along),
             b.vy / speed + dot(wd, up)};
        const real pX = t.pull[0] / y.g, pZ = t.pull[1] / y.g;
        pull = {pX * y.cph - pZ * y.sph, pX * y.sph + pZ * y.cph};
    }

    bool has_one_contact() const
    {
        return c > 0x1p-49L && (h * std::fabs(s) > 0x1p-49L || h == 0);
    }

    /* What holds the lowest point: a coin that rolls. */
    std::vector<push> rolls() const
    {
        const vector e_X = {1, 0, 0};
        return {{d, e_X, e_X}, {d, along, along}, {d, up, up}};
    }
    /* A rim at d that slips along n, of e_X and e_h: Coulomb. */
    push slips(const vector &at, const vector &n, real mu) const
    {
        return {at, up - mu * (n[0] * vector{1, 0, 0} + n[1] * along), up};
    }

    /* The sizes of these forces.  Unknown: the acceleration, that of the turn,
     * the sizes. */
    vector forces(const std::vector<push> &parts) const
    {
        const vector inertia = {IX, IX, IZ};
        const vector weight = pull[0] * vector{1, 0, 0} + pull[1] * along - up;
        const vector gyration = cross(turn, inertia * w);
        const size_t n = 6 + parts.size();
        std::vector<vector> e(n, vector(real(0), n + 1));
        for (size_t i = 0; i < 3; ++i) {
            e[i][i] = 1; /* Newton */
            e[i][n] = weight[i];
            e[3 + i][3 + i] = inertia[i]; /* Euler */
            e[3 + i][n] = -gyration[i];
        }
        for (size_t k = 6; k < n; ++k) {
            const push &part = parts[k - 6];
            const vector torque = cross(part.d, part.by);
            const vector lever = cross(part.d, part.held);
            for (size_t i = 0; i < 3; ++i) {
                e[i][k] = -part.by[i];
                e[3 + i][k] = -torque[i];
                e[k][i] = part.held[i]; /* the point is at rest */
                e[k][3 + i] = lever[i];
            }
            e[k][n] = -dot(part.held, cross(turn, cross(w, part.d)));
        }
        return solution(e)[std::slice(6, n - 6, 1)];
    }
};

/* ------------------------------------------------------------------- sizes */

/* Of the terms of N, F_X and F_h: (120), of a coin that rolls.  F_X is
 * computed by Newton's law, as in (25), so that its terms are not over D. */
struct sizes {
    real N, X, h;
};

sizes rolling(const thick &o)
{
    const real wX = std::fabs(o.w[0]), wY = std::fabs(o.w[1]),
               wZ = std::fabs(o.w[2]);
    const real J = o.IX + 1 + o.h * o.h, k1 = o.IZ / o.IX;
    const real pull = std::abs(o.pull).sum(), roll = wZ + o.h * wY;
    const real slope =
        (wY * (o.IZ * wZ + o.IX * wY * std::fabs(o.T) + o.Y / o.c * roll) +
         o.size_P + pull * o.Y) /
        J;
    return {1 + o.Y * wX * wX + o.size_P * slope,
            wX * (wY + o.h * k1 * wZ) + pull,
            o.Y * slope + o.size_P * wX * wX + wY / o.c * roll + pull};
}

/* (122), of N: of a coin that slips against a direction, with the friction mu
 * along e_h. */
real slipping(const thick &o, real N, real mu)
{
    const real wX = o.w[0], wY = std::fabs(o.w[1]);
    const real gX0 =
        wY * (o.IZ / o.IX * std::fabs(o.w[2]) + wY * std::fabs(o.T));
    const terms weight(0, 1 + o.Y * wX * wX + o.size_P * gX0);
    const real lean = o.P * (o.P + mu * o.Y) / o.IX;
    const real size = o.size_P * (o.size_P + std::fabs(mu) * o.Y) / o.IX;
    return (weight.size + std::fabs(N) * (1 + size)) / std::fabs(1 + lean);
}

/* -------------------------------------------------------------------- laws */

/* A force beside its truth, over cos theta. */
void hold_force(trial<doubles> &q, const vector &F, const sizes &of)
{
    const moment &y = q.at;
    const real Mg = y.M * y.g, all = Mg / y.c;
    const coin_force &f = q.force;
    const real turned = all * (of.X + of.h);
    q.within(f.normal, {Mg * F[2], all * of.N}, 32);
    q.within(f.R[1], {Mg * F[2], all * of.N}, 32);
    q.within(f.R[0], {Mg * (F[0] * y.cph + F[1] * y.sph), turned}, 32);
    q.within(f.R[2], {Mg * (F[1] * y.cph - F[0] * y.sph), turned}, 32);
    q.within(f.friction, {Mg * std::hypot(F[0], F[1]), turned}, 32);
}

/* Held by any friction: it rolls. */
bool reaction_rolls(trial<doubles> &q)
{
    if (!q.roll() || !q.is_normal())
        return false;
    const thick o(q.at, q.p, q.b, q.table);
    if (!o.has_one_contact() || !q.says(COIN_OK, q.b) ||
        coin_body_reaction(&q.b, &q.p, &q.table, &q.force) != COIN_OK)
        return false;
    hold_force(q, o.forces(o.rolls()), rolling(o));
    return true;
}

bool reaction_slips(trial<doubles> &q)
{
    const thick o(q.at, q.p, q.b, q.table);
    const terms speed = length(o.uX, o.uh);
    const real mu = q.table.mu_kinetic;
    if (!o.has_one_contact() || !q.is_normal() || !q.says(COIN_SLIPS, q.b) ||
        coin_body_reaction(&q.b, &q.p, &q.table, &q.force) != COIN_OK ||
        speed.value < 1e-3L * speed.size || speed.value < 1e-9L)
        return false;
    const vector n = {o.uX.value / speed.value, o.uh.value / speed.value};
    const vector N = o.forces({o.slips(o.d, n, mu)});
    const real size = slipping(o, N[0], mu * n[1]);
    if (!(N[0] > 32 * q.u * size)) /* it lifts off */
        return q.force.normal > q.p.mass * q.p.gravity * size * 64 * q.u &&
               q.is(BROKEN);
    const real turned = mu * (size + N[0] * speed.size / speed.value);
    hold_force(q, {-mu * N[0] * n[0], -mu * N[0] * n[1], N[0]},
               {size, turned, turned});
    return true;
}

/* On both rims, which slip, each its own way. */
bool reaction_slips_on_both(trial<doubles> &q)
{
    const thick o(q.at, q.p, q.b, q.table);
    const real mu = q.table.mu_kinetic, wY = o.w[1];
    std::vector<vector> n;
    std::vector<push> rims;
    real off = 0;
    for (real at : {o.h, -o.h}) {
        const terms X = terms(o.uX).add(at * wY), u = length(X, o.uh);
        off = std::max(off, u.size / u.value);
        n.push_back({X.value / u.value, o.uh.value / u.value});
        rims.push_back(o.slips({0, -1, at}, n.back(), mu));
    }
    if (!(off < 1e3L) || !q.is_normal() || !q.says(COIN_SLIPS, q.b) ||
        coin_body_reaction(&q.b, &q.p, &q.table, &q.force) != COIN_OK)
        return false;
    const vector N = o.forces(rims);
    if (!(N.min() > 0)) /* it tips */
        return false;
    const vector F = -mu * (N[0] * n[0] + N[1] * n[1]);
    const real spread = 2 * o.h + mu * (n[1][1] - n[0][1]);
    const real moment = std::fabs(o.IZ * wY * o.w[2]);
    const real size = (3 * o.h + 3 * mu + moment) / std::fabs(spread);
    const real turned = mu * (2 * size + off);
    hold_force(q, {F[0], F[1], N.sum()}, {1, turned, turned});
    return true;
}

/* (88) */
bool energy(trial<doubles> &q)
{
    const moment &y = q.at;
    const coin_body &b = q.b;
    const double E = coin_body_energy(&b, &q.p);
    terms truth(y.M * y.g * b.y);
    for (real v : {b.vx, b.vy, b.vz})
        truth.add(y.M * v * v / 2);
    for (real w : {y.wX, y.wY})
        truth.add(y.IX * w * w / 2);
    truth.add(y.IZ * y.wZ * y.wZ / 2);
    q.within(E, truth, 12);
    return E == E && q.is_normal();
}

/* The velocity v + w x d of the lowest point, in the table's frame. */
bool contact(trial<doubles> &q)
{
    const moment &y = q.at;
    const thick o(y, q.p, q.b, q.table);
    const real speed = std::sqrt(y.g * y.a);
    const real wX = std::fabs(o.w[0]);
    const real X = speed * (o.uX.size), h = speed * (o.uh.size);
    double v[3];
    if (!o.has_one_contact() || !q.is_normal() ||
        coin_body_contact(&q.b, &q.p, v) != COIN_OK)
        return false;
    q.within(v[0], {speed * (o.u[0] * y.cph + o.u[1] * y.sph), X + h}, 8);
    q.within(v[1],
             {speed * o.u[2], std::fabs(real(q.b.vy)) + speed * wX * o.size_P},
             8);
    q.within(v[2], {speed * (o.u[1] * y.cph - o.u[0] * y.sph), X + h}, 8);
    return true;
}

/* Momentum grows by J, angular momentum by r x J; the pose stays. */
bool strike(trial<doubles> &q)
{
    const moment &y = q.at;
    const frame f(y);
    const vector inertia = {y.IX, y.IX, y.IZ};
    double J[3], r[3];
    for (int i = 0; i < 3; ++i) {
        J[i] = q.s.blow[i] * q.s.M * std::sqrt(q.s.g * q.s.a);
        r[i] = q.s.place[i] * q.s.a;
    }
    coin_body b = q.b;
    if (!q.is_normal() || coin_body_strike(&b, &q.p, J, r) != COIN_OK)
        return false;
    const vector blow = {J[0], J[1], J[2]}, at = {r[0], r[1], r[2]};
    const vector moment_of = cross(at, blow);
    const vector *const axis[] = {&f.X, &f.Y, &f.Z};
    for (size_t i = 0; i < 3; ++i) {
        const vector size = std::abs(*axis[i]);
        terms w((&y.wX)[i]);
        w.value += dot(moment_of, *axis[i]) / inertia[i];
        for (size_t k = 0; k < 3; ++k)
            w.size += size[k] / inertia[i] *
                      (std::fabs(at[(k + 1) % 3] * blow[(k + 2) % 3]) +
                       std::fabs(at[(k + 2) % 3] * blow[(k + 1) % 3]));
        q.within((&b.s.wX)[i], w, 8);
        q.within((&b.vx)[i], terms((&q.b.vx)[i]).add(blow[i] / y.M), 8);
        (&b.s.wX)[i] = (&q.b.s.wX)[i];
        (&b.vx)[i] = (&q.b.vx)[i];
    }
    return q.is(std::memcmp(&b, &q.b, sizeof b) ? BROKEN : 0);
}

/* (29), of discs along the axis. */
bool cylinder(trial<doubles> &q)
{
    const double M = q.p.mass, a = q.p.radius, g = q.p.gravity,
                 H = q.p.thickness;
    coin_params p;
    if (coin_params_cylinder(&p, M, a, H, g) != COIN_OK)
        return false;
    q.within(p.inertia_X, real(M) * (real(a) * a / 4 + real(H) * H / 12), 4);
    q.within(p.inertia_Z, real(M) * a * a / 2, 4);
    return q.is(p.mass == M && p.radius == a && p.gravity == g &&
                        p.thickness == H
                    ? 0
                    : BROKEN);
}

/* ------------------------------------------------------------------- draws */

/* Any thickness, pull and blow; often next to the lean of balance. */
void thickens(scene *s, const double *g)
{
    s->thickness = s->a * power_of_ten(g[TIME], -4, 0.602);
    s->which = 0;
    if (g[METHOD] > 0.8)
        s->theta = std::atan(s->thickness / 2 / s->a) * (1 + s->q[3]);
    for (int i = 0; i < 2; ++i)
        s->pull[i] = g[METHOD] < 0.2 ? 0 : 4 * g[COUNT + i] - 2;
    for (int i = 0; i < 3; ++i) {
        s->blow[i] = 10 * s->q[i];
        s->place[i] = 4 * g[MORE + i] - 2;
    }
}

void on_table(scene *s, const double *g)
{
    thickens(s, g);
    s->above = 0;
}

void held(scene *s, const double *g)
{
    on_table(s, g);
    s->mu_static = double(INFINITY);
}

void on_both_rims(scene *s, const double *g)
{
    on_table(s, g);
    s->theta = s->wX = 0;
}

const char *const FORCE = "32 u of the terms over cos theta";
} // namespace

const std::vector<row> THICK = {
    {"coin_params_cylinder", "4 u", 1, thickens, judged(cylinder)},
    {"coin_body_energy_thick", "12 u of the terms", 1, thickens,
     judged(energy)},
    {"coin_body_contact_thick", "8 u of the terms", 1, thickens,
     judged(contact)},
    {"coin_body_strike", "8 u of the terms", 1, thickens, judged(strike)},
    {"coin_body_reaction_rolls", FORCE, 1, held, judged(reaction_rolls)},
    {"coin_body_reaction_slips", FORCE, 1, on_table, judged(reaction_slips)},
    {"coin_body_reaction_slips_on_both", FORCE, 1, on_both_rims,
     judged(reaction_slips_on_both)},
};
