/* SPDX-License-Identifier: MIT */
/* Functions whose truth is a formula: what is read off a state or a body, and
 * steady motions. */
#include "law.hpp"

namespace
{
/* --------------------------------------------------------------- of a state */

/* What comes out as it was. */
terms same(real value)
{
    return {value, 0};
}
/* Of something of size 1. */
terms unit(real value)
{
    return {value, 1};
}

list center_of(const moment &y)
{
    return {same(y.x), y.a * y.c, same(y.z)};
}

list velocity_of(const moment &y)
{
    const list d = rates_of(y);
    return {d[3], -y.a * y.wX * y.s, d[4]}; /* (20) */
}

list contact_of(const moment &y)
{
    const terms roll = rates_of(y)[2];
    return {terms(y.x).add(-y.a * y.s * y.sph), same(0),
            terms(y.z).add(-y.a * y.s * y.cph), /* (21) */
            terms().add(roll, -y.a * y.cph),    same(0),
            terms().add(roll, y.a * y.sph)}; /* (22) */
}

list axes_of(const moment &y)
{
    const frame f(y);
    list rows;
    for (const auto &axis : {f.X, f.Y, f.Z})
        for (real e : axis)
            rows.push_back(unit(e));
    return rows;
}

list angular_velocity_of(const moment &y)
{
    const frame f(y);
    list w(3);
    for (size_t i = 0; i < 3; ++i)
        w[i].add(y.wX * f.X[i]).add(y.wY * f.Y[i]).add(y.wZ * f.Z[i]);
    return w;
}

/* (90): the height within half of what an axis is. */
list matrix_of(const moment &y)
{
    const frame f(y);
    const real cps = std::cos(y.psi), sps = std::sin(y.psi);
    list m(16, same(0));
    for (size_t i = 0; i < 3; ++i) {
        m[i] = unit(cps * f.X[i] + sps * f.Y[i]);
        m[4 + i] = unit(cps * f.Y[i] - sps * f.X[i]);
        m[8 + i] = unit(f.Z[i]);
    }
    m[12] = same(y.x);
    m[13] = {y.a * y.c, y.a * y.c / 2};
    m[14] = same(y.z);
    m[15] = same(1);
    return m;
}

/* (30) */
list quaternion_of(const moment &y)
{
    const real C1 = std::cos(y.phi / 2), S1 = std::sin(y.phi / 2);
    const real C2 = std::cos(y.theta / 2), S2 = std::sin(y.theta / 2);
    const real C3 = std::cos(y.psi / 2), S3 = std::sin(y.psi / 2);
    return {
        unit(C1 * C2 * C3 + S1 * S2 * S3), unit(C1 * S2 * C3 + S1 * C2 * S3),
        unit(S1 * C2 * C3 - C1 * S2 * S3), unit(C1 * C2 * S3 - S1 * S2 * C3)};
}

/* And, where N is clear of 0, the ratio. */
list reaction_of(const table_force &f)
{
    list all = {f.R[0], f.R[1], f.R[2], f.normal, f.friction};
    if (f.normal.value > 1e-4L * f.normal.size)
        all.push_back(over(f.friction, f.normal));
    return all;
}

/* ------------------------------------------------------------ the integrals */

/* One of the four power series about upright, to the last term that counts:
 * even or odd, of p or of w, (35). */
real series(real u, real kap, int first, int side)
{
    real sum = 0, term = first == 0 ? 1 : u;
    for (real n = first; n < 1000; n += 2) {
        sum += term;
        term *= u * u * (n * (n + side) + kap) / ((n + 1) * (n + 2));
    }
    return sum;
}

/* K_Y, K_Z of (35). */
list integrals_upright(const moment &y)
{
    const real u = y.s, kap = y.k1 * y.k2, p = y.wY * y.c;
    const real Pe = series(u, kap, 0, -1), Po = series(u, kap, 1, -1);
    const real We = series(u, kap, 0, 1), Wo = series(u, kap, 1, 1);
    return {terms(We * p).add(-y.k1 * Po * y.wZ),
            terms(Pe * y.wZ).add(-y.k2 * Wo * p)};
}

/* The regular and the logarithmic solution about flat and their P, (36), (37).
 */
struct flat_series {
    real R0 = 0, S0 = 0, PR, PS;

