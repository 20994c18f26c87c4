/* SPDX-License-Identifier: MIT */
/* Coins with losses: what is read off a state, the way to rest, and the
 * quasi-steady model. */
#include "losses.hpp"

#include "growth.hpp"
#include "path.hpp"
#include "row.hpp"
#include "truth.hpp"

namespace
{
/* --------------------------------------------------------- read off a state */
template <class R> struct asked {
    coin_params p;
    coin_state y;
    coin_losses l;
    moment<R> at;
    R u = R(doubles::u), least = 16 * R(doubles::normal);
    verdict<R> v;

    explicit asked(const scene &s)
        : p(params_of<doubles>(s)), y(state_of<doubles>(s)), l(losses_of(s)),
          at(p, y)
    {
    }

    slowing<R> slowed() const
    {
        const losses<R> of(l, softening(l, p), 1, 1, 1);
        return of.at(at.IX, at.J, at.K, at.s, at.c, at.wX, at.wY, at.wZ);
    }

    void hold(double output, const terms<R> &truth)
    {
        v.hold(R(output), truth.value, 16 * (u * truth.size + least));
    }
};

template <class R> double power(const scene &s, double)
{
    asked<R> q(s);
    const double P = coin_losses_power(&q.y, &q.p, &q.l);
    if (P != P)
        return NO_CLAIM;
    q.hold(P, q.slowed().power);
    return q.v.worst;
}

template <class R> double rates(const scene &s, double)
{
    asked<R> q(s);
    coin_state d;
    if (coin_losses_rates(&q.y, &q.p, &q.l, &d) != COIN_OK)
        return NO_CLAIM;
    const slowing<R> by = q.slowed();
    terms<R> want[8];
    rates_of(q.at, want);
    q.hold(d.wX, want[5].add(by.wX, R(1)));
    q.hold(d.wY, want[6].add(by.wY, R(1)));
    q.hold(d.wZ, want[7].add(by.wZ, R(1)));
    return q.v.worst;
}

template <class R> double reaction(const scene &s, double)
{
    asked<R> q(s);
    coin_force f;
    if (coin_losses_reaction(&q.y, &q.p, &q.l, &f) != COIN_OK)
        return NO_CLAIM;
    const slowing<R> by = q.slowed();
    const moment<R> &y = q.at;
    const R Ma = y.M * y.a;
    table_force<R> F = force_of(y);
    /* M a (-dwZ e_X + dwX e_Z) */
    F.Rx.add(by.wZ, -Ma * y.cph).add(by.wX, Ma * y.c * y.sph);
    F.normal.add(by.wX, -Ma * y.s);
    F.Rz.add(by.wZ, Ma * y.sph).add(by.wX, Ma * y.c * y.cph);
    q.hold(f.R[0], F.Rx);
    q.hold(f.normal, F.normal);
    q.hold(f.R[2], F.Rz);
    return q.v.worst;
}

/* Any state, and losses from 1e-8 to 0.1; soft, where it is not the usual, from
 * 1e-9 to 1. */
void some_losses(scene *s, const double *g)
{
    s->steps = std::floor(256 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 7 * g[26 + i] - 8);
    s->tol = std::pow(10, 9 * g[24] - 9);
}

/* -------------------------------------------------------------- the way to
 * rest */
int32_t settled(coin_state *y, const coin_params *p, const coin_losses *l,
                double t, double tol)
{
    return coin_settle(y, p, l, t, tol, nullptr);
}

int32_t settled(coinf_state *y, const coinf_params *p, const coinf_losses *l,
                float t, float tol)
{
    return coinf_settle(y, p, l, t, tol, nullptr);
}

/* A scene's losses in a precision. */
template <class T> typename T::losses losses_in(const scene &s)
{
    const coin_losses l = losses_of(s);
    typename T::losses to = {};
    for (int i = 0; i < 8; ++i)
        (&to.damping)[i] = typename T::real((&l.damping)[i]);
    return to;
}

/* Followed by the textbook's equations and torques for up to 80 rad. */
template <class T, class R> double settle(const scene &s, double enough)
{
    using real = typename T::real;
    const typename T::params p = params_of<T>(s);
    const typename T::losses l = losses_in<T>(s);
    const typename T::state start = state_of<T>(s);
    const real t = real(s.t), tol = real(s.tol);
    typename T::state end = start;
    path<R> truth(p, start);
    if (truth.is_long(R(t)) || settled(&end, &p, &l, t, tol) != COIN_OK)
        return NO_CLAIM;
    const losses<R> slow(l, softening(l, p), p.mass, p.radius, 1 / truth.w);
    const R natural = R(t) * truth.w;
    const R turned = natural * root(2 * truth.energy());
    truth.slow = &slow;
    if (!truth.follow(R(t)))
        return NO_CLAIM;
    coin_state whole;
    for (int i = 0; i < 8; ++i)
        (&whole.theta)[i] = double((&end.theta)[i]) + T::low(end, i);
    R off[8], worst = 0;
    truth.apart(whole, truth.fastest(), off);
    for (int i = 1; i < 3 && T::u > 1e-10; ++i)
        off[i] = within_half_a_turn(off[i]);
    for (int i = 0; i < 5; ++i)
        worst = larger(worst, magnitude(off[i]));
    const R bound = 2 * R(tol) * (1 + turned) + 90 * R(T::u) * (1 + natural) +
                    16 * R(T::u) * truth.largest_of_pose();
    if (bound >= 1)
        return NO_CLAIM;
    const double ratio = worst <= R(1e30) ? double(worst / bound) : BROKEN;
    const losses<long double> by(l, softening(l, p), p.mass, p.radius,
                                 1 / (long double)truth.w);
    return unamplified(ratio, enough, [&](double most) {
        return growth(p, start, t / 16, 16, most, &by);
    });
}

/* Forward, 0.01 to 30 natural units; losses up to 0.03.  Half roll slowly at
 * first, so that the contact soon turns round.  A fifth hardly spin. */
void launches(scene *s, const double *g)
{
    if (g[25] < 0.5)
        s->wZ = 0.2 * s->wZ - s->wY * std::tan(s->theta);
    if (g[25] > 0.8) {
        const double part = std::pow(10, -50 * (g[25] - 0.8));
        s->wY *= part;
        s->wZ *= part;
    }
    s->steps = std::floor(128 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 5 * g[26 + i] - 6.5);
    s->tol = std::pow(10, 9 * g[24] - 12);
    s->t = std::sqrt(s->a / s->g) * std::pow(10, 3.5 * g[22] - 2);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
}

void float_launches(scene *s, const double *g)
{
    launches(s, g);
    s->tol = std::pow(10, 4 * g[24] - 6);
}

/* ------------------------------------------------------- the quasi-steady
 * model */
/* A number and its derivative: so that no formula of a derivative is shared. */
template <class R> struct dual {
    R x, d;
};
template <class R> dual<R> operator*(dual<R> a, dual<R> b)
{
    return {a.x * b.x, a.x * b.d + a.d * b.x};
}
template <class R> dual<R> operator+(dual<R> a, dual<R> b)
{
    return {a.x + b.x, a.d + b.d};
}

/* A correction that is none, in parts of a variable. */
template <class R>
constexpr double NONE_SLOW = std::is_same_v<R, long double> ? 1e-15 : 1e-19;

/* Steady motions, one after the other, by r, the root of cos theta: natural
 * units. */
template <class R> struct slow_path {
    using vector = std::array<R, 6>; /* wY, wZ, time, phi, psi, r */

    R IX, IZ, side;
    const losses<R> *of;
    vector y;

    slow_path(const coin_params &p, const coin_state &s, const losses<R> *l)
        : of(l)
    {
        const moment<R> m(p, s);
        const R w = root(m.g / m.a);
        IX = m.IX / m.m;
        IZ = m.IZ / m.m;
        side = s.theta < 0 ? -1 : 1;
        y = {m.wY / w, m.wZ / w, 0, m.phi, m.psi, root(m.c)};
    }

    /* d/dr, where the variables have changed by v. */
    vector rates(const vector &v) const
    {
        const R r = y[5] + v[5], wY = y[0] + v[0], wZ = y[1] + v[1];
        const R c = r * r, s = side * root((1 - c) * (1 + c));
        const slowing<R> by = of->at(IX, 1 + IX, 1 + IZ, s, c, 0, wY, wZ);
        const R none = residue_rate(s, c, wY, wZ, 0, by);
        const R wX = none / (none - residue_rate(s, c, wY, wZ, 1, by));
        const R time = -2 * r / (s * wX);
        return {(wX * (wY * s / c + IZ / IX * wZ) + by.wY.value) * time,
                (wX * wY / (1 + IZ) + by.wZ.value) * time,
                time,
                wY / c * time,
                (wZ + wY * s / c) * time,
                1};
    }

    /* Towards flat, to the root `end`; false where the lean turns round. */
    bool follow(R end)
    {
        R part = R(0.2); /* of r that a step takes */
        for (int tries = 0; y[5] > end && tries < 400; ++tries) {
            const R r = y[5], H = larger(end, r * (1 - part)) - r;
            const vector d0 = rates(vector());
            vector change, sizes;
            if (!(d0[2] < 0 && -d0[2] * r < R(1e18)))
                return false;
            for (int i = 0; i < 6; ++i)
                sizes[i] = magnitude(y[i]) + magnitude(d0[i] * r) + R(1e-30);
            if (!extrapolated<R, 6>(
                    [this](const vector &v, vector &d) { d = rates(v); }, sizes,
                    H, change, NONE_SLOW<R>)) {
                part /= 2;
                continue;
            }
            part = lesser(part * R(1.5), R(0.3));
            for (int i = 0; i < 6; ++i)
                y[i] += change[i];
            y[5] = r + H;
        }
        return y[5] <= end && y[2] >= 0;
    }

  private:
    /* d/dt of I_X T wY^2 + K wY wZ - s, (39), if theta changes by wX. */
    R residue_rate(R s, R c, R wY, R wZ, R wX, const slowing<R> &by) const
    {
        const R K = 1 + IZ;
        const dual<R> sth = {s, c * wX}, T = {s / c, wX / (c * c)};
        const dual<R> Y = {wY, wX * (wY * s / c + IZ / IX * wZ) + by.wY.value};
        const dual<R> Z = {wZ, wX * wY / K + by.wZ.value};
        const dual<R> I = {IX, 0}, k = {K, 0}, minus = {-1, 0};
        return (I * T * Y * Y + k * Y * Z + minus * sth).d;
    }
};

/* The parts to which the model is solved: a state, and the time to rest. */
constexpr double SHARP = 1e-9, TIME = 1e-6;

/* What a row of the model is asked with. */
template <class R> struct quasi {
    coin_params p;
    coin_state start;
    coin_losses l;
    R w;
    losses<R> of;

    quasi(const scene &s)
        : p(params_of<doubles>(s)), start(state_of<doubles>(s)),
          l(losses_of(s)), w(root(R(p.gravity) / p.radius)),
          of(l, softening(l, p), p.mass, p.radius, 1 / w)
    {
    }

    /* The time to rest, in natural units; negative where the truth has none.
     * The last of it goes as a power of r that the slopes tell: from two places
     * by the same, or there is no truth. */
    R life(const losses<R> &by) const
    {
        slow_path<R> path(p, start, &by);
        R whole[2];
        for (int i = 0; i < 2; ++i) {
            const R end = i == 0 ? 0.01 : 0.005;
            if (!path.follow(R(1.1) * end))
                return -1;
            const R before = path.rates({})[2];
            if (!path.follow(end))
                return -1;
            const R slope = path.rates({})[2];
            const R power = logarithm(before / slope) / logarithm(R(1.1));
            whole[i] = path.y[2] - end * slope / (1 + power);
        }
        const R apart = magnitude(whole[1] - whole[0]);
        return apart <= R(0.3 * TIME) * whole[1] ? whole[1] : R(-1);
    }
};

template <class R> double time_to_rest(const scene &s, double)
{
    const quasi<R> q(s);
    const double T = coin_time_to_rest(&q.start, &q.p, &q.l);
    const R want = T < 1e300 ? q.life(q.of) : R(-1);
    return want > 0 ? double(magnitude(T * q.w / want - 1) / R(TIME))
                    : NO_CLAIM;
}

/* The time, the rates, the heading and the roll at the lean that it gives. */
template <class R> double quasisteady_at(const scene &s, double)
{
    const quasi<R> q(s);
    const double T = coin_time_to_rest(&q.start, &q.p, &q.l);
    coin_state out;
    if (!(T < 1e300) ||
        coin_quasisteady_at(&q.start, &q.p, &q.l, T * s.t, &out) != COIN_OK)
        return NO_CLAIM;
    slow_path<R> path(q.p, q.start, &q.of);
    const R c = cosine(R(out.theta)), r = root(c);
    if (!(path.y[5] > r) || !path.follow(r))
        return NO_CLAIM;
    const auto d = path.rates({});
    const R lean = 8 * R(doubles::u) / r; /* of r, as theta has it */
    const R got[] = {out.wY / q.w, out.wZ / q.w, R(T * s.t) * q.w, R(out.phi),
                     R(out.psi)};
    verdict<R> v;
    for (int i = 0; i < 5; ++i) {
        const R way =
            i < 3
                ? magnitude(path.y[i])
                : magnitude(path.y[i] - R(i == 3 ? q.start.phi : q.start.psi));
        v.hold(got[i], path.y[i],
               R(SHARP) * larger(way, R(1)) + magnitude(d[i]) * lean +
                   8 * R(doubles::u) * magnitude(got[i]));
    }
    return v.worst;
}

template <class R> double fit(const scene &s, double)
{
    quasi<R> q(s);
    const double time = s.t / double(q.w) * 1000;
    coin_losses fitted = q.l;
    if (coin_losses_fit(&fitted, &q.start, &q.p, time) != COIN_OK)
        return NO_CLAIM;
    const losses<R> by(fitted, softening(fitted, q.p), q.p.mass, q.p.radius,
                       1 / q.w);
    const R want = q.life(by);
    return want > 0 ? double(magnitude(want / (time * q.w) - 1) / R(TIME))
                    : NO_CLAIM;
}

/* Spins and slow circles, 0.03 to 1.2 rad from flat, of bodies with I_X from
 * M a^2/20 to M a^2 and I_Z from I_X on; losses of 1e-8 to 1e-3,
 * the pivoting friction not alone; a part of the life. */
void slow_motions(scene *s, const double *g)
{
    const double e = 0.03 + 1.17 * g[8];
    s->theta = (g[9] < 0.5 ? 1 : -1) * (1.5707963267948966 - e);
    s->IX = s->M * s->a * s->a * (0.05 + 0.95 * g[4] * g[4]);
    s->IZ = s->IX * (1 + g[5]);
    const double w = std::sqrt(s->g / s->a);
    coin_params p = params_of<doubles>(*s);
    coin_state made = state_of<doubles>(*s);
    if (g[12] < 0.5)
        coin_steady_spin(&made, &p, s->theta);
    else
        coin_steady_circle(&made, &p, s->theta,
                           w * (4 * g[13] - 2) * (1 - e / 2), 1);
    s->wX = 0;
    s->wY = made.wY;
    s->wZ = made.wZ;
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->t = 0.01 + 0.98 * g[22];
    s->steps = 1 + std::floor(63 * g[23]);
    for (int i = 0; i < 4; ++i)
        s->q[i] = std::pow(10, 5 * g[26 + i] - 8);
}
} // namespace

#define LOSSES(function, name, law, divisor, edge)                             \
    {                                                                          \
        name, law, divisor, false, edge, function<long double>, function<quad> \
    }

void add_losses(std::vector<row> *rows)
{
    const row made[] = {
        LOSSES(power, "coin_losses_power", "16 u of the terms", 1, some_losses),
        LOSSES(rates, "coin_losses_rates", "16 u of the terms", 1, some_losses),
        LOSSES(reaction, "coin_losses_reaction", "16 u of the terms", 1,
               some_losses),
        {"coin_settle", "2 tol a radius of speed + rounding", 25, false,
         launches, settle<doubles, long double>, settle<doubles, quad>},
        {"coinf_settle", "2 tol a radius of speed + rounding", 25, true,
         float_launches, settle<floats, long double>, settle<floats, quad>},
        LOSSES(time_to_rest, "coin_time_to_rest", "1e-6 of the model's", 20,
               slow_motions),
        LOSSES(quasisteady_at, "coin_quasisteady_at",
               "1e-9 of the model's or of 1", 25, slow_motions),
        LOSSES(fit, "coin_losses_fit", "1e-6 of the model's", 25, slow_motions),
    };
    for (const row &r : made)
        rows->push_back(r);
}
