/* SPDX-License-Identifier: MIT */
/* The best rate of operations of doubles, RATE_LANES in a vector. */
#ifndef RATE_H
#define RATE_H

#include "clock.h"

/* Time for one, where many vectors of them are under way: as many that none
 * waits for another, and about as many additions as products. */
static inline double rate_window(double tare)
{
    typedef double lanes __attribute__((vector_size(8 * RATE_LANES)));
    static volatile double one = 1.0000001;
    const lanes none = {0}, y = none + one;
    lanes v[14];
    for (int i = 0; i < 14; ++i)
        v[i] = y * one;
    lanes a = v[0], b = v[1], c = v[2], d = v[3], e = v[4], f = v[5], g = v[6],
          h = v[7], i = v[8], j = v[9], k = v[10], l = v[11], m = v[12],
          o = v[13];
    const double begin = clock_ns();
    for (int n = 0; n < 1000; ++n) {
        a = a * y, b = b + y, c = c * y, d = d * y, e = e + y, f = f * y;
        g = g * y, h = h + y, i = i * y, j = j * y, k = k + y, l = l * y;
        m = m * y, o = o + y;
    }
    const double ns = clock_ns() - begin - tare;
    const lanes sum = a + b + c + d + e + f + g + h + i + j + k + l + m + o;
    one += 0 * sum[0];
    return ns / (1000.0 * 14 * RATE_LANES);
}

#endif
