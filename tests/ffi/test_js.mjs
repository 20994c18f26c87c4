// SPDX-License-Identifier: MIT
// docs/examples/js with a coin that has an edge: tossed, on a slope, struck, refused.
//     node test_js.mjs rollcoin.wasm
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { load } from "../../docs/examples/js/rollcoin.mjs";

const coin = await load(readFileSync(process.argv[2]));
const [p, table, body] = ["coin_params", "coin_table", "coin_body"].map(coin.struct);
const [J, r] = [coin.doubles(3), coin.doubles(3)];
const { COIN_SLIPS: SLIPS, COIN_RESTS: RESTS, COIN_DECIDED: DECIDED } = coin;
const { COIN_EPARAMS: EPARAMS, COIN_ESTATE: ESTATE, COIN_EARG: EARG } = coin;

const near = (found, wanted, off) => assert.ok(Math.abs(found - wanted) < off, `${found}, not ${wanted}`);
const move = (t, tol, stop) => coin.coin_move(body, p, table, t, tol, stop, null);

function toss(theta, wX) {
  body.fill(0);
  [body.s.theta, body.s.wX, body.y, body.vy] = [theta, wX, 0.03, 0.5];
}

// A chip as thick as half its width.
assert.equal(coin.coin_params_cylinder(p, 0.005, 0.01, 0.01, 9.80665), 0);
assert.equal(p.thickness, 0.01);
near(p.inertia_X, 5e-7 / 3, 1e-20);
table.set([0.4, 0.3, 0.2]);
const resists = 1e-2 * p.mass * p.gravity * p.radius;
table.losses.gap = 1;
assert.equal(coin.losses({ dry: resists, spin: resists }, table), table);
assert.deepEqual([...table.losses], [0, resists, 0, 0, 0, 0, resists, 0, 0, 0, 0, 0]);

for (const [face, y, theta, wX] of [["HEADS", 0.005, -1, 0], ["TAILS", 0.005, 1, 0], ["EDGE", 0.01, -1, 10]]) {
  toss(theta, wX);
  assert.equal(move(Infinity, 1e-6, DECIDED) & (DECIDED | RESTS), DECIDED);
  assert.equal(coin.coin_body_face(body, p), coin["COIN_" + face]);
  assert.equal(move(Infinity, 1e-6, 0), RESTS);
  assert.equal(coin.coin_body_face(body, p), coin["COIN_" + face]);
  near(body.y, y, 1e-12);
}

// A slope holds it, or lets it slide.
toss(1, 0);
move(Infinity, 1e-6, 0);
table.pull[0] = 0.3 * p.gravity;
assert.equal(move(0.1, 1e-9, 0), RESTS);
table.pull[0] = 0.5 * p.gravity;
assert.equal(move(0.1, 1e-9, 0), SLIPS);
near(body.vx, (0.5 - 0.3) * p.gravity * 0.1, 1e-9);
assert.equal(move(0.1, 1e-9, DECIDED), EARG);

// A blow turns and moves it; what is out of range does not.
body.fill(0);
body.y = p.radius;
J[2] = 1e-3;
r[1] = p.radius;
assert.equal(coin.coin_body_strike(body, p, J, r), 0);
near(body.vz, J[2] / p.mass, 1e-12);
near(body.s.wX, J[2] * r[1] / p.inertia_X, 1e-9);
const before = [...body];
J[2] = 1e30;
assert.equal(coin.coin_body_strike(body, p, J, r), ESTATE);
assert.deepEqual([...body], before);

// What is for thin coins refuses it, and it is not thicker than 4 radii.
assert.ok(Number.isNaN(coin.coin_critical_roll(p)));
assert.equal(coin.coin_step(coin.struct("coin_state"), p, 1e-3), EPARAMS);
assert.equal(coin.coin_params_cylinder(p, 0.005, 0.01, 0.05, 9.80665), EPARAMS);
assert.equal(p.thickness, 0.01);

