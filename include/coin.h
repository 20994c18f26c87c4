/* SPDX-License-Identifier: MIT */
/** @file coin.h
 * librollcoin: the motion of a coin, a disc or a ring, on a table.
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
 * UNITS. Angles are in radians, everything else in any consistent units.
 * Dimensions stand in brackets: [M] mass, [L] length, [T] time, [1] none.  A
 * natural unit of time is sqrt(radius/gravity): 35 ms for a US quarter.
 *
 * ARGUMENTS come in one order: the object acted on, the parameters p, the table
 * or losses, scalars, outputs.  A pointer is not null unless a line says "may
 * be null"; one to [count] things may be null if count is 0.  An output may be
 * the same object as an input of the same type.
 *
 * STATUS. Most functions return an int32_t.  0 is COIN_OK.  A positive value is
 * no error: its bits are warnings, or the mode of a body, or COIN_MORE, which
 * says that not all was done.  A negative value is an error: every output and
 * the state are then unchanged, unless the function says otherwise.  Functions
 * that return a double return NaN instead of an error.  Each function may
 * return these, the usual errors: COIN_EARG for a null pointer; COIN_EPARAMS if
 * p, losses or a table are out of range; COIN_ESTATE if a state or a body is,
 * whether it is given or would be made.  Its @return says what else.  If there
 * are several errors, the first of COIN_EARG, COIN_EPARAMS, COIN_ESTATE,
 * COIN_ESTEP, COIN_EDOMAIN is returned.  A function without p accepts what is
 * in the range of some coin: x, z up to 1e24, an angular velocity up to 1e21.
 *
 * RANGES. What no coin and no wheel is, is refused:
 *   mass, radius, gravity      1e-15 to 1e15 each, in the units of the caller
 *   I_X/(M a^2)                1e-3 to 1e3
 *   I_Z/I_X                    1e-3 to 2 (1 + 1e-12): no body has I_Z > 2 I_X
 *   wX, wY, wZ                 up to 1e6 sqrt(g/a) each
 *   vx, vy, vz of a body       up to 1e6 sqrt(g a) each
 *   theta                      below pi/2
 *   phi, psi                   up to 2^31 rad
 *   x, z; y of a body          up to 1e9 a
 *   losses, in natural units   0, or 1e-12 to 1e3 each, dry and rolling to 1;
 *                              flat 0, or 1e-12 to 1e-2
 *   dt, t                      up to 1e15 natural units; coin_settle() and
 *                              coin_move() also +infinity
 *   tol                        1e-13 to 1e-2; coin_settle() and coin_move()
 *                              from 1e-12
 * Sizes are meant, of either sign.  NaN is out of every range.  Within them no
 * function overflows, and all bounds hold.
 *
 * COST. The unit is a textbook step: classical Runge-Kutta that calls the sine
 * and the cosine of libm once for each angle in every stage, 1,496 instructions
 * by gcc -O2 on x86-64.  docs/accuracy.md counts calls that move a coin.  Every
 * other call takes less than one textbook step, its checks included, unless its
 * documentation states another cost (make bound).
 *
 * PROMISES. No allocation, no global state, no output, no errno: every function
 * is reentrant, and bounded in stack and, for a given number of steps and of
 * coins, in time.  What moves a state gives the same bits wherever doubles are
 * those of IEEE 754 (see coin_selftest()).
 * A state that is returned is in range, but for the rounding of a body's phi, x
 * and z at the end of theirs.  It means to the next call what the returned
 * status says: many short calls move a coin as one long call does, within the
 * stated error (test_state_out).  No function changes the rounding mode or the
 * traps; docs/embedding.md says which values raise no floating-point exception.
 *
 * ACCURACY. "u" is 2^-53 = 1.1e-16.  "8 u of the terms" bounds an error by 8 u
 * times the sum of the absolute values of the formula's terms, for the double
 * theta as it is, where no term is below the normal doubles (2e-308).  In
 * brackets stands the test that holds the bound. */
#ifndef ROLLCOIN_COIN_H
#define ROLLCOIN_COIN_H

#include <stddef.h>
#include <stdint.h>

#define COIN_VERSION_MAJOR 1
#define COIN_VERSION_MINOR 0
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

/** An axisymmetric body.  coin_params_disc(), _ring() and _body() make a thin
 * one, coin_params_cylinder() one with a thickness. */
typedef struct coin_params {
    double mass;        /**< M [M] */
    double radius;      /**< a, of the rim that rolls [L] */
    double gravity;     /**< g [L/T^2] */
    double inertia_X;   /**< I_X = I_Y, about a diameter [M L^2] */
    double inertia_Z;   /**< I_Z, about the axis [M L^2] */
    double thickness;   /**< between the two rims: 1e-4 to 4 radii; or 0, a
                             thin coin, which most functions ask for [L] */
    double reserved[2]; /**< must be 0 */
} coin_params;

/** Where a coin is and how it turns: its angular velocity along the coin's
 * frame.  Rolling determines the velocity of the centre, Eq. (20), and its
 * height is y = radius cos(theta). */
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
    double normal;   /**< N = R_y [M L/T^2] */
    double friction; /**< F = sqrt(R_x^2 + R_z^2) [M L/T^2] */
    double ratio;    /**< F/N [1]; +infinity if N <= 0 */
} coin_force;

/** Status: 0, or negative = error.  Numbers never change meaning. */
enum {
    COIN_OK = 0,       /**< done */
    COIN_EPARAMS = -1, /**< parameters, losses or a table out of range */
    COIN_ESTATE = -2,  /**< a state or a body out of range */
    COIN_ESTEP = -3,   /**< dt or t out of range, or a step beyond its method */
    COIN_EARG = -4,    /**< null pointer, unknown method, branch or bit, tol */
    COIN_EDOMAIN = -5, /**< no such steady motion, period or losses; or not a
                          steady motion */
    COIN_EFLAT = -6,   /**< the coin falls flat within the time asked */
    COIN_EBUILD = -7,  /**< not the pinned bits: coin_selftest() */
    COIN_ERANGE = -9   /**< phi, psi, a place or a rate would leave its range,
                            or a step is refused within 16 rad or radii of its
                            end */
};

