/* SPDX-License-Identifier: MIT */
/** @file coin.h
 * librollcoin: the motion of a coin that rolls without slipping on a table.
 *
 * This header is the whole public API and its reference documentation.
 * Equation numbers, such as Eq. (14), are those of docs/physics.md; make
 * install puts the pages of docs/ into PREFIX/share/doc/rollcoin.
 *
 * FRAMES. Small letters x y z are the table's frame, y up.  Capital letters
 * X Y Z are the coin's frame: origin at the centre, X horizontal in the coin's
 * plane, Y up in its plane, Z along its axis.  theta is the lean (0 = upright,
 * +-pi/2 = flat on the table), phi the heading about the vertical, psi the roll
 * about the axis.  The pose is a rotation by psi about z, then by theta about
 * x, then by phi about y, all about the fixed axes of the table.
 *
 * UNITS. Angles are in radians; everything else is in any consistent set of
 * units.  Dimensions stand in brackets: [M] mass, [L] length, [T] time, [1]
 * none.  A natural unit of time is sqrt(radius/gravity): 35 ms for a US
 * quarter.
 *
 * ARGUMENTS come in one order: the object acted on, the parameters, scalars,
 * then outputs.  Every pointer must be valid and not null, except where a
 * line says "may be null".  An output may be the same object as an input of
 * the same type.  Unless a line says otherwise, p are parameters that
 * coin_params_check() accepts, s is a state that coin_state_check() accepts,
 * l are losses that coin_losses_check() accepts, d and f are a slide and a
 * friction that coin_slide_advance() accepts, out is the result, and method is
 * one of COIN_RK4, COIN_RK8, COIN_SYMPLECTIC2 and COIN_SYMPLECTIC4.
 *
 * STATUS. Most functions return an int32_t: 0 is COIN_OK; a positive value
 * means done; a negative value is an error.  A positive value is a set of
 * warning bits, or COIN_RESTS, or COIN_SLIPS of coin_slide_advance().  After an
 * error every output and the state are unchanged, unless the function says
 * otherwise.  A function that moves a state by many steps may stop before the
 * end, and says where it stopped.  Where several errors apply, the first of
 * COIN_EARG, COIN_EPARAMS, COIN_ESTATE, COIN_ESTEP, COIN_EDOMAIN is returned.
 * Functions that return a double return NaN on bad input.
 * "The usual errors" below are COIN_EARG for a null pointer, COIN_EPARAMS as
 * coin_params_check() and COIN_ESTATE as coin_state_check().  A function
 * without p does not return COIN_EPARAMS, and accepts any finite angular
 * velocity.
 *
 * COST. A textbook step is a step of classical Runge-Kutta for the eight
 * variables that calls the sine of libm in every stage: 1,901 instructions,
 * some 0.12 us.  The next table has the instructions of a call, checks of the
 * arguments included, by gcc -O2 on x86-64 for a US quarter (callgrind):
 *   40-100    coin_params_ functions, coin_critical_roll(), _spin()
 *   130-190   coin_state_check(), coin_losses_check()
 *   220-310   coin_energy(), _center(), _axes(), _check(), coin_slide_energy()
 *   320-440   coin_reaction(), _rates(), _fastest_rate(), _velocity(),
 *             _contact(), _angular_velocity(), _quaternion(),
 *             coin_steady_roll(), _upright_spin(), _radii(), coin_stability(),
 *             coin_slide_of(), coin_slide_velocity()
 *   520-670   coin_matrix(), coin_steady_spin(), _circle(), _at()
 *   780-1,300 coin_losses_power(), _rates(), _reaction()
 *   690-2,200 coin_slide_reaction(): most where a slip begins
 *   1,200     coin_state_from_motion(); 1,600 coin_state_from_landing()
 *   380-6,800 coin_integrals(): 1,800 at a lean of 0.3, most from 0.8 on
 *
 * PROMISES. No allocation, no global state, no output, no errno: every function
 * is reentrant and bounded in time and stack.  What moves a state gives the
 * same bits wherever doubles are those of IEEE 754 (see coin_selftest()).
 *
 * A STATE THAT IS RETURNED means to the next call what the returned status
 * says.  So many short calls move a coin as one long call does.  A call with
 * t = 0 repeats COIN_OK, COIN_SLIPS, COIN_RESTS and COIN_EFLAT.  A call with
 * t = tol natural units repeats COIN_ELIFT, whose moment is located to tol.  A
 * slide that rolls has a slip speed of 0, but for rounding (test_state_out).
 *
 * FLOATING POINT.  No function changes the rounding mode or the traps.  A call
 * raises neither division by zero nor invalid nor overflow, unless it returns
 * COIN_EARG, COIN_EPARAMS, COIN_ESTATE, COIN_ESTEP, COIN_ERANGE or NaN.  So
 * these exceptions may be trapped (test_traps, make fuzz).  This is promised
 * for mass, radius, gravity and moments of inertia from 1e-24 to 1e24, and for
 * rates, velocities and losses that are 0 or from 1e-40 to 1e40 of their
 * natural units, in which M = a = g = 1; in floats for 1e-6 to 1e6 of these
 * (test_float_traps).
 * coin_batch_run() does not promise it if a coin of the batch is refused.
 * Inexact and underflow may be raised.
 * clang keeps this promise only with -ffp-exception-behavior=maytrap, which the
 * Makefile passes: without it clang may evaluate an expression that a branch
 * then discards.
 *
 * ACCURACY. "u" is 2^-53 = 1.1e-16.  "8 u of the terms" bounds an error by 8 u
 * times the sum of the absolute values of the formula's terms.  The bound takes
 * the double theta as exact.  Bounds hold as long as none of the terms, and no
 * product in them, is below the normal doubles (2e-308). */
#ifndef ROLLCOIN_COIN_H
#define ROLLCOIN_COIN_H

#include <stddef.h>
#include <stdint.h>

#define COIN_VERSION_MAJOR 0
#define COIN_VERSION_MINOR 1
#define COIN_VERSION_PATCH 0

/* Define COIN_API (empty, or to your own linkage) before including this file
 * to embed the sources in a program that must not export them. */
#ifndef COIN_API
#if defined(_WIN32) && defined(COIN_BUILD)
#define COIN_API __declspec(dllexport)
#elif defined(__GNUC__)
#define COIN_API __attribute__((visibility("default")))
#else
#define COIN_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- types -- */

/** A thin axisymmetric body.  Fill it by coin_params_disc(), _ring() or
 * _body(); every member may be read, and written at your own risk. */
typedef struct coin_params {
    double mass;        /**< M, > 0 [M] */
    double radius;      /**< a, of the rim that rolls, > 0 [L] */
    double gravity;     /**< g, > 0 [L/T^2] */
    double inertia_X;   /**< I_X = I_Y, about a diameter, > 0 [M L^2] */
    double inertia_Z;   /**< I_Z, about the axis, > 0, <= 2 I_X [M L^2] */
    double reserved[3]; /**< must be 0 */
} coin_params;

/** Where a coin is and how it turns.  The angular velocity is that of the
 * body, resolved along the coin's frame.  The height of the centre is not a
 * member: it is y = radius cos(theta).  Nor is the velocity of the centre:
 * rolling determines it, Eq. (20). */
typedef struct coin_state {
    double theta; /**< lean, -pi/2 < theta < pi/2 [rad] */
    double phi;   /**< heading, |phi| <= 2^31 [rad] */
    double psi;   /**< roll, |psi| <= 2^31 [rad] */
    double x;     /**< of the centre [L] */
    double z;     /**< of the centre [L] */
    double wX;    /**< omega_X = d(theta)/dt [1/T] */
    double wY;    /**< omega_Y [1/T] */
    double wZ;    /**< omega_Z [1/T] */
} coin_state;

