// SPDX-License-Identifier: MIT
// As many calls of one step as the argument says.
#include "rollcoin.hpp"

#include <cstdlib>

int main(int argc, char **argv)
{
    const long n = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0;
    const auto p = rollcoin::disc(0.00567, 0.01213, 9.80665);
    rollcoin::state s{0.3, 0, 0, 0, 0, 0, 5, 40};

    for (long i = 0; i < n; ++i)
        rollcoin::run(s, p, rollcoin::method::rk4, 1e-3, 1);
}