/** Status: positive = no error, with these bits. */
enum {
    COIN_SLIPS = 1,       /**< F > mu N > 0: a real coin slips */
    COIN_LIFTS = 2,       /**< N <= 0; of a body: it is off the table */
    COIN_COARSE = 4,      /**< |dt| coin_fastest_rate() is above 0.35 (RK4), 1
                               (RK8), 0.08, 0.16 (symplectic methods) */
    COIN_NEARLY_FLAT = 8, /**< cos(theta) < 0.01 */
    COIN_RESTS = 16,      /**< the coin lies flat, or stands, and stays */
    COIN_ROLLS = 32,      /**< a slip or a flight has ended, and it rolls */
    COIN_TOUCHES = 64,    /**< the coin comes down on the table */
    COIN_MORE = 128,      /**< the steps of one call did not suffice: it has
                               moved by `reached` */
    COIN_DECIDED = 256    /**< which side ends up is decided */
};

/** How a coin lies: coin_body_face(). */
enum {
    COIN_HEADS = 1, /**< the +Z side is up: theta < 0 */
    COIN_TAILS = 2, /**< the other side is up */
    COIN_EDGE = 3   /**< upright, or it would fall back on its edge */
};

/** Methods of integration. */
enum {
    COIN_RK4 = 0,         /**< classical Runge-Kutta, order 4 */
    COIN_RK8 = 1,         /**< Dormand-Prince, 12 stages, order 8 */
    COIN_SYMPLECTIC2 = 2, /**< kick-drift-kick with the exact drift, order 2 */
    COIN_SYMPLECTIC4 = 3  /**< Chin 4A with the exact drift, order 4 */
};

/* ------------------------------------------------------------- stepping -- */

/** One step of classical Runge-Kutta, order 4: coin_run(s, p, COIN_RK4, dt, 1,
 * null), with the same bits.  Eq. (14)-(20).
 * Step, status and accuracy are those of coin_run(); an error leaves *s.
 * Cost: 962 instructions, where a further step of coin_run() takes 581; at
 *         most 832 bytes of stack on a Cortex-M4F (make firmware). */
COIN_API int32_t coin_step(coin_state *s, const coin_params *p, double dt);

/** Moves a coin by fixed steps.  n runs of one step give what one run of n
 * steps gives, but for rounding.
 * @param method      COIN_RK4, ...: coin_method_name()
 * @param dt          the step; < 0 runs backward [T]
 * @param steps       how many; 0 changes nothing
 * @param[out] done   how many were done; may be null
 * @return COIN_COARSE: all done, but a step began or ended beyond the method's
 *         limit of full accuracy; COIN_EARG also for an unknown method;
 *         COIN_ESTEP if dt is out of range, *done untouched; or if a step is
 *         refused: s is then the state after the *done steps before.
 *         COIN_ERANGE: the same, where phi, psi, x or z is at the end of its
 *         range; or if a rate ends out of range, *done = 0.
 * A step is refused if |dt| W is beyond 1.2 (COIN_SYMPLECTIC2: 1,
 * COIN_SYMPLECTIC4: 1.4) where it begins or ends; if it would lead through the
 * table or out of range; or if it turns lean or heading by more than 1.5 rad.
 * The symplectic methods also refuse a coarse step whose drift is beyond the
 * reach of Eq. (34).
 * Accuracy: a step adds at most 0.1 (|dt| W)^5 radians and radii by COIN_RK4,
 *         2e-4 (|dt| W)^9 by COIN_RK8, 0.6 (|dt| W)^3 by COIN_SYMPLECTIC2 and
 *         0.04 (|dt| W)^5 by COIN_SYMPLECTIC4, and as much, relative to W, in
 *         the rates, before the motion's own amplification, if I_X <= M a^2/2;
 *         rounding adds 4 u a step, 4 u/cos(theta) by the symplectic methods.
 * Cost: per call the checks and four sines and cosines, and these again per 64
 *         steps; the symplectic methods take two more for each drift. */
COIN_API int32_t coin_run(coin_state *s, const coin_params *p, int32_t method,
                          double dt, uint64_t steps, uint64_t *done);

/** A trajectory in one call: out[k] is the state after k * steps_per_sample
 * steps, out[0] = *start.  out[k] has the bits of one coin_run() from *start,
 * however often it is sampled.
 * @param start             where to begin; may be an element of out
 * @param steps_per_sample  steps of dt between two samples
 * @param count             how many samples out holds; 0 changes nothing
 * @param[out] out          [count] states
 * @param[out] done         how many samples were written; may be null
 * @return as coin_run(); if a step is refused, out[0 .. *done-1] hold the
 *         samples before it, and the rest are untouched.
 * Cost: that of coin_run(); some 340 instructions more for each sample. */
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
 *         coarse, goes on by itself from there, at the cost of coin_run(). */
COIN_API int32_t coin_batch_run(coin_state *s, size_t count,
                                const coin_params *p, int32_t method, double dt,
                                uint64_t steps, int32_t *status);

