// SPDX-License-Identifier: MIT
// The types of rollcoin.mjs: by `make bindings-update`.

/** What the library is given by a pointer: from struct() or doubles(). */
export type Doubles = Float64Array;
export type StructName = "coin_params" | "coin_state" | "coin_force" | "coin_orbit" | "coin_losses" | "coin_table" | "coin_body";
export type Losses = { damping?: number; dry?: number; viscous?: number; layer?: number; gap?: number; rolling?: number; spin?: number; angular?: number; soft?: number; flat?: number };

/** Of the bytes of rollcoin.wasm; by itself of that which is beside this file. */
export function load(bytes?: BufferSource): Promise<Coin>;

export interface Coin {
  /** So many zeros. */
  doubles(count: number): Doubles;
  /** The zeros of a struct of coin.h. */
  struct(name: StructName): Doubles;
  /** A coin_losses of these, or the losses of a coin_table. */
  losses(named: Losses, into?: Doubles): Doubles;
  coin_step(s: Doubles | null, p: Doubles | null, dt: number): number;
  coin_run(s: Doubles | null, p: Doubles | null, method: number, dt: number, steps: bigint, done: Doubles | null): number;
  coin_sample(start: Doubles | null, p: Doubles | null, method: number, dt: number, steps_per_sample: bigint, count: number, result: Doubles | null, done: Doubles | null): number;
  coin_batch_run(s: Doubles | null, count: number, p: Doubles | null, method: number, dt: number, steps: bigint, status: Doubles | null): number;
  coin_advance(s: Doubles | null, p: Doubles | null, t: number, tol: number, reached: Doubles | null): number;
  coin_method_name(method: number): string;
  coin_params_disc(p: Doubles | null, mass: number, radius: number, gravity: number): number;
  coin_params_ring(p: Doubles | null, mass: number, radius: number, inner_radius: number, gravity: number): number;
  coin_params_body(p: Doubles | null, mass: number, radius: number, gravity: number, inertia_X: number, inertia_Z: number): number;
  coin_params_cylinder(p: Doubles | null, mass: number, radius: number, thickness: number, gravity: number): number;
  coin_params_check(p: Doubles | null): number;
  coin_state_check(s: Doubles | null, p: Doubles | null): number;
  coin_state_from_motion(s: Doubles | null, p: Doubles | null, q: Doubles | null, omega: Doubles | null, x: number, z: number): number;
  coin_angular_velocity(s: Doubles | null, omega: Doubles | null): number;
  coin_energy(s: Doubles | null, p: Doubles | null): number;
  coin_integrals(s: Doubles | null, p: Doubles | null, K: Doubles | null): number;
  coin_reaction(s: Doubles | null, p: Doubles | null, result: Doubles | null): number;
  coin_rates(s: Doubles | null, p: Doubles | null, result: Doubles | null): number;
  coin_center(s: Doubles | null, p: Doubles | null, r: Doubles | null): number;
  coin_velocity(s: Doubles | null, p: Doubles | null, v: Doubles | null): number;
  coin_contact(s: Doubles | null, p: Doubles | null, r: Doubles | null, v: Doubles | null): number;
  coin_axes(s: Doubles | null, R: Doubles | null): number;
  coin_quaternion(s: Doubles | null, q: Doubles | null): number;
  coin_matrix(s: Doubles | null, p: Doubles | null, m: Doubles | null): number;
  coin_fastest_rate(s: Doubles | null, p: Doubles | null): number;
  coin_check(s: Doubles | null, p: Doubles | null, method: number, dt: number, mu: number): number;
  coin_steady_roll(s: Doubles | null, p: Doubles | null, wZ: number): number;
  coin_steady_spin(s: Doubles | null, p: Doubles | null, theta: number): number;
  coin_steady_upright_spin(s: Doubles | null, p: Doubles | null, wY: number): number;
  coin_steady_circle(s: Doubles | null, p: Doubles | null, theta: number, wZ: number, branch: number): number;
  coin_steady_turn(s: Doubles | null, p: Doubles | null, theta: number, radius: number): number;
  coin_steady_ride(s: Doubles | null, p: Doubles | null, speed: number, radius: number): number;
  coin_steady_radii(s: Doubles | null, p: Doubles | null, center: Doubles | null, contact: Doubles | null): number;
  coin_stability(s: Doubles | null, p: Doubles | null, lambda2: Doubles | null): number;
  coin_critical_roll(p: Doubles | null): number;
  coin_critical_spin(p: Doubles | null): number;
  coin_steady_at(s: Doubles | null, p: Doubles | null, t: number, result: Doubles | null): number;
  coin_orbit_init(o: Doubles | null, s: Doubles | null, p: Doubles | null): number;
  coin_orbit_at(o: Doubles | null, t: number, result: Doubles | null): number;
  coin_losses_check(l: Doubles | null, p: Doubles | null): number;
  coin_losses_power(s: Doubles | null, p: Doubles | null, l: Doubles | null): number;
  coin_losses_rates(s: Doubles | null, p: Doubles | null, l: Doubles | null, result: Doubles | null): number;
  coin_losses_reaction(s: Doubles | null, p: Doubles | null, l: Doubles | null, result: Doubles | null): number;
  coin_settle(s: Doubles | null, p: Doubles | null, l: Doubles | null, t: number, tol: number, reached: Doubles | null): number;
  coin_time_to_rest(s: Doubles | null, p: Doubles | null, l: Doubles | null, tol: number): number;
  coin_losses_fit(l: Doubles | null, s: Doubles | null, p: Doubles | null, time: number): number;
  coin_table_check(table: Doubles | null, p: Doubles | null): number;
  coin_body_from_state(b: Doubles | null, s: Doubles | null, p: Doubles | null): number;
  coin_body_from_motion(b: Doubles | null, p: Doubles | null, q: Doubles | null, omega: Doubles | null, r: Doubles | null, v: Doubles | null): number;
  coin_move(b: Doubles | null, p: Doubles | null, table: Doubles | null, t: number, tol: number, stop: number, reached: Doubles | null): number;
  coin_body_energy(b: Doubles | null, p: Doubles | null): number;
  coin_body_reaction(b: Doubles | null, p: Doubles | null, table: Doubles | null, result: Doubles | null): number;
  coin_body_contact(b: Doubles | null, p: Doubles | null, v: Doubles | null): number;
  coin_body_strike(b: Doubles | null, p: Doubles | null, J: Doubles | null, r: Doubles | null): number;
  coin_body_face(b: Doubles | null, p: Doubles | null): number;
  coin_body_matrix(b: Doubles | null, p: Doubles | null, m: Doubles | null): number;
  coin_version(): number;
  coin_version_string(): string;
  coin_status_string(status: number): string;
  coin_selftest(): number;
}