/** The force of the table on the coin. */
typedef struct coin_force {
    double R[3];     /**< in the table frame x, y, z [M L/T^2] */
    double normal;   /**< N = R_y; <= 0 means a real coin would lift off */
    double friction; /**< F = sqrt(R_x^2 + R_z^2) */
    double ratio;    /**< F/N, the friction coefficient needed [1]; +infinity
                          if N <= 0 */
} coin_force;

/** The losses that slow a coin and bring it to rest.  Each member but soft is
 * the coefficient of one law of resistance.  The resistances add up; a
 * coefficient of 0 has no effect.  Eq. (64)-(69). */
typedef struct coin_losses {
    double damping; /**< alpha: a torque alpha |d(psi)/dt| times the angular
                         momentum, component by component [1] */
    double dry;     /**< contour friction: a torque against the rolling of the
                         contact along the rim, independent of its rate
                         [M L^2/T^2] */
    double viscous; /**< the same, proportional to that rate [M L^2/T] */
    double layer;   /**< the same, proportional to the power 3/2 of that rate:
                         the boundary layer of the air [M L^2/T^(1/2)] */
    double gap;     /**< the same, proportional to that rate over cos(theta):
                         the air in the gap below the coin [M L^2/T] */
    double rolling; /**< the rolling moment of physics engines: as dry, times
                         cos(theta) [M L^2/T^2] */
    double spin;    /**< pivoting friction: a torque proportional to the turn
                         about the vertical [M L^2/T] */
    double soft;    /**< the rate of roll below which dry and rolling fade
                         [1/T].  0 stands for sqrt(g/a)/1024; a value below
                         2^-30 sqrt(g/a) stands for 2^-30 sqrt(g/a) */
} coin_losses;

/** Coulomb's dry friction between coin and table. */
typedef struct coin_friction {
    double mu_static;  /**< the largest friction of a contact that does not
                            slip, over N; >= mu_kinetic, may be +infinity [1] */
    double mu_kinetic; /**< the friction of a contact that slips, over N; from
                            0 to the bound of Painleve, Eq. (86) [1] */
} coin_friction;

/** A coin that may slip. */
typedef struct coin_slide {
    coin_state s; /**< where it is and how it turns */
    double vx;    /**< velocity of the centre along x and z [L/T] */
    double vz;
} coin_slide;

/** A motion that coin_orbit_init() solves once, so that coin_orbit_at() gives
 * its state at any time.  It holds half a period of theta, in pieces that are
 * polynomials of time: 32 KiB.  It has no pointers, so that it may be copied,
 * stored, and shared between threads and processes.  Only the library that made
 * it can read it: a library of another version, or on a machine of another byte
 * order, returns COIN_EARG for it. */
typedef struct coin_orbit {
    double period;             /**< of theta; 0 if the motion is steady [T] */
    double heading_per_period; /**< what phi gains in it [rad] */
    double roll_per_period;    /**< what psi gains in it [rad] */
    double theta_min;          /**< the turning points of the lean [rad] */
    double theta_max;
    double center[2];  /**< x, z of the centre of the annulus that the path
                            of the centre of mass fills; NaN if it drifts
                            [L] */
    double radius_min; /**< of the annulus; NaN if it drifts [L] */
    double radius_max;
    double drift[2];          /**< x, z of the displacement per period, if
                                   heading_per_period is a multiple of 2 pi to
                                   rounding, and else 0 [L] */
    double conditioning;      /**< how much a period amplifies rounding, >= 1:
                                   1 + (J/2) |dT/dE| s^2/w.  Here T is the
                                   period and w^2 = 2 E/J; s is the larger
                                   |d(wX)/dt| of the two turning points, at
                                   most w^2 [1] */
    double reserved[26];      /**< 0: for members of later versions */
    double private_frame[32]; /**< from here on for the library only */
    double private_edges[48];
    double private_centers[42];
    double private_terms[3780];
    double private_spare[156]; /**< 0 */
} coin_orbit;

/** Status: 0, or negative = error.  Numbers never change meaning. */
enum {
    COIN_OK = 0,       /**< done */
    COIN_EPARAMS = -1, /**< parameters out of range: coin_params_check();
                            or losses or friction out of range */
    COIN_ESTATE = -2,  /**< state out of range: coin_state_check() */
    COIN_ESTEP = -3,   /**< a step or a time that is not finite, negative
                            where losses or slips forbid that, or too long.  A
                            step is too long if |dt| W is beyond the method's
                            limit, if the step would cross the table, or if it
                            turns lean or heading by more than 1.5 rad: shorten
                            dt, or call coin_advance().  A time is too long if
                            the steps of one call do not suffice: call again,
                            or ask for less.  A time of a closed form is too
                            long if phi, psi, x or z would leave its range */
    COIN_EARG = -4,    /**< null pointer, unknown method, branch or bit, bad
                            tolerance, mu of a check < 0 */
    COIN_EDOMAIN = -5, /**< no such steady motion; or the state is not steady;
                            or its motion has no well-defined period */
    COIN_EFLAT = -6,   /**< the coin falls flat within the time asked */
    COIN_EBUILD = -7,  /**< this build does not give the pinned bits:
                            coin_selftest() */
    COIN_ELIFT = -8,   /**< a coin that may slip lifts off the table within the
                            time asked */
    COIN_ERANGE = -9   /**< no step leads on from the state reached, and |phi|
                            or |psi| is within 16 rad of 2^31, the end of its
                            range: subtract whole turns */
};

/** Status: positive = done, with these warning bits. */
enum {
    COIN_SLIPS = 1,      /**< N > 0 and F > mu N: a real coin slips */
    COIN_LIFTS = 2,      /**< N <= 0: a real coin lifts off */
    COIN_COARSE = 4,     /**< |dt| W is beyond the method's limit of full
                              accuracy: 0.35 for COIN_RK4, 1 for COIN_RK8, 0.08
                              and 0.16 for the symplectic methods.  W, Eq. (47),
                              is sqrt((wX^2 + wY^2)/cos^2 theta + wZ^2 +
                              g/(a cos theta)) */
    COIN_NEARLY_FLAT = 8 /**< cos(theta) < 0.01 */
};

/** Status: positive, and no warning: never combined with the bits above. */
enum {
    COIN_RESTS = 16 /**< done: the coin lies flat */
};

/** Methods of integration. */
enum {
    COIN_RK4 = 0,         /**< classical Runge-Kutta, order 4 */
    COIN_RK8 = 1,         /**< Dormand-Prince, 12 stages, order 8 */
    COIN_SYMPLECTIC2 = 2, /**< kick-drift-kick with the exact drift, order 2 */
    COIN_SYMPLECTIC4 = 3  /**< Chin 4A with the exact drift, order 4 */
};

/* ----------------------------------------------------------- parameters -- */

/** A uniform thin disc: I_X = M a^2/4, I_Z = M a^2/2.  Eq. (29).
 * @param[out] p   the parameters, reserved members 0
 * @param mass     M, > 0 [M]
 * @param radius   a, > 0 [L]
 * @param gravity  g, > 0 [L/T^2]
 * @return COIN_OK; COIN_EARG null p; COIN_EPARAMS as coin_params_check().
 * Accuracy: 4 u in I_X and I_Z (make adversary); the rest is as given. */
COIN_API int32_t coin_params_disc(coin_params *p, double mass, double radius,
                                  double gravity);

/** A thin ring: I_X = M (a^2 + b^2)/4, I_Z = 2 I_X.  Eq. (29).
 * @param[out] p        the parameters, reserved members 0
 * @param mass,radius   M and a, as coin_params_disc() [M] [L]
 * @param inner_radius  b, 0 (a disc) to radius (a hoop) inclusive [L]
 * @param gravity       g, > 0 [L/T^2]
 * @return as coin_params_disc(); COIN_EPARAMS also if b is out of range.
 * Accuracy: 4 u in I_X and I_Z (make adversary); the rest is as given. */
COIN_API int32_t coin_params_ring(coin_params *p, double mass, double radius,
                                  double inner_radius, double gravity);

