/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_COINF_H
#define ROLLCOIN_COINF_H
#include <coin.h>
#ifdef __cplusplus
extern "C" {
#endif
typedef struct coinf_params {
    float mass;
    float radius;
    float gravity;
    float inertia_X;
    float inertia_Z;
    float thickness;
    float reserved[2];
} coinf_params;
typedef struct coinf_state {
    float theta;
    float phi;
    float psi;
    float x;
    float z;
    float wX;
    float wY;
    float wZ;
    float low[8];
} coinf_state;
typedef struct coinf_force {
    float R[3];
    float normal;
    float friction;
    float ratio;
} coinf_force;
COIN_API int32_t coinf_params_disc(coinf_params *p, float mass, float radius,
                                   float gravity);
COIN_API int32_t coinf_params_ring(coinf_params *p, float mass, float radius,
                                   float inner_radius, float gravity);
COIN_API int32_t coinf_params_body(coinf_params *p, float mass, float radius,
                                   float gravity, float inertia_X,
                                   float inertia_Z);
COIN_API int32_t coinf_params_check(const coinf_params *p);
COIN_API int32_t coinf_state_check(const coinf_state *s, const coinf_params *p);
COIN_API int32_t coinf_state_from_motion(coinf_state *s, const coinf_params *p,
                                         const float q[4], const float omega[3],
                                         float x, float z);
COIN_API int32_t coinf_angular_velocity(const coinf_state *s, float omega[3]);
COIN_API int32_t coinf_step(coinf_state *s, const coinf_params *p, float dt);
COIN_API int32_t coinf_run(coinf_state *s, const coinf_params *p,
                           int32_t method, float dt, uint64_t steps,
                           uint64_t *done);
COIN_API float coinf_energy(const coinf_state *s, const coinf_params *p);
COIN_API int32_t coinf_integrals(const coinf_state *s, const coinf_params *p,
                                 float K[2]);
COIN_API int32_t coinf_reaction(const coinf_state *s, const coinf_params *p,
                                coinf_force *out);
COIN_API int32_t coinf_rates(const coinf_state *s, const coinf_params *p,
                             coinf_state *out);
COIN_API int32_t coinf_center(const coinf_state *s, const coinf_params *p,
                              float r[3]);
COIN_API int32_t coinf_velocity(const coinf_state *s, const coinf_params *p,
                                float v[3]);
COIN_API int32_t coinf_contact(const coinf_state *s, const coinf_params *p,
                               float r[3], float v[3]);
COIN_API int32_t coinf_axes(const coinf_state *s, float R[9]);
COIN_API int32_t coinf_quaternion(const coinf_state *s, float q[4]);
COIN_API int32_t coinf_matrix(const coinf_state *s, const coinf_params *p,
                              float m[16]);
COIN_API float coinf_fastest_rate(const coinf_state *s, const coinf_params *p);
COIN_API int32_t coinf_check(const coinf_state *s, const coinf_params *p,
                             int32_t method, float dt, float mu);
COIN_API int32_t coinf_selftest(void);
#ifdef __cplusplus
}
#endif
#endif