/** Moves a coin by any time to a stated accuracy, however near to flat it
 * passes.  The steps are of order 14, by extrapolation, in Sundman's time,
 * Eq. (32), with an estimate of their error.  The last is in t, Eq. (54).
 * @param t          the time, of either sign [T]
 * @param tol        the error that the steps may add per natural unit of time
 *                   or per radius that a fast coin covers, in radians and
 *                   radii, before the motion's own amplification [1]
 * @param[out] reached  the time moved: t, unless the status says that the call
 *                   ended earlier; may be null
 * @return COIN_EARG also for tol out of range; COIN_ESTEP: t is out of range,
 *         *reached untouched.  COIN_MORE: 2^20 steps were not enough, and s is
 *         the state at *reached.  COIN_ERANGE: phi, psi, x or z would leave its
 *         range, and s is the state at *reached; or a rate ends out of range,
 *         *reached = 0.  COIN_EFLAT: the coin falls flat, nearer than
 *         1e-30 rad, at *reached; s is the last state before that a double can
 *         hold.  A coin at rest counts as fallen: for t >= 0 *reached is 0.
 * Accuracy: within 2 tol (1 + n), n the radii that the coin covers at the speed
 *         sqrt(2 energy/mass) (docs/limits.md), plus rounding, about 1e-15 per
 *         unit.  At d rad from flat, the double theta of the start holds
 *         cos(theta) with a relative error of u/d.
 * Cost: about one step per radian that the coin turns by (docs/accuracy.md);
 *         more as 1/tol^(1/14).  A pass at d rad from flat costs as much as
 *         ln(1/d) natural units.  At most 2^20 steps, some 0.2 s. */
COIN_API int32_t coin_advance(coin_state *s, const coin_params *p, double t,
                              double tol, double *reached);

/** A method's name, "rk4" for COIN_RK4; null if there is no such method. */
COIN_API const char *coin_method_name(int32_t method);

/* ----------------------------------------------------------- parameters -- */

/** A uniform thin disc: I_X = M a^2/4, I_Z = M a^2/2.  Eq. (29).
 * @param mass     M [M]
 * @param radius   a [L]
 * @param gravity  g [L/T^2]
 * Accuracy: 4 u in I_X and I_Z (make adversary). */
COIN_API int32_t coin_params_disc(coin_params *p, double mass, double radius,
                                  double gravity);

/** A thin ring: I_X = M (a^2 + b^2)/4, I_Z = 2 I_X.  Eq. (29).
 * @param inner_radius  b, 0 (a disc) to radius (a hoop) inclusive [L]
 * @return COIN_EPARAMS also if b is out of range. */
COIN_API int32_t coin_params_ring(coin_params *p, double mass, double radius,
                                  double inner_radius, double gravity);

/** Any thin axisymmetric body.
 * @param inertia_X  I_X about a diameter [M L^2]
 * @param inertia_Z  I_Z about the axis [M L^2] */
COIN_API int32_t coin_params_body(coin_params *p, double mass, double radius,
                                  double gravity, double inertia_X,
                                  double inertia_Z);

/** A uniform cylinder, for coin_move() and coin_body_*(): I_X = M (a^2/4 +
 * thickness^2/12), I_Z = M a^2/2.  A ring or another body gets rims by setting
 * p->thickness.
 * @param thickness  0, or 1e-4 to 4 radii [L]
 * Accuracy: 4 u in I_X and I_Z (make adversary). */
COIN_API int32_t coin_params_cylinder(coin_params *p, double mass,
                                      double radius, double thickness,
                                      double gravity);

/** Whether parameters are in range, and the reserved members 0 (test_range). */
COIN_API int32_t coin_params_check(const coin_params *p);

/* ---------------------------------------------------------------- state -- */

/** Whether a state is in range (test_range). */
COIN_API int32_t coin_state_check(const coin_state *s, const coin_params *p);

/** The state of a coin that an engine holds as a rotation and an angular
 * velocity.  Eq. (7), (30).
 * @param[out] s  the state; -pi < phi, psi <= pi
 * @param q       [4] w, x, y, z: rotation body to table; |q|^2 from 1e-15 to
 *                1e15 [1]
 * @param omega   [3] angular velocity in the table frame [1/T]
 * @param x,z     the centre of mass [L]
 * @return COIN_ESTATE if q, omega, x or z is out of range, or the coin lies
 *         flat.
 * Accuracy: 8 u in each angle for a unit q; near flat each of phi and psi is
 *         uncertain by u/cos(theta), but their sum or difference is not
 *         (test_state). */
COIN_API int32_t coin_state_from_motion(coin_state *s, const coin_params *p,
                                        const double q[4],
                                        const double omega[3], double x,
                                        double z);

/** The angular velocity in the table frame.  Eq. (7).
 * @param[out] omega  [3] along x, y, z [1/T]
 * Accuracy: 8 u of the terms (test_observe). */
COIN_API int32_t coin_angular_velocity(const coin_state *s, double omega[3]);

/* ---------------------------------------------------------- observables -- */

/** The energy, constant along every motion: 0 at rest with the centre at the
 * table's height [M L^2/T^2].  Eq. (23).
 * Accuracy: 8 u of E (test_observe). */
COIN_API double coin_energy(const coin_state *s, const coin_params *p);

/** The two linear integrals, constant along every motion: the values of wY and
 * wZ that their linear equations give at theta = 0.  Eq. (35), after Eq. (38)
 * near flat.
 * @param[out] K  [2] K_Y, K_Z [1/T]
 * Accuracy: 16 u of the terms of Eq. (35) (test_integrals).  Uses log of libm
 *         for |sin theta| > 0.7: the last bit may differ between platforms.
 * Cost: at most 5 textbook steps. */
COIN_API int32_t coin_integrals(const coin_state *s, const coin_params *p,
                                double K[2]);

/** The force of the table on the coin.  Eq. (25)-(28).  The rolling model holds
 * the coin to the table, so that N may be negative: see COIN_LIFTS.
 * Accuracy: 14 u of the terms (make adversary). */
COIN_API int32_t coin_reaction(const coin_state *s, const coin_params *p,
                               coin_force *out);

/** The rates of change of every member.  Eq. (14)-(20).
 * @param[out] out  d/dt of theta, phi, ... in the member of that name; it is
 *                  not a state
 * Accuracy: 12 u of the terms (test_motion). */
