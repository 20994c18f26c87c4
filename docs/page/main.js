// SPDX-License-Identifier: MIT
// main.js: time and controls.

let playing = false, direction = 1, slow = 1, scheduled = true, lastFrame = 0, verdictSince = 0, keeping;
const tosses = { Heads: 0, Tails: 0, counted: true };

// ------------------------------------------------------------------- motion --
// The time of a swing; of a steady motion, that of a small one.  0: no period.
function swing() {
  const orbit = lib.page_orbit(), lambda2 = lib.page_lambda2();
  return orbit && (doubles(orbit, 1)[0] || 2 * Math.PI * (lambda2 < 0 ? 1 / Math.sqrt(-lambda2) : unit()));
}
const farAhead = () => m.swings * swing();

// Makes the motion of m.  If the library refuses it, that before stays.
function rebuild(before) {
  const status = take(m);
  if (status < 0) {
    say("That start was refused: " + statusWords(status) + ".");
    take(Object.assign(m, before));
  }
  if (m.swings && !(swing() > 0 && lib.page_at(farAhead(), 0) >= 0)) {
    say("No orbit leads so far ahead: this is the start.");
    m.swings = 0;
  }
  lib.page_trail(farAhead());
  motion.more = true;
  extendTrail();
  wake();
}

// Computes more of the trail, for some milliseconds, and what hangs on it.
function extendTrail() {
  const begun = performance.now(), lossy = isLossy();
  while (motion.more && performance.now() - begun < 8) {
    const status = lib.page_trail_on(lossy ? 1e12 * unit() : m.span, 100);
    motion.more = status === 0;
    if (status < 0) say("It goes no further: " + statusWords(status) + ".");
  }
  const count = motion.count = lib.page_knot_count();
  motion.knots = doubles(lib.page_knots(), MOMENT * count);
  const last = knot(count - 1, AT.t);
  motion.flat = !motion.more && Math.abs(knot(count - 1, AT.theta)) > 1.570796;
  motion.restsAt = (lossy || isReal()) && motion.flat ? last : NaN;
  motion.end = lossy ? last : Math.min(m.span, motion.more ? m.span : last);
  if (!motion.more) m.now = Math.min(m.now, motion.end);
  const [x0, x1, z0, z1] = [AT.cx, AT.cz].flatMap(extremes).map(x => x / m.radius);
  motion.center = [(x0 + x1) / 2, (z0 + z1) / 2];
  motion.reach = Math.hypot(x1 - x0, z1 - z0) / 2.6;
  motion.height = extremes(AT.y)[1] / m.radius;
  runRaces();
  describe();
  Object.values(GRAPHS).forEach(drawGraph);
}

const wake = () => { if (!scheduled) requestAnimationFrame(frame); scheduled = true; };

function frame(time) {
  const passed = clamp((time - lastFrame) / 1000, 0, 0.1);
  lastFrame = time;
  scheduled = false;
  if (motion.more) extendTrail();
  if (playing) m.now = clamp(m.now + direction * slow * m.speed * passed, 0, motion.more ? 1e99 : motion.end);
  motion.status = playing && motion.count > 1500 ? lib.page_near(m.now) : lib.page_at(farAhead(), m.now);
  motion.moment = doubles(lib.page_now(), MOMENT);
  if (m.swings) goFar();
  if (racing() && !races.tooMany)
    [0, 1].forEach(k => lib.page_race(k, k ? m.method : -1, m.dt, -1, playing ? 0 : 1));
  drawStage();
  Object.values(GRAPHS).forEach(markGraph);
  showTime(time);
  if (playing && !motion.more && m.now === (direction > 0 ? motion.end : 0)) atTheEnd();
  if (playing || motion.more || m.swings && !far.there) wake();
}

// An RK4 on the way to the same swing, some milliseconds in each frame,
// and on from there.
const far = { steps: 0, there: false };
function goFar() {
  const begun = performance.now(), dt = 0.1 * unit();
  do {
    far.steps = lib.page_far(farAhead(), dt, 2e4);
    far.there = far.steps >= farAhead() / dt;
  } while (!far.there && performance.now() - begun < 8);
  if (far.there) lib.page_race(0, 0, dt, -1, 0);
}

// A coin that lies flat stays there; another begins again.
function atTheEnd() {
  if (!motion.flat) m.now = motion.end - m.now;
  else play(false);
  if (!motion.flat || !isTossed() || tosses.counted || direction < 0) return;
  tosses.counted = true;
  ++tosses[faceUp()];
  $("tosses").textContent = `Heads ${tosses.Heads}, tails ${tosses.Tails}`;
}

const faceUp = () => motion.moment[AT.theta] < 0 ? "Heads" : "Tails";

