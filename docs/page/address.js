// SPDX-License-Identifier: MIT
// address.js: what the hash of the address says.  It holds every number in
// full, except those that the scene already has.

const LIMITS = { // of the numbers that the library does not judge
  span: [1e-9, 1e9], dt: [1e-9, 1e9], swings: [0, 1e9], now: [0, 1e9], speed: [1e-9, 1e6],
  az: [-1e3, 1e3], el: [0.05, 1.55], zoom: [0.05, 50], mu: [0, Infinity], bounce: [0, 1],
  mapy: [0, 1e9], mapw: [-1e9, 1e9], mapzoom: [1, 1e13],
};
const FIRST = "toss"; // the scene of an address that names none
const NUMBER = /^[+-]?(\d{1,30}(\.\d{0,30})?|\.\d{1,30})(e[+-]?\d{1,3})?$/i;

const CHOICES = { // of a word, kept as its index
  method: () => METHODS, race: () => ["0", "1"], play: () => ["0", "1"], scene: sceneNames,
};

// Puts one part of the address into a state, or says why not.
function readPart(state, name, text) {
  const limited = Object.hasOwn(LIMITS, name);
  const x = NUMBER.test(text) ? Number(text) : name === "mu" && text === "inf" ? Infinity : NaN;
  const choices = Object.hasOwn(CHOICES, name) && CHOICES[name]();
  if (choices && !choices.includes(text)) return "it is one of " + choices.join(", ");
  if (!choices && !limited && !ASKED.includes(name)) return "nothing has that name";
  if (!choices && Number.isNaN(x) || x === Infinity && name !== "mu") return "that is not a number";
  if (limited && (x < LIMITS[name][0] || x > LIMITS[name][1]))
    return "it must lie between " + LIMITS[name].join(" and ");
  state[name] = choices ? choices.indexOf(text) : x;
  return "";
}

// The state that an address describes, and what was wrong with it.
function readAddress(hash) {
  const complaints = hash.length > 3000 ? ["it is longer than 3000 characters"] : [], seen = new Set();
  const parts = complaints.length ? [] : hash.replace(/^#/, "").split("&").filter(Boolean);
  const scene = (parts.find(p => p.startsWith("scene=")) || "").slice(6);
  const state = defaultsOf(sceneNames().indexOf(sceneNames().includes(scene) ? scene : FIRST));
  for (const part of parts) {
    const [, name, text] = /^([^=]*)=?(.*)$/s.exec(part);
    const why = seen.has(name) ? "it is there twice" : readPart(state, name, text);
    seen.add(name);
    if (why) complaints.push("“" + part.slice(0, 40) + "”: " + why);
  }
  const status = take(state);
  if (status >= 0) return { state, complaints };
  complaints.push("all of it: " + plainWords(status));
  return { state: defaultsOf(state.scene), complaints };
}

function addressOf(state) {
  const usual = defaultsOf(state.scene), parts = ["scene=" + sceneNames()[state.scene]];
  const written = (name, x) => Object.hasOwn(CHOICES, name) ? CHOICES[name]()[x]
    : Object.is(x, -0) ? "-0" : x === Infinity ? "inf" : x;
  for (const name of new Set([...ASKED, ...Object.keys(LIMITS), ...Object.keys(CHOICES)]))
    if (!Object.is(state[name], usual[name])) parts.push(name + "=" + written(name, state[name]));
  return "#" + parts.join("&");
}