    flat_series(real v, real kap)
    {
        real r = 1, s = 0, power = 1, slope_r = 0, slope_s = 0;
        for (int k = 0; k < 200; ++k) {
            const real n = k, d = (n + 1) * (n + 1);
            const real rho = (n * (n + 1) + kap) / d;
            R0 += r * power;
            S0 += s * power;
            s = rho * s + r * ((2 * n + 1) / d - 2 * rho / (n + 1));
            r *= rho;
            slope_r += (n + 1) * r * power;
            slope_s += (n + 1) * s * power;
            power *= v;
        }
        S0 += R0 * std::log(v);
        PR = -2 * v * (1 - v) * slope_r;
        PS = -2 * (1 - v) * (R0 + v * slope_r * std::log(v) + v * slope_s);
    }
};

list integrals_flat(const moment &y)
{
    const real sign = y.theta < 0 ? -1 : 1, wZ = sign * y.wZ, p = y.wY * y.c;
    const real kap = y.k1 * y.k2, v = y.c * y.c / (1 + sign * y.s) / 2;
    const flat_series f(v, kap), up(0.5, kap);
    const terms al = terms(y.k2 * p * f.S0 / 2).add(-wZ * f.PS / 2);
    const terms be = terms(wZ * f.PR / 2).add(-y.k2 * p * f.R0 / 2);
    return {terms().add(al, up.PR / y.k2).add(be, up.PS / y.k2),
            terms().add(al, sign * up.R0).add(be, sign * up.S0)}; /* (38) */
}

/* The terms are those of (35) up to sin theta = 0.7 and those of (38) beyond,
 * as physics.md says. */
list integrals_of(const moment &y)
{
    return std::fabs(y.s) <= 0.7L ? integrals_upright(y) : integrals_flat(y);
}

/* ------------------------------------------------------------------- losses */

slowing slowed(const moment &y, const scene &s)
{
    const losses l(losses_of(s), params_of<coin_params>(s), 1, 1, 1);
    return l.at(y.IX, y.IZ, y.J, y.K, y.s, y.c, y.wX, y.wY, y.wZ);
}

list losses_rates_of(const moment &y, const scene &s)
{
    const slowing by = slowed(y, s);
    list d = rates_of(y);
    return {d[5].add(by.wX, 1), d[6].add(by.wY, 1), d[7].add(by.wZ, 1)};
}

/* --------------------------------------------------------------- of a body */

list body_energy_of(const moment &y, const coin_body &b)
{
    return {terms(y.M * b.vx * b.vx / 2)
                .add(y.M * b.vy * b.vy / 2)
                .add(y.M * b.vz * b.vz / 2)
                .add(y.IX * y.wX * y.wX / 2)
                .add(y.IX * y.wY * y.wY / 2)
                .add(y.IZ * y.wZ * y.wZ / 2)
                .add(y.M * y.g * b.y)}; /* (88) */
}

/* The slip velocity along e_X and e_h, (77). */
struct slip_velocity {
    terms X, h, speed;