COIN_API int32_t coin_rates(const coin_state *s, const coin_params *p,
                            coin_state *out);

/** The centre of mass.
 * @param[out] r  [3] x, y, z; y = radius cos(theta) [L]
 * Accuracy: 4 u (test_observe). */
COIN_API int32_t coin_center(const coin_state *s, const coin_params *p,
                             double r[3]);

/** The velocity of the centre of mass.  Eq. (20).
 * @param[out] v  [3] along x, y, z [L/T]
 * Accuracy: 8 u of the terms (test_observe). */
COIN_API int32_t coin_velocity(const coin_state *s, const coin_params *p,
                               double v[3]);

/** The point of contact, and how fast it moves along the table (the geometric
 * point: the coin's own material there is at rest).  Eq. (21), (22).
 * @param[out] r  [3] the point, y = 0 [L]
 * @param[out] v  [3] its velocity, y = 0 [L/T]
 * Accuracy: 8 u of the terms (test_observe). */
COIN_API int32_t coin_contact(const coin_state *s, const coin_params *p,
                              double r[3], double v[3]);

/** The coin's frame.  Eq. (7).
 * @param[out] R  [9] rows e_X, e_Y, e_Z, each along x, y, z [1]
 * Accuracy: 4 u (test_observe). */
COIN_API int32_t coin_axes(const coin_state *s, double R[9]);

/** The rotation of the body, the roll included.  Eq. (30).
 * @param[out] q  [4] w, x, y, z, unit norm, body to table; continuous in the
 *                angles, so q and -q both occur [1]
 * Accuracy: 4 u (test_observe). */
COIN_API int32_t coin_quaternion(const coin_state *s, double q[4]);

/** The pose as one matrix, as a renderer loads it: body to table, the roll
 * included.  Eq. (90).
 * @param[out] m  [16] by columns, as OpenGL, Vulkan and three.js have them: the
 *                body's three axes [1] and its centre of mass [L], each with
 *                x, y, z of the table and then 0, 0, 0, 1.  Element (row,
 *                column) is m[4 * column + row]
 * Accuracy: 8 u in the axes, 4 u in y (test_matrix). */
COIN_API int32_t coin_matrix(const coin_state *s, const coin_params *p,
                             double m[16]);

/** How fast the coin turns and falls now: the W of Eq. (47) [1/T],
 * sqrt((wX^2 + wY^2)/cos^2 theta + wZ^2 + gravity/(radius cos theta)).  The
 * error of a step of dt depends on |dt| W: docs/choosing.md, COIN_COARSE.
 * Near flat W grows within one swing, so take it each frame, or use
 * coin_advance().
 * Accuracy: 8 u (make adversary). */
COIN_API double coin_fastest_rate(const coin_state *s, const coin_params *p);

/* ------------------------------------------------------------- validity -- */

/** Whether the rolling model holds for this state, and whether a step is fine
 * enough for it.
 * @param dt  the step in question [T]
 * @param mu  the friction coefficient, >= 0, may be +infinity [1]
 * @return the bits COIN_SLIPS, COIN_LIFTS, COIN_COARSE, COIN_NEARLY_FLAT;
 *         COIN_EARG also for an unknown method and mu < 0 or NaN; COIN_ESTEP if
 *         dt is out of range.
 * Accuracy: a bit may be wrong where the state is nearer to its threshold than
 *         8 u of the terms of that threshold (make adversary). */
COIN_API int32_t coin_check(const coin_state *s, const coin_params *p,
                            int32_t method, double dt, double mu);

/* -------------------------------------------------------- steady motion -- */

/** Straight rolling, upright: theta = wX = wY = 0.
 * @param[out] s  all 8 members, the pose 0
 * @param wZ      the speed is radius |wZ|, along -x for wZ > 0 [1/T] */
COIN_API int32_t coin_steady_roll(coin_state *s, const coin_params *p,
                                  double wZ);

/** Spinning with the centre at rest, leaning: wX = wZ = 0, wY > 0.  Needs no
 * friction.  Eq. (42).
 * @param theta  the lean, |theta| < pi/2 [rad]
 * Accuracy: 8 u in wY (make adversary). */
COIN_API int32_t coin_steady_spin(coin_state *s, const coin_params *p,
                                  double theta);

/** Spinning upright about a diameter: theta = wX = wZ = 0.
 * @param wY  the rate [1/T] */
COIN_API int32_t coin_steady_upright_spin(coin_state *s, const coin_params *p,
                                          double wY);

/** Rolling along a circle at a constant lean.  Eq. (40), computed as Eq. (41)
 * without cancellation.
 * @param theta   the lean, 0 < |theta| < pi/2 [rad]
 * @param wZ      the rate [1/T]
 * @param branch  +1 or -1: the root f+ or f- of Eq. (40).  The slow precession
 *                is branch +1 for wZ > 0, -1 for wZ < 0
 * @return COIN_EARG also for another branch; COIN_EDOMAIN if theta = 0, or next
 *         to 0 with wZ = 0.
 * Accuracy: 8 u in wY (test_steady). */
COIN_API int32_t coin_steady_circle(coin_state *s, const coin_params *p,
                                    double theta, double wZ, int32_t branch);

/** The circle of a given size at a given lean: the one with wY > 0 and
 * wY wZ theta >= 0, which exists for every lean but 0.  Eq. (93).
 * @param theta   the lean, 0 < |theta| < pi/2 [rad]
 * @param radius  of the centre's circle, >= 0; 0 is coin_steady_spin() [L]
 * @return COIN_EARG also for radius < 0 or NaN; COIN_EDOMAIN if theta = 0, or
 *         radius is above 1e9 a.
 * Accuracy: 8 u in wY and wZ (test_steady_turn). */