/** Any thin axisymmetric body.
 * @param[out] p     the parameters, reserved members 0
 * @param mass,radius,gravity  as coin_params_disc() [M] [L] [L/T^2]
 * @param inertia_X  I_X about a diameter, > 0 [M L^2]
 * @param inertia_Z  I_Z about the axis, > 0 and <= 2 I_X [M L^2]
 * @return as coin_params_disc().
 * Accuracy: the members are the arguments, unrounded. */
COIN_API int32_t coin_params_body(coin_params *p, double mass, double radius,
                                  double gravity, double inertia_X,
                                  double inertia_Z);

/** Whether the parameters can be computed with.
 * @param p  any parameters
 * @return COIN_OK; COIN_EARG null; COIN_EPARAMS if a member is not finite or
 *         not positive, a reserved member is not 0, I_Z exceeds 2 I_X by more
 *         than a relative 1e-12 (no rigid body has I_Z > 2 I_X), or one of the
 *         following numbers, in the units of p, is below 1e-300, or their sum
 *         is above 1e300: M, a, g, I_X, I_Z, M a, M g, M a^2, M g a, g/a;
 *         J = I_X + M a^2 and K = I_Z + M a^2; the ratios I_Z/I_X, M a^2/K,
 *         I_X/J, K/J, M g a/J; the square of coin_critical_roll(). */
COIN_API int32_t coin_params_check(const coin_params *p);

/* ---------------------------------------------------------------- state -- */

/** Whether a state can be computed with.
 * @param s  any state
 * @return COIN_OK; COIN_EARG null; COIN_EPARAMS; COIN_ESTATE if a member is
 *         not finite, |theta| >= pi/2, |phi| or |psi| > 2^31 (the rounding of
 *         a larger angle is a visible turn), or the angular velocity is so
 *         large that energies or forces would overflow. */
COIN_API int32_t coin_state_check(const coin_state *s, const coin_params *p);

/** The state of a coin that an engine holds as a rotation and an angular
 * velocity.  Eq. (7), (30).
 * @param[out] s  the state; -pi < phi, psi <= pi
 * @param q       [4] w, x, y, z: rotation body to table, any norm [1]
 * @param omega   [3] angular velocity in the table frame [1/T]
 * @param x,z     the centre of mass [L]
 * @return COIN_OK; the usual errors: COIN_ESTATE if q, omega, x or z is not
 *         finite, q is 0, the coin lies flat, or omega is so large that
 *         energies or forces would overflow.
 * Accuracy: 8 u in each angle for a unit q; near flat each of phi and psi is
 *         uncertain by u/cos(theta), but their sum or difference is not
 *         (test_state). */
COIN_API int32_t coin_state_from_motion(coin_state *s, const coin_params *p,
                                        const double q[4],
                                        const double omega[3], double x,
                                        double z);

/** The angular velocity in the table frame.  Eq. (7).
 * @param[out] omega  [3] along x, y, z [1/T]
 * @return COIN_OK; COIN_EARG; COIN_ESTATE as the usual errors, and if a
 *         component would overflow.
 * Accuracy: 8 u of the terms (test_pose). */
COIN_API int32_t coin_angular_velocity(const coin_state *s, double omega[3]);

/* ------------------------------------------------------------- stepping -- */

/** One classical Runge-Kutta step of order 4: coin_run(s, p, COIN_RK4, dt, 1,
 * null), with the same bits.  Eq. (14)-(20).
 *
 * A US quarter, leaning 0.3 rad, for one second:
 * @code
 * coin_params p;
 * coin_state s = {0.3, 0, 0, 0, 0, 0, 5, 40};
 * coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
 * for (int i = 0; i < 1000; ++i)
 *     if (coin_step(&s, &p, 1e-3) < 0)
 *         return 1;
 * @endcode
 * @param[in,out] s  the state
 * @param dt         the step, any finite value; < 0 runs backward [T]
 * @return as coin_run(): COIN_OK, COIN_COARSE, or an error, after which *s is
 *         unchanged.
 * Accuracy: that of a step of COIN_RK4 by coin_run().
 * Cost: 1,005 instructions, where a further step of coin_run() takes 581, a
 *         textbook step 1,901 (COST, above).  Most of the 432 between check
 *         the arguments and compute sines and cosines, which coin_run() does
 *         once for many steps.  It needs at most 800 bytes of stack on a
 *         Cortex-M4F (make firmware). */
COIN_API int32_t coin_step(coin_state *s, const coin_params *p, double dt);

/** Moves a coin by a number of fixed steps.
 * @param[in,out] s   the state
 * @param method      COIN_RK4, ...: coin_method_name()
 * @param dt          the step, any finite value; < 0 runs backward [T]
 * @param steps       how many; 0 changes nothing
 * @param[out] done   how many were done; may be null
 * @return COIN_OK; COIN_COARSE: all done, but a step began or ended with
 *         |dt| W beyond the method's limit of full accuracy; the usual errors
 *         and COIN_EARG for an unknown method, with *done untouched;
 *         COIN_ESTEP if dt is not finite (*done untouched), or if a step is
 *         refused: s is then the state after the *done steps before it.
 *         COIN_ERANGE: the same, where phi or psi is at the end of its range.
 * A step is refused if |dt| W is beyond 1.2 (COIN_SYMPLECTIC2: 1,
 * COIN_SYMPLECTIC4: 1.4) where it begins or ends; if it would lead through the
 * table or out of the range of coin_state_check(); or if it turns lean or
 * heading by more than 1.5 rad.  The symplectic methods also refuse a coarse
 * step if its drift is beyond the reach of the series of Eq. (34).
 *
 * In a step the method integrates theta, phi and psi from their rates.
 *
 * A run of n steps equals n runs of one step but for rounding.  So a caller may
 * divide a long run into several calls, and stop between them.  Each further
 * call changes the result by at most 8 u/cos(theta) in radians, radii and
 * natural units of rate, and by 8 u of phi, psi, x and z.  This is before the
 * motion's own amplification.  It holds for steps that are not coarse, with
 * COIN_RK4 for |dt| W up to 0.2 (test_cuts).
 * coin_sample() reports states on the way and keeps the bits of one
 * uninterrupted run.
 * Accuracy: a step adds at most 0.1 (|dt| W)^5 radians and radii by COIN_RK4,
 *         2e-4 (|dt| W)^9 by COIN_RK8, 0.6 (|dt| W)^3 by COIN_SYMPLECTIC2 and
 *         0.04 (|dt| W)^5 by COIN_SYMPLECTIC4, and as much, relative to W, in
 *         the rates.  This is before the motion's own amplification, and for
 *         bodies whose mass lies within the rim: I_X <= M a^2/2.  Rounding adds
 *         4 u a step, 4 u/cos(theta) by the symplectic methods, and at the end
 *         16 u of the pose (docs/limits.md).  As a rule errors are far smaller
 *         (docs/guide.md).
 * Cost: per call the checks and four sines and cosines; per 64 steps as many
 *         sines and cosines again; the symplectic methods take two more for
 *         each drift.  A step has no loop whose length depends on data, and no
 *         branch but the check of its limits. */
COIN_API int32_t coin_run(coin_state *s, const coin_params *p, int32_t method,
                          double dt, uint64_t steps, uint64_t *done);

/** A trajectory in one call: out[k] is the state after k * steps_per_sample
 * steps, out[0] = *start.  The samples lie on one uninterrupted run: out[k]
 * has the bits of one coin_run() from *start, however often it is sampled.
 * @param start             where to begin; may be an element of out
 * @param dt                the step, as coin_run() [T]
 * @param steps_per_sample  steps between two samples
 * @param count             how many samples out holds; 0 changes nothing
 * @param[out] out          [count] states
 * @param[out] done         how many samples were written; may be null
 * @return as coin_run(); if a step is refused, out[0 .. *done-1] hold the
 *         samples before it, and the rest are untouched.
 * Cost: that of coin_run(); 300 instructions more for each sample. */
