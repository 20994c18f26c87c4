// SPDX-License-Identifier: MIT
// docs/examples/js with a coin that has an edge: tossed, on a slope, struck, refused.
//     node test_js.mjs rollcoin.wasm
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { load } from "../../docs/examples/js/rollcoin.mjs";

const coin = await load(readFileSync(process.argv[2]));
const [p, table, body] = ["coin_params", "coin_table", "coin_body"].map(coin.struct);
const [J, r] = [coin.doubles(3), coin.doubles(3)];
const [RADIUS, GRAVITY, INERTIA, THICKNESS] = [1, 2, 3, 5];
const [Y, VX, VY, VZ] = [8, 9, 10, 11];
const [SLIPS, RESTS, DECIDED] = [1, 16, 256];
const [HEADS, TAILS, EDGE] = [1, 2, 3];
const [EPARAMS, ESTATE, EARG] = [-1, -2, -4];

const near = (found, wanted, off) => assert.ok(Math.abs(found - wanted) < off, `${found}, not ${wanted}`);
const move = (t, tol, stop) => coin.coin_move(body, p, table, t, tol, stop, null);

function toss(theta, wX) {
  body.fill(0);
  [body[0], body[5], body[Y], body[VY]] = [theta, wX, 0.03, 0.5];
}

// A chip as thick as half its width.
assert.equal(coin.coin_params_cylinder(p, 0.005, 0.01, 0.01, 9.80665), 0);
assert.equal(p[THICKNESS], 0.01);
near(p[INERTIA], 5e-7 / 3, 1e-20);
table.set([0.4, 0.3, 0.2]);
const resists = 1e-2 * p[0] * p[GRAVITY] * p[RADIUS];
coin.losses({ dry: resists, spin: resists }, table);

for (const [face, y, theta, wX] of [[HEADS, 0.005, -1, 0], [TAILS, 0.005, 1, 0], [EDGE, 0.01, -1, 10]]) {
  toss(theta, wX);
  assert.equal(move(Infinity, 1e-6, DECIDED) & (DECIDED | RESTS), DECIDED);
  assert.equal(coin.coin_body_face(body, p), face);
  assert.equal(move(Infinity, 1e-6, 0), RESTS);
  assert.equal(coin.coin_body_face(body, p), face);
  near(body[Y], y, 1e-12);
}

// A slope holds it, or lets it slide.
toss(1, 0);
move(Infinity, 1e-6, 0);
table[3] = 0.3 * p[GRAVITY];
assert.equal(move(0.1, 1e-9, 0), RESTS);
table[3] = 0.5 * p[GRAVITY];
assert.equal(move(0.1, 1e-9, 0), SLIPS);
near(body[VX], (0.5 - 0.3) * p[GRAVITY] * 0.1, 1e-9);
assert.equal(move(0.1, 1e-9, DECIDED), EARG);

// A blow turns and moves it; what is out of range does not.
body.fill(0);
body[Y] = p[RADIUS];
J[2] = 1e-3;
r[1] = p[RADIUS];
assert.equal(coin.coin_body_strike(body, p, J, r), 0);
near(body[VZ], J[2] / p[0], 1e-12);
near(body[5], J[2] * r[1] / p[INERTIA], 1e-9);
const before = [...body];
J[2] = 1e30;
assert.equal(coin.coin_body_strike(body, p, J, r), ESTATE);
assert.deepEqual([...body], before);

// What is for thin coins refuses it, and it is not thicker than 4 radii.
assert.ok(Number.isNaN(coin.coin_critical_roll(p)));
assert.equal(coin.coin_step(coin.struct("coin_state"), p, 1e-3), EPARAMS);
assert.equal(coin.coin_params_cylinder(p, 0.005, 0.01, 0.05, 9.80665), EPARAMS);
assert.equal(p[THICKNESS], 0.01);
console.log("test_js: passed");
