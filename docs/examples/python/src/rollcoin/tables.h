/* SPDX-License-Identifier: MIT */
/* The functions of coin.h and coinf.h that read or move a coin, for each of a
 * table; and those that give a state at a time, for a table of times: by
 * `make bindings-update`. */
EACH(each_coin_advance, (coin_state *s, const coin_params *p, double t,
     double tol, double *reached), coin_advance(s + i, p, t, tol, reached + i))
EACH(each_coin_state_check, (const coin_state *s, const coin_params *p),
     coin_state_check(s + i, p))
EACH(each_coin_angular_velocity, (const coin_state *s, double *omega),
     coin_angular_velocity(s + i, omega + 3 * i))
EACH_NUMBER(coin_energy, double, (const coin_state *s, const coin_params *p),
     (s + i, p))
EACH(each_coin_integrals, (const coin_state *s, const coin_params *p,
     double *K), coin_integrals(s + i, p, K + 2 * i))
EACH(each_coin_reaction, (const coin_state *s, const coin_params *p,
     coin_force *out), coin_reaction(s + i, p, out + i))
EACH(each_coin_rates, (const coin_state *s, const coin_params *p,
     coin_state *out), coin_rates(s + i, p, out + i))
EACH(each_coin_center, (const coin_state *s, const coin_params *p, double *r),
     coin_center(s + i, p, r + 3 * i))
EACH(each_coin_velocity, (const coin_state *s, const coin_params *p, double *v),
     coin_velocity(s + i, p, v + 3 * i))
EACH(each_coin_contact, (const coin_state *s, const coin_params *p, double *r,
     double *v), coin_contact(s + i, p, r + 3 * i, v + 3 * i))
EACH(each_coin_axes, (const coin_state *s, double *R), coin_axes(s + i,
     R + 9 * i))
EACH(each_coin_quaternion, (const coin_state *s, double *q),
     coin_quaternion(s + i, q + 4 * i))
EACH(each_coin_matrix, (const coin_state *s, const coin_params *p, double *m),
     coin_matrix(s + i, p, m + 16 * i))
EACH_NUMBER(coin_fastest_rate, double, (const coin_state *s,
     const coin_params *p), (s + i, p))
EACH(each_coin_check, (const coin_state *s, const coin_params *p,
     int32_t method, double dt, double mu), coin_check(s + i, p, method, dt,
     mu))
EACH(each_coin_steady_radii, (const coin_state *s, const coin_params *p,
     double *center, double *contact), coin_steady_radii(s + i, p, center + i,
     contact + i))
EACH(each_coin_stability, (const coin_state *s, const coin_params *p,
     double *lambda2), coin_stability(s + i, p, lambda2 + i))
EACH(each_coin_steady_at, (const coin_state *s, const coin_params *p, double t,
     coin_state *out), coin_steady_at(s + i, p, t, out + i))
EACH(times_coin_steady_at, (const coin_state *s, const coin_params *p,
     const double *t, coin_state *out), coin_steady_at(s, p, t[i], out + i))
EACH(times_coin_orbit_at, (const coin_orbit *o, const double *t,
     coin_state *out), coin_orbit_at(o, t[i], out + i))
EACH_NUMBER(coin_losses_power, double, (const coin_state *s,
     const coin_params *p, const coin_losses *l), (s + i, p, l))
EACH(each_coin_losses_rates, (const coin_state *s, const coin_params *p,
     const coin_losses *l, coin_state *out), coin_losses_rates(s + i, p, l,
     out + i))
EACH(each_coin_losses_reaction, (const coin_state *s, const coin_params *p,
     const coin_losses *l, coin_force *out), coin_losses_reaction(s + i, p, l,
     out + i))
EACH(each_coin_settle, (coin_state *s, const coin_params *p,
     const coin_losses *l, double t, double tol, double *reached),
     coin_settle(s + i, p, l, t, tol, reached + i))
EACH_NUMBER(coin_time_to_rest, double, (const coin_state *s,
     const coin_params *p, const coin_losses *l, double tol), (s + i, p, l,
     tol))
EACH(each_coin_move, (coin_body *b, const coin_params *p,
     const coin_table *table, double t, double tol, int32_t stop,
     double *reached), coin_move(b + i, p, table, t, tol, stop, reached + i))
EACH_NUMBER(coin_body_energy, double, (const coin_body *b,
     const coin_params *p), (b + i, p))
EACH(each_coin_body_reaction, (const coin_body *b, const coin_params *p,
     const coin_table *table, coin_force *out), coin_body_reaction(b + i, p,
     table, out + i))
EACH(each_coin_body_contact, (const coin_body *b, const coin_params *p,
     double *v), coin_body_contact(b + i, p, v + 3 * i))
EACH(each_coin_body_face, (const coin_body *b, const coin_params *p),
     coin_body_face(b + i, p))
EACH(each_coin_body_matrix, (const coin_body *b, const coin_params *p,
     double *m), coin_body_matrix(b + i, p, m + 16 * i))
EACH(each_coinf_state_check, (const coinf_state *s, const coinf_params *p),
     coinf_state_check(s + i, p))
EACH(each_coinf_angular_velocity, (const coinf_state *s, float *omega),
     coinf_angular_velocity(s + i, omega + 3 * i))
EACH_NUMBER(coinf_energy, float, (const coinf_state *s, const coinf_params *p),
     (s + i, p))
EACH(each_coinf_integrals, (const coinf_state *s, const coinf_params *p,
     float *K), coinf_integrals(s + i, p, K + 2 * i))
EACH(each_coinf_reaction, (const coinf_state *s, const coinf_params *p,
     coinf_force *out), coinf_reaction(s + i, p, out + i))
EACH(each_coinf_rates, (const coinf_state *s, const coinf_params *p,
     coinf_state *out), coinf_rates(s + i, p, out + i))
EACH(each_coinf_center, (const coinf_state *s, const coinf_params *p, float *r),
     coinf_center(s + i, p, r + 3 * i))
EACH(each_coinf_velocity, (const coinf_state *s, const coinf_params *p,
     float *v), coinf_velocity(s + i, p, v + 3 * i))
EACH(each_coinf_contact, (const coinf_state *s, const coinf_params *p, float *r,
     float *v), coinf_contact(s + i, p, r + 3 * i, v + 3 * i))
EACH(each_coinf_axes, (const coinf_state *s, float *R), coinf_axes(s + i,
     R + 9 * i))
EACH(each_coinf_quaternion, (const coinf_state *s, float *q),
     coinf_quaternion(s + i, q + 4 * i))
EACH(each_coinf_matrix, (const coinf_state *s, const coinf_params *p, float *m),
     coinf_matrix(s + i, p, m + 16 * i))
EACH_NUMBER(coinf_fastest_rate, float, (const coinf_state *s,
     const coinf_params *p), (s + i, p))
EACH(each_coinf_check, (const coinf_state *s, const coinf_params *p,
     int32_t method, float dt, float mu), coinf_check(s + i, p, method, dt, mu))
