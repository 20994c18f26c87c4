// SPDX-License-Identifier: MIT
// coin.h for C++17: errors become exceptions, outputs become results.
//
// Nothing is owned and nothing is hidden: params and state are the plain
// structs of coin.h, which stays the reference.  Every function of coin.h is
// here, but those for other languages; those of coinf.h are called as they are,
// with check() around them.
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
using losses = coin_losses;
using table = coin_table;
using body = coin_body;
using orbit = coin_orbit; // 32 KiB
using vec2 = std::array<double, 2>;
using vec3 = std::array<double, 3>;
using quaternion = std::array<double, 4>; // w, x, y, z

enum class method : std::int32_t {
    rk4 = COIN_RK4,
    rk8 = COIN_RK8,
    symplectic2 = COIN_SYMPLECTIC2,
    symplectic4 = COIN_SYMPLECTIC4
};

// How a coin lies: face_of().
enum class face : std::int32_t {
    heads = COIN_HEADS,
    tails = COIN_TAILS,
    edge = COIN_EDGE
};

// A negative status.  The state is then as before the call; after run(),
// advance(), settle(), move() and sample() it is the last good one, and what
// their last argument points to says how far they came.
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

// Of the functions that return a number, which is NaN on bad input: the first
// check that fails says why.
inline double check(double number, std::int32_t why)
{
    if (std::isnan(number))
        throw error(why < 0 ? why : COIN_EDOMAIN);
    return number;
}

// ------------------------------------------------------------------ parameters

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

inline params params_of(double mass, double radius, double gravity,
                        double inertia_X, double inertia_Z)
{
    params p;
    check(coin_params_body(&p, mass, radius, gravity, inertia_X, inertia_Z));
    return p;
}

// For the calls of a body; thickness is 0, or 1e-4 to 4 radii.
inline params cylinder(double mass, double radius, double thickness,
                       double gravity)
{
    params p;
    check(coin_params_cylinder(&p, mass, radius, thickness, gravity));
    return p;
}

inline void check(const params &p)
{
    check(coin_params_check(&p));
}

inline void check(const state &s, const params &p)
{
    check(coin_state_check(&s, &p));
}

inline void check(const losses &l, const params &p)
{
    check(coin_losses_check(&l, &p));
}

// ---------------------------------------------------------------------
// stepping
inline const char *name(method m)
{
    return coin_method_name(static_cast<std::int32_t>(m));
}

inline std::int32_t step(state &s, const params &p, double dt)
{
    return check(coin_step(&s, &p, dt));
}

// Returns COIN_COARSE or 0; *done says how far it came if it throws.
inline std::int32_t run(state &s, const params &p, method m, double dt,
                        std::uint64_t steps, std::uint64_t *done = nullptr)
{
    return check(
        coin_run(&s, &p, static_cast<std::int32_t>(m), dt, steps, done));
}

// What call(time left, &moved) returns.  advance(), settle() and move() call
// again where the steps of one call do not suffice; if t is infinite 100 times
// at most: COIN_MORE then says that more are needed.
template <class Call>
std::int32_t go_on(double t, double *reached, const Call &call)
{
    std::int32_t status;
    double done = 0;
    int calls = 0;
    do {
        double moved = 0;
        status = call(t - done, &moved);
        done += moved;
        ++calls;
    } while (status > 0 && (status & COIN_MORE) != 0 &&
             (t < HUGE_VAL || calls < 100));
    if (reached != nullptr)
        *reached = done;
    return check(status);
}

inline std::int32_t advance(state &s, const params &p, double t, double tol,
                            double *reached = nullptr)
{
    return go_on(t, reached, [&](double left, double *moved) {
        return coin_advance(&s, &p, left, tol, moved);
    });
}

// count states, steps_per_sample steps apart, the start first.
inline void sample(const state &start, const params &p, method m, double dt,
                   std::uint64_t steps_per_sample, std::size_t count,
                   state *out, std::size_t *done = nullptr)
{
    check(coin_sample(&start, &p, static_cast<std::int32_t>(m), dt,
                      steps_per_sample, count, out, done));
}