COIN_API int32_t coin_sample(const coin_state *start, const coin_params *p,
                             int32_t method, double dt,
                             uint64_t steps_per_sample, size_t count,
                             coin_state *out, size_t *done);

/** coin_run() for many coins of one body, side by side in the processor's
 * vectors.  Each coin gets the bits that coin_run() gives it.
 * @param[in,out] s    [count] states
 * @param count        how many; 0 is OK
 * @param method       any; COIN_RK4 and COIN_RK8 use vectors
 * @param dt,steps     the step [T] and how many, as coin_run()
 * @param[out] status  [count] what coin_run() returns for each; may be null
 * @return COIN_EARG, COIN_EPARAMS: nothing was touched.  Else the status of the
 *         first coin that failed, or all warnings together.  A coin that failed
 *         is where its last good step left it, and the others go on.
 * Cost: docs/accuracy.md.  A coin that comes near flat, or whose steps are
 *         coarse, goes on by itself from there, at the cost of coin_run().
 *         Coins that are alike gain most. */
COIN_API int32_t coin_batch_run(coin_state *s, size_t count,
                                const coin_params *p, int32_t method, double dt,
                                uint64_t steps, int32_t *status);

/** Moves a coin by any time to a stated accuracy, however near to flat it
 * passes.  The steps are of order 14, by extrapolation, in Sundman's time,
 * Eq. (32), and their length is chosen by an estimate of their error.  The last
 * step is in t, Eq. (54).
 * @param[in,out] s  the state
 * @param t          the time, of either sign [T]
 * @param tol        1e-13 to 1e-2: the error that the steps may add per natural
 *                   unit of time, in radians and radii, before the motion's
 *                   own amplification [1]
 * @param[out] reached  the time moved: t, if no error is returned; may be null
 * @return COIN_OK; the usual errors; COIN_EARG also for tol out of range.
 *         COIN_ESTEP: t is not finite or is above 1e15 natural units, and s and
 *         *reached are untouched; or x or z overflows, s is untouched and
 *         *reached is 0; or 2^20 steps were not enough, s is the state at
 *         *reached, and another call goes on from there.  COIN_ERANGE: phi or
 *         psi would leave its range, and s is the state at *reached.
 *         COIN_EFLAT: the coin falls flat, nearer than 1e-30 rad.  s is then
 *         the last state before the impact that a double can hold, and *reached
 *         the time of the impact.  A coin at rest, as coin_settle() leaves it,
 *         counts as fallen: for t >= 0 *reached is 0.
 * Accuracy: within 2 tol (1 + n), with n as for coin_settle() (docs/limits.md);
 *         below tol per unit for 99 of 100 random coins over 4 units, at each
 *         tolerance (docs/accuracy.md).  Rounding adds about
 *         1e-15 per unit.  Near flat the double theta cannot hold cos(theta)
 *         exactly: a call that begins at a distance d from flat has a relative
 *         error of u/d in it.  Within a call no such error arises.
 * Cost: proportional to |t|, and to 1/tol^(1/14).  A step costs 1.3 times one
 *         of COIN_RK8.  A pass at a distance d from flat adds the cost of
 *         ln(1/d) natural units.  Low bounces near flat contain many such
 *         passes.
 *         A coin that turns fast needs about one step per radian.  A call takes
 *         at most 2^20 steps, some 0.2 s: as a rule enough for 160,000 natural
 *         units at the smallest tol. */
COIN_API int32_t coin_advance(coin_state *s, const coin_params *p, double t,
                              double tol, double *reached);

/** A method's name, "rk4" for COIN_RK4; null if there is no such method. */
COIN_API const char *coin_method_name(int32_t method);

/* ---------------------------------------------------------- observables -- */

/** The energy [M L^2/T^2], constant along every motion.  Eq. (23).
 * @return E, which is 0 at rest with the centre at the table's height; NaN on
 *         the usual errors.
 * Accuracy: 8 u of E (test_energy). */
COIN_API double coin_energy(const coin_state *s, const coin_params *p);

/** The two linear integrals, constant along every motion: the values of wY and
 * wZ that their linear equations give at theta = 0.  Eq. (35), after Eq. (38)
 * near flat.
 * @param[out] K  [2] K_Y, K_Z [1/T]
 * @return COIN_OK; the usual errors.
 * Accuracy: 16 u of the terms of Eq. (35) at every |theta| < pi/2
 * (test_integrals).  Near flat the terms grow as ln(1/cos theta).  Uses log of
 * libm for |sin theta| > 0.7: the last bit may differ between platforms. */
COIN_API int32_t coin_integrals(const coin_state *s, const coin_params *p,
                                double K[2]);

/** The force of the table on the coin.  Eq. (25)-(28).  The rolling model holds
 * the coin to the table, so that N may be negative: see COIN_LIFTS.
 * @return COIN_OK; the usual errors.
 * Accuracy: 14 u of the terms (make adversary). */
COIN_API int32_t coin_reaction(const coin_state *s, const coin_params *p,
                               coin_force *out);

/** The rates of change of every member.  Eq. (14)-(20).
 * @param[out] out  d/dt of theta, phi, ... in the member of that name; it is
 *                  not a state
 * @return COIN_OK; the usual errors.
 * Accuracy: 12 u of the terms (test_motion). */
COIN_API int32_t coin_rates(const coin_state *s, const coin_params *p,
                            coin_state *out);

/** The centre of mass.
 * @param[out] r  [3] x, y, z; y = radius cos(theta) [L]
 * @return COIN_OK; the usual errors.  Accuracy: 4 u (test_pose). */
COIN_API int32_t coin_center(const coin_state *s, const coin_params *p,
                             double r[3]);

/** The velocity of the centre of mass.  Eq. (20).
 * @param[out] v  [3] along x, y, z [L/T]
 * @return COIN_OK; the usual errors.  Accuracy: 8 u of the terms (test_pose).
 */
COIN_API int32_t coin_velocity(const coin_state *s, const coin_params *p,
                               double v[3]);

/** The point of contact, and how fast it moves along the table (the geometric
 * point: the coin's own material there is at rest).  Eq. (21), (22).
 * @param[out] r  [3] the point, y = 0 [L]
 * @param[out] v  [3] its velocity, y = 0 [L/T]
 * @return COIN_OK; the usual errors.  Accuracy: 8 u of the terms (test_pose).
 */
COIN_API int32_t coin_contact(const coin_state *s, const coin_params *p,
                              double r[3], double v[3]);

/** The coin's frame.  Eq. (7).
 * @param[out] R  [9] rows e_X, e_Y, e_Z, each along x, y, z [1]
 * @return COIN_OK; COIN_EARG; COIN_ESTATE.  Accuracy: 4 u (test_pose). */
COIN_API int32_t coin_axes(const coin_state *s, double R[9]);

/** The rotation of the body, the roll included.  Eq. (30).
 * @param[out] q  [4] w, x, y, z, unit norm, body to table; continuous in the
 *                angles, so q and -q both occur
 * @return COIN_OK; COIN_EARG; COIN_ESTATE.  Accuracy: 4 u (test_pose). */
COIN_API int32_t coin_quaternion(const coin_state *s, double q[4]);

/** How fast the coin turns and falls now: the W of Eq. (47),
 * sqrt((wX^2 + wY^2)/cos^2 theta + wZ^2 + gravity/(radius cos theta)).  The
 * error of a step of dt depends on |dt| W: COIN_COARSE, and the tables of
 * docs/guide.md.  It is of this state only.  Near flat it grows within one
 * swing, so take it each frame, or use coin_advance().
 * @return W [1/T]; NaN on the usual errors.
 * Accuracy: 8 u (make adversary).
 * Cost: in the table above. */
COIN_API double coin_fastest_rate(const coin_state *s, const coin_params *p);

/* ------------------------------------------------------------- validity -- */

