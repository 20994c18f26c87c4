// SPDX-License-Identifier: MIT
// coin.h for C++17: errors become exceptions, outputs become results.
//
// Nothing is owned and nothing is hidden: params and state are the plain
// structs of coin.h, which stays the reference.  Whatever is not wrapped here
// is called as it is, with check() around it.
#ifndef ROLLCOIN_HPP
#define ROLLCOIN_HPP

#include <coin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace rollcoin
{

using params = coin_params;
using state = coin_state;
using force = coin_force;
using vec3 = std::array<double, 3>;
using quaternion = std::array<double, 4>; // w, x, y, z

enum class method : std::int32_t {
    rk4 = COIN_RK4,
    rk8 = COIN_RK8,
    symplectic2 = COIN_SYMPLECTIC2,
    symplectic4 = COIN_SYMPLECTIC4
};

// A negative status.  The state is then as before the call; after run() and
// the like it is the last good one.
class error : public std::runtime_error
{
  public:
    explicit error(std::int32_t status)
        : std::runtime_error(coin_status_string(status)), status_(status)
    {
    }
    std::int32_t status() const noexcept
    {
        return status_;
    }

  private:
    std::int32_t status_;
};

// The warning bits of a status, COIN_SLIPS and so on; throws if it is an error.
inline std::int32_t check(std::int32_t status)
{
    if (status < 0)
        throw error(status);
    return status;
}

// Of the functions that return a number, which is NaN on bad input.
inline double check(double number)
{
    if (std::isnan(number))
        throw std::invalid_argument("coin out of range");
    return number;
}

inline params disc(double mass, double radius, double gravity)
{
    params p;
    check(coin_params_disc(&p, mass, radius, gravity));
    return p;
}

inline params ring(double mass, double radius, double inner_radius,
                   double gravity)
{
    params p;
    check(coin_params_ring(&p, mass, radius, inner_radius, gravity));
    return p;
}

// Returns COIN_COARSE or 0; *done says how far it came if it throws.
inline std::int32_t run(state &s, const params &p, method m, double dt,
                        std::uint64_t steps, std::uint64_t *done = nullptr)
{
    return check(
        coin_run(&s, &p, static_cast<std::int32_t>(m), dt, steps, done));
}

inline std::int32_t advance(state &s, const params &p, double t, double tol,
                            double *reached = nullptr)
{
    return check(coin_advance(&s, &p, t, tol, reached));
}

// count states, steps_per_sample steps apart, the start first.
inline std::vector<state> sample(const state &start, const params &p, method m,
                                 double dt, std::uint64_t steps_per_sample,
                                 std::size_t count)
{
    std::vector<state> path(count);
    check(coin_sample(&start, &p, static_cast<std::int32_t>(m), dt,
                      steps_per_sample, count, path.data(), nullptr));
    return path;
}

inline double energy(const state &s, const params &p)
{
    return check(coin_energy(&s, &p));
}

inline force reaction(const state &s, const params &p)
{
    force f;
    check(coin_reaction(&s, &p, &f));
    return f;
}

inline vec3 center(const state &s, const params &p)
{
    vec3 r;
    check(coin_center(&s, &p, r.data()));
    return r;
}

inline vec3 velocity(const state &s, const params &p)
{
    vec3 v;
    check(coin_velocity(&s, &p, v.data()));
    return v;
}

inline quaternion rotation(const state &s)
{
    quaternion q;
    check(coin_quaternion(&s, q.data()));
    return q;
}

// Whether the rolling model and the step hold: 0, or the warning bits.
inline std::int32_t validity(const state &s, const params &p, method m,
                             double dt, double mu)
{
    return check(coin_check(&s, &p, static_cast<std::int32_t>(m), dt, mu));
}

} // namespace rollcoin

#endif