inline std::vector<state> sample(const state &start, const params &p, method m,
                                 double dt, std::uint64_t steps_per_sample,
                                 std::size_t count)
{
    std::vector<state> path(count);
    sample(start, p, m, dt, steps_per_sample, count, path.data());
    return path;
}

// Each of count coins gets the bits of run(), and in status what it returns;
// throws the error of the first that fails, when all are done.
inline std::int32_t batch_run(state *s, std::size_t count, const params &p,
                              method m, double dt, std::uint64_t steps,
                              std::int32_t *status = nullptr)
{
    return check(coin_batch_run(s, count, &p, static_cast<std::int32_t>(m), dt,
                                steps, status));
}

inline std::int32_t batch_run(std::vector<state> &s, const params &p, method m,
                              double dt, std::uint64_t steps,
                              std::int32_t *status = nullptr)
{
    return batch_run(s.data(), s.size(), p, m, dt, steps, status);
}

// ---------------------------------------------------------- states,
// observables Of a coin that an engine holds as a rotation and an angular
// velocity.
inline state from_motion(const params &p, const quaternion &q,
                         const vec3 &omega, double x, double z)
{
    state s;
    check(coin_state_from_motion(&s, &p, q.data(), omega.data(), x, z));
    return s;
}

inline vec3 angular_velocity(const state &s)
{
    vec3 omega;
    check(coin_angular_velocity(&s, omega.data()));
    return omega;
}

inline double energy(const state &s, const params &p)
{
    double v[3];
    return check(coin_energy(&s, &p), coin_velocity(&s, &p, v));
}

inline double fastest_rate(const state &s, const params &p)
{
    double v[3];
    return check(coin_fastest_rate(&s, &p), coin_velocity(&s, &p, v));
}

inline vec2 integrals(const state &s, const params &p)
{
    vec2 K;
    check(coin_integrals(&s, &p, K.data()));
    return K;
}