/** Whether the rolling model holds for this state, and whether a step is fine
 * enough for it.  docs/guide.md says what to do about each bit.
 * @param dt  the step in question, any finite value [T]
 * @param mu  the friction coefficient, >= 0, may be +infinity [1]
 * @return COIN_OK, or the bits COIN_SLIPS, COIN_LIFTS, COIN_COARSE,
 *         COIN_NEARLY_FLAT; COIN_EARG also for an unknown method and mu < 0 or
 *         NaN; the usual errors; COIN_ESTEP dt not finite.
 * Accuracy: a bit may be wrong where the state is nearer to its threshold than
 *         8 u of the terms of that threshold (make adversary).
 * Cost: 0.8 of that of coin_reaction(). */
COIN_API int32_t coin_check(const coin_state *s, const coin_params *p,
                            int32_t method, double dt, double mu);

/* ---------------------------------------------------- games and engines -- */

/** The pose as one matrix, as a renderer loads it: body to table, the roll
 * included.  Eq. (90).
 * @param[out] m  [16] by columns, as OpenGL, Vulkan and three.js have them: the
 *                body's three axes and its centre of mass, each with x, y, z
 *                of the table and then 0, 0, 0, 1.  Element (row, column) is
 *                m[4 * column + row] [1], the centre [L]
 * @return COIN_OK; the usual errors.
 * Accuracy: 8 u in the axes, 4 u in the centre's y; its x and z are those of
 * the state (test_matrix). */
COIN_API int32_t coin_matrix(const coin_state *s, const coin_params *p,
                             double m[16]);

/** coin_advance() that stops at the first moment from which a real coin would
 * slip or lift off, or at which it is nearly flat.  The forces at the ends of a
 * step and their derivatives bound the forces between, Eq. (92), so that brief
 * excursions within a step are found as well.
 * @param[in,out] s  the state
 * @param t          the time, of either sign [T]
 * @param tol        1e-13 to 1e-2: as for coin_advance(), but the steps are
 *                   never longer than those of 1e-6.  It is also the accuracy
 *                   of the event: a state that is tol natural units of time
 *                   earlier has none of the warnings [1]
 * @param mu         the friction coefficient, >= 0, may be +infinity [1]
 * @param bits       COIN_SLIPS, COIN_LIFTS, COIN_NEARLY_FLAT, or several,
 *                   or-ed.  COIN_SLIPS alone does not stop where N <= 0
 * @param[out] reached  the time moved; may be null
 * @return COIN_OK: none of these warnings held within t, *reached is t, and s
 *         is, digit for digit, what coin_advance() gives with tol, or with 1e-6
 *         if that is less.  Positive: those of the bits that hold in s, as
 *         coin_check() returns them; *reached is the first moment at which one
 *         of them was found to hold.  A bit that holds at the start is returned
 *         at once, with *reached = 0.  COIN_EARG also if mu is negative or NaN,
 *         or if bits is 0 or has any other bit; other errors and COIN_EFLAT as
 *         coin_advance().
 * Accuracy: in the computed motion no excursion is missed in which F/N exceeds
 *         mu by 1e-6 of mu or more, for mu >= 1e-6 (test_until).
 * Cost: 1.5 to 2.2 times that of coin_advance(), up to 3.4 times where F/N
 *         comes within 1e-4 of mu, and more where cos(theta) stays near its
 *         bound; 0.2 us more in calls of a step or less.  A tol above 1e-6
 *         costs as much as 1e-6.  An event costs as much as ten to forty steps.
 *         The call needs some 10 KiB of stack. */
COIN_API int32_t coin_advance_until(coin_state *s, const coin_params *p,
                                    double t, double tol, double mu,
                                    int32_t bits, double *reached);

/** The rolling motion of a coin that an engine has dropped on the table.  The
 * impact neither slips nor bounces, so that it keeps the angular momentum about
 * the point of contact.  Eq. (91).  A coin that rolls already stays as it is.
 * @param[out] s  the state; -pi < phi, psi <= pi
 * @param q       [4] w, x, y, z: rotation body to table, any norm [1]
 * @param omega   [3] angular velocity in the table frame before the impact
 *                [1/T]
 * @param v       [3] velocity of the centre of mass before the impact.  It may
 *                point away from the table: the angular momentum is kept then
 *                too [L/T]
 * @param x,z     the centre of mass [L]
 * @return COIN_OK; the usual errors: COIN_ESTATE as coin_state_from_motion(),
 *         and if v is not finite or the rates would overflow.
 * Accuracy: that of coin_state_from_motion() in the angles; 16 u of the terms
 *         in the rates, with the computed angles taken as exact
 *         (test_landing). */
COIN_API int32_t coin_state_from_landing(coin_state *s, const coin_params *p,
                                         const double q[4],
                                         const double omega[3],
                                         const double v[3], double x, double z);

/* -------------------------------------------------------- steady motion -- */

/** Straight rolling, upright: theta = wX = wY = 0.
 * @param[out] s  all 8 members, the pose 0
 * @param wZ      the speed is radius |wZ|, along -x for wZ > 0 [1/T]
 * @return COIN_OK; COIN_EARG; COIN_EPARAMS; COIN_ESTATE if wZ is not finite, or
 *         so large that energies or forces would overflow.
 * Accuracy: wZ is as given, and all else is 0. */
COIN_API int32_t coin_steady_roll(coin_state *s, const coin_params *p,
                                  double wZ);

/** Spinning with the centre at rest, leaning: wX = wZ = 0, wY > 0.  Needs no
 * friction.  Eq. (42).
 * @param theta  the lean, |theta| < pi/2 [rad]
 * @return as coin_steady_roll(); COIN_ESTATE if theta is out of range, or wY
 *         would be.
 * Accuracy: 8 u in wY (make adversary). */
COIN_API int32_t coin_steady_spin(coin_state *s, const coin_params *p,
                                  double theta);

/** Spinning upright about a diameter: theta = wX = wZ = 0.
 * @param wY  any finite rate [1/T]
 * @return as coin_steady_roll(), with wY for wZ.
 * Accuracy: wY is as given, and all else is 0. */
COIN_API int32_t coin_steady_upright_spin(coin_state *s, const coin_params *p,
                                          double wY);

/** Rolling along a circle at a constant lean.  Eq. (40), computed as Eq. (41)
 * without cancellation.
 * @param theta   the lean, 0 < |theta| < pi/2 [rad]
 * @param wZ      any finite rate [1/T]
 * @param branch  +1 or -1: the root f+ or f- of Eq. (40); the slow precession
 *                (a large circle for small theta) is the root with
 *                wY wZ theta > 0: branch +1 for wZ > 0, -1 for wZ < 0
 * @return as coin_steady_roll(); COIN_EARG other branch; COIN_ESTATE also if wY
 *         would overflow; COIN_EDOMAIN theta = 0, or wY too small for a double.
 * Accuracy: 8 u in wY (test_steady). */
COIN_API int32_t coin_steady_circle(coin_state *s, const coin_params *p,
                                    double theta, double wZ, int32_t branch);

/** The circle of a given size at a given lean, as people state the problem: the
 * one with wY > 0 and wY wZ theta >= 0, which exists for every lean but 0.
 * Eq. (93).
 * @param theta   the lean, 0 < |theta| < pi/2 [rad]
 * @param radius  of the centre's circle, >= 0; 0 is coin_steady_spin() [L]
 * @return as coin_steady_roll(); COIN_EARG also radius < 0 or NaN; COIN_ESTATE
 *         theta out of range, or wY or wZ would be; COIN_EDOMAIN theta = 0,
 *         radius above 1e300 as a length or in radii a, or wY too small for a
 *         double.
 * Accuracy: 8 u in wY and wZ (test_steady_turn).
 * Cost: 480 instructions. */
COIN_API int32_t coin_steady_turn(coin_state *s, const coin_params *p,
                                  double theta, double radius);