COIN_API int32_t coin_steady_turn(coin_state *s, const coin_params *p,
                                  double theta, double radius);

/** The lean that a coin needs to ride round a circle at a given speed: the same
 * choice, with 0 < theta < pi/2, of which there is just one.  Eq. (93), (94).
 * @param speed   of the centre, > 0 [L/T]
 * @param radius  of the centre's circle, > 0 [L]
 * @return COIN_EARG also if one is not above 0; COIN_EDOMAIN if radius is above
 *         1e9 a, or tan(theta) would be above 1e7.
 * Accuracy: 16 u in the radius, 16 u + u/cos(theta) in the speed, and the lean
 *         as these determine it (test_steady_turn). */
COIN_API int32_t coin_steady_ride(coin_state *s, const coin_params *p,
                                  double speed, double radius);

/** The circles that the centre and the contact point of a steady motion
 * follow.  Eq. (43).
 * @param[out] center   R_G, of the centre of mass [L]
 * @param[out] contact  R_C, of the contact point; both +infinity if wY = 0, or
 *                      1e9 a or more [L]
 * @return COIN_EDOMAIN if the state is not steady: |wX| above 1e-9 of the
 *         largest of |wY|, |wZ|, sqrt(g/a), or the two sides of Eq. (39) apart
 *         by more than 1e-9 of the largest of its terms and M g a.
 * Accuracy: 8 u of the terms (make adversary). */
COIN_API int32_t coin_steady_radii(const coin_state *s, const coin_params *p,
                                   double *center, double *contact);

/** Linear stability of a steady motion.  Eq. (44).
 * @param[out] lambda2  lambda^2: > 0, a small lean away from it grows as
 *                      exp(sqrt(lambda^2) t); < 0, it oscillates with the
 *                      period 2 pi/sqrt(-lambda^2); 0, critical [1/T^2]
 * @return as coin_steady_radii().
 * Accuracy: 16 u of the terms (test_stability). */
COIN_API int32_t coin_stability(const coin_state *s, const coin_params *p,
                                double *lambda2);

/** The rate |wZ| above which straight rolling is stable: sqrt(g/(3 a)) for a
 * disc [1/T].  Eq. (45).
 * Accuracy: 8 u (make adversary). */
COIN_API double coin_critical_roll(const coin_params *p);

/** The rate |wY| above which upright spinning is stable: sqrt(4 g/(5 a)) for a
 * disc [1/T].  Eq. (46).
 * Accuracy: 8 u (make adversary). */
COIN_API double coin_critical_spin(const coin_params *p);

/** A steady motion at any time, in closed form: nothing is stepped.  Eq. (56).
 * @param s         a steady state, as coin_steady_radii()
 * @param t         the time, of either sign [T]
 * @param[out] out  the state at t, with wX = 0
 * @return COIN_ESTEP if t is out of range; COIN_ERANGE if phi, psi, x or z
 *         leaves its range; COIN_EDOMAIN as coin_steady_radii().
 * Accuracy: 6 u of the angles turned, and 6 u of the path, plus the rounding of
 *         phi, psi, x and z to doubles (test_steady_at).
 * Cost: 0.6 textbook steps. */
COIN_API int32_t coin_steady_at(const coin_state *s, const coin_params *p,
                                double t, coin_state *out);

/* ---------------------------------------------- motion without stepping -- */

/** A motion that coin_orbit_init() has solved.  It has no pointers, so that it
 * may be copied, stored and shared; a library of another version, or on a
 * machine of another byte order, returns COIN_EARG for it. */
typedef struct coin_orbit {
    double period;             /**< of theta; 0 if the motion is steady [T] */
    double heading_per_period; /**< what phi gains in it [rad] */
    double roll_per_period;    /**< what psi gains in it [rad] */
    double theta_min;          /**< the turning points of the lean [rad] */
    double theta_max;
    double center[2];  /**< x, z of the centre of the annulus that the path
                            fills; NaN if it drifts [L] */
    double radius_min; /**< of the annulus; NaN if it drifts [L] */
    double radius_max;
    double drift[2];          /**< x, z of the displacement per period, if
                                   heading_per_period is k 2 pi; else 0 [L] */
    double conditioning;      /**< growth of rounding in a period, >= 1 [1] */
    double reserved[26];      /**< 0: for members of later versions */
    double private_frame[32]; /**< from here on for the library only */
    double private_edges[48];
    double private_centers[42];
    double private_terms[3780];
    double private_spare[156]; /**< 0 */
} coin_orbit;

/** Solves a motion for all times, by power series of half a period of theta.
 * Eq. (55), (57).  A stable steady motion is an orbit of period 0.
 * @return COIN_EDOMAIN if the motion has no well-defined period: it is an
 *         unstable steady motion that is not exactly upright; conditioning is
 *         1e12 or more, next to a separatrix; or the pieces of an orbit do not
 *         suffice, as it comes too close to flat or takes too long between
 *         turning points (docs/limits.md).
 * Accuracy: period, heading and roll per period to 1e-15 times conditioning,
 *         relative to the larger of them and 1 (test_orbit); next to a steady
 *         motion the period is better had by coin_stability().  The path that
 *         coin_orbit_at() gives lies between radius_min and radius_max to 1e-12
 *         of the larger, beside the rounding of x and z (test_orbit).
 * Cost: some 100 to 300 textbook steps, near flat at most 1,300 textbook steps;
 *         46 KiB of stack. */
COIN_API int32_t coin_orbit_init(coin_orbit *o, const coin_state *s,
                                 const coin_params *p);

