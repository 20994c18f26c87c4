/* SPDX-License-Identifier: MIT */
/* Fixed steps, one and many, against the law that coin.h states of them:
 * C (|dt| W)^(order + 1) a step, before the motion's own amplification. */
#include "motion.hpp"

namespace
{
struct method {
    int order;
    double C, limit;
};
constexpr method METHODS[] = {
    {4, 0.1, 0.35}, {8, 2e-4, 1}, {2, 0.6, 0.08}, {4, 0.04, 0.16}};

/* The law's bodies: those whose mass lies within the rim, up to the hoop's
 * I_X = M a^2/2 and its rounding. */
template <class P> bool is_within_the_rim(const P &p)
{
    return p.inertia_X < 0.500001 * p.mass * p.radius * p.radius;
}

/* The largest difference of the members in radians, radii and parts of W. */
template <class T, class R>
R apart(const motion<R> &truth, const typename T::state &s, R W)
{
    scene whole = {};
    double *to = &whole.theta;
    for (int i = 0; i < 8; ++i)
        to[i] = double((&s.theta)[i]) + T::low(s, i);
    R off[8], worst = 0;
    truth.apart(whole, W, off);
    for (int i = 0; i < 8; ++i) {
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
    const R error = apart<T, R>(truth, y, W);
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

/* dt W at and below the method's limit, where the law has least to spare. */
void near_the_limit(scene *s, const double *g, int kind)
{
    const double part = g[22] < 0.5 ? 2 * g[22] : 2 * g[22] - 1;
    const double size = METHODS[kind].limit * std::pow(10, -2 * part * part);
    s->t = (g[22] < 0.5 ? size : -size) / fastest_of(*s);
}

#define STEPS(T, name, share, method, law)                                     \
    LAW(T, name, LAWS[method], share, near_the_limit, method, law)
} // namespace

std::vector<row> steps()
{
    const char *const LAWS[] = {
        "0.1 (dt W)^5 a step + rounding", "2e-4 (dt W)^9 a step + rounding",
        "0.6 (dt W)^3 a step + rounding", "0.04 (dt W)^5 a step + rounding"};
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
    };
}