/** The lean that a coin needs to ride round a circle at a given speed: the same
 * choice, with 0 < theta < pi/2, of which there is just one.  Eq. (93), (94).
 * @param speed   of the centre, > 0 [L/T]
 * @param radius  of the centre's circle, > 0 [L]
 * @return as coin_steady_turn(); COIN_EARG also speed <= 0, radius = 0 or NaN;
 *         COIN_ESTATE also if wZ = speed/a would be out of range; COIN_EDOMAIN
 *         also if tan(theta) would be above 1e7.
 * Accuracy: 16 u in the radius, 16 u + u/cos(theta) in the speed, and the lean
 *         as these determine it (test_steady_turn).
 * Cost: some 1,060 instructions. */
COIN_API int32_t coin_steady_ride(coin_state *s, const coin_params *p,
                                  double speed, double radius);

/** The circles that the centre and the contact point of a steady motion
 * follow.  Eq. (43).
 * @param[out] center   R_G, of the centre of mass; +infinity if wY = 0, or if
 *                      R_G is above 1e307, as a length or in radii a [L]
 * @param[out] contact  R_C, of the contact point; likewise [L]
 * @return COIN_OK; the usual errors; COIN_EDOMAIN if the state is not steady:
 *         |wX| above 1e-9 of the largest of |wY|, |wZ|, sqrt(g/a), or the two
 *         sides of Eq. (39) apart by more than 1e-9 of the largest of its
 *         terms and M g a.
 * Accuracy: 8 u of the terms (make adversary). */
COIN_API int32_t coin_steady_radii(const coin_state *s, const coin_params *p,
                                   double *center, double *contact);

/** Linear stability of a steady motion.  Eq. (44).
 * @param[out] lambda2  lambda^2 [1/T^2]: > 0, a small lean away from it grows
 *                      as exp(sqrt(lambda^2) t); < 0, it oscillates with the
 *                      period 2 pi/sqrt(-lambda^2); 0, critical (and stable in
 *                      fact: docs/physics.md)
 * @return as coin_steady_radii().
 * Accuracy: 16 u of the terms (test_stability). */
COIN_API int32_t coin_stability(const coin_state *s, const coin_params *p,
                                double *lambda2);

/** The rate |wZ| above which straight rolling is stable: sqrt(g/(3 a)) for a
 * disc.  Eq. (45).  @return the rate [1/T]; NaN on bad parameters.
 * Accuracy: 8 u (make adversary). */
COIN_API double coin_critical_roll(const coin_params *p);

/** The rate |wY| above which upright spinning is stable: sqrt(4 g/(5 a)) for a
 * disc.  Eq. (46).  @return the rate [1/T]; NaN on bad parameters.
 * Accuracy: 8 u (make adversary). */
COIN_API double coin_critical_spin(const coin_params *p);

/* ---------------------------------------------- motion without stepping -- */

/** A steady motion at any time, in closed form: nothing is stepped.  Eq. (56).
 * @param s         a steady state.  It may violate (39) by up to 1e-9; the
 *                  effect of that on the motion is left out, and wX of *out
 *                  is 0
 * @param t         the time, of either sign [T]
 * @param[out] out  the state at t
 * @return COIN_OK; the usual errors; COIN_ESTEP t not finite, or phi, psi, x
 *         or z leaves its range; COIN_EDOMAIN as coin_steady_radii().
 * Accuracy: 6 u of the angles turned, and 6 u of the path, plus the rounding of
 *         phi, psi, x and z to doubles (test_steady_at).
 * Cost: three sines and cosines. */
COIN_API int32_t coin_steady_at(const coin_state *s, const coin_params *p,
                                double t, coin_state *out);

/** Solves a motion for all times: half a period of theta, between its turning
 * points, by power series.  The rest follows by symmetry about the turning
 * points and by the period.  Eq. (55), (57).
 * @param[out] o  the orbit
 * @return COIN_OK; the usual errors; COIN_EDOMAIN if the motion has no
 *         well-defined period: it is an unstable steady motion that is not
 *         exactly upright; or it is so close to a separatrix that conditioning
 *         is 1e12 or more; or the pieces of an orbit do not suffice, since it
 *         comes too close to flat, or takes too long from one turning point to
 *         the next.  The latter is so next to critical motions, and for bodies
 *         whose I_Z is far below I_X.  Of random motions of rings that stay at
 *         least 1e-6 rad from flat, fewer than 1 in 100 are refused; more are
 *         refused of those that start about 1e-6 rad from flat and come as
 *         close on the other side.  All motions that come closer than 1e-9 rad
 *         are refused.
 * A stable steady motion is an orbit too, of period 0.  An unstable one is an
 * orbit only if it is exactly upright: rounding would take any other away from
 * the steady motion.
 * Accuracy: period, heading and roll per period to 1e-15 times conditioning,
 *         relative to the larger of them and 1, for motions that are far from
 *         steady ones (test_orbit).  Always: after a period the lean and the
 *         rates are those of *s, and heading and roll have gained what is
 *         stated, to the accuracy of coin_orbit_at() (make adversary).  The
 *         less theta swings, the less does this tell of its period: next to a
 *         steady motion 2 pi/sqrt(-lambda^2) is better, by coin_stability().
 * Cost: docs/models.md; some 46 KiB of stack. */
COIN_API int32_t coin_orbit_init(coin_orbit *o, const coin_state *s,
                                 const coin_params *p);

/** The state at any time, forward or backward, without stepping.
 * @param o         as coin_orbit_init() of the same version left it: an orbit
 *                  carries a tag of its version.  Other contents do no harm,
 *                  and most are detected
 * @param t         the time since the state that the orbit was made from [T]
 * @param[out] out  the state
 * @return COIN_OK; COIN_EARG, also for contents that are seen not to be an
 *         orbit; COIN_ESTEP if t is not finite, 2^31 periods or more, or theta,
 *         phi, psi, x or z leaves its range.
 * Accuracy: the sum of these terms.  In theta, phi and psi 1e-14 rad; 1e-15
 *         times conditioning for each period since the start; and
 *         4 u W (|t| + period), as from a rounding of t, where W is the fastest
 *         rate of the motion, Eq. (47), which is large in a pass close to flat.
 *         In x and z, in radii, (1 + radius_max/radius) times that sum, with
 *         the distance from the start for radius_max if the path drifts.  If
 *         heading_per_period is nearly a multiple of 2 pi, off by b, then the
 *         lesser of sum/b and W |t| (theta_max - theta_min) is added.  In the
 *         rates W times that sum (test_orbit_edges).  In all members 4 u of the
 *         state, amplified as the motion amplifies an error in the lean or a
 *         rate: next to an unstable steady motion the error of heading and roll
 *         may be a thousand times 1e-15 conditioning.  The orbit of a steady
 *         motion also leaves out what coin_steady_at() leaves out: in the lean
 *         16 u of the larger of |lambda^2| and the terms of (39), over
 *         |lambda^2|.  Its effect on heading and roll grows with time (make
 *         adversary).
 * Cost: 0.5 to 0.7 textbook steps, whatever t is (docs/models.md). */
COIN_API int32_t coin_orbit_at(const coin_orbit *o, double t, coin_state *out);

/* ----------------------------------------------------------- real coins -- */

/** Whether losses can be computed with.
 * @param l  any losses
 * @return COIN_OK; COIN_EARG null; COIN_EPARAMS as coin_params_check(), or a
 *         member of *l is negative or not finite, or it or its quotient by
 *         inertia_X or by inertia_Z + mass radius^2 is above 1e60. */
COIN_API int32_t coin_losses_check(const coin_losses *l, const coin_params *p);

/** The power that the losses take: -d(energy)/dt.  Eq. (69).
 * @return P >= 0 [M L^2/T^3]; NaN on the usual errors, coin_losses_check(),
 *         and where it would overflow.
 * Accuracy: 16 u of the terms (test_losses). */