/** The state at any time, forward or backward, without stepping.
 * @param o         as coin_orbit_init() of the same version left it.  Other
 *                  contents do no harm, and most are detected
 * @param t         the time since the state that the orbit was made from [T]
 * @return COIN_EARG also for contents that are seen not to be an orbit;
 *         COIN_ESTEP if t is 2^31 periods or more, or, of a steady motion, out
 *         of range; COIN_ERANGE if a member of *out leaves its range.
 * Accuracy: in theta, phi and psi 1e-14 rad + 1e-15 conditioning for each
 *         period + 4 u W (|t| + period), W the fastest rate of the motion; in
 *         x and z, in radii, (1 + radius_max/radius) times that; in the rates W
 *         times that (test_orbit_edges, docs/limits.md).
 * Cost: 0.5 to 0.7 textbook steps, whatever t is. */
COIN_API int32_t coin_orbit_at(const coin_orbit *o, double t, coin_state *out);

/* --------------------------------------------------------------- losses -- */

/** What slows a coin and brings it to rest.  Each member but soft and flat is
 * the coefficient of one law of resistance; they add up, and 0 stands for none.
 * Initialise by member names.  Eq. (64)-(69), (95). */
typedef struct coin_losses {
    double damping; /**< a torque damping |d(psi)/dt| times the angular
                       momentum; of a coin that rolls [1] */
    double dry;     /**< a torque against the rolling of the contact along the
                         rim, independent of its rate [M L^2/T^2] */
    double viscous; /**< the same, proportional to that rate [M L^2/T] */
    double layer;   /**< the same, to its power 3/2: the boundary layer of the
                         air [M L^2/T^(1/2)] */
    double gap;     /**< the same, to the rate over cos(theta): the air in the
                         gap below the coin [M L^2/T] */
    double rolling; /**< dry times cos(theta): the rolling moment of engines
                         [M L^2/T^2] */
    double spin;    /**< pivoting friction: a torque proportional to the turn
                         about the vertical [M L^2/T] */
    double angular; /**< the angular damping of engines: the torque
                         -angular (I_X wX, I_X wY, I_Z wZ) [1/T] */
    double soft;    /**< the rate of roll below which dry and rolling fade; 0
                         stands for sqrt(g/a)/1024 [1/T] */
    double flat;    /**< a coin whose cos(theta) comes below this lies flat; 0
                         stands for 1e-6 [rad] */
    double reserved[2]; /**< must be 0 */
} coin_losses;

/** Whether losses are in range, and the reserved members 0. */
COIN_API int32_t coin_losses_check(const coin_losses *l, const coin_params *p);

/** The power that the losses take: -d(energy)/dt >= 0 [M L^2/T^3].  Eq. (69).
 * Accuracy: 24 u of the terms (test_losses). */
COIN_API double coin_losses_power(const coin_state *s, const coin_params *p,
                                  const coin_losses *l);

/** coin_rates() of a coin with losses.  Eq. (14)-(20), (68).
 * @param[out] out  as coin_rates()
 * Accuracy: 16 u of the terms (test_losses). */
COIN_API int32_t coin_losses_rates(const coin_state *s, const coin_params *p,
                                   const coin_losses *l, coin_state *out);

/** coin_reaction() of a coin with losses.  Eq. (25)-(28), (70).
 * Accuracy: 16 u of the terms (test_losses). */
COIN_API int32_t coin_losses_reaction(const coin_state *s, const coin_params *p,
                                      const coin_losses *l, coin_force *out);

/** Moves a coin with losses by any time, to a stated accuracy, and tells when
 * it has come to rest.  It is held to the table: it neither slips nor lifts.
 * Eq. (32), (68), (72).
 * @param l          the losses; without any, `flat` does not act
 * @param t          the time, >= 0; +infinity: until it rests [T]
 * @param tol,reached  as coin_advance()
 * @return COIN_RESTS: the coin rests since *reached.  It lies flat: |theta| is
 * the last lean that coin_state_check() accepts, wX the speed of the fall, wX
 * theta >= 0, wY = 0, and wZ the rate at which the face still turns.  Or it
 * stands: theta, wX and wY were exactly 0, and |wZ| fell below 1e-10 natural
 * units.  COIN_MORE: 2^20 trials of steps were not enough, and s is the state
 * at *reached.  COIN_EARG also for tol out of range; COIN_ESTEP if t is.
 * COIN_ERANGE: as coin_advance(), with s the state at *reached.
 * Accuracy: of 100 random launches, 95 err by less than tol (1 + n) after n
 *         natural units, and 99 by less than 20 tol (1 + n), before
 *         amplification (test_settle).
 * Cost: some 8 to 12 textbook steps per radian that the contact rolls by, at
 *         1e-9. */
COIN_API int32_t coin_settle(coin_state *s, const coin_params *p,
                             const coin_losses *l, double t, double tol,
                             double *reached);

/** The time until a coin rests, by settling a copy of it [T]: 0 at rest;
 * +infinity if it stays upright.  Where 2^20 trials of steps do not suffice it
 * is +infinity if every coefficient but spin is 0, and else NaN.
 * @param tol        as coin_settle() [1]
 * Cost: that of coin_settle(), at most some 5e6 textbook steps. */
COIN_API double coin_time_to_rest(const coin_state *s, const coin_params *p,
                                  const coin_losses *l, double tol);

/** Scales losses so that a coin comes to rest after a given time: all members
 * of *l but soft and flat are multiplied by one factor.
 * @param[in,out] l  at least one term other than spin is not 0
 * @param time       > 0, up to 5e14 natural units [T]
 * @return COIN_OK: the coin rests after `time` within 1 %, by settling it at
 * tol = 1e-6; COIN_EARG also for time not in range, the last that is asked;
 *         COIN_EDOMAIN if no such factor was found by 100,000 trials of steps
 *         (docs/choosing.md).
 * Cost: that of 5 to 100 settlings of that time, at most some 0.1 s. */
COIN_API int32_t coin_losses_fit(coin_losses *l, const coin_state *s,
                                 const coin_params *p, double time);

/* ---------------------------------------------------------- a real coin -- */

