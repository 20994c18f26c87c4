// SPDX-License-Identifier: MIT
// The types of rollcoin.mjs: by `make bindings-update`.

/** What the library is given by a pointer: from struct(), doubles(), ... */
export type Doubles = Float64Array;
/** From ints(). */
export type Ints = Int32Array;
/** From longs(). */
export type Longs = BigUint64Array;
export type StructName = keyof Structs;
export type Losses = { damping?: number; dry?: number; viscous?: number; layer?: number; gap?: number; rolling?: number; spin?: number; angular?: number; soft?: number; flat?: number };
export type Structs = { coin_params: coin_params; coin_state: coin_state; coin_force: coin_force; coin_orbit: coin_orbit; coin_losses: coin_losses; coin_table: coin_table; coin_body: coin_body };

// The structs of coin.h: members by name, or by place.
export interface coin_params extends Doubles {
  /** M [M] */ mass: number;
  /** a, of the rim that rolls [L] */ radius: number;
  /** g [L/T^2] */ gravity: number;
  /** I_X = I_Y, about a diameter [M L^2] */ inertia_X: number;
  /** I_Z, about the axis [M L^2] */ inertia_Z: number;
  /** between the two rims: 1e-4 to 4 radii; or 0, a thin coin, which most functions ask for [L] */ thickness: number;
}
export interface coin_state extends Doubles {
  /** lean, -pi/2 < theta < pi/2 [rad] */ theta: number;
  /** heading, |phi| <= 2^31 [rad] */ phi: number;
  /** roll, |psi| <= 2^31 [rad] */ psi: number;
  /** of the centre [L] */ x: number;
  /** of the centre [L] */ z: number;
  /** omega_X = d(theta)/dt [1/T] */ wX: number;
  /** omega_Y [1/T] */ wY: number;
  /** omega_Z [1/T] */ wZ: number;
}
export interface coin_force extends Doubles {
  /** in the table frame x, y, z [M L/T^2] */ readonly R: Doubles;
  /** N = R_y [M L/T^2] */ normal: number;
  /** F = sqrt(R_x^2 + R_z^2) [M L/T^2] */ friction: number;
  /** F/N [1]; +infinity if N <= 0 */ ratio: number;
}
export interface coin_orbit extends Doubles {
  /** of theta; 0 if the motion is steady [T] */ period: number;
  /** what phi gains in it [rad] */ heading_per_period: number;
  /** what psi gains in it [rad] */ roll_per_period: number;
  /** the turning points of the lean [rad] */ theta_min: number;
  theta_max: number;
  /** x, z of the centre of the annulus that the path fills; NaN if it drifts [L] */ readonly center: Doubles;
  /** of the annulus; NaN if it drifts [L] */ radius_min: number;
  radius_max: number;
  /** x, z of the displacement per period, if heading_per_period is k 2 pi; else 0 [L] */ readonly drift: Doubles;
  /** growth of rounding in a period, >= 1 [1] */ conditioning: number;
}
export interface coin_losses extends Doubles {
  /** a torque damping |d(psi)/dt| times the angular momentum; of a coin that rolls [1] */ damping: number;
  /** a torque against the rolling of the contact along the rim, independent of its rate [M L^2/T^2] */ dry: number;
  /** the same, proportional to that rate [M L^2/T] */ viscous: number;
  /** the same, to its power 3/2: the boundary layer of the air [M L^2/T^(1/2)] */ layer: number;
  /** the same, to the rate over cos(theta): the air in the gap below the coin [M L^2/T] */ gap: number;
  /** dry times cos(theta): the rolling moment of engines [M L^2/T^2] */ rolling: number;
  /** pivoting friction: a torque proportional to the turn about the vertical [M L^2/T] */ spin: number;
  /** the angular damping of engines: the torque -angular (I_X wX, I_X wY, I_Z wZ) [1/T] */ angular: number;
  /** the rate of roll below which dry and rolling fade; 0 stands for sqrt(g/a)/1024 [1/T] */ soft: number;
  /** a coin whose cos(theta) comes below this lies flat; 0 stands for 1e-6 [rad] */ flat: number;
}
export interface coin_table extends Doubles {
  /** of Coulomb's friction, before the contact slips; mu_kinetic to +infinity [1] */ mu_static: number;
  /** while it slips; 0 to the bound of Painleve, Eq. (86) [1] */ mu_kinetic: number;
  /** of an impact, 0 to 1 [1] */ restitution: number;
  /** acceleration along x and z, of a slope or a tray; of at most 100 gravity in size [L/T^2] */ readonly pull: Doubles;
  /** damping must be 0 */ readonly losses: coin_losses;
}
export interface coin_body extends Doubles {
  /** where it is and how it turns */ readonly s: coin_state;
  /** height of the centre [L] */ y: number;
  /** velocity of the centre [L/T] */ vx: number;
  vy: number;
  vz: number;
}

