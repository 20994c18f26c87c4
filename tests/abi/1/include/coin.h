/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_COIN_H
#define ROLLCOIN_COIN_H
#include <stddef.h>
#include <stdint.h>
#define COIN_VERSION_MAJOR 1
#define COIN_VERSION_MINOR 0
#define COIN_VERSION_PATCH 0
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
typedef struct coin_params {
    double mass;
    double radius;
    double gravity;
    double inertia_X;
    double inertia_Z;
    double thickness;
    double reserved[2];
} coin_params;
typedef struct coin_state {
    double theta;
    double phi;
    double psi;
    double x;
    double z;
    double wX;
    double wY;
    double wZ;
} coin_state;
typedef struct coin_force {
    double R[3];
    double normal;
    double friction;
    double ratio;
} coin_force;
enum {
    COIN_OK = 0,
    COIN_EPARAMS = -1,
    COIN_ESTATE = -2,
    COIN_ESTEP = -3,
    COIN_EARG = -4,
    COIN_EDOMAIN = -5,
    COIN_EFLAT = -6,
    COIN_EBUILD = -7,
    COIN_ERANGE = -9
};
enum {
    COIN_SLIPS = 1,
    COIN_LIFTS = 2,
    COIN_COARSE = 4,
    COIN_NEARLY_FLAT = 8,
    COIN_RESTS = 16,
    COIN_ROLLS = 32,
    COIN_TOUCHES = 64,
    COIN_MORE = 128,
    COIN_DECIDED = 256
};
enum {
    COIN_HEADS = 1,
    COIN_TAILS = 2,
    COIN_EDGE = 3
};
enum {
    COIN_RK4 = 0,
    COIN_RK8 = 1,
    COIN_SYMPLECTIC2 = 2,
    COIN_SYMPLECTIC4 = 3
};
COIN_API int32_t coin_step(coin_state *s, const coin_params *p, double dt);
COIN_API int32_t coin_run(coin_state *s, const coin_params *p, int32_t method,
                          double dt, uint64_t steps, uint64_t *done);
COIN_API int32_t coin_sample(const coin_state *start, const coin_params *p,
                             int32_t method, double dt,
                             uint64_t steps_per_sample, size_t count,
                             coin_state *out, size_t *done);
COIN_API int32_t coin_batch_run(coin_state *s, size_t count,
                                const coin_params *p, int32_t method, double dt,
                                uint64_t steps, int32_t *status);
COIN_API int32_t coin_advance(coin_state *s, const coin_params *p, double t,
                              double tol, double *reached);
COIN_API const char *coin_method_name(int32_t method);
COIN_API int32_t coin_params_disc(coin_params *p, double mass, double radius,
                                  double gravity);
COIN_API int32_t coin_params_ring(coin_params *p, double mass, double radius,
                                  double inner_radius, double gravity);
COIN_API int32_t coin_params_body(coin_params *p, double mass, double radius,
                                  double gravity, double inertia_X,
                                  double inertia_Z);
COIN_API int32_t coin_params_cylinder(coin_params *p, double mass,
                                      double radius, double thickness,
                                      double gravity);
COIN_API int32_t coin_params_check(const coin_params *p);
COIN_API int32_t coin_state_check(const coin_state *s, const coin_params *p);
COIN_API int32_t coin_state_from_motion(coin_state *s, const coin_params *p,
                                        const double q[4],
                                        const double omega[3], double x,
                                        double z);
COIN_API int32_t coin_angular_velocity(const coin_state *s, double omega[3]);
COIN_API double coin_energy(const coin_state *s, const coin_params *p);
COIN_API int32_t coin_integrals(const coin_state *s, const coin_params *p,
                                double K[2]);
COIN_API int32_t coin_reaction(const coin_state *s, const coin_params *p,
                               coin_force *out);
COIN_API int32_t coin_rates(const coin_state *s, const coin_params *p,
                            coin_state *out);
COIN_API int32_t coin_center(const coin_state *s, const coin_params *p,
                             double r[3]);
COIN_API int32_t coin_velocity(const coin_state *s, const coin_params *p,
                               double v[3]);
COIN_API int32_t coin_contact(const coin_state *s, const coin_params *p,
                              double r[3], double v[3]);
COIN_API int32_t coin_axes(const coin_state *s, double R[9]);
COIN_API int32_t coin_quaternion(const coin_state *s, double q[4]);
COIN_API int32_t coin_matrix(const coin_state *s, const coin_params *p,
                             double m[16]);
COIN_API double coin_fastest_rate(const coin_state *s, const coin_params *p);
COIN_API int32_t coin_check(const coin_state *s, const coin_params *p,
                            int32_t method, double dt, double mu);
