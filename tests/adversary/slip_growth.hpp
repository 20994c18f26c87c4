/* SPDX-License-Identifier: MIT */
/* What "before amplification" takes out of a slip: by how much it makes an
 * error grow that is made on its way. */
#ifndef ROLLCOIN_ADVERSARY_SLIP_GROWTH_HPP
#define ROLLCOIN_ADVERSARY_SLIP_GROWTH_HPP

#include "slides.hpp"

#include <vector>

/* How much an error at *from has grown at the end, or so much of it that it is
 * enough.  An error that has grown too far tells nothing of smaller ones. */
inline long double growth_of(const slide<long double> &from,
                             const slide<long double> &end, long double t,
                             long double enough)
{
    long double sum = 1;
    for (size_t i : {0, 5, 6, 7, 8, 9}) {
        slide<long double> other = from;
        other.nudge(i, 1e-7L);
        if (sum >= enough)
            break;
        if (other.follow(t) != slide<long double>::SLIPS)
            return 1e30;
        const long double off = end.apart(other);
        if (off > end.linear())
            return 1e30;
        sum += off / 1e-7L;
    }
    return sum;
}

/* By how much errors on the way grow until t; if that is more than enough,
 * something between the two. */
inline double growth(const asked &q, long double t, double enough)
{
    using truth = slide<long double>;
    constexpr int MOMENTS = 4;
    static int worst_before = 0; /* the next slip is like the last */
    truth end(q);
    end.be_quick();
    std::vector<truth> moments;
    for (int k = 0; k < MOMENTS; ++k) {
        moments.push_back(end);
        if (end.follow(t / MOMENTS) != truth::SLIPS)
            return 1e30;
    }
    const int first = worst_before;
    long double worst = 1;
    for (int i = 0; i < MOMENTS && worst < enough; ++i) {
        const int k = (first + i) % MOMENTS;
        const long double left = t * (MOMENTS - k) / MOMENTS;
        const long double grown = growth_of(moments[k], end, left, enough);
        worst_before = grown > worst ? k : worst_before;
        worst = larger(worst, grown);
    }
    return double(worst);
}

#endif
