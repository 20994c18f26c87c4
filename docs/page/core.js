"use strict";
// SPDX-License-Identifier: MIT
// core.js: the library as WebAssembly, the state of the page, numbers as text.

const $ = id => document.getElementById(id);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

// ------------------------------------------------------------- the library --
let lib; // what page.c exports

// The module is compiled once; each worker makes its own library of it.
async function loadLibrary() {
  const packed = Uint8Array.from(atob($("wasm").textContent), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const compiled = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  lib = (await WebAssembly.instantiate(compiled)).exports;
  return compiled;
}

const doubles = (address, count) => new Float64Array(lib.memory.buffer, address, count);

const words = address => new TextDecoder().decode(new Uint8Array(lib.memory.buffer, address, 256)).split("\0")[0];
const statusWords = status => words(lib.page_status_words(status));
const sceneWord = (k, which) => words(lib.page_scene_word(k, which));
const sceneNames = () => Array.from({ length: lib.page_scene_count() }, (_, k) => sceneWord(k, 0));

// ----------------------------------------------------- layouts, see page.c --
const ASKED = ("theta phi psi x z wX wY wZ y vx vy vz mass radius inner gravity " +
  "damping dry viscous layer gap rolling spin angular soft flat reserved0 reserved1 mu bounce thickness").split(" ");
const START = ASKED.slice(0, 12), LOSSES = ASKED.slice(16, 24);
const METHODS = ["rk4", "rk8", "symplectic2", "symplectic4"];
const COIN = { slips: 1, lifts: 2, coarse: 4, flat: 8, rests: 16, through: -100 };
const MOMENT = 28, RACER = 22, KNOTS = 60000; // doubles in each
const AT = { t: 0, theta: 1, phi: 2, x: 4, z: 5, wX: 6, wY: 7, wZ: 8, y: 9, vx: 10, vy: 11, vz: 12, cx: 17, cz: 18,
  R: 19, normal: 22, ratio: 24, energy: 25, slip: 26, bits: 27 };
const RACE = { steps: 10, status: 11, pose: 12, energy: 13, shown: 14 };

// ------------------------------------------------------ what the page holds --
// The scene and its start, as the address has them: numbers;
// scene, method: indices; race, play: 0 or 1.
let m;

// What follows: the end of the time axis; whether the trail grows on; its knots;
// a circle about the path and its height, in radii; the present and the status of
// its call; when the coin rests.
const motion = { end: 0, more: false, count: 0, knots: null, center: [0, 0], reach: 1, height: 1, moment: null,
  status: 0, restsAt: NaN, rests: false };

const unit = () => Math.sqrt(m.radius / m.gravity); // of natural time
const weight = () => m.mass * m.gravity;
const isLossy = () => LOSSES.some(name => m[name] > 0);
const isReal = () => m.mu < Infinity; // it slips, flies and bounces; else it rolls, whatever that needs
const isTossed = () => m.y > 0;
const hasFaces = () => m.inner === 0; // heads and tails: not a ring
const sceneName = () => sceneWord(m.scene, 0);
const knot = (k, what) => motion.knots[k * MOMENT + what];
const racing = () => m.race === 1 && !isLossy() && !isReal();
const racer = which => doubles(lib.page_racers() + 8 * RACER * which, RACER);

// How far the eye is above the table [rad], and how close, where a scene wants it otherwise.
const EYES = { toss: [0.5, 1], luck: [0.4, 1], disk: [0.26, 1.5], whirl: [0.36, 1] };

// A motion in real time; what is over in a moment 2, 4 ... times slower.
function defaultsOf(scene) {
  const d = { scene, method: 1, race: 0, play: 1, swings: 0, now: 0, az: 0.6 };
  lib.page_scene(scene);
  doubles(lib.page_asked(), ASKED.length).forEach((x, k) => { d[ASKED[k]] = x; });
  [d.el, d.zoom] = EYES[sceneWord(scene, 0)] || [0.55, 1];
  d.dt = lib.page_scene_number(scene, 0);
  d.span = lib.page_scene_number(scene, 1);
  const second = secondOf(scene), slower = 2 ** Math.floor(Math.log2(Math.max(12 * second / d.span, 1)));
  d.speed = d.mu < Infinity ? second / (sceneWord(scene, 0) === "luck" ? 4 : 1) : second / slower;
  return Object.assign(d, wholeMap(d));
}

// Hands the body, the start and the losses to the library, which may refuse.
function take(state) {
  doubles(lib.page_asked(), ASKED.length).set(ASKED.map(name => state[name]));
  return lib.page_take();
}