COIN_API double coin_losses_power(const coin_state *s, const coin_params *p,
                                  const coin_losses *l);

/** coin_rates() of a coin with losses.  Eq. (14)-(20), (68).
 * @param[out] out  as coin_rates()
 * @return COIN_OK; the usual errors; COIN_EPARAMS also as coin_losses_check();
 *         COIN_ESTATE also if a rate would overflow.
 * Accuracy: 16 u of the terms (test_losses). */
COIN_API int32_t coin_losses_rates(const coin_state *s, const coin_params *p,
                                   const coin_losses *l, coin_state *out);

/** coin_reaction() of a coin with losses.  Eq. (25)-(28), (70).
 * @return as coin_losses_rates().
 * Accuracy: 16 u of the terms (test_losses). */
COIN_API int32_t coin_losses_reaction(const coin_state *s, const coin_params *p,
                                      const coin_losses *l, coin_force *out);

/** Moves a coin with losses by any time, to a stated accuracy, and tells when
 * it has come to rest.  The steps are of order 8 in Sundman's time, Eq. (32),
 * (68), and each estimates its error.  Once the contact has stopped, the last
 * fall is computed separately, Eq. (72).
 *
 * A disc that spins until it lies flat:
 * @code
 * const coin_losses l = {0, 1e-7, 0, 0, 0, 0, 0, 0};
 * coin_params p;
 * coin_state s;
 * double when;
 * coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
 * coin_steady_spin(&s, &p, 1.0);
 * if (coin_settle(&s, &p, &l, 1e3, 1e-6, &when) == COIN_RESTS)
 *     printf("flat after %g s\n", when);
 * @endcode
 * @param[in,out] s  the state
 * @param t          the time, >= 0 [T]
 * @param tol        1e-13 to 1e-2: the error that steps may add per natural
 *                   unit of time, in radians and radii, before the motion's
 *                   own amplification [1]
 * @param[out] reached  the time moved: t, or less if the call ended early; may
 *                   be null
 * @return COIN_OK; COIN_RESTS: the coin lies flat, and *reached is the time at
 *         which it came to rest.  In s, |theta| is the last lean that
 *         coin_state_check() accepts, wX the speed of the fall, wX theta >= 0,
 *         wY = 0, and wZ the rate at which the face still turns.  Another call
 *         from that state returns COIN_RESTS and *reached = 0.  The usual
 *         errors; COIN_EARG also for tol out of range; COIN_EPARAMS also as
 *         coin_losses_check(); COIN_ESTEP: t is negative or not finite, or
 *         beyond 1e15 natural units, and nothing was moved; or x or z
 *         overflows, s is untouched and *reached is 0; or 2^20 steps were not
 *         enough, s is the state at *reached, and another call goes on from
 *         there.  COIN_ERANGE: phi or psi would leave its range, and s is the
 *         state at *reached.
 * Without any loss it is coin_advance(), but for a fall, which gives COIN_RESTS
 * and wY = 0.  Pivoting friction alone never brings a coin to rest.  The coin
 * is kept on the table, as by coin_advance(): coin_check() tells whether a real
 * one would slip or lift.  If the losses never stop the contact, as with
 * damping or rolling, the time from cos(theta) = 1e-10 to rest is taken from
 * the law by which such a motion ends.
 * Accuracy: in 995 of 1000 random launches the error stays within tol per
 *         natural unit of time (test_settle).  In all launches that were
 *         searched it stays within 2 tol (1 + n): n is the number of radii that
 *         the coin would cover at the speed sqrt(2 E/M), E its energy at the
 *         start (docs/limits.md).  The time of rest is the same to a relative
 *         1e-9 for any number of calls.
 * Cost: some 3 RK8 steps per radian that the contact rolls by, at 1e-9.  It is
 *         higher where dry friction holds the contact: the steps then have to
 *         follow the rate dry/(soft cos(theta)), divided by a moment of
 *         inertia. */
COIN_API int32_t coin_settle(coin_state *s, const coin_params *p,
                             const coin_losses *l, double t, double tol,
                             double *reached);

/** The time until a coin lies flat, by the quasi-steady model: the coin goes
 * through steady motions, and the losses move it from one to the next.
 * Eq. (74).
 * @param s  near a steady motion; the model follows that motion
 * @return the time [T]; 0 at rest; +infinity if nothing stops the coin: without
 *         losses that act, or by pivoting friction alone.  NaN on the usual
 *         errors and coin_losses_check(); if the state swings about the steady
 *         motion by more than a tenth of its angle from flat; if that motion is
 *         unstable, or becomes so before the coin lies flat; or if 2^15 steps
 *         or 1e150 natural units are not enough, or for rates above 1e40
 *         sqrt(g/a).
 * Accuracy: the last fall is not quasi-steady.  With m the loss in natural
 *         units, the relative error is proportional to m^1.2 to m^1.5 for
 *         contour friction, to m^0.8 for rolling and to m^2 for damping.  It is
 *         6e-5 for a quarter that dry friction stops after 8 s (docs/models.md,
 *         test_quasisteady).  That is for a coin without swing, whose wX is
 *         that of coin_quasisteady_at() at t = 0.  A coin that starts with
 *         wX = 0 swings a little.  Rolling makes the swing grow, and the error
 *         is m^0.4 of the time.  The model itself is solved to 1e-6 of the
 *         time.
 * Cost: up to 610 textbook steps. */
COIN_API double coin_time_to_rest(const coin_state *s, const coin_params *p,
                                  const coin_losses *l);

/** A coin with losses at any time, by the quasi-steady model.  Eq. (74).
 * @param s         as for coin_time_to_rest()
 * @param t         the time, >= 0 [T]
 * @param[out] out  the state at t: wX is the slow change of the lean, not a
 *                  swing; may be s
 * @return COIN_OK; COIN_RESTS: the coin lies flat before t, and *out is the
 *         state at rest: |theta| the last lean that coin_state_check() accepts,
 *         wX = wY = 0, and wZ the rate at which the face still turns; the usual
 *         errors; COIN_EPARAMS also as coin_losses_check(); COIN_ESTEP t
 *         negative or not finite, or phi, psi, x or z leaves its range;
 *         COIN_EDOMAIN the state is not near a stable steady motion, or that
 *         becomes unstable before t, or 2^15 steps are not enough, or a rate
 *         is above 1e40 sqrt(g/a).
 * Accuracy: let m be the loss in natural units.  Until the angle from flat is
 *         10 m, the errors of theta, wY and wZ are proportional to m^2, and
 *         those of phi and psi to m: 70 m at half of the time to rest of a spin
 *         from 0.1 rad.  x and z err as phi does (test_quasisteady).  The model
 *         itself is solved to 1e-9: in natural units, or relative where a
 *         variable is larger than 1 (make adversary).
 * Cost: up to 230 textbook steps, whatever t. */
COIN_API int32_t coin_quasisteady_at(const coin_state *s, const coin_params *p,
                                     const coin_losses *l, double t,
                                     coin_state *out);

/** Scales losses so that a coin comes to rest after a given time: all members
 * of *l but soft are multiplied by one factor.
 * @param[in,out] l  at least one term other than spin is not 0
 * @param s          as for coin_time_to_rest()
 * @param time       > 0 [T]
 * @return COIN_OK; the usual errors; COIN_EARG also for time not in range;
 *         COIN_EPARAMS also as coin_losses_check(); COIN_EDOMAIN if
 *         coin_time_to_rest() gives no time, or such losses would not pass
 *         coin_losses_check().
 * Accuracy, cost: those of coin_time_to_rest(). */
COIN_API int32_t coin_losses_fit(coin_losses *l, const coin_state *s,
                                 const coin_params *p, double time);

/* ----------------------------------------------------- coins that slip -- */

/** Makes a slide of the state of a coin that rolls.  Eq. (20).
 * @param[out] d  the state *s, with the velocity that it rolls with
 * @return COIN_OK; the usual errors.
 * Accuracy: 8 u of the terms (test_slide). */