// ------------------------------------------------------------------- controls --
function play(on) {
  const end = direction > 0 ? motion.end : 0;
  if (on && m.now === end && !motion.more) m.now = motion.end - end;
  playing = on;
  $("play").setAttribute("aria-label", on ? "Pause" : "Play");
  $("play").dataset.on = on;
  $("reverse").setAttribute("aria-pressed", direction < 0);
  go(m.now);
}

const go = t => { m.now = clamp(t, 0, motion.more ? Infinity : motion.end); keep(); wake(); };
const pausedAt = t => { play(false); go(t); };

// Keeps the state in the address, soon: browsers limit how often.
const write = () => history.replaceState(null, "", addressOf(m));
const keep = () => { clearTimeout(keeping); keeping = setTimeout(write, 250); };

// Changes m; a change of the start begins at t = 0.
function change(parts, restart = true) {
  const before = { ...m };
  say("");
  Object.assign(m, restart ? { now: 0, swings: 0 } : {}, parts);
  rebuild(before);
  showControls();
  keep();
}

// Sliders: what they show of m, what m becomes, and their text.  Rates and
// losses are in natural units.
const rate = name => [() => m[name] * unit(), x => ({ [name]: x / unit() }), () => short(m[name], 4)];
const duration = (name, text) => [() => Math.log10(m[name] / unit()), x => ({ [name]: 10 ** x * unit() }), text];
const UNITS_OF_TIME = { viscous: 1, layer: 1.5, gap: 1, spin: 1 };
const torqueUnit = name => weight() * m.radius * unit() ** (UNITS_OF_TIME[name] || 0);
const lossUnit = name => ({ damping: 1, angular: 1 / unit() })[name] || torqueUnit(name);
const law = () => LOSSES.find(name => m[name] > 0) || $("law").value;
const losses = (name, x) => ({ ...Object.fromEntries(LOSSES.map(other => [other, 0])), [name]: x * lossUnit(name) });
const loss = () => m[law()] / lossUnit(law());
const IDEAL = { mu: Infinity, y: 0, vx: 0, vy: 0, vz: 0 };
const SLIDERS = {
  lean: [() => degrees(m.theta), x => ({ theta: x * Math.PI / 180 }), () => short(degrees(m.theta), 4) + "°"],
  wX: rate("wX"), wY: rate("wY"), wZ: rate("wZ"),
  hole: [() => m.inner / m.radius, x => ({ inner: x * m.radius }), () => short(m.inner / m.radius) + " radii"],
  strength: [() => isLossy() ? Math.log10(loss()) : -7, x => losses(law(), x < -6.99 ? 0 : 10 ** x),
    () => isLossy() ? power(loss()) : "none"],
  mu: [() => Math.min(m.mu, 1.05), x => x > 1 ? IDEAL : { mu: x },
    () => isReal() ? short(m.mu) : "∞, it never slips"],
  bounce: [() => m.bounce, x => ({ bounce: x }), () => short(m.bounce)],
  dt: duration("dt", () => timeText(m.dt)), speed: duration("speed", () => timeText(m.speed, 2) + " in 1 s"),
};

function showControls() {
  for (const [id, [value, , text]] of Object.entries(SLIDERS)) {
    $(id).value = value();
    $(id + "out").textContent = text();
    $(id).setAttribute("aria-valuetext", text());
  }
  for (const [id, value] of Object.entries({ scene: m.scene, method: m.method, law: law() })) $(id).value = value;
  $("race").checked = m.race;
}

// What the library has in its block of inputs, as parts of m.
const asked = names => Object.fromEntries(names.map(name =>
  [name, doubles(lib.page_asked(), ASKED.length)[ASKED.indexOf(name)]]));

const startHere = () => { lib.page_at(farAhead(), m.now); lib.page_start_here(0); change(asked(START)); };

// Swings ahead by the orbit.
const jump = swings => change({ swings: lib.page_orbit() ? swings : 0 }, false);

function restAfter(time) {
  take(isLossy() ? m : { ...m, ...losses(law(), 1e-3) });
  const status = lib.page_rest_after(time);
  if (status >= 0) change(asked(LOSSES));
  else take(m), say("There are no such losses: " + statusWords(status) + ".");
}

// Saves what the page has made as a file.
function save(name, blob) {
  const link = document.createElement("a");
  Object.assign(link, { download: "rollcoin-" + name, href: URL.createObjectURL(blob) }).click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1e3);
}

const COLUMNS = "t theta phi psi x z wX wY wZ y contact_x contact_z N ratio energy bits".split(" ");
const PLACES = [...Array(10).keys(), AT.cx, AT.cz, AT.normal, AT.ratio, AT.energy, AT.bits];
function csv() {
  const rows = Array.from({ length: motion.count }, (_, k) => PLACES.map(at => knot(k, at)).join());
  return [COLUMNS.join(), ...rows, ""].join("\n");
}

