/* SPDX-License-Identifier: MIT */
/** @file coinf.h
 * librollcoin in single precision, for processors whose doubles are slow.
 *
 * Each coinf_ function here is the coin_ function of that name, with float for
 * double: the same sources, equations, units, statuses, order of arguments and
 * promises.  Only what differs is said here.  "u" is 2^-24 = 6.0e-8, and bounds
 * do not hold below the normal floats, 1.2e-38.
 *
 * STATE. A float holds 7 digits, and a loop of many small steps would lose most
 * of them.  So a state keeps in low what the rounding of its members left out:
 * theta + low[0] is the lean, and so on.  Functions that move a state read and
 * write low.  Functions that only read a state check low, and leave it out.
 * Heading and roll are returned within half a turn of 0.
 *
 * ERROR. Over 20 natural units of time, by coinf_step() with any dt from 1e-3
 * to 2e-2 units, the pose is within 4e-6 radians and radii of the exact motion
 * in each scene of tests/reference that amplifies errors less than 100 times
 * (test_float).
 *
 * RANGES are those of coin.h but for these:
 *   mass, radius, gravity      1e-8 to 1e8 each
 *   I_Z/I_X                    up to 2 (1 + 1e-6)
 *   wX, wY, wZ                 up to 1000 sqrt(g/a) each
 *   phi, psi                   up to 4096 rad
 *   x, z                       up to 1e6 a
 *   without p                  x, z up to 1e14, angular velocities up to 1e11
 *   dt                         up to 1e6 natural units
 *   |q|^2 of a rotation        1e-8 to 1e8
 *
 * METHOD is COIN_RK4, the only one here; any other is COIN_EARG.
 */
#ifndef ROLLCOIN_COINF_H
#define ROLLCOIN_COINF_H

#include <coin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- types -- */

/** A thin axisymmetric body, as coin_params. */
typedef struct coinf_params {
    float mass;        /**< M [M] */
    float radius;      /**< a, of the rim that rolls [L] */
    float gravity;     /**< g [L/T^2] */
    float inertia_X;   /**< I_X = I_Y, about a diameter [M L^2] */
    float inertia_Z;   /**< I_Z, about the axis [M L^2] */
    float thickness;   /**< must be 0 [L] */
    float reserved[2]; /**< must be 0 */
} coinf_params;

/** Where a coin is and how it turns, as coin_state. */
typedef struct coinf_state {
    float theta;  /**< lean, -pi/2 < theta < pi/2 [rad] */
    float phi;    /**< heading, |phi| <= 4096 [rad] */
    float psi;    /**< roll, |psi| <= 4096 [rad] */
    float x;      /**< of the centre [L] */
    float z;      /**< of the centre [L] */
    float wX;     /**< omega_X = d(theta)/dt [1/T] */
    float wY;     /**< omega_Y [1/T] */
    float wZ;     /**< omega_Z [1/T] */
    float low[8]; /**< the rounding errors of the members above, in their
                       order: 0 at the start.  Where you set a member, set its
                       low to 0 */
} coinf_state;

/** The force of the table on the coin, as coin_force. */
typedef struct coinf_force {
    float R[3];     /**< in the table frame x, y, z [M L/T^2] */
    float normal;   /**< N = R_y [M L/T^2] */
    float friction; /**< F = sqrt(R_x^2 + R_z^2) [M L/T^2] */
    float ratio;    /**< F/N [1]; +infinity if N <= 0 */
} coinf_force;

/* ----------------------------------------------------------- parameters -- */

/** As coin_params_disc(). */
COIN_API int32_t coinf_params_disc(coinf_params *p, float mass, float radius,
                                   float gravity);

/** As coin_params_ring(). */
COIN_API int32_t coinf_params_ring(coinf_params *p, float mass, float radius,
                                   float inner_radius, float gravity);

/** As coin_params_body(). */
COIN_API int32_t coinf_params_body(coinf_params *p, float mass, float radius,
                                   float gravity, float inertia_X,
                                   float inertia_Z);

/** As coin_params_check(): RANGES, above. */
COIN_API int32_t coinf_params_check(const coinf_params *p);

/* ---------------------------------------------------------------- state -- */

/** As coin_state_check(): RANGES, above.
 * @return COIN_ESTATE also if low is not finite or
 *         |low[0]| + |low[1]| + |low[2]| > 2^-20. */
COIN_API int32_t coinf_state_check(const coinf_state *s, const coinf_params *p);

/** As coin_state_from_motion(); sets low to 0. */
COIN_API int32_t coinf_state_from_motion(coinf_state *s, const coinf_params *p,
                                         const float q[4], const float omega[3],
                                         float x, float z);

/** As coin_angular_velocity(). */
COIN_API int32_t coinf_angular_velocity(const coinf_state *s, float omega[3]);

/* ------------------------------------------------------------- stepping -- */

/** One step: what a loop at a fixed rate calls each time.
 * @return as coin_step(), but the limits are checked at the last stage instead
 *         of the end of the step, and a step may turn lean and heading by more
 *         than 1.5 rad.
 * Cost: docs/embedding.md.  A quarter of it is the checks, which a call of
 *         coinf_run() makes once for all its steps. */
COIN_API int32_t coinf_step(coinf_state *s, const coinf_params *p, float dt);

/** As coin_run(); COIN_ESTEP also where a rate ends out of range.  A run of n
 * steps is n runs of one step, to the bit. */
COIN_API int32_t coinf_run(coinf_state *s, const coinf_params *p,
                           int32_t method, float dt, uint64_t steps,
                           uint64_t *done);

/* ---------------------------------------------------------- observables -- */

/** As coin_energy(). */
COIN_API float coinf_energy(const coinf_state *s, const coinf_params *p);

/** As coin_integrals(), with logf of libm. */
COIN_API int32_t coinf_integrals(const coinf_state *s, const coinf_params *p,
                                 float K[2]);

/** As coin_reaction(). */
COIN_API int32_t coinf_reaction(const coinf_state *s, const coinf_params *p,
                                coinf_force *out);

/** As coin_rates(); sets low to 0. */
COIN_API int32_t coinf_rates(const coinf_state *s, const coinf_params *p,
                             coinf_state *out);

/** As coin_center(). */
COIN_API int32_t coinf_center(const coinf_state *s, const coinf_params *p,
                              float r[3]);

/** As coin_velocity(). */
COIN_API int32_t coinf_velocity(const coinf_state *s, const coinf_params *p,
                                float v[3]);

/** As coin_contact(). */
COIN_API int32_t coinf_contact(const coinf_state *s, const coinf_params *p,
                               float r[3], float v[3]);

/** As coin_axes(). */
COIN_API int32_t coinf_axes(const coinf_state *s, float R[9]);

/** As coin_quaternion(). */
COIN_API int32_t coinf_quaternion(const coinf_state *s, float q[4]);

/** As coin_matrix(). */
COIN_API int32_t coinf_matrix(const coinf_state *s, const coinf_params *p,
                              float m[16]);

/** As coin_fastest_rate(). */
COIN_API float coinf_fastest_rate(const coinf_state *s, const coinf_params *p);

/* ------------------------------------------------------------- validity -- */

/** As coin_check(). */
COIN_API int32_t coinf_check(const coinf_state *s, const coinf_params *p,
                             int32_t method, float dt, float mu);

/* ------------------------------------------------------------ self-test -- */

/** As coin_selftest(), of the functions of this header alone.
 * Cost: some 20 us on a desktop. */
COIN_API int32_t coinf_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