/** Of the bytes of rollcoin.wasm; by itself of that which is beside this file. */
export function load(bytes?: BufferSource): Promise<Coin>;

export interface Coin {
  /** So many zeros. */
  doubles(count: number): Doubles;
  /** The same, for an int32_t or size_t. */
  ints(count: number): Ints;
  /** The same, for a uint64_t. */
  longs(count: number): Longs;
  /** The zeros of a struct of coin.h. */
  struct<Name extends StructName>(name: Name): Structs[Name];
  /** An array of C's, which is passed by the first. */
  structs<Name extends StructName>(name: Name, count: number): Structs[Name][];
  /** A coin_losses of these, or the losses of a coin_table. */
  losses(named: Losses): coin_losses;
  losses<Into extends coin_losses | coin_table>(named: Losses, into: Into): Into;
  /** done */ readonly COIN_OK: number;
  /** parameters, losses or a table out of range */ readonly COIN_EPARAMS: number;
  /** a state or a body out of range */ readonly COIN_ESTATE: number;
  /** dt or t out of range, or a step beyond its method */ readonly COIN_ESTEP: number;
  /** null pointer, unknown method, branch or bit, tol */ readonly COIN_EARG: number;
  /** no such steady motion, period or losses; or not a steady motion */ readonly COIN_EDOMAIN: number;
  /** the coin falls flat within the time asked */ readonly COIN_EFLAT: number;
  /** not the pinned bits: coin_selftest() */ readonly COIN_EBUILD: number;
  /** phi, psi, a place or a rate would leave its range, or a step is refused within 16 rad or radii of its end */ readonly COIN_ERANGE: number;
  /** F > mu N > 0: a real coin slips */ readonly COIN_SLIPS: number;
  /** N <= 0; of a body: it is off the table */ readonly COIN_LIFTS: number;
  /** |dt| coin_fastest_rate() is above 0.35 (RK4), 1 (RK8), 0.08, 0.16 (symplectic methods) */ readonly COIN_COARSE: number;
  /** cos(theta) < 0.01 */ readonly COIN_NEARLY_FLAT: number;
  /** the coin lies flat, or stands, and stays */ readonly COIN_RESTS: number;
  /** a slip or a flight has ended, and it rolls */ readonly COIN_ROLLS: number;
  /** the coin comes down on the table */ readonly COIN_TOUCHES: number;
  /** the steps of one call did not suffice: it has moved by `reached` */ readonly COIN_MORE: number;
  /** which side ends up is decided */ readonly COIN_DECIDED: number;
  /** the +Z side is up: theta < 0 */ readonly COIN_HEADS: number;
  /** the other side is up */ readonly COIN_TAILS: number;
  /** upright, or it would fall back on its edge */ readonly COIN_EDGE: number;
  /** classical Runge-Kutta, order 4 */ readonly COIN_RK4: number;
  /** Dormand-Prince, 12 stages, order 8 */ readonly COIN_RK8: number;
  /** kick-drift-kick with the exact drift, order 2 */ readonly COIN_SYMPLECTIC2: number;
  /** Chin 4A with the exact drift, order 4 */ readonly COIN_SYMPLECTIC4: number;
  coin_step(s: Doubles | null, p: Doubles | null, dt: number): number;
  coin_run(s: Doubles | null, p: Doubles | null, method: number, dt: number, steps: bigint, done: Longs | null): number;
  coin_sample(start: Doubles | null, p: Doubles | null, method: number, dt: number, steps_per_sample: bigint, count: number, result: Doubles | null, done: Ints | null): number;
  coin_batch_run(s: Doubles | null, count: number, p: Doubles | null, method: number, dt: number, steps: bigint, status: Ints | null): number;
  coin_advance(s: Doubles | null, p: Doubles | null, t: number, tol: number, reached: Doubles | null): number;
  coin_method_name(method: number): string | null;
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