// The stage on the colour of its panel.
function picture() {
  const from = $("stage"), to = document.createElement("canvas"), c = to.getContext("2d");
  Object.assign(to, { width: from.width, height: from.height });
  c.fillStyle = COLORS.panel;
  c.fillRect(0, 0, to.width, to.height);
  c.drawImage(from, 0, 0);
  to.toBlob(blob => save("coin.png", blob));
}

async function copy(text, button) {
  const label = button.textContent, written = navigator.clipboard?.writeText(text);
  button.textContent = written ? await written.then(() => "Copied", () => "Not allowed") : "No clipboard";
  setTimeout(() => { button.textContent = label; }, 1500);
}

const ACTIONS = {
  play: () => play(!playing), reverse: () => { direction = -direction; play(true); },
  begin: () => pausedAt(0), back: () => pausedAt(m.now - m.dt), step: () => pausedAt(m.now + m.dt), here: startHere,
  toss, slow: () => { slow = slow === 1 ? 0.2 : 1; $("slow").setAttribute("aria-pressed", slow < 1); },
  million: () => jump(1e6), near: () => jump(0),
  csv: () => save("run.csv", new Blob([csv()], { type: "text/csv" })), picture,
  link: () => copy(location.href.replace(/#.*|$/, addressOf(m)), $("link")),
  copyc: () => copy($("listing").textContent, $("copyc")),
};
const KEYS = { " ": "play", r: "reverse", Home: "begin", ArrowLeft: "back", ArrowRight: "step", s: "here", l: "link",
  t: "toss", w: "slow" };
const ARROWS = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };

function onKey(e) {
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.closest("input, select, summary, pre")) return;
  if (e.key === " " && e.target.closest("button, a")) return;
  const onStage = e.target === $("stage"), act = ACTIONS[KEYS[e.key]];
  if (onStage && ARROWS[e.key]) look(...ARROWS[e.key]);
  else if (onStage && "+-".includes(e.key)) zoom(e.key === "+" ? 1.2 : 1 / 1.2);
  else if (act) act();
  else return;
  e.preventDefault();
}

// ------------------------------------------------------------------- listening --
function listen() {
  const on = (id, kind, act) => $(id).addEventListener(kind, e => act(e.target.value, e));
  for (const [id, act] of Object.entries(ACTIONS)) on(id, "click", () => act());
  for (const [id, [, read]] of Object.entries(SLIDERS))
    on(id, "input", x => change(read(Number(x)), !["dt", "speed"].includes(id)));
  on("scrub", "input", x => pausedAt(x * motion.end));
  on("scene", "change", k => { location.hash = "scene=" + sceneNames()[k]; });
  on("method", "change", k => change({ method: Number(k) }, false));
  on("law", "change", name => isLossy() && change(losses(name, loss())));
  on("race", "change", (_, e) => change({ race: Number(e.target.checked) }, false));
  on("rest", "change", x => restAfter(Number(x)));
  for (const g of Object.values(GRAPHS).filter(graph => !graph.x))
    g.canvas.addEventListener("pointerdown", e =>
      pausedAt((e.offsetX - g.X(0)) / (g.X(motion.end) - g.X(0)) * motion.end));
  document.addEventListener("keydown", onKey);
  $("skip").addEventListener("click", e => { e.preventDefault(); $("stage").focus(); });
  window.addEventListener("hashchange", e => load(new URL(e.newURL).hash));
  window.addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  listenToStage($("stage"));
}

const redraw = () => { readColors(); Object.values(GRAPHS).forEach(drawGraph); wake(); };

// ----------------------------------------------------------------- beginning --
function load(hash) {
  const { state, complaints } = readAddress(hash);
  clearTimeout(keeping);
  m = state;
  direction = 1;
  say("");
  rebuild(state);
  if (complaints.length) say("Parts of the address were not used: " + complaints.join("; ") + ".");
  showControls();
  play(m.play && !matchMedia("(prefers-reduced-motion: reduce)").matches);
  write();
}

function begin() {
  for (const [id, g] of Object.entries(GRAPHS))
    Object.assign(g, { canvas: $(id + "graph"), value: $(id + "value"), still: document.createElement("canvas") });
  for (const [id, names] of Object.entries({ scene: sceneNames(), method: METHODS }))
    $(id).replaceChildren(...names.map((name, k) => new Option(name, k)));
  readColors();
  document.body.classList.toggle("embed", new URLSearchParams(location.search).get("embed") === "1");
  $("selftest").textContent = selfTest() ? "The library's bits: self-test passed" : "Other bits: self-test failed";
  scheduled = false;
  load(location.hash);
  listen();
}

loadLibrary().then(begin, error => { $("selftest").textContent = error.message + ": self-test failed"; });