COIN_API int32_t coin_steady_roll(coin_state *s, const coin_params *p,
                                  double wZ);
COIN_API int32_t coin_steady_spin(coin_state *s, const coin_params *p,
                                  double theta);
COIN_API int32_t coin_steady_upright_spin(coin_state *s, const coin_params *p,
                                          double wY);
COIN_API int32_t coin_steady_circle(coin_state *s, const coin_params *p,
                                    double theta, double wZ, int32_t branch);
COIN_API int32_t coin_steady_turn(coin_state *s, const coin_params *p,
                                  double theta, double radius);
COIN_API int32_t coin_steady_ride(coin_state *s, const coin_params *p,
                                  double speed, double radius);
COIN_API int32_t coin_steady_radii(const coin_state *s, const coin_params *p,
                                   double *center, double *contact);
COIN_API int32_t coin_stability(const coin_state *s, const coin_params *p,
                                double *lambda2);
COIN_API double coin_critical_roll(const coin_params *p);
COIN_API double coin_critical_spin(const coin_params *p);
COIN_API int32_t coin_steady_at(const coin_state *s, const coin_params *p,
                                double t, coin_state *out);
typedef struct coin_orbit {
    double period;
    double heading_per_period;
    double roll_per_period;
    double theta_min;
    double theta_max;
    double center[2];
    double radius_min;
    double radius_max;
    double drift[2];
    double conditioning;
    double reserved[26];
    double private_frame[32];
    double private_edges[48];
    double private_centers[42];
    double private_terms[3780];
    double private_spare[156];
} coin_orbit;
COIN_API int32_t coin_orbit_init(coin_orbit *o, const coin_state *s,
                                 const coin_params *p);
COIN_API int32_t coin_orbit_at(const coin_orbit *o, double t, coin_state *out);
typedef struct coin_losses {
    double damping;
    double dry;
    double viscous;
    double layer;
    double gap;
    double rolling;
    double spin;
    double angular;
    double soft;
    double flat;
    double reserved[2];
} coin_losses;
COIN_API int32_t coin_losses_check(const coin_losses *l, const coin_params *p);
COIN_API double coin_losses_power(const coin_state *s, const coin_params *p,
                                  const coin_losses *l);
COIN_API int32_t coin_losses_rates(const coin_state *s, const coin_params *p,
                                   const coin_losses *l, coin_state *out);
COIN_API int32_t coin_losses_reaction(const coin_state *s, const coin_params *p,
                                      const coin_losses *l, coin_force *out);
COIN_API int32_t coin_settle(coin_state *s, const coin_params *p,
                             const coin_losses *l, double t, double tol,
                             double *reached);
COIN_API double coin_time_to_rest(const coin_state *s, const coin_params *p,
                                  const coin_losses *l, double tol);
COIN_API int32_t coin_losses_fit(coin_losses *l, const coin_state *s,
                                 const coin_params *p, double time);
typedef struct coin_table {
    double mu_static;
    double mu_kinetic;
    double restitution;
    double pull[2];
    double reserved[3];
    coin_losses losses;
} coin_table;
typedef struct coin_body {
    coin_state s;
    double y;
    double vx;
    double vy;
    double vz;
    double reserved[4];
} coin_body;
COIN_API int32_t coin_table_check(const coin_table *table,
                                  const coin_params *p);
COIN_API int32_t coin_body_from_state(coin_body *b, const coin_state *s,
                                      const coin_params *p);
COIN_API int32_t coin_body_from_motion(coin_body *b, const coin_params *p,
                                       const double q[4], const double omega[3],
                                       const double r[3], const double v[3]);
COIN_API int32_t coin_move(coin_body *b, const coin_params *p,
                           const coin_table *table, double t, double tol,
                           int32_t stop, double *reached);
COIN_API double coin_body_energy(const coin_body *b, const coin_params *p);
COIN_API int32_t coin_body_reaction(const coin_body *b, const coin_params *p,
                                    const coin_table *table, coin_force *out);
COIN_API int32_t coin_body_contact(const coin_body *b, const coin_params *p,
                                   double v[3]);
COIN_API int32_t coin_body_strike(coin_body *b, const coin_params *p,
                                  const double J[3], const double r[3]);
COIN_API int32_t coin_body_face(const coin_body *b, const coin_params *p);
COIN_API int32_t coin_body_matrix(const coin_body *b, const coin_params *p,
                                  double m[16]);
COIN_API uint32_t coin_version(void);
COIN_API const char *coin_version_string(void);
COIN_API const char *coin_status_string(int32_t status);
COIN_API uint32_t coin_sizeof(const char *type);
COIN_API int32_t coin_selftest(void);
#ifdef __cplusplus
}
#endif
#endif
