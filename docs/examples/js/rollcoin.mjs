// SPDX-License-Identifier: MIT
// rollcoin.mjs: the library in JavaScript, in a browser or in node.
//
//     import { load } from "./rollcoin.mjs";
//     const coin = await load();            // rollcoin.wasm, beside this file; or load(bytes)
//     const state = coin.struct("coin_state");
//
// Each function of coin.h is there under its name.  What it takes by a pointer is
// a Float64Array from struct() or doubles(), in the order of coin.h; null is a null
// pointer.  A uint64_t is a BigInt: 60n.  The arrays are never freed: make few, and
// use them again.
const LOSSES = ["damping", "dry", "viscous", "layer", "gap", "rolling", "spin", "angular", "soft", "flat"];
const TEXTS = ["coin_version_string", "coin_status_string", "coin_method_name"];

// What `make js` makes; the package of npm has it here.
async function beside() {
  const url = new URL("rollcoin.wasm", import.meta.url);
  if (url.protocol === "file:") return (await import("node:fs/promises")).readFile(url);
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

export async function load(bytes) {
  const c = (await WebAssembly.instantiate(bytes ?? await beside())).instance.exports;
  let top = c.__heap_base.value;
  const bytesAt = (at, count) => new Uint8Array(c.memory.buffer, at, count);
  const textAt = at => at && new TextDecoder().decode(bytesAt(at, 256)).split("\0")[0];

  // Zeros that the library can be given.
  function doubles(count) {
    const at = Math.ceil(top / 8) * 8;
    top = at + 8 * count;
    if (top > c.memory.buffer.byteLength) throw new RangeError("no memory left for coins");
    return new Float64Array(c.memory.buffer, at, count).fill(0);
  }

  function struct(name) {
    bytesAt(top, name.length + 1).set([...new TextEncoder().encode(name), 0]);
    const size = c.coin_sizeof(top);
    if (!size) throw new TypeError("no struct of coin.h: " + name);
    return doubles(size / 8);
  }

  // Losses by their names, { dry: 1e-7 }; or those of a coin_table, whose end they are.
  function losses(named, into = struct("coin_losses")) {
    const unknown = Object.keys(named).find(name => !LOSSES.includes(name));
    if (unknown) throw new TypeError("no losses: " + unknown);
    into.subarray(-12).set(LOSSES.map(name => named[name] ?? 0));
    return into;
  }

  const coin = { doubles, struct, losses };
  for (const [name, call] of Object.entries(c).filter(([key]) => key.startsWith("coin_"))) {
    const plain = (...given) => call(...given.map(x => x === null ? 0 : x instanceof Float64Array ? x.byteOffset : x));
    coin[name] = TEXTS.includes(name) ? (...given) => textAt(plain(...given)) : plain;
  }
  return coin;
}
