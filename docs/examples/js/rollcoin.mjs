// SPDX-License-Identifier: MIT
// rollcoin.mjs: the library in JavaScript, in a browser or in node.
//
//     import { load } from "./rollcoin.mjs";
//     const coin = await load();            // rollcoin.wasm, beside this file; or load(bytes)
//     const state = coin.struct("coin_state");
//     state.theta = 0.3;
//
// Each function and constant of coin.h is there under its name.  What a function
// takes by a pointer is an array from struct(), doubles(), ints() or longs(); null is
// a null pointer.  A struct is a Float64Array in the order of coin.h, with the names
// of its members.  A uint64_t is a BigInt: 60n.  The arrays are never freed: make few,
// and use them again.

// From coin.h, by `make bindings-update`; members by their places, in doubles:
const CONSTANTS = {
  COIN_OK: 0, COIN_EPARAMS: -1, COIN_ESTATE: -2, COIN_ESTEP: -3, COIN_EARG: -4, COIN_EDOMAIN: -5, COIN_EFLAT: -6, COIN_EBUILD: -7, COIN_ERANGE: -9,
  COIN_SLIPS: 1, COIN_LIFTS: 2, COIN_COARSE: 4, COIN_NEARLY_FLAT: 8, COIN_RESTS: 16, COIN_ROLLS: 32, COIN_TOUCHES: 64, COIN_MORE: 128, COIN_DECIDED: 256,
  COIN_HEADS: 1, COIN_TAILS: 2, COIN_EDGE: 3,
  COIN_RK4: 0, COIN_RK8: 1, COIN_SYMPLECTIC2: 2, COIN_SYMPLECTIC4: 3,
};
const STRUCTS = {
  coin_params: { mass: 0, radius: 1, gravity: 2, inertia_X: 3, inertia_Z: 4, thickness: 5 },
  coin_state: { theta: 0, phi: 1, psi: 2, x: 3, z: 4, wX: 5, wY: 6, wZ: 7 },
  coin_force: { R: [0, 3], normal: 3, friction: 4, ratio: 5 },
  coin_orbit: { period: 0, heading_per_period: 1, roll_per_period: 2, theta_min: 3, theta_max: 4, center: [5, 7], radius_min: 7, radius_max: 8, drift: [9, 11], conditioning: 11 },
  coin_losses: { damping: 0, dry: 1, viscous: 2, layer: 3, gap: 4, rolling: 5, spin: 6, angular: 7, soft: 8, flat: 9 },
  coin_table: { mu_static: 0, mu_kinetic: 1, restitution: 2, pull: [3, 5], losses: [8, 20, "coin_losses"] },
  coin_body: { s: [0, 8, "coin_state"], y: 8, vx: 9, vy: 10, vz: 11 },
};
const TEXTS = ["coin_method_name", "coin_version_string", "coin_status_string"];
// Until here.

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
  const textAt = at => at === 0 ? null : new TextDecoder().decode(bytesAt(at, 256)).split("\0")[0];

  // Zeros that the library can be given.
  const zeros = Type => count => {
    const at = Math.ceil(top / 8) * 8;
    const size = count * Type.BYTES_PER_ELEMENT;
    if (!(size >= 0 && at + size <= c.memory.buffer.byteLength)) throw new RangeError("no memory for so many: " + count);
    top = at + size;
    bytesAt(at, size).fill(0);
    return new Type(c.memory.buffer, at, count);
  };
  const [doubles, ints, longs] = [Float64Array, Int32Array, BigUint64Array].map(zeros);

  // Gives an array the names of a struct, and no others: a wrong name throws.
  function names(array, name) {
    for (const [member, place] of Object.entries(STRUCTS[name] ?? {})) {
      const [begin, end, inner] = [place].flat();
      Object.defineProperty(array, member, end
        ? { value: names(array.subarray(begin, end), inner) }
        : { get: () => array[begin], set(value) { array[begin] = value; } });
    }
    return Object.preventExtensions(array);
  }

  function struct(name) {
    bytesAt(top, name.length + 1).set([...new TextEncoder().encode(name), 0]);
    const size = c.coin_sizeof(top);
    if (!size) throw new TypeError("no struct of coin.h: " + name);
    return names(doubles(size / 8), name);
  }

  // One after another, as an array of C: its pointer is the first of them.
  const structs = (name, count) => Array.from({ length: count }, () => struct(name));

  // Losses by their names, { dry: 1e-7 }; or those of a coin_table.
  function losses(named, into = struct("coin_losses")) {
    const all = Object.keys(STRUCTS.coin_losses);
    const unknown = Object.keys(named).find(name => !all.includes(name));
    if (unknown) throw new TypeError("no losses: " + unknown);
    (into.losses ?? into).set(all.map(name => named[name] ?? 0));
    return into;
  }

  function passed(x) {
    if (Object(x) !== x) return x;
    if (x.buffer !== c.memory.buffer) throw new TypeError("an array that is not from struct(), doubles(), ints() or longs()");
    return x.byteOffset;
  }

  const coin = { ...CONSTANTS, doubles, ints, longs, struct, structs, losses };
  for (const [name, call] of Object.entries(c).filter(([key]) => key.startsWith("coin_"))) {
    const plain = (...given) => call(...given.map(passed));
    coin[name] = TEXTS.includes(name) ? (...given) => textAt(plain(...given)) : plain;
  }
  return coin;
}