    slip_velocity(const moment &y, const coin_body &d)
    {
        X.add(d.vx * y.cph).add(-d.vz * y.sph).add(y.a * y.wZ);
        h.add(d.vx * y.sph).add(d.vz * y.cph).add(-y.a * y.wX * y.c);
        speed = {std::hypot(X.value, h.value), X.size + h.size};
    }
};

/* Of the lowest point, (77), (105). */
list body_contact_of(const moment &y, const scene &s)
{
    const coin_body b = body_of(s);
    const slip_velocity u(y, b);
    return {{u.X.value * y.cph + u.h.value * y.sph, u.speed.size},
            terms(b.vy).add(y.a * y.wX * y.s),
            {u.h.value * y.cph - u.X.value * y.sph, u.speed.size}};
}

/* Up to this cos theta the face counts as horizontal: no point is lowest. */
constexpr real FACE = 0x1p-49L;

void on_table(scene *s, const double *)
{
    s->above = s->which = 0;
}

/* Of a coin that slips; M = 1 is the unit of the masses. */
bool body_reaction(trial<doubles> &q)
{
    const moment &y = q.at;
    const slip_velocity u(y, q.b);
    coin_force &f = q.force;
    if (coin_body_reaction(&q.b, &q.p, &q.table, &f) != COIN_OK ||
        !q.says(COIN_SLIPS, q.b) || u.speed.value < 1e-3L * u.speed.size ||
        u.speed.value < 1e-9L * y.a)
        return false;
    const real lever = y.m / y.IX, mu = q.table.mu_kinetic;
    const terms nX = over(u.X, u.speed), nh = over(u.h, u.speed);
    const terms weight = terms(y.g)
                             .add(-y.a * y.wX * y.wX * y.c)
                             .add(y.a * y.s * y.k1 * y.wY * y.wZ)
                             .add(y.a * y.s * y.wY * y.wY * y.T); /* (78) */
    const terms N =
        over(weight,
             terms(1).add(lever * y.s * y.s).add(nh, lever * mu * y.s * y.c));
    /* (80) */
    if (!(N.value > 32 * q.u * N.size)) /* it lifts off */
        return f.normal > y.M * N.size * 64 * q.u && q.is(BROKEN);
    const real all = y.M / y.c, F = mu * y.M * N.value;
    const real turned = (mu * N.size + F / y.M * u.speed.size / u.speed.value);
    const real X = -F * nX.value, h = -F * nh.value;
    q.within(f.normal, {y.M * N.value, all * N.size}, 32);
    q.within(f.R[1], {y.M * N.value, all * N.size}, 32);
    q.within(f.R[0], {X * y.cph + h * y.sph, all * turned}, 32);
    q.within(f.R[2], {h * y.cph - X * y.sph, all * turned}, 32);
    q.within(f.friction, {F, all * turned}, 32);
    return true;
}

/* ---------------------------------------------------------- steady motions */

int branch(const scene &s)
{
    return s.method < 2 ? -1 : 1;
}

/* wY, (40): the root that nothing cancels in, and the product of the two. */
list circle_of(const moment &y, const scene &s)
{
    const real b = y.K * y.wZ, c = y.IX * y.T, d = y.Mga * y.s;
    const real root = std::sqrt(b * b + 4 * c * d);
    const real q = -(b + (b < 0 ? -root : root)) / 2;
    const bool is_large = (branch(s) < 0) == (s.wZ >= 0);
    return {same(0), is_large ? q / c : -d / q, same(y.wZ), same(y.theta)};
}

double radius_of(const scene &s)
{
    return s.a * std::fabs(s.q[0] / s.q[1]);
}

/* (93), of a circle of any size. */
list turn_of(const moment &y, const scene &s)
{
    const real sth = std::fabs(y.s), r = radius_of(s) / y.a;
    const real wY = std::sqrt(y.Mga * sth * y.c / (y.K * r + y.IX * sth));
    return {same(0), wY, (y.theta < 0 ? -1 : 1) * wY / y.c * r, same(y.theta)};
}

/* Speed, radius, and (39). */
bool ride(trial<doubles> &q)
{
    const scene &s = q.s;
    const double radius = radius_of(s);
    const double speed = std::sqrt(s.g * s.a) * std::fabs(s.q[2] / s.q[3]);
    coin_state made;
    if (coin_steady_ride(&made, &q.p, speed, radius) != COIN_OK)
        return false;
    const moment y(q.p, made);
    const real tilt = y.IX * y.wY * y.wY * y.T, Mga = y.Mga * y.s;
    q.hold(y.a * y.wZ, speed, (16 + 1 / y.c) * q.u * speed);
    q.hold(y.a * y.wZ * y.c / y.wY, radius, 16 * q.u * radius);
    q.hold(y.K * y.wZ * y.wY + tilt, Mga, 24 * q.u * Mga);
    return q.is(made.wX == 0 && made.wY > 0 && made.theta > 0 ? 0 : BROKEN);
}

list radii_of(const moment &y)
{
    const real G = y.a * y.wZ * y.c / y.wY;
    return {
        std::fabs(G),
        {std::fabs(G + y.a * y.s), terms(G).add(y.a * y.s).size}}; /* (43) */
}

/* (56): 6 u of what changes, and half a unit of what comes out. */
list steady_at_of(const moment &y, const scene &s)
{
    const real t = s.t, turn = y.wY / y.c * t, h = turn / 2;
    const real chord = -y.a * y.wZ * t * (h == 0 ? 1 : std::sin(h) / h);
    const real path = std::fabs(y.a * y.wZ * t);
    const auto far = [](real from, real change, real size) {
        return terms(from + change, 6 * size + std::fabs(from + change));
    };
    return {same(y.theta),
            far(y.phi, turn, std::fabs(turn)),
            far(y.psi, (y.wZ + y.wY * y.T) * t,
                terms(y.wZ).add(y.wY * y.T).size * std::fabs(t)),
            far(y.x, chord * std::cos(y.phi + h), path),
            far(y.z, -chord * std::sin(y.phi + h), path),
            same(0)};
}

/* A steady state to rounding, or off by up to 1e-9. */
void steady_edge(scene *s, const double *g)
{
    double large, slow;
    s->wX = 0;
    if (g[QUAD + 2] < 0.15) {
        s->theta = 0;
        *(g[QUAD + 2] < 0.07 ? &s->wY : &s->wZ) = 0;
    } else if (g[QUAD + 2] < 0.3) {
        s->wZ = 0;
        s->wY = std::sqrt(s->M * s->g * s->a * std::cos(s->theta) / s->IX);
    } else {
        circles_of(*s, &large, &slow);
        s->wY = g[QUAD + 2] < 0.7 ? slow : large;
    }
    if (g[QUAD + 3] < 0.5)
        s->wY *= 1 + 1e-9 * s->q[0];
    near_pose(s, g);
    s->t =
        unit_of(*s) * (g[TIME] < 0.5 ? 1 : -1) * power_of_ten(g[COUNT], -2, 6);
}

/* --------------------------------------------------- functions of their own */

/* (29) */
template <class T> bool params_ring(trial<T> &q)
{
    const auto M = q.p.mass, a = q.p.radius, g = q.p.gravity;
    const auto b = decltype(a)(q.s.q[0] < 0 ? 0 : a * q.s.q[0]);
    typename T::params p, disc;
    if (T::ring(&p, M, a, b, g) != COIN_OK)
        return false;
    const real IX = real(M) * (real(a) * a + real(b) * b) / 4;
    q.within(p.inertia_X, IX, 4);
    q.within(p.inertia_Z, 2 * IX, 4);
    const bool is_kept = p.mass == M && p.radius == a && p.gravity == g;
    const bool is_disc = T::disc(&disc, M, a, g) == COIN_OK &&
                         disc.inertia_X == p.inertia_X &&
                         disc.inertia_Z == p.inertia_Z;
    return q.is(is_kept && (b > 0 || is_disc) ? 0 : BROKEN);
}

/* The rotation of the scene's angles, each number off by a little. */
void near_a_rotation(scene *s, const double *)
{
    const moment y(params_of<coin_params>(*s), *s);
    const list q = quaternion_of(y);
    for (size_t i = 0; i < 4; ++i)
        s->q[i] = double(q[i].value * (1 + 1e-3L * s->q[i]));
}

/* 8 u in theta, 8 u/cos theta in phi and psi, and in the one of their sum and
 * difference that stays sharp, twice 8 u. */
template <class T> bool from_motion(trial<T> &a)
{
    using number = typename T::number;
    const auto turned_by = [&](real of, real by, real allowed) {
        a.hold(std::remainder(of - by, 4 * HALF_PI), 0, allowed);
    };
    const number omega[] = {a.y.wX, a.y.wY, a.y.wZ};
    number q[4];
    for (int i = 0; i < 4; ++i)
        q[i] = number(a.s.q[i]);
    typename T::state y;
    if (T::from_motion(&y, &a.p, q, omega, a.y.x, a.y.z) != COIN_OK)
        return false;
    const real w = q[0], x = q[1], k = q[2], l = q[3];
    const real A = std::hypot(w + x, k - l), B = std::hypot(w - x, k + l);
    const real minus = std::atan2(k - l, w + x);
    const real plus = std::atan2(k + l, w - x);
    const real n = w * w + x * x + k * k + l * l, bound = 8 * a.u;
    const real theta = std::atan2(2 * (w * x - k * l), A * B);
    a.hold(y.theta, theta, bound);
    turned_by(y.phi, plus + minus, bound * n / (A * B));
    turned_by(y.psi, plus - minus, bound * n / (A * B));
    if (theta > 0)
        turned_by(real(y.phi) - real(y.psi), 2 * minus, 2 * bound);
    else
        turned_by(real(y.phi) + real(y.psi), 2 * plus, 2 * bound);
    return true;
}

constexpr double LIMITS[] = {0.35, 1, 0.08, 0.16};

/* Off a threshold by a part of 1e-17 to 1. */
void at_the_limits(scene *s, const double *g)
{
    if (g[MORE] < 0.3)
        s->theta = 1.5607961601207294 + 0.01 * s->q[3];
    const moment y(params_of<coin_params>(*s), *s);
    const table_force f(y);
    const double mu = double(f.friction.value / f.normal.value);
    s->mu_kinetic = mu > 0 && std::isfinite(mu) ? mu * (1 + s->q[0]) : 0.3;
    s->t = LIMITS[int(s->method)] / double(fastest(y)) * (1 + s->q[1]);
}

template <class T> bool check(trial<T> &q)
{
    using number = typename T::number;
    const int method = int(q.s.method) & (T::is_single ? COIN_SYMPLECTIC2 : 3);
    const number dt = number(q.s.t), mu = number(q.s.mu_kinetic);
    const int32_t bits = T::check(&q.y, &q.p, method, dt, mu);
    /* A bit that is wrong, in parts of what rounding may do to its threshold */
    const auto bit = [&](int32_t said, const terms &beyond) {
        if ((said != 0) != (beyond.value > 0))
            q.hold(beyond.value, 0, 8 * q.u * beyond.size);
    };
    const table_force f(q.at);
    const real limit = number(LIMITS[method]), flat = number(0.01);
    bit(bits & COIN_LIFTS, terms().add(f.normal, -1));
    if (!(bits & COIN_LIFTS))
        bit(bits & COIN_SLIPS, terms(f.friction).add(f.normal, -mu));
    bit(bits & COIN_COARSE, {std::fabs(dt) * fastest(q.at) - limit, limit});
    bit(bits & COIN_NEARLY_FLAT, {flat - q.at.c, flat});
    return bits >= 0;
}

/* ------------------------------------------------------------- the table */

/* What a call says: a number is a number, or a status and what it made. */
template <class N> bool puts(N value, N *out)
{
    *out = value;
    return value == value;
}
template <class N> bool puts(int32_t status, const N *from, int count, N *out)
{
    std::copy(from, from + count, out);
    return status == COIN_OK;
}
/* The rates of a steady motion, and its lean. */
bool puts(int32_t status, const coin_state &made, double *out)
{
    out[3] = made.theta;
    return puts(status, &made.wX, 3, out);
}

/* What a call puts out is each within so many u of the terms of its truth. */
template <class T, class C, class F>
row row_of(const char *function, int ulps, edge draw, int genes, C call,
           F truth)
{
    const auto law = [=](trial<T> &q) {
        typename T::number out[16];
        if (!call(q, out) || !q.is_normal())
            return false;
        size_t i = 0;
        for (const terms &want : truth(q.at, q.s))
            q.within(out[i++], want, ulps);
        return true;
    };
    const std::string bound = std::to_string(ulps) + " u of the terms";
    return {function, bound, 1, draw, judged<T>(law), genes, T::is_single};
}

/* A row of a function, one of coin.h alone, and two of a function and its twin:
 * a call of it, f, that puts out numbers; their truths, of a moment y and a
 * scene s. */
#define ROW(T, function, ulps, draw, genes, call, ...)                         \
    row_of<T>(                                                                 \
        #function, ulps, draw, genes,                                          \
        [f = function](auto &q, auto *out) { return call; },                   \
        []([[maybe_unused]] const moment &y,                                   \
           [[maybe_unused]] const scene &s) -> list { return __VA_ARGS__; })
#define ONE(name, ulps, draw, ...)                                             \
    ROW(doubles, coin_##name, ulps, draw, GENES, __VA_ARGS__)
#define TWIN(name, ulps, ...)                                                  \
    ROW(doubles, coin_##name, ulps, nullptr, LOSS, __VA_ARGS__),               \
        ROW(floats, coinf_##name, ulps, nullptr, LOSS, __VA_ARGS__)

const char *const OF_MOTION = "8 u; over cos theta in phi and psi";
const char *const OF_CHECK = "8 u of the terms of each threshold";
} // namespace

const std::vector<row> FORMULAS = {
    TWIN(energy, 8, puts(f(&q.y, &q.p), out),
         {terms(y.J * y.wX * y.wX / 2)
              .add(y.IX * y.wY * y.wY / 2)
              .add(y.K * y.wZ * y.wZ / 2)
              .add(y.Mga * y.c)}), /* (23) */
    TWIN(fastest_rate, 8, puts(f(&q.y, &q.p), out), {fastest(y)}),
    TWIN(integrals, 16, f(&q.y, &q.p, out) == COIN_OK, integrals_of(y)),
    TWIN(reaction, 14, puts(f(&q.y, &q.p, &q.force), &q.force.R[0], 6, out),
         reaction_of(table_force(y))),
    TWIN(rates, 12, puts(f(&q.y, &q.p, &q.made), &q.made.theta, 8, out),
         rates_of(y)),
    TWIN(center, 4, f(&q.y, &q.p, out) == COIN_OK, center_of(y)),
    TWIN(velocity, 8, f(&q.y, &q.p, out) == COIN_OK, velocity_of(y)),
    TWIN(contact, 8, f(&q.y, &q.p, out, out + 3) == COIN_OK, contact_of(y)),
    TWIN(axes, 4, f(&q.y, out) == COIN_OK, axes_of(y)),
    TWIN(quaternion, 4, f(&q.y, out) == COIN_OK, quaternion_of(y)),
    TWIN(matrix, 8, f(&q.y, &q.p, out) == COIN_OK, matrix_of(y)),
    TWIN(angular_velocity, 8, f(&q.y, out) == COIN_OK, angular_velocity_of(y)),
    ONE(losses_power, 24, nullptr, puts(f(&q.y, &q.p, &q.losses), out),
        {slowed(y, s).power}),
    ONE(losses_rates, 16, nullptr,
        puts(f(&q.y, &q.p, &q.losses, &q.made), &q.made.wX, 3, out),
        losses_rates_of(y, s)),
    ONE(losses_reaction, 16, nullptr,
        puts(f(&q.y, &q.p, &q.losses, &q.force), &q.force.R[0], 6, out),
        reaction_of(table_force(y, slowed(y, s)))),
    ONE(body_energy, 12, nullptr, puts(f(&q.b, &q.p), out),
        body_energy_of(y, body_of(s))),
    ONE(body_contact, 8, nullptr,
        q.at.c > FACE && f(&q.b, &q.p, out) == COIN_OK, body_contact_of(y, s)),
    ONE(body_from_state, 8, nullptr, puts(f(&q.b, &q.y, &q.p), &q.b.vx, 3, out),
        velocity_of(y)),
    ONE(steady_spin, 8, nullptr, puts(f(&q.made, &q.p, q.s.theta), q.made, out),
        {same(0), std::sqrt(y.Mga / y.IX * y.c), same(0), same(y.theta)}),
    /* (42) */
    ONE(steady_circle, 8, nullptr,
        puts(f(&q.made, &q.p, q.s.theta, q.s.wZ, branch(q.s)), q.made, out),
        circle_of(y, s)),
    ONE(steady_turn, 8, nullptr,
        puts(f(&q.made, &q.p, q.s.theta, radius_of(q.s)), q.made, out),
        turn_of(y, s)),
    ONE(steady_radii, 8, steady_edge,
        std::fabs(q.y.wY) * 0.99e9L > std::fabs(q.y.wZ) * q.at.c &&
            f(&q.y, &q.p, out, out + 1) == COIN_OK,
        radii_of(y)),
    ONE(stability, 16, steady_edge, f(&q.y, &q.p, out) == COIN_OK,
        {lambda2_of(y)}),
    ONE(critical_roll, 8, nullptr, puts(f(&q.p), out),
        {std::sqrt(y.Mga / y.k1 / y.K)}), /* (45) */
    ONE(critical_spin, 8, nullptr, puts(f(&q.p), out),
        {std::sqrt(y.Mga / y.J)}), /* (46) */
    ONE(steady_at, 1, steady_edge,
        puts(f(&q.y, &q.p, q.s.t, &q.made), &q.made.theta, 6, out),
        steady_at_of(y, s)),
    {"coin_params_ring", "4 u", 1, nullptr, judged(params_ring<doubles>), LOSS},
    {"coinf_params_ring", "4 u", 1, nullptr,
     judged<floats>(params_ring<floats>), LOSS, true},
    {"coin_state_from_motion", OF_MOTION, 1, near_a_rotation,
     judged(from_motion<doubles>), LOSS},
    {"coinf_state_from_motion", OF_MOTION, 1, near_a_rotation,
     judged<floats>(from_motion<floats>), LOSS, true},
    {"coin_check", OF_CHECK, 1, at_the_limits, judged(check<doubles>), LOSS},
    {"coinf_check", OF_CHECK, 1, at_the_limits, judged<floats>(check<floats>),
     LOSS, true},
    {"coin_steady_ride", "16 u + u/cos theta of the speed; 16 u of the radius",
     1, nullptr, judged(ride)},
    {"coin_body_reaction", "32 u of the terms over cos theta; slipping", 1,
     on_table, judged(body_reaction)},
};
