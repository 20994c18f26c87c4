/* SPDX-License-Identifier: MIT */
#include "plain.h"

void plain_run(double y[8], const struct peer_body *b, double dt,
               unsigned long steps)
{
    double k1[8], k2[8], k3[8], k4[8], v[8];
    while (steps-- > 0) {
        peer_rates(b, y, k1);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt / 2 * k1[i];
        peer_rates(b, v, k2);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt / 2 * k2[i];
        peer_rates(b, v, k3);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt * k3[i];
        peer_rates(b, v, k4);
        for (int i = 0; i < 8; ++i)
            y[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
}