// Members are those of C, by name and by place; a part is a struct itself.
const state = coin.struct("coin_state");
assert.equal(coin.coin_params_disc(p, 0.00567, 0.01213, 9.80665), 0);
assert.deepEqual([p[0], p.mass, p.radius, p.gravity, p.thickness], [0.00567, 0.00567, 0.01213, 9.80665, 0]);
Object.assign(state, { theta: 0.3, phi: 1, psi: 2, x: 3, z: 4, wX: 5, wY: 6, wZ: 7 });
assert.deepEqual([...state], [0.3, 1, 2, 3, 4, 5, 6, 7]);
assert.equal(coin.coin_body_from_state(body, state, p), 0);
assert.deepEqual([...body.s], [...state]);
near(body.y, p.radius * Math.cos(0.3), 1e-15);
const v = coin.doubles(3);
coin.coin_velocity(state, p, v);
assert.deepEqual([body.vx, body.vy, body.vz], [...v]);
assert.equal(coin.coin_energy(body.s, p), coin.coin_energy(state, p));
const force = coin.struct("coin_force");
assert.equal(coin.coin_reaction(state, p, force), 0);
assert.equal(force.normal, force.R[1]);
near(force.ratio, Math.hypot(force.R[0], force.R[2]) / force.R[1], 1e-12);

// A wrong name throws, and an array that is not of the library's memory.
assert.throws(() => { body.s.thetta = 1; }, TypeError);
assert.throws(() => { body.s = state; }, TypeError);
assert.throws(() => coin.struct("coin_coin"), TypeError);
assert.throws(() => coin.losses({ drag: 1 }), /no losses: drag/);
assert.throws(() => coin.coin_energy(new Float64Array(8), p), TypeError);
assert.throws(() => coin.coin_energy([...state], p), TypeError);
assert.throws(() => coin.coin_velocity(state, p, [0, 0, 0]), TypeError);
for (const count of [1e6, -4, NaN, undefined]) assert.throws(() => coin.doubles(count), RangeError);
assert.ok(coin.doubles(1).byteOffset > force.byteOffset);

// Whole numbers come back as they are.
const [done, steps, status] = [coin.longs(1), coin.ints(2), coin.ints(3)];
assert.deepEqual([...done, ...steps], [0n, 0, 0]);
assert.equal(coin.coin_run(state, p, coin.COIN_RK8, 1e-4, 100n, done), coin.COIN_OK);
assert.equal(done[0], 100n);
const path = coin.structs("coin_state", 3);
assert.equal(coin.coin_sample(body.s, p, coin.COIN_RK8, 1e-4, 50n, 3, path[0], steps), coin.COIN_OK);
assert.deepEqual([...steps], [3, 0]);
assert.deepEqual([...path[0]], [...body.s]);
assert.deepEqual([...path[2]], [...state]);
path[1].theta = 2;
assert.equal(coin.coin_batch_run(path[0], 3, p, coin.COIN_RK4, 1e-4, 1n, status), ESTATE);
assert.deepEqual([...status], [coin.COIN_OK, ESTATE, coin.COIN_OK]);
assert.equal(coin.coin_method_name(coin.COIN_SYMPLECTIC4), "symplectic4");
assert.equal(coin.coin_method_name(9), null);

// Of no coins the array may be null.
const none = coin.structs("coin_state", 0);
assert.equal(coin.coin_batch_run(none[0], 0, p, coin.COIN_RK4, 1e-4, 1n, null), coin.COIN_OK);
assert.equal(coin.coin_sample(state, p, coin.COIN_RK4, 1e-4, 1n, 0, null, null), coin.COIN_OK);

// Every constant is there, in the order of coin.h.
const header = readFileSync(new URL("../../include/coin.h", import.meta.url), "utf8");
const constants = [...header.matchAll(/^ {4}(COIN_\w+) = (-?\d+)/gm)].map(([, name, value]) => [name, Number(value)]);
assert.ok(constants.length > 20);
assert.deepEqual(Object.entries(coin).filter(([name]) => name.startsWith("COIN_")), constants);
console.log("test_js: passed");