inline state rates(const state &s, const params &p)
{
    state d;
    check(coin_rates(&s, &p, &d));
    return d;
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

struct moving_point {
    vec3 place, velocity;
};

inline moving_point contact(const state &s, const params &p)
{
    moving_point c;
    check(coin_contact(&s, &p, c.place.data(), c.velocity.data()));
    return c;
}

// Rows e_X, e_Y, e_Z.
inline std::array<double, 9> axes(const state &s)
{
    std::array<double, 9> R;
    check(coin_axes(&s, R.data()));
    return R;
}

// What a renderer loads, by columns.
inline std::array<double, 16> matrix(const state &s, const params &p)
{
    std::array<double, 16> m;
    check(coin_matrix(&s, &p, m.data()));
    return m;
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

// ---------------------------------------------------------------- steady
// motion
inline state steady_roll(const params &p, double wZ)
{
    state s;
    check(coin_steady_roll(&s, &p, wZ));
    return s;
}

inline state steady_spin(const params &p, double theta)
{
    state s;
    check(coin_steady_spin(&s, &p, theta));
    return s;
}

inline state steady_upright_spin(const params &p, double wY)
{
    state s;
    check(coin_steady_upright_spin(&s, &p, wY));
    return s;
}

inline state steady_circle(const params &p, double theta, double wZ,
                           std::int32_t branch)
{
    state s;
    check(coin_steady_circle(&s, &p, theta, wZ, branch));
    return s;
}

inline state steady_turn(const params &p, double theta, double radius)
{
    state s;
    check(coin_steady_turn(&s, &p, theta, radius));
    return s;
}

inline state steady_ride(const params &p, double speed, double radius)
{
    state s;
    check(coin_steady_ride(&s, &p, speed, radius));
    return s;
}

struct radii {
    double center, contact;
};

inline radii steady_radii(const state &s, const params &p)
{
    radii r;
    check(coin_steady_radii(&s, &p, &r.center, &r.contact));
    return r;
}

// lambda^2.
inline double stability(const state &s, const params &p)
{
    double lambda2;
    check(coin_stability(&s, &p, &lambda2));
    return lambda2;
}

inline double critical_roll(const params &p)
{
    return check(coin_critical_roll(&p), COIN_EPARAMS);
}

inline double critical_spin(const params &p)
{
    return check(coin_critical_spin(&p), COIN_EPARAMS);
}

// -------------------------------------------------------- motion without
// stepping
inline state steady_at(const state &s, const params &p, double t)
{
    state out;
    check(coin_steady_at(&s, &p, t, &out));
    return out;
}

inline void init(orbit &o, const state &s, const params &p)
{
    check(coin_orbit_init(&o, &s, &p));
}

inline state at(const orbit &o, double t)
{
    state out;
    check(coin_orbit_at(&o, t, &out));
    return out;
}

// ------------------------------------------------------------------- real
// coins
inline state losses_rates(const state &s, const params &p, const losses &l)
{
    state d;
    check(coin_losses_rates(&s, &p, &l, &d));
    return d;
}

inline double losses_power(const state &s, const params &p, const losses &l)
{
    const double power = coin_losses_power(&s, &p, &l);
    if (std::isnan(power))
        losses_rates(s, p, l); // which throws
    return power;
}

inline force losses_reaction(const state &s, const params &p, const losses &l)
{
    force f;
    check(coin_losses_reaction(&s, &p, &l, &f));
    return f;
}

// Returns COIN_RESTS if the coin rests, COIN_MORE as go_on() says, else 0.
inline std::int32_t settle(state &s, const params &p, const losses &l, double t,
                           double tol, double *reached = nullptr)
{
    return go_on(t, reached, [&](double left, double *moved) {
        return coin_settle(&s, &p, &l, left, tol, moved);
    });
}

inline double time_to_rest(state s, const params &p, const losses &l,
                           double tol)
{
    const double time = coin_time_to_rest(&s, &p, &l, tol);
    return check(time, coin_settle(&s, &p, &l, 0, tol, nullptr));
}

// All terms but soft and flat times one factor, so that the coin rests after
// time.
inline losses losses_fit(losses l, const state &s, const params &p, double time)
{
    check(coin_losses_fit(&l, &s, &p, time));
    return l;
}

// ------------------------------------------------------------ a real coin
inline void check(const table &f, const params &p)
{
    check(coin_table_check(&f, &p));
}

// A body that rolls.
inline body body_of(const state &s, const params &p)
{
    body b;
    check(coin_body_from_state(&b, &s, &p));
    return b;
}

// A body of an engine, in the air or on the table.
inline body body_of(const params &p, const quaternion &q, const vec3 &omega,
                    const vec3 &r, const vec3 &v)
{
    body b;
    check(coin_body_from_motion(&b, &p, q.data(), omega.data(), r.data(),
                                v.data()));
    return b;
}

// Returns the mode, 0 if it rolls, with the moments of stop that ended it and
// COIN_MORE as go_on() says.
inline std::int32_t move(body &b, const params &p, const table &f, double t,
                         double tol, std::int32_t stop = 0,
                         double *reached = nullptr)
{
    return go_on(t, reached, [&](double left, double *moved) {
        return coin_move(&b, &p, &f, left, tol, stop, moved);
    });
}

inline double energy(const body &b, const params &p)
{
    double v[3];
    return check(coin_body_energy(&b, &p), coin_body_contact(&b, &p, v));
}

inline force reaction(const body &b, const params &p, const table &f)
{
    force out;
    check(coin_body_reaction(&b, &p, &f, &out));
    return out;
}

// The velocity of the lowest point: the slip, and at COIN_TOUCHES the impact.
inline vec3 contact(const body &b, const params &p)
{
    vec3 v;
    check(coin_body_contact(&b, &p, v.data()));
    return v;
}

// A blow: the impulse J at the place r from the centre.
inline void strike(body &b, const params &p, const vec3 &J, const vec3 &r)
{
    check(coin_body_strike(&b, &p, J.data(), r.data()));
}

// Which side is up; after COIN_DECIDED it is how the coin ends.
inline face face_of(const body &b, const params &p)
{
    return static_cast<face>(check(coin_body_face(&b, &p)));
}

// matrix() with the body's own height.
inline std::array<double, 16> matrix(const body &b, const params &p)
{
    std::array<double, 16> m;
    check(coin_body_matrix(&b, &p, m.data()));
    return m;
}

// Throws unless this build computes the pinned bits.
inline void selftest()
{
    check(coin_selftest());
}

} // namespace rollcoin

#endif
