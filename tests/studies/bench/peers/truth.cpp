/* SPDX-License-Identifier: MIT */
/* 1,000 random coins and where they are after 4 natural units of time:
 * Boost.odeint's Fehlberg 7(8) in long double on the textbook's equations, so
 * that neither formula nor code is the library's. */
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace odeint = boost::numeric::odeint;

using real = long double;
using vector = std::array<real, 8>; /* theta phi psi x z wX wY wZ */

static real inner; /* radius, M = a = g = 1 */

static void rates(const vector &y, vector &d, real)
{
    const real IX = (1 + inner * inner) / 4, IZ = 2 * IX;
    const real wX = y[5], wY = y[6], wZ = y[7];
    const real s = std::sin(y[0]), c = std::cos(y[0]), t = s / c;
    const real sph = std::sin(y[1]), cph = std::cos(y[1]);
    d = {wX,
         wY / c,
         wZ + wY * t,
         -wZ * cph + wX * c * sph,
         wZ * sph + wX * c * cph,
         (-(IZ + 1) * wY * wZ - IX * wY * wY * t + s) / (IX + 1),
         wX * wY * t + IZ / IX * wZ * wX,
         wX * wY / (IZ + 1)};
}

/* SplitMix64, uniform in [0, 1). */
static double uniform()
{
    static std::uint64_t state = 20260101;
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Discs, hoops and rings; any lean up to 1.4; rates from 0.1 to 3 or so. */
static vector start()
{
    const double b = uniform();
    const double rate = std::pow(10, -1 + 1.5 * uniform());
    inner = b < 0.3 ? 0 : b > 0.8 ? 1 : b;
    vector y = {1.4 * (2 * uniform() - 1)};
    for (int i = 5; i < 8; ++i)
        y[i] = double(rate * (2 * uniform() - 1));
    return y;
}

int main()
{
    auto stepper = odeint::make_controlled(
        1e-17L, 1e-17L, odeint::runge_kutta_fehlberg78<vector, real>());
    std::puts("b,t,theta,phi,psi,x,z,wX,wY,wZ");
    for (int k = 0; k < 1000; ++k) {
        vector y = start();
        real before = 0;
        for (real t : {0.0L, 4.0L}) {
            odeint::integrate_adaptive(stepper, rates, y, before, t, 1e-3L);
            before = t;
            std::printf("%.17g,%.0Lf", double(inner), t);
            for (real v : y)
                std::printf(",%.20Lg", v);
            std::puts("");
        }
    }
    return 0;
}
