/* SPDX-License-Identifier: MIT */
/* Fixed steps, one and many, against the law that coin.h states of them:
 * C (|dt| W)^(order + 1) a step, before the motion's own amplification. */
#include "motion.hpp"

#include <cstring>

namespace
{
struct method {
    int order;
    double C, limit;
};
constexpr method METHODS[] = {
    {4, 0.1, 0.35}, {8, 2e-4, 1}, {2, 0.6, 0.08}, {4, 0.04, 0.16}};

constexpr int POSE = 5, MEMBERS = 8;

/* The law's bodies: those whose mass lies within the rim, up to the hoop's
 * I_X = M a^2/2 and its rounding. */
template <class P> bool is_within_the_rim(const P &p)
{
    return p.inertia_X < 0.500001 * p.mass * p.radius * p.radius;
}

/* The largest difference of the first members in radians, radii and parts of W.
 */
template <class T, class R>
R apart(const motion<R> &truth, const typename T::state &s, R W, int members)
{
    scene whole = {};
    double *to = &whole.theta;
    for (int i = 0; i < 8; ++i)
        to[i] = double((&s.theta)[i]) + T::low(s, i);
    R off[MEMBERS], worst = 0;
    truth.apart(whole, W, off);
    for (int i = 0; i < members; ++i) {
        /* Heading and roll of floats lie within half a turn. */
        const bool turns = T::u > 1e-10 && (i == 1 || i == 2);
        while (turns && magnitude(off[i]) > 2 * half_pi<R>)
            off[i] += (off[i] > 0 ? -4 : 4) * half_pi<R>;
        worst = larger(worst, magnitude(off[i]));
    }
    return worst;
}

template <class T, class R> bool runs(trial<T, R> &q, uint64_t steps)
{
    const method &law = METHODS[q.kind];
    const typename T::real dt = typename T::real(q.s.t);
    typename T::state y = q.y;
    motion<R> truth(q.p, y);
    if (!is_within_the_rim(q.p) ||
        T::run(&y, &q.p, q.kind, dt, steps, nullptr) != COIN_OK)
        return false;
    R sum = 0, W = truth.fastest(), last = W, least = truth.at(truth.C);
    for (uint64_t k = 0; k < steps; ++k) {
        if (!truth.follow(R(dt)))
            return false;
        least = lesser(least, truth.at(truth.C));
        W = larger(last, truth.fastest());
        last = truth.fastest();
        sum += whole_power(magnitude(R(dt)) * truth.w * W, law.order + 1);
    }
    const R flat = q.kind < 2 ? R(1) : 1 / least;
    const R rounding =
        q.u * (4 * R(steps) * flat + 16 * truth.largest_of_pose());
    const R bound = R(law.C) * sum + rounding;
    const R error = apart<T, R>(truth, y, W, MEMBERS);
    if (!(error <= R(1e30)))
        return q.is(BROKEN);
    const double ratio = double(error / bound);
    /* Growth is that of errors of cos theta in the lean; one of its rounding is
     * that of a radian. */
    const R lean = q.kind < 2 ? q.u * 4 * R(steps) * (1 / least - 1) : R(0);
    const double more = double(1 + lean / bound);
    q.is(steps == 1 || !(ratio > UNAMPLIFIED)
             ? ratio
             : unamplified(ratio / more, q.enough, {q.p, q.y}, dt, steps));
    return bound < 1;
}

template <class T, class R> bool step(trial<T, R> &q)
{
    return runs(q, 1);
}

template <class T, class R> bool run(trial<T, R> &q)
{
    return runs(q, uint64_t(q.s.steps));
}

/* ----------------------------------------------------------- the textbook */

using members = std::array<long double, 8>;

members slopes(const moment<long double> &still, const members &at)
{
    moment<long double> y = still;
    terms<long double> d[8];
    y.s = sine(at[0]);
    y.c = cosine(at[0]);
    y.T = y.s / y.c;
    y.sph = sine(at[1]);
    y.cph = cosine(at[1]);
    y.wX = at[5];
    y.wY = at[6];
    y.wZ = at[7];
    rates_of(y, d);
    members rates;
    for (size_t i = 0; i < 8; ++i)
        rates[i] = d[i].value;
    return rates;
}

members beyond(const members &from, long double h, const members &slope)
{
    members at = from;
    for (size_t i = 0; i < 8; ++i)
        at[i] += h * slope[i];
    return at;
}

/* Classical Runge-Kutta steps on all eight members. */
coin_state textbook(const moment<long double> &m, long double h, uint64_t steps)
{
    members y = {m.theta, m.phi, m.psi, m.x, m.z, m.wX, m.wY, m.wZ};
    while (steps-- > 0) {
        const members k1 = slopes(m, y);
        const members k2 = slopes(m, beyond(y, h / 2, k1));
        const members k3 = slopes(m, beyond(y, h / 2, k2));
        const members k4 = slopes(m, beyond(y, h, k3));
        for (size_t i = 0; i < 8; ++i)
            y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    coin_state end = {};
    for (size_t i = 0; i < 8; ++i)
        (&end.theta)[i] = double(y[i]);
    return end;
}

/* RK4's pose beside the textbook's: 1.5 times its error, and where that is
 * none a tenth of the error on an ordinary motion; and rounding, as in
 * runs().  That of floats is for any motion, and before the motion's
 * amplification. */
template <class T, class R> bool beside_textbook(trial<T, R> &q)
{
    const typename T::real dt = typename T::real(q.s.t);
    const uint64_t steps = uint64_t(q.s.steps);
    typename T::state ours = q.y;
    motion<R> truth(q.p, q.y);
    if (!is_within_the_rim(q.p) ||
        T::run(&ours, &q.p, COIN_RK4, dt, steps, nullptr) != COIN_OK ||
        !truth.follow(R(dt) * q.s.steps))
        return false;
    const R W = truth.fastest();
    const coin_state book = textbook(moment<long double>(q.p, q.y), dt, steps);
    const R theirs = apart<doubles, R>(truth, book, W, POSE);
    const R dtW = magnitude(R(dt)) * truth.w * truth.most_W;
    const R rounding = q.u * (4 * R(q.s.steps) + 16 * truth.largest_of_pose());
    const R law = larger(1.5 * theirs, R(1.5e-3) * whole_power(dtW, 4));
    const R error = apart<T, R>(truth, ours, W, POSE);
    const double ratio = double(error / (law + rounding));
    if (T::u < 1e-10 || !(ratio > larger(q.enough, UNAMPLIFIED)))
        return q.is(ratio);
    const R grown = R(growth({q.p, q.y}, dt, steps, 1e30));
    return q.is(double(error / (law + rounding * grown)));
}

/* Spins, steady and not, followed for five natural units. */
void beside_spins(scene *s, const double *g, int)
{
    const double m = s->M * s->a * s->a, unit = std::sqrt(s->a / s->g);
    const double lean = 0.02 + 1.5 * g[8];
    s->theta = g[9] < 0.5 ? lean : -lean;
    s->wX = 0;
    s->wZ = g[13] < 0.5 ? 0 : 2 * (g[13] - 0.75) / unit;
    s->wY = std::sqrt(s->g / s->a * m / s->IX * std::cos(lean)) *
            (g[28] < 0.3 ? 1 : 0.5 + 2.5 * g[12]);
    near_pose(s, g);
    const double W = fastest_of(*s);
    s->t = (g[22] < 0.5 ? 0.02 + 0.16 * g[22] : 0.06 - 0.16 * g[22]) / W;
    s->steps = std::floor(lesser(5 * unit, 60 / W) / std::fabs(s->t));
}

/* ------------------------------------------------------------- equal bits */

template <class S> bool same(const S &a, const S &b)
{
    return !std::memcmp(&a, &b, sizeof a);
}

/* coin_step() is a run of one step. */
template <class T, class R> bool step_is_a_run(trial<T, R> &q)
{
    typename T::state one = q.y, other = q.y;
    const typename T::real dt = typename T::real(q.s.t);
    const int32_t said = T::step(&one, &q.p, dt);
    q.equal(said == T::run(&other, &q.p, COIN_RK4, dt, 1, nullptr) &&
            same(one, other));
    return true;
}

/* Coins beside each other are coins alone. */
template <class T, class R> bool batch_is_runs(trial<T, R> &q)
{
    constexpr int COUNT = 17;
    const int method = int(q.s.method);
    const uint64_t steps = uint64_t(q.s.steps);
    coin_state many[COUNT], one[COUNT];
    int32_t said[COUNT];
    for (int i = 0; i < COUNT; ++i) {
        many[i] = q.y;
        many[i].wZ *= 1 + q.s.q[i % 4] * i;
        one[i] = many[i];
    }
    if (coin_batch_run(many, COUNT, &q.p, method, q.s.t, steps, said) ==
        COIN_EPARAMS)
        return false;
    for (int i = 0; i < COUNT; ++i)
        q.equal(coin_run(&one[i], &q.p, method, q.s.t, steps, nullptr) ==
                    said[i] &&
                same(one[i], many[i]));
    return true;
}

/* A sample's elements are where runs from the start end. */
template <class T, class R> bool sample_is_runs(trial<T, R> &q)
{
    const int method = int(q.s.method);
    const uint64_t each = uint64_t(q.s.steps);
    coin_state out[5];
    size_t done = 0;
    if (coin_sample(&q.y, &q.p, method, q.s.t, each, 5, out, &done) < 0 &&
        !done)
        return false;
    for (size_t k = 0; k < done; ++k) {
        coin_state one = q.y;
        coin_run(&one, &q.p, method, q.s.t, each * k, nullptr);
        q.equal(same(one, out[k]));
    }
    return true;
}

/* dt W at and below the method's limit, where the law has least to spare. */
void near_the_limit(scene *s, const double *g, int kind)
{
    const double part = g[22] < 0.5 ? 2 * g[22] : 2 * g[22] - 1;
    const double size = METHODS[kind].limit * std::pow(10, -2 * part * part);
    s->t = (g[22] < 0.5 ? size : -size) / fastest_of(*s);
}

#define STEPS(T, name, share, method, law)                                     \
    LAW(T, name, LAWS[method], share, near_the_limit, method, law)
#define BITS(T, name, share, law)                                              \
    LAW(T, name, "equal bits", share, nullptr, 0, law)
} // namespace

std::vector<row> steps()
{
    const char *const LAWS[] = {
        "0.1 (dt W)^5 a step + rounding", "2e-4 (dt W)^9 a step + rounding",
        "0.6 (dt W)^3 a step + rounding", "0.04 (dt W)^5 a step + rounding"};
    const char *const beside = "1.5 times the textbook's; 1.5e-3 (dt W)^4";
    return {
        STEPS(doubles, "coin_step", 1, COIN_RK4, step),
        STEPS(doubles, "coin_run_rk8_once", 1, COIN_RK8, step),
        STEPS(doubles, "coin_run_symplectic2_once", 1, COIN_SYMPLECTIC2, step),
        STEPS(doubles, "coin_run_symplectic4_once", 1, COIN_SYMPLECTIC4, step),
        STEPS(floats, "coinf_step", 1, COIN_RK4, step),
        STEPS(doubles, "coin_run_rk4", 4, COIN_RK4, run),
        STEPS(doubles, "coin_run_rk8", 4, COIN_RK8, run),
        STEPS(doubles, "coin_run_symplectic2", 4, COIN_SYMPLECTIC2, run),
        STEPS(doubles, "coin_run_symplectic4", 4, COIN_SYMPLECTIC4, run),
        STEPS(floats, "coinf_run_rk4", 4, COIN_RK4, run),
        LAW(doubles, "coin_run_rk4_beside_textbook", beside, 30, beside_spins,
            0, beside_textbook),
        LAW(floats, "coinf_run_rk4_beside_textbook", beside, 30, near_the_limit,
            0, beside_textbook),
        BITS(doubles, "coin_step_is_coin_run", 1, step_is_a_run),
        BITS(floats, "coinf_step_is_coinf_run", 1, step_is_a_run),
        BITS(doubles, "coin_batch_run", 2, batch_is_runs),
        BITS(doubles, "coin_sample", 1, sample_is_runs),
    };
}
