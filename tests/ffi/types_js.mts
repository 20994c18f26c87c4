// SPDX-License-Identifier: MIT
// The types of docs/examples/js: tsc accepts these calls, and refuses those that
// stand below "@ts-expect-error".  Nothing is run.
import { load } from "../../docs/examples/js/rollcoin.js";

const coin = await load();
const [p, s, done] = [coin.struct("coin_params"), coin.struct("coin_state"), coin.longs(1)];
const [body, table] = [coin.struct("coin_body"), coin.struct("coin_table")];

let before = coin.COIN_LIFTS;
before = coin.coin_move(body, p, table, 1, 1e-6, coin.COIN_TOUCHES | coin.COIN_ROLLS, null);
// @ts-expect-error: no such constant
coin.COIN_TOUCH;
// @ts-expect-error: a constant
coin.COIN_RK8 = 2;

coin.coin_run(s, p, coin.COIN_RK8, 1e-3, 100n, done);
const steps: bigint = done[0];
// @ts-expect-error: a uint64_t in doubles
coin.coin_run(s, p, coin.COIN_RK8, 1e-3, 100n, coin.doubles(1));
// @ts-expect-error: a uint64_t that is a number
coin.coin_run(s, p, coin.COIN_RK8, 1e-3, 100, done);

const many = coin.structs("coin_state", 3);
coin.coin_batch_run(many[0], 3, p, coin.COIN_RK4, 1e-3, steps, coin.ints(3));
coin.coin_sample(s, p, coin.COIN_RK4, 1e-3, 1n, 3, coin.doubles(24), coin.ints(1));
// @ts-expect-error: statuses in doubles
coin.coin_batch_run(many[0], 3, p, coin.COIN_RK4, 1e-3, 1n, coin.doubles(3));
// @ts-expect-error: states in JavaScript's own array
coin.coin_batch_run(many, 3, p, coin.COIN_RK4, 1e-3, 1n, null);

const name: string | null = coin.coin_method_name(9);
// @ts-expect-error: there may be no such method
name.length;

coin.coin_energy(body.s, p);
[body.s.theta, table.pull[0], table.losses.dry, many[1].wX] = [1, 0.1, p.mass, s[5]];
coin.losses({ dry: 1e-7 }, table).restitution = 0.4;
coin.losses({ dry: 1e-7 }).set([1, 2]);
// @ts-expect-error: no such member
body.s.thetta = 1;
// @ts-expect-error: a part of the body, which set() copies into
body.s = s;
// @ts-expect-error: no losses
coin.losses({ drag: 1 });
// @ts-expect-error: losses of what has none
coin.losses({ dry: 1 }, body);
// @ts-expect-error: no such struct
coin.struct("coin_coin");