/** What the table does to a real coin.  Initialise by member names. */
typedef struct coin_table {
    double mu_static;  /**< of Coulomb's friction, before the contact slips;
                            mu_kinetic to +infinity [1] */
    double mu_kinetic; /**< while it slips; 0 to the bound of Painleve, Eq. (86)
                            [1] */
    double restitution; /**< of an impact, 0 to 1 [1] */
    double pull[2];     /**< acceleration along x and z, of a slope or a tray;
                             of at most 100 gravity in size [L/T^2] */
    double reserved[3]; /**< must be 0 */
    coin_losses losses; /**< damping must be 0 */
} coin_table;

/** A real coin.  Whether it touches the table, rolls or slips is read off its
 * height and velocities: coin_move(). */
typedef struct coin_body {
    coin_state s; /**< where it is and how it turns */
    double y;     /**< height of the centre [L] */
    double vx;    /**< velocity of the centre [L/T] */
    double vy;
    double vz;
    double reserved[4]; /**< must be 0 */
} coin_body;

/** Whether a table, its losses included, is in range. */
COIN_API int32_t coin_table_check(const coin_table *table,
                                  const coin_params *p);

/** Makes a body of the state of a coin that rolls.  Eq. (20).
 * @return COIN_ESTATE also if the body is out of range. */
COIN_API int32_t coin_body_from_state(coin_body *b, const coin_state *s,
                                      const coin_params *p);

/** Makes a body of what a physics engine knows of it, in the air or on the
 * table.  If an engine's coin has a thickness and p has none, subtract
 * thickness/2 times |n_y| from y, n_y the vertical part of its axis, and add it
 * where the coin is drawn: |n_y| = |sin(theta)|.  If the face is horizontal,
 * theta is the last lean before pi/2, and psi = 0.
 * @param q       [4] as coin_state_from_motion() [1]
 * @param omega   [3] angular velocity in the table's frame [1/T]
 * @param r       [3] the centre.  Up to 0.1 radius below the height at which
 *                the coin touches, it is set on the table [L]
 * @param v       [3] velocity of the centre [L/T]
 * @return COIN_ESTATE also if y is lower, or as coin_body_from_state().
 * Cost: at most 1.4, with a thickness at most 1.7 textbook steps. */
COIN_API int32_t coin_body_from_motion(coin_body *b, const coin_params *p,
                                       const double q[4], const double omega[3],
                                       const double r[3], const double v[3]);

/** Moves a real coin by any time: it flies, bounces, slips, rolls, and comes to
 * rest.
 * @param t          the time, >= 0; +infinity: until it rests.  0 changes
 *                   nothing and tells the mode [T]
 * @param tol,reached  as coin_settle()
 * @param stop       0, or bits of the moments below: the call ends at the first
 *                   of them after its start, located to tol natural units
 * @return the mode at the end, or-ed with the moments that ended the call: 0,
 * it rolls; COIN_SLIPS; COIN_LIFTS, in the air, or an impact is due;
 * COIN_RESTS, all rates and velocities are 0.  So COIN_SLIPS says that it
 * slips, not that a slip begins: see MOMENTS.  COIN_MORE: 11,000 trials of
 * steps did not suffice; COIN_ERANGE: a member of b would leave its range; b is
 * then the body at *reached.  COIN_EARG also for tol or stop; COIN_ESTATE also
 * for a body below the table; COIN_ESTEP if t is out of range.  An angle within
 * a turn of the end of its range, or a place next to it, may leave it: the next
 * call is COIN_ESTATE.
 *
 * MODES are read off the members.  Let h be half of the thickness, and w the
 * sum |wX| + |wZ|, or |wX| + |wY| + |wZ| if h > 0.  A speed counts as 0 up to
 * 1e-10 sqrt(g a) + 16 u (a + h) w.  A body touches the table if its height y
 * is a cos(theta) + h |sin(theta)| within 16 u (a + h), and the normal speed of
 * its lowest point, coin_body_contact(), counts as 0; else it is in the air.
 * It rolls if it touches, its slip speed counts as 0, and the table can hold
 * it.  It lies flat if |theta| is the last lean before pi/2 and wX = wY = 0.
 * It is upright on both rims if h > 0 and theta = wX = 0.
 *
 * MOMENTS. What holds at the start is none; each is told once.
 *   COIN_SLIPS        the contact, or the face, begins to slide
 *   COIN_LIFTS        the coin leaves the table without an impact
 *   COIN_NEARLY_FLAT  cos(theta) falls below 0.01 while it touches, or it
 *                     begins to touch with less
 *   COIN_ROLLS        a slip, or a flight, has ended and it rolls
 *   COIN_TOUCHES      it comes down on the table, also with the other rim at
 *                     upright: b is the body before the impact, which the next
 *                     call with t > 0 makes
 *   COIN_DECIDED      its energy falls below that of balancing on a rim, M g
 *                     sqrt(a^2 + h^2): coin_body_face() is how it ends.  A thin
 *                     coin that ends on its edge tells none.  With a pull
 *                     COIN_EARG
 * At COIN_SLIPS and COIN_LIFTS the members still roll or touch; the mode is
 * what begins.  To tell a moment from a mode, keep `before`, the status of the
 * call before.  With COIN_TOUCHES and COIN_ROLLS in stop, a slip begins if
 * status & ~before & COIN_SLIPS; the coin leaves the table without an impact if
 * status & ~before & COIN_LIFTS, and not COIN_TOUCHES.  The time moved may be
 * 0: after an impact that does not bounce a slip begins at the same moment.  A
 * loop that tells each moment of a frame:
 *
 *     for (left = frame; left > 0 && status >= 0 && !(status & COIN_RESTS);
 *          left -= moved)
 *         status = coin_move(&b, &p, &table, left, tol, stop, &moved);
 *
 *   below 0                 it ends: an error
 *   COIN_RESTS              it ends: the coin does not move any more
 *   COIN_MORE, bits of stop it calls again, for the time that is left
 *   else                    it ends: the time is over
 *
 * MOTION. A slip begins where F exceeds mu_static N, Eq. (84), or where rolling
 * would need the table to hold it down.  The coin lifts off where N <= 0 and
 * the free acceleration of its lowest point is upward, Eq. (96).  In the air,
 * Eq. (99), (116), phi and psi come to lie in [-pi, pi]; where the face passes
 * the horizontal both jump by pi, and wX, wY change sign.  The +Z side, heads,
 * is up where theta < 0.  An impact below 1e-4 sqrt(g a) does not bounce, Eq.
 * (108), (114).  On its face the coin slides by mu_kinetic without losses, Eq.
 * (109), and wZ is the turn of the face; where mu_static is infinite it sticks;
 * flat it rests on a slope if |pull| <= mu_static g, Eq. (127).  A coin rests
 * on its edge if theta = wX = wY = 0, and |wZ| and its speed (natural) are <
 * 1e-10; against a pull only with a thickness, if its losses and mu_static hold
 * it.  With a thickness it rocks from rim to rim through upright, Eq.
 * (118)-(123), and stands where that gets slow, Eq. (128).
 *
 * Accuracy: of 100 random launches, 98 err by less than tol (1 + n) after n
 *         natural units (test_slide).  A flight errs by 1e-15 for each radian
 *         that it turns by (test_flight).  A face that is within 2e-15 rad of
 *         horizontal counts as horizontal.  A touch is located to 1e-15 over
 *         its normal speed (test_touch).  Of 1,000 excursions of F/N above
 *         mu_static by 1e-4 of it, 4 are missed at tol = 1e-5, and fewer below
 *         (test_excursions).  Bounces amplify errors (test_toss).  phi and psi
 *         of a thick coin that slips as it falls on its face may err by 1e-7.
 * Cost: docs/accuracy.md counts frames in which a coin rolls, slips, flies or
 *         bounces.  Coins near flat cost most, some 20 ms a call; with
 *         losses at the end of their ranges 0.2 s. */
