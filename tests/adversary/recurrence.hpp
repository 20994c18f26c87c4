/* SPDX-License-Identifier: MIT */
/* The true motion at far times.  Lean and rates of a swing return after a
 * period, and each period turns and moves the coin as the one before.  So one
 * period and what is left of the time are integrated, whatever the time is. */
#ifndef ROLLCOIN_ADVERSARY_RECURRENCE_HPP
#define ROLLCOIN_ADVERSARY_RECURRENCE_HPP

#include "path.hpp"

/* As follow(), for a time of up to so many times what follow() takes. */
template <class R> bool follow_in_pieces(path<R> *now, R t)
{
    constexpr int MOST_PIECES = 4;
    const R turn = magnitude(t * now->w) * now->fastest();
    const R pieces = 1 + 2 * turn / path<R>::MOST_TURN;
    if (!(pieces < MOST_PIECES))
        return false;
    for (int k = 0, n = int(pieces); k < n; ++k)
        if (!now->follow(t / n))
            return false;
    return true;
}

/* From `guess` on to the time at which lean and rates are again those of begin,
 * by Newton's rule along the motion; 0 if that is not found. */
template <class R> R period_of(const path<R> &begin, R guess, path<R> *whole)
{
    const R W = begin.fastest(), X = begin.at()[5] / W,
            P = begin.pull() / (W * W), few = 1024 * precision<R>();
    R period = 0, step = guess, before;
    *whole = begin;
    do {
        before = magnitude(step);
        if (!follow_in_pieces(whole, step))
            return 0;
        period += step;
        const R speed = (whole->at()[5] - begin.at()[5]) / W;
        step = -(whole->lean_apart(begin) * X + speed * P) /
               ((X * X + P * P) * W * begin.w);
    } while (magnitude(step) < before / 2);
    R off = magnitude(whole->lean_apart(begin)) / begin.cos_theta();
    for (int i = 5; i < 8; ++i)
        off = larger(off, magnitude(whole->at()[i] - begin.at()[i]) / W);
    return off < few && magnitude(period - guess) < magnitude(guess) / 2
               ? period
               : 0;
}

/* As follow(), by periods if the time is longer than follow() takes.  The
 * guess is of a period. */
template <class R> bool follow_far(path<R> *now, R t, R guess)
{
    if (!now->is_long(t))
        return now->follow(t);
    path<R> whole = *now;
    const R period = period_of(*now, t < 0 ? -guess : guess, &whole);
    const R times = period == 0 ? 0 : whole_part(t / period);
    if (times == 0 || !follow_in_pieces(now, t - times * period))
        return false;
    now->repeat(whole, times);
    return true;
}

#endif
