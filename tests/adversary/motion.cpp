/* SPDX-License-Identifier: MIT */
#include "motion.hpp"

double growth(motion<long double> now, long double dt, uint64_t times,
              double enough)
{
    using number = long double;
    now.none = 0x1p-42; /* to compare motions a ten millionth apart */
    std::vector<std::pair<motion<number>, number>> moments;
    motion<number> fast = now;
    number left_fast = 0;
    for (uint64_t k = 0; k < times; ++k) {
        const number left = dt * number(times - k);
        if (k % (times / 6 + 1) == 0)
            moments.push_back({now, left});
        if (k == 0 || now.fastest() > fast.fastest()) {
            fast = now;
            left_fast = left;
        }
        if (!now.follow(dt))
            return 1e30;
    }
    moments.push_back({fast, left_fast});
    static size_t worst_before = 0; /* the next motion is like the last */
    const size_t first = worst_before;
    double worst = 1;
    for (size_t i = 0; i < moments.size() && worst < enough; ++i) {
        const size_t k = (first + i) % moments.size();
        const double grown =
            moments[k].first.grown(now, moments[k].second, enough);
        worst_before = grown > worst ? k : worst_before;
        worst = larger(worst, grown);
    }
    return worst;
}

double unamplified(double ratio, double enough,
                   const motion<long double> &start, long double dt,
                   uint64_t times)
{
    if (!(ratio > larger(enough, UNAMPLIFIED)))
        return ratio;
    return ratio / growth(start, dt, times, enough > 0 ? ratio / enough : 1e30);
}