COIN_API int32_t coin_move(coin_body *b, const coin_params *p,
                           const coin_table *table, double t, double tol,
                           int32_t stop, double *reached);

/** Kinetic plus potential energy [M L^2/T^2].  Eq. (88).
 * Accuracy: 12 u of the terms. */
COIN_API double coin_body_energy(const coin_body *b, const coin_params *p);

/** The force of the table: what rolling needs; if that leaves the cone of
 * mu_static, the force of the slip that begins; of a body that slips mu_kinetic
 * N against the slip; at rest M g, and what holds the coin against the pull; 0
 * in the air, and where the table would have to pull.  Eq. (79)-(82), (84).
 * Accuracy: 32 u of the terms over cos(theta); where losses hold the contact, a
 *         roll below 1e-7 of the rates of the fall is left out.
 * Cost: 1.1 textbook steps; where a slip begins, whose direction is searched
 *         for, at most 8 textbook steps. */
COIN_API int32_t coin_body_reaction(const coin_body *b, const coin_params *p,
                                    const coin_table *table, coin_force *out);

/** The velocity of the lowest material point, in the air too; of a body that
 * lies flat, that of its centre.  At COIN_TOUCHES -v[1] is the speed of the
 * impact; of a coin on the table v[0] and v[2] are its slip.  Eq. (77), (105).
 * @param[out] v  [3] along x, y and z [L/T]
 * Accuracy: 8 u of the terms. */
COIN_API int32_t coin_body_contact(const coin_body *b, const coin_params *p,
                                   double v[3]);

/** A blow: gives a body the impulse J at a place, in the air or on the table,
 * for which the next coin_move() answers.  Eq. (129).
 * @param J  [3] along x, y and z [M L/T]
 * @param r  [3] the place, from the centre, along x, y and z too [L]
 * @return COIN_ESTATE also if the body is out of range then; b stays.
 * Accuracy: 8 u of the terms (make adversary). */
COIN_API int32_t coin_body_strike(coin_body *b, const coin_params *p,
                                  const double J[3], const double r[3]);

/** Which side is up: COIN_HEADS, COIN_TAILS; COIN_EDGE, the coin is upright or
 * would fall back on its edge: |tan(theta)| <= thickness/(2 radius).  After
 * COIN_DECIDED it is how the coin ends. */
COIN_API int32_t coin_body_face(const coin_body *b, const coin_params *p);

/** coin_matrix() of a body: with its own height.
 * Cost: at most 1.1 textbook steps. */
COIN_API int32_t coin_body_matrix(const coin_body *b, const coin_params *p,
                                  double m[16]);

/* ------------------------------------------------ version and self-test -- */

/** The library's version, 0xMMmmpp, to compare with COIN_VERSION_ macros. */
COIN_API uint32_t coin_version(void);

/** The same as text, such as "1.2.3". */
COIN_API const char *coin_version_string(void);

/** What a status means, in English, without a full stop; never null. */
COIN_API const char *coin_status_string(int32_t status);

/** The size of a public struct as the library was compiled, for bindings: 64
 * for "coin_state"; 0 if `type` is null or no struct's name. */
COIN_API uint32_t coin_sizeof(const char *type);

/** Whether this build computes the pinned bits, and knows NaN: moves three
 * coins by 100 steps of each method, and as far by coin_advance().  Those of
 * coin_settle(), coin_move() and orbits are pinned by make repro.
 * @return COIN_OK; COIN_EBUILD if the compiler fused or reordered arithmetic
 *         (fast-math, contraction) or takes NaN for a number, or the rounding
 *         mode is not to-nearest.
 * Cost: some 1,200 textbook steps. */
COIN_API int32_t coin_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
