"use strict";
// SPDX-License-Identifier: MIT
// core.js: the library as WebAssembly, the state of the page, numbers as text.

const $ = id => document.getElementById(id);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

// ------------------------------------------------------------- the library --
let lib; // what page.c exports

async function loadLibrary() {
  const packed = Uint8Array.from(atob($("wasm").textContent), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  lib = (await WebAssembly.instantiate(bytes)).instance.exports;
}

const doubles = (address, count) => new Float64Array(lib.memory.buffer, address, count);

const words = address => new TextDecoder().decode(new Uint8Array(lib.memory.buffer, address, 256)).split("\0")[0];
const statusWords = status => words(lib.page_status_words(status));
const sceneWord = (k, which) => words(lib.page_scene_word(k, which));
const sceneNames = () => Array.from({ length: lib.page_scene_count() }, (_, k) => sceneWord(k, 0));

// The bits of this browser against those that the C library gave.
const selfTest = () => lib.page_selftest() === 0 && $("hashes").textContent.trim() ===
  sceneNames().map((name, k) => name + " " + words(lib.page_hash(k))).join("\n");

// ----------------------------------------------------- layouts, see page.c --
const ASKED = ("theta phi psi x z wX wY wZ y vx vy vz mass radius inner gravity " +
  "damping dry viscous layer gap rolling spin angular soft flat reserved0 reserved1 mu bounce").split(" ");
const START = ASKED.slice(0, 12), LOSSES = ASKED.slice(16, 24);
const METHODS = ["rk4", "rk8", "symplectic2", "symplectic4"];
const COIN = { slips: 1, lifts: 2, coarse: 4, flat: 8, rests: 16, through: -100 };
const MOMENT = 27, RACER = 22; // doubles in each
const AT = { t: 0, theta: 1, wX: 6, y: 9, cx: 17, cz: 18, R: 19, normal: 22, ratio: 24, energy: 25, bits: 26 };
const RACE = { steps: 10, status: 11, pose: 12, energy: 13, shown: 14 };

// ------------------------------------------------------ what the page holds --
// The scene and its start, as the address has them: numbers;
// scene, method: indices; race, play: 0 or 1.
let m;

// What follows: the end of the time axis; whether the trail grows on; its knots;
// a circle about the path and its height, in radii; the present and the status of
// its call; when the coin rests.
const motion = { end: 0, more: false, count: 0, knots: null, center: [0, 0], reach: 1, height: 1, moment: null,
  status: 0, restsAt: NaN, flat: false };

const unit = () => Math.sqrt(m.radius / m.gravity); // of natural time
const weight = () => m.mass * m.gravity;
const isLossy = () => LOSSES.some(name => m[name] > 0);
const isReal = () => m.mu < Infinity; // it slips, flies and bounces; else it rolls, whatever that needs
const isTossed = () => m.y > 0;
const knot = (k, what) => motion.knots[k * MOMENT + what];
const racing = () => m.race === 1 && !isLossy() && !isReal();
const racer = which => doubles(lib.page_racers() + 8 * RACER * which, RACER);

function defaultsOf(scene) {
  const d = { scene, method: 1, race: 0, play: 1, swings: 0, now: 0, az: 0.6, el: 0.55, zoom: 1 };
  lib.page_scene(scene);
  doubles(lib.page_asked(), ASKED.length).forEach((x, k) => { d[ASKED[k]] = x; });
  d.dt = lib.page_scene_number(scene, 0);
  d.span = lib.page_scene_number(scene, 1);
  d.speed = Number((d.span / 12).toPrecision(1));
  return d;
}

// Hands the body, the start and the losses to the library, which may refuse.
function take(state) {
  doubles(lib.page_asked(), ASKED.length).set(ASKED.map(name => state[name]));
  return lib.page_take();
}

// ------------------------------------------------------------------ numbers --
// As C prints them by "%.17g".
function g17(x) {
  if (x === 0) return Object.is(x, -0) ? "-0" : "0";
  if (!Number.isFinite(x)) return x > 0 ? "inf" : x < 0 ? "-inf" : "nan";
  const [digits, e] = x.toExponential(16).split("e"), trim = s => s.replace(/\.?0+$/, "");
  if (e >= -4 && e < 17) return e < 16 ? trim(x.toFixed(16 - e)) : x.toFixed(0);
  return trim(digits) + "e" + (e < 0 ? "-" : "+") + String(Math.abs(e)).padStart(2, "0");
}

// Short, for people: with a true minus.
function short(x, digits = 3) {
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "–";
  const size = Math.abs(x);
  if (size < 1e-12) return "0"; // rounding
  if (size >= 1e6 || size < 1e-3) return power(x, digits - 1);
  return x.toFixed(clamp(digits - Math.ceil(Math.log10(size)), 0, digits)).replace("-", "−");
}

const raised = e => [...String(e)].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("");
function power(x, digits = 1) {
  const [d, e] = x.toExponential(digits).split("e");
  return d.replace("-", "−") + "·10" + raised(Number(e));
}

const timeText = (t, digits = 3) => short(t, digits) + " " + sceneWord(m.scene, 2).replace("sqrt(a/g)", "√(a/\u2060g)");
