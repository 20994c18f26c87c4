// SPDX-License-Identifier: MIT
// Tosses a US quarter until it lies flat.
//     make js && node docs/examples/js/toss.mjs build/js/rollcoin.wasm
import { readFileSync } from "node:fs";
import { load } from "./rollcoin.mjs";

const coin = await load(readFileSync(process.argv[2]));
const [p, table, body, reached] = [coin.struct("coin_params"), coin.struct("coin_table"), coin.struct("coin_body"),
  coin.doubles(1)];

coin.coin_params_disc(p, 0.00567, 0.01213, 9.80665); // kg, m, m/s^2
table.set([0.4, 0.3, 0.4]); // static and kinetic friction, restitution
table[9] = 1e-2 * 0.00567 * 9.80665 * 0.01213; // losses.dry
body.set([1, 0, 0, 0, 0, 90, 5, 5]); // theta, phi, psi, x, z [rad, m], wX, wY, wZ [1/s]
body.set([0.05, 0.1, 1.2, 0], 8); // y [m], vx, vy, vz [m/s]

const status = coin.coin_move(body, p, table, Infinity, 1e-6, 0, reached);
console.log(`${body[0] < 0 ? "heads" : "tails"} after ${reached[0].toFixed(6)} s: ${coin.coin_status_string(status)}`);
