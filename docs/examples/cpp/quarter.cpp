// SPDX-License-Identifier: MIT
// A US quarter rolls for a second: the same as quarter.c.
//
//   c++ -std=c++17 quarter.cpp $(pkg-config --cflags --libs rollcoin)
#include "rollcoin.hpp"

#include <cstdio>

int main()
try {
    const auto p = rollcoin::disc(0.00567, 0.01213, 9.80665);
    rollcoin::state s{};
    s.theta = 0.3; // rad
    s.wY = 5;      // rad/s
    s.wZ = 40;

    for (int tenth = 1; tenth <= 10; ++tenth) {
        rollcoin::run(s, p, rollcoin::method::rk8, 1e-2, 10);
        std::printf("%.1f s  lean %.9f  centre (%.9f, %.9f) m\n", tenth / 10.0,
                    s.theta, s.x, s.z);
    }
    std::printf("energy %.9f J, F/N %.9f\n", rollcoin::energy(s, p),
                rollcoin::reaction(s, p).ratio);
} catch (const rollcoin::error &e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