COIN_API int32_t coin_slide_of(coin_slide *d, const coin_state *s,
                               const coin_params *p);

/** Moves a coin that may slip by any time, to a stated accuracy.  The coin
 * rolls while the friction that rolling needs is at most mu_static N.  When it
 * needs more, the coin slips against a friction of mu_kinetic N, until its slip
 * speed is 0.  The moments at which a slip begins and ends are located, also if
 * both lie within one step.  Eq. (77)-(87).
 *
 * A quarter that is thrown along the table, until it rolls:
 * @code
 * const coin_friction f = {0.35, 0.3};
 * coin_params p;
 * coin_slide d = {{0.1, 0, 0, 0, 0, 0, 0, 0}, 0.5, 0};
 * double when = 0;
 * int32_t status;
 * coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
 * do {
 *     status = coin_slide_advance(&d, &p, &f, NULL, 1e-3, 1e-9, NULL);
 *     when += 1e-3;
 * } while (status == COIN_SLIPS);
 * if (status == COIN_OK)
 *     printf("rolls after %g s at most\n", when);
 * @endcode
 * @param[in,out] d  the slide
 * @param f          the friction
 * @param l          losses, whose damping is 0; may be null: none
 * @param t          the time, >= 0 [T]
 * @param tol        1e-13 to 1e-2: as coin_advance() and, with losses, as
 *                   coin_settle() [1]
 * @param[out] reached  the time by which the coin moved: t, or less if the call
 *                   ended early; may be null [T]
 * @return COIN_OK: it rolls at the end; COIN_SLIPS: it slips at the end.
 *         COIN_RESTS: the coin lies flat.  *reached is when it touched down,
 *         and d->s its state then, as coin_settle() says.  This is returned for
 *         a fall without losses too.  If the coin lies flat at the start,
 *         *reached = 0.
 *         COIN_ELIFT: the normal force N has come to 0, and the coin would lift
 *         off.  The slide and *reached are those of that moment.  If N <= 0 at
 *         the start, *reached = 0 and nothing was moved.  N is that of
 *         coin_slide_reaction().  If the coin rolls, and rolling on would need
 *         more friction than mu_static N, it is the N of the slip that begins.
 *         That N may be positive where the N of rolling is negative.
 *         The usual errors.  COIN_EARG: also for tol out of range.
 *         COIN_EPARAMS: also as coin_losses_check(), with inertia_Z in place of
 *         inertia_Z + mass radius^2, and for damping > 0, which is defined for
 *         coins that roll only.  Also if mu_kinetic is negative, not finite,
 *         above mu_static, or not below the bound of Painleve, Eq. (86), which
 *         is 2 sqrt(k (1 + k)) with k = I_X/(M a^2): 1.118 for a disc, 1.732
 *         for a hoop.  Beyond it Coulomb's friction may allow no motion, or
 *         several.  COIN_ESTATE: also if vx or vz is not finite, or so large
 *         that energies would overflow.  COIN_ESTEP: t is negative, not finite,
 *         or beyond 1e15 natural units, and nothing was moved; or x or z would
 *         overflow, the slide is untouched and *reached is 0; or 2^20 trials of
 *         steps were not enough, the slide is that at *reached, and another
 *         call goes on from there.  COIN_ERANGE: phi or psi would leave its
 *         range, and the slide is that at *reached.
 * t = 0 changes nothing: the status tells whether the coin rolls or slips.  A
 * slip speed below 1e-10 sqrt(g a) + 16 u a (|wX| + |wZ|) counts as 0.  While a
 * slip begins, its speed counts as 0 until it is 2e-10 sqrt(g a), though vx and
 * vz contain it.  A coin also rolls if the friction that it needs exceeds
 * mu_static N by less than 1e-14 of the terms of the force, which is rounding.
 * Without a slip the motion is that of coin_advance().
 * mu_static = mu_kinetic is accepted.  A slip then begins without acceleration,
 * and many short steps follow until it has grown.  A launch costs 14 times as
 * much as with mu_kinetic = 0.9 mu_static in the mean, and 70 times in the
 * worst case (make slide-study).  No launch of that study needed 2^20 steps.
 * A body with I_Z up to 1e-5 M a^2 or I_X up to 1e-6 M a^2 may be stiff while
 * it slips: 2^20 trials may then last for less than a natural unit of time.
 * Of random throws (leans of 0.1 to 1.3, rates of 0.1 to 3 sqrt(g/a), frictions
 * up to 0.5) some 1 in 100 are stiff at these limits, and a third to a half at
 * I_Z = 1e-7 M a^2.  At 10 times the limits none of 7,000 was.
 * Accuracy: the times at which a slip begins and ends err by less than 1e-8
 *         natural units, 10 units after the start, at tol = 1e-11 (test_slide).
 *         The exception is a slip whose speed comes close to 0 and grows again:
 *         its direction reverses almost at once, and the time of that reversal
 *         is less accurate than the motion after it.
 * Cost: while it rolls 1.25 times that of coin_advance() in long calls (make
 *         slide-study); docs/models.md has more. */
COIN_API int32_t coin_slide_advance(coin_slide *d, const coin_params *p,
                                    const coin_friction *f,
                                    const coin_losses *l, double t, double tol,
                                    double *reached);

/** Kinetic plus potential energy; the velocity of the centre is that of the
 * slide.  Eq. (88).
 * @return the energy [M L^2/T^2]; NaN on the usual errors, COIN_ESTATE as
 *         coin_slide_advance().
 * Accuracy: 12 u of the terms (make adversary). */
COIN_API double coin_slide_energy(const coin_slide *d, const coin_params *p);

/** The force of the table.  If the coin rolls, it is the force that rolling
 * needs.  If that leaves the cone of friction of mu_static, it is the force of
 * the slip that begins.  If the coin slips, its friction is mu_kinetic N
 * against the slip.  Eq. (79)-(82), (84).
 * @param l         losses; may be null: none
 * @param[out] out  the force
 * @return COIN_OK; the usual errors; COIN_EPARAMS and COIN_ESTATE also as
 *         coin_slide_advance(), and COIN_ESTATE if a force would overflow.
 * Accuracy: 32 u of the terms over cos(theta) (test_slide). */
COIN_API int32_t coin_slide_reaction(const coin_slide *d, const coin_params *p,
                                     const coin_friction *f,
                                     const coin_losses *l, coin_force *out);

/** The slip velocity: that of the material point of contact.  Eq. (77).
 * @param[out] u  [2] along x and z; 0 to rounding if the coin rolls [L/T]
 * @return COIN_OK; the usual errors; COIN_ESTATE also as coin_slide_advance().
 * Accuracy: 8 u of the terms (test_slide). */
COIN_API int32_t coin_slide_velocity(const coin_slide *d, const coin_params *p,
                                     double u[2]);

/* ------------------------------------------------ version and self-test -- */

/** The library's version, 0xMMmmpp; compare with the COIN_VERSION_ macros to
 * see that header and library belong together. */
COIN_API uint32_t coin_version(void);

/** The same as text, "0.1.0". */
COIN_API const char *coin_version_string(void);

/** What a status means, in English, without a full stop; never null.  If
 * several warning bits are set, the text names the set. */
COIN_API const char *coin_status_string(int32_t status);

/** The size of a public struct as the library was compiled: for bindings, which
 * compare it with that of their own.
 * @param type  its name, "coin_state" or "coinf_state"; may be null
 * @return 64 for "coin_state"; 0 if no struct has that name. */
COIN_API uint32_t coin_sizeof(const char *type);

/** Whether this build computes the pinned bits: steps some coins and compares
 * a hash with the one built in.
 * @return COIN_OK; COIN_EBUILD if the compiler fused or reordered arithmetic
 *         (fast-math, contraction), or the rounding mode is not to-nearest.
 * Cost: some 200 us. */
COIN_API int32_t coin_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
