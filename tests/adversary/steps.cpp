/* SPDX-License-Identifier: MIT */
/* Fixed steps, one and many, against the law that coin.h states of them:
 * C (|dt| W)^(order + 1) a step, before the motion's own amplification. */
#include "growth.hpp"
#include "path.hpp"
#include "row.hpp"
#include "truth.hpp"

#include <array>
#include <cstring>

namespace
{
struct law {
    int order;
    double C;
};
constexpr law LAWS[] = {{4, 0.1}, {8, 2e-4}, {2, 0.6}, {4, 0.04}};

/* The law's bodies: those whose mass lies within the rim, up to the hoop's
 * I_X = M a^2/2 and its rounding. */
constexpr double FAR = 0.500001;

constexpr int POSE = 5, MEMBERS = 8;

/* The largest difference of the first members in radians, radii and parts of W.
 */
template <class T, class R>
R apart(const path<R> &truth, const typename T::state &s, R W, int members)
{
    scene whole = {};
    double *to = &whole.theta;
    for (int i = 0; i < 8; ++i)
        to[i] = double((&s.theta)[i]) + T::low(s, i);
    R off[MEMBERS], worst = 0;
    truth.apart(whole, W, off);
    if (T::u > 1e-10) /* heading and roll within half a turn */
        for (int i = 1; i < 3; ++i)
            off[i] = within_half_a_turn(off[i]);
    for (int i = 0; i < members; ++i)
        worst = larger(worst, magnitude(off[i]));
    return worst;
}

template <class T, class R, int METHOD>
double run_of(const scene &s, double enough, uint64_t steps)
{
    const typename T::params p = params_of<T>(s);
    typename T::state y = state_of<T>(s);
    const typename T::real dt = typename T::real(s.t);
    path<R> truth(p, y);
    if (!(p.inertia_X < FAR * p.mass * p.radius * p.radius) ||
        T::run(&y, &p, METHOD, dt, steps, nullptr) != COIN_OK)
        return NO_CLAIM;
    R sum = 0, W = truth.fastest(), last = W, least = truth.cos_theta();
    for (uint64_t k = 0; k < steps; ++k) {
        if (!truth.follow(R(dt)))
            return NO_CLAIM;
        least = lesser(least, truth.cos_theta());
        const R next = truth.fastest();
        W = larger(last, next);
        last = next;
        sum +=
            whole_power(magnitude(R(dt)) * truth.w * W, LAWS[METHOD].order + 1);
    }
    const R flat = METHOD < 2 ? R(1) : 1 / least;
    const R rounding =
        T::u * (4 * R(steps) * flat + 16 * truth.largest_of_pose());
    const R bound = R(LAWS[METHOD].C) * sum + rounding;
    const R error = apart<T, R>(truth, y, W, MEMBERS);
    if (!(error <= R(1e30)))
        return BROKEN;
    const double ratio = double(error / bound);
    if (bound >= 1)
        return NO_CLAIM;
    /* Growth is that of errors of cos theta in the lean; one of its rounding is
     * that of a radian. */
    const R lean = METHOD < 2 ? T::u * 4 * R(steps) * (1 / least - 1) : R(0);
    const double more = double(1 + lean / bound);
    return steps == 1 ? ratio : unamplified(ratio, enough, [&](double most) {
        return more * growth(p, state_of<T>(s), dt, steps, most / more);
    });
}

template <class T, class R, int METHOD>
double step(const scene &s, double enough)
{
    return run_of<T, R, METHOD>(s, enough, 1);
}

template <class T, class R, int METHOD>
double run(const scene &s, double enough)
{
    return run_of<T, R, METHOD>(s, enough, uint64_t(s.steps));
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
    for (int i = 0; i < 8; ++i)
        rates[i] = d[i].value;
    return rates;
}

members beyond(const members &from, long double h, const members &slope)
{
    members at = from;
    for (int i = 0; i < 8; ++i)
        at[i] += h * slope[i];
    return at;
}

/* Classical Runge-Kutta steps on all eight members. */
template <class P, class S>
coin_state textbook(const P &p, const S &s, long double h, uint64_t steps)
{
    const moment<long double> m(p, s);
    members y = {m.theta, m.phi, m.psi, m.x, m.z, m.wX, m.wY, m.wZ};
    while (steps-- > 0) {
        const members k1 = slopes(m, y);
        const members k2 = slopes(m, beyond(y, h / 2, k1));
        const members k3 = slopes(m, beyond(y, h / 2, k2));
        const members k4 = slopes(m, beyond(y, h, k3));
        for (int i = 0; i < 8; ++i)
            y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    coin_state end = {};
    for (int i = 0; i < 8; ++i)
        (&end.theta)[i] = double(y[i]);
    return end;
}

/* RK4's pose beside the textbook's: 1.5 times its error, and where that is
 * none a tenth of the error on an ordinary motion; and rounding, as in
 * run_of(). That of floats is for any motion, and before the motion's
 * amplification. */
template <class T, class R>
double beside_textbook(const scene &s, double enough)
{
    const typename T::params p = params_of<T>(s);
    const typename T::state start = state_of<T>(s);
    const typename T::real dt = typename T::real(s.t);
    const uint64_t steps = uint64_t(s.steps);
    typename T::state ours = start;
    path<R> truth(p, start);
    if (!(p.inertia_X < FAR * p.mass * p.radius * p.radius) ||
        T::run(&ours, &p, COIN_RK4, dt, steps, nullptr) != COIN_OK ||
        truth.is_long(R(dt) * s.steps) || !truth.follow(R(dt) * s.steps))
        return NO_CLAIM;
    const R W = truth.fastest();
    const R theirs =
        apart<doubles, R>(truth, textbook(p, start, dt, steps), W, POSE);
    const R dtW = magnitude(R(dt)) * truth.w * truth.most_W;
    const R rounding =
        R(T::u) * (4 * R(s.steps) + 16 * truth.largest_of_pose());
    const R method = larger(1.5 * theirs, R(1.5e-3) * whole_power(dtW, 4));
    const R error = apart<T, R>(truth, ours, W, POSE);
    const double ratio = double(error / (method + rounding));
    if (T::u < 1e-10 || !(ratio > larger(enough, UNAMPLIFIED)))
        return ratio;
    const R grown = R(growth(p, start, dt, steps, 1e30));
    return double(error / (method + rounding * grown));
}

/* Spins, steady and not, followed for five natural units. */
void beside_spins(scene *s, const double *g)
{
    const double m = s->M * s->a * s->a, unit = std::sqrt(s->a / s->g);
    const double lean = 0.02 + 1.5 * g[8], c = std::cos(lean);
    s->theta = g[9] < 0.5 ? lean : -lean;
    s->wX = 0;
    s->wZ = g[13] < 0.5 ? 0 : 2 * (g[13] - 0.75) / unit;
    s->wY = std::sqrt(s->g / s->a * m / s->IX * c) *
            (g[28] < 0.3 ? 1 : 0.5 + 2.5 * g[12]);
    s->phi = 6 * g[18] - 3;
    s->psi = 6 * g[19] - 3;
    s->x = s->a * (6 * g[20] - 3);
    s->z = s->a * (6 * g[21] - 3);
    const double W =
        std::sqrt(s->wY * s->wY / (c * c) + s->wZ * s->wZ + s->g / (s->a * c));
    s->t = (g[22] < 0.5 ? 0.02 + 0.16 * g[22] : 0.06 - 0.16 * g[22]) / W;
    s->steps = std::floor(lesser(5 * unit, 60 / W) / std::fabs(s->t));
}

/* ------------------------------------------------------------- equal bits */

template <class T>
bool same(const typename T::state &a, const typename T::state &b)
{
    return !std::memcmp(&a, &b, sizeof a);
}

/* coin_step() is a run of one step. */
template <class T> double step_is_a_run(const scene &s, double)
{
    const typename T::params p = params_of<T>(s);
    typename T::state one = state_of<T>(s), other = one;
    const typename T::real dt = typename T::real(s.t);
    const int32_t said = T::step(&one, &p, dt);
    return said == T::run(&other, &p, COIN_RK4, dt, 1, nullptr) &&
                   same<T>(one, other)
               ? 0
               : BROKEN;
}

/* Four coins beside each other are four alone. */
double batch_is_runs(const scene &s, double)
{
    const int method = int(s.method);
    const coin_params p = params_of<doubles>(s);
    const uint64_t steps = uint64_t(s.steps);
    coin_state many[17], one[17];
    int32_t said[17];
    for (int i = 0; i < 17; ++i) {
        many[i] = state_of<doubles>(s);
        many[i].wZ *= 1 + s.q[i % 4] * i;
        one[i] = many[i];
    }
    if (coin_batch_run(many, 17, &p, method, s.t, steps, said) == COIN_EPARAMS)
        return NO_CLAIM;
    for (int i = 0; i < 17; ++i)
        if (coin_run(&one[i], &p, method, s.t, steps, nullptr) != said[i] ||
            !same<doubles>(one[i], many[i]))
            return BROKEN;
    return 0;
}

/* A sample's elements are where runs from the start end. */
double sample_is_runs(const scene &s, double)
{
    const coin_params p = params_of<doubles>(s);
    const coin_state start = state_of<doubles>(s);
    const int method = int(s.method);
    const uint64_t each = uint64_t(s.steps);
    coin_state out[5];
    size_t done = 0;
    if (coin_sample(&start, &p, method, s.t, each, 5, out, &done) < 0 && !done)
        return NO_CLAIM;
    for (size_t k = 0; k < done; ++k) {
        coin_state one = start;
        coin_run(&one, &p, method, s.t, each * k, nullptr);
        if (!same<doubles>(one, out[k]))
            return BROKEN;
    }
    return 0;
}

/* dt W at and below the method's limit, where the law has least to spare. */
template <int METHOD> void near_the_limit(scene *s, const double *genes)
{
    constexpr double limits[] = {0.35, 1, 0.08, 0.16};
    const double c = std::cos(s->theta);
    const double W = std::sqrt((s->wX * s->wX + s->wY * s->wY) / (c * c) +
                               s->wZ * s->wZ + s->g / (s->a * c));
    const double part = genes[22] < 0.5 ? 2 * genes[22] : 2 * genes[22] - 1;
    const double size = limits[METHOD] * std::pow(10, -2 * part * part);
    s->t = (genes[22] < 0.5 ? size : -size) / W;
}
} // namespace

#define STEP(T, name, method, law, divisor, edge)                              \
    {                                                                          \
        name, law, divisor, T::u > 1e-10, edge, step<T, long double, method>,  \
            step<T, quad, method>                                              \
    }
#define RUN(T, name, method, law, divisor, edge)                               \
    {                                                                          \
        name, law, divisor, T::u > 1e-10, edge, run<T, long double, method>,   \
            run<T, quad, method>                                               \
    }
#define BITS(function, name, T, divisor)                                       \
    {                                                                          \
        name, "equal bits", divisor, T::u > 1e-10, nullptr, function, function \
    }

void add_steps(std::vector<row> *rows)
{
    const char *const rk4 = "0.1 (dt W)^5 a step + rounding";
    const char *const rk8 = "2e-4 (dt W)^9 a step + rounding";
    const char *const sy2 = "0.6 (dt W)^3 a step + rounding";
    const char *const sy4 = "0.04 (dt W)^5 a step + rounding";
    const row made[] = {
        STEP(doubles, "coin_step", COIN_RK4, rk4, 1, near_the_limit<0>),
        STEP(doubles, "coin_run_rk8_once", COIN_RK8, rk8, 1, near_the_limit<1>),
        STEP(doubles, "coin_run_symplectic2_once", COIN_SYMPLECTIC2, sy2, 1,
             near_the_limit<2>),
        STEP(doubles, "coin_run_symplectic4_once", COIN_SYMPLECTIC4, sy4, 1,
             near_the_limit<3>),
        STEP(floats, "coinf_step", COIN_RK4, rk4, 1, near_the_limit<0>),
        RUN(doubles, "coin_run_rk4", COIN_RK4, rk4, 2, near_the_limit<0>),
        RUN(doubles, "coin_run_rk8", COIN_RK8, rk8, 2, near_the_limit<1>),
        RUN(doubles, "coin_run_symplectic2", COIN_SYMPLECTIC2, sy2, 2,
            near_the_limit<2>),
        RUN(doubles, "coin_run_symplectic4", COIN_SYMPLECTIC4, sy4, 2,
            near_the_limit<3>),
        RUN(floats, "coinf_run_rk4", COIN_RK4, rk4, 2, near_the_limit<0>),
        {"coin_run_rk4_beside_textbook",
         "1.5 times the textbook's; 1.5e-3 (dt W)^4", 30, false, beside_spins,
         beside_textbook<doubles, long double>, beside_textbook<doubles, quad>},
        {"coinf_run_rk4_beside_textbook",
         "1.5 times the textbook's; 1.5e-3 (dt W)^4", 30, true,
         near_the_limit<0>, beside_textbook<floats, long double>,
         beside_textbook<floats, quad>},
        BITS(step_is_a_run<doubles>, "coin_step_is_coin_run", doubles, 1),
        BITS(step_is_a_run<floats>, "coinf_step_is_coinf_run", floats, 1),
        BITS(batch_is_runs, "coin_batch_run", doubles, 2),
        BITS(sample_is_runs, "coin_sample", doubles, 1),
    };
    for (const row &r : made)
        rows->push_back(r);
}
