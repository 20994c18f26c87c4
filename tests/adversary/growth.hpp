/* SPDX-License-Identifier: MIT */
/* What "before the motion's own amplification" takes out: by how much the true
 * motion makes an error grow that is made on its way. */
#ifndef ROLLCOIN_ADVERSARY_GROWTH_HPP
#define ROLLCOIN_ADVERSARY_GROWTH_HPP

#include "path.hpp"
#include "row.hpp"

#include <utility>
#include <vector>

template <class R> R within_half_a_turn(R angle)
{
    const R turn = 4 * half_pi<R>();
    while (magnitude(angle) > turn / 2)
        angle += angle > 0 ? -turn : turn;
    return angle;
}

/* The largest difference in radians, radii and parts of W. */
template <class R> R apart(const path<R> &a, const path<R> &b)
{
    R worst = magnitude(a.lean_apart(b));
    const R W = a.fastest();
    for (size_t i = 1; i < 8; ++i)
        worst = larger(worst,
                       magnitude(a.at()[i] - b.at()[i]) / (i < 5 ? R(1) : W));
    return worst;
}

/* A small error that has become so large grew by more than its size shows: next
 * to an unstable steady motion it would tell nothing of smaller ones. */
constexpr long double TOO_FAR = 0.1L;

/* How much an error at *from has grown when the motion comes to end: errors of
 * the lean and of each rate, as an error of a step is, and of the heading,
 * which turns the way that is left.  Or so much of it that it is enough. */
inline long double growth_of(const path<long double> &from,
                             const path<long double> &end, long double t,
                             long double enough)
{
    const long double size = 1e-7L;
    const long double dx = end.at()[3] - from.at()[3];
    const long double dz = end.at()[4] - from.at()[4];
    long double sum = 1 + root(dx * dx + dz * dz);
    for (int which = 0; which < 4 && sum < enough; ++which) {
        long double most = 0;
        for (int side = -1; side <= 1; side += 2) {
            path<long double> other = from;
            other.nudge(which, side * size);
            if (!other.follow(t))
                return 1e30L;
            const long double off = apart(end, other);
            if (off > TOO_FAR)
                return 1e30L;
            most = larger(most, off / size);
        }
        sum += most;
    }
    return sum;
}

/* From the worst of some moments of a motion of so many times dt: the start,
 * five on the way, and that where W is largest.  If that is more than enough,
 * something between the two. */
template <class P, class S>
double growth(const P &p, const S &s, double dt, uint64_t times, double enough,
              const losses<long double> *slow = nullptr)
{
    path<long double> now(p, s);
    now.slow = slow;
    now.be_quick();
    path<long double> fast = now;
    std::vector<std::pair<path<long double>, long double>> moments;
    long double most = 0, left_fast = 0;
    for (uint64_t k = 0; k < times; ++k) {
        const long double left = (long double)dt * (long double)(times - k);
        if (k % (times / 6 + 1) == 0)
            moments.push_back({now, left});
        if (now.fastest() > most) {
            most = now.fastest();
            fast = now;
            left_fast = left;
        }
        if (!now.follow(dt))
            return 1e30;
    }
    moments.push_back({fast, left_fast});
    static size_t worst_before = 0; /* the next motion is like the last */
    const size_t first = worst_before;
    long double worst = 1;
    for (size_t i = 0; i < moments.size() && worst < enough; ++i) {
        const size_t k = (first + i) % moments.size();
        const long double grown =
            growth_of(moments[k].first, now, moments[k].second, enough);
        worst_before = grown > worst ? k : worst_before;
        worst = larger(worst, grown);
    }
    return double(worst);
}

/* A ratio above UNAMPLIFIED, without the growth that grown(most) tells, where
 * more than most need not be known.  Not more than enough need be known of the
 * result. */
template <class F>
double unamplified(double ratio, double enough, const F &grown)
{
    if (!(ratio > larger(enough, UNAMPLIFIED)))
        return ratio;
    const double most = enough > 0 ? ratio / enough : 1e30;
    return ratio / grown(most);
}

#endif
