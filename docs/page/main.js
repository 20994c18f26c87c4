// SPDX-License-Identifier: MIT
// main.js: time, controls and what they say.

let playing = false, direction = 1, scheduled = true, lastFrame = 0, verdictSince = 0, keeping;

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
  while (motion.more && performance.now() - begun < 8)
    motion.more = lib.page_trail_on(lossy ? 1e12 * unit() : m.span, 100) === 0;
  const count = motion.count = lib.page_knot_count();
  motion.knots = doubles(lib.page_knots(), MOMENT * count);
  const last = knot(count - 1, AT.t);
  motion.flat = !motion.more && Math.abs(knot(count - 1, AT.theta)) > 1.570796;
  motion.restsAt = lossy && motion.flat ? last : NaN;
  motion.end = lossy ? last : Math.min(m.span, motion.more ? m.span : last);
  if (!motion.more) m.now = Math.min(m.now, motion.end);
  const [x0, x1, z0, z1] = [AT.cx, AT.cz].flatMap(extremes).map(x => x / m.radius);
  motion.center = [(x0 + x1) / 2, (z0 + z1) / 2];
  motion.reach = Math.hypot(x1 - x0, z1 - z0) / 2.3;
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
  if (playing) m.now = clamp(m.now + direction * m.speed * passed, 0, motion.more ? 1e99 : motion.end);
  motion.status = playing && motion.count > 1500 ? lib.page_near(m.now) : lib.page_at(farAhead(), m.now);
  motion.moment = doubles(lib.page_now(), MOMENT);
  if (racing() && !races.tooMany)
    [0, 1].forEach(k => lib.page_race(k, k ? m.method : -1, m.dt, -1, playing ? 0 : 1));
  drawStage();
  Object.values(GRAPHS).forEach(markGraph);
  showTime(time);
  if (playing && !motion.more && m.now === (direction > 0 ? motion.end : 0)) play(false);
  if (playing || motion.more) wake();
}

// ------------------------------------------------------------- what is said --
const say = text => { $("message").textContent = text; };

// Shows what the page says of a kind, with numbers where it has <b>.
function tell(id, kind, ...numbers) {
  for (const part of $(id).children) part.hidden = part.className !== kind;
  $(id).querySelectorAll(`.${kind} b`).forEach((b, k) => { b.textContent = numbers[k]; });
}

// The kind of the present, in a word, and why.
function verdict() {
  const s = motion.moment, bits = s[AT.bits], need = `needs μ ${short(s[AT.ratio])}, has ${short(m.mu)}`;
  if (m.now >= motion.restsAt) return ["rests", "At rest", "after " + timeText(motion.restsAt)];
  if (motion.flat && m.now >= motion.end) return ["lifts", "Falls flat", "after " + timeText(motion.end)];
  if (motion.status < 0) return ["lifts", "Cannot be computed", statusWords(motion.status)];
  if (bits & COIN.lifts)
    return ["lifts", "Would lift off", `the table would have to pull: N = ${short(s[AT.normal] / weight())} Mg`];
  if (bits & COIN.slips) return ["slips", "Would slip", need];
  return ["rolls", "Rolls", need + (bits & COIN.flat ? "; nearly flat" : "")];
}

function showRacer(which) {
  const r = racer(which), status = r[RACE.status], method = which ? METHODS[m.method] : "Textbook RK4";
  const stopped = [method, timeText(r[RACE.steps] * m.dt)];
  const errors = [method, short(r[RACE.pose], 2), short(r[RACE.energy], 2)];
  if (!racing() || races.tooMany) tell("racer" + which, "idle", method);
  else if (status < 0) tell("racer" + which, status === COIN.through ? "through" : "refused", ...stopped);
  else tell("racer" + which, status === COIN.coarse ? "coarse" : "runs", ...errors);
}

function showTime(time) {
  const [kind, word, why] = verdict(), clock = timeText(m.now, 4);
  $("light").dataset.kind = kind;
  $("why").textContent = why;
  if ($("verdict").textContent !== word && (!playing || time - verdictSince > 400)) {
    $("verdict").textContent = word;
    verdictSince = time;
  }
  $("scrub").value = motion.end ? m.now / motion.end : 0;
  $("scrub").setAttribute("aria-valuetext", clock);
  const far = m.swings ? m.swings.toLocaleString("en") + " swings + " : "";
  $("clock").textContent = `${far}${clock} of ${short(motion.end)}`;
  [0, 1].forEach(showRacer);
  if (!playing) [$("listing").textContent, $("digits").textContent] = [listing(), digits()];
}

// What changes with the start only.
function describe() {
  const usual = defaultsOf(m.scene), own = ASKED.slice(0, 12).some(name => m[name] !== usual[name]);
  const orbit = lib.page_orbit(), quasi = isLossy() ? lib.page_time_to_rest() : NaN;
  const rest = !isLossy() ? "none" : motion.restsAt > 0 ? "rests" : motion.more ? "moves" : "never";
  $("story").textContent = own ? `The scene ${sceneWord(m.scene, 0)} from another start.` : sceneWord(m.scene, 1) + ".";
  tell("resttext", rest, quasi > 0 ? timeText(quasi, 4) : "unknown", timeText(motion.restsAt, 4));
  tell("fartext", isLossy() ? "lossy" : !orbit ? "none" : m.swings ? "far" : "orbit",
    m.swings ? short(lib.page_orbit_error(farAhead() + motion.end, m.swings), 2) : timeText(swing(), 4));
  tell("racetext", isLossy() ? "lossy" : races.tooMany ? "many" : "equal");
}

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
const SLIDERS = {
  lean: [() => degrees(m.theta), x => ({ theta: x * Math.PI / 180 }), () => short(degrees(m.theta), 4) + "°"],
  wX: rate("wX"), wY: rate("wY"), wZ: rate("wZ"),
  hole: [() => m.inner / m.radius, x => ({ inner: x * m.radius }), () => short(m.inner / m.radius) + " radii"],
  strength: [() => isLossy() ? Math.log10(loss()) : -7, x => losses(law(), x < -6.99 ? 0 : 10 ** x),
    () => isLossy() ? power(loss()) : "none"],
  mu: [() => m.mu, x => ({ mu: x }), () => short(m.mu)],
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

// Swings ahead by the orbit; without one, by steps, and says so.
function jump(swings) {
  if (isLossy() || !swings || lib.page_orbit()) return change({ swings: isLossy() ? 0 : swings }, false);
  const begun = performance.now(), ahead = (swings > 1e7 ? 1e4 : 1e3) * unit();
  lib.page_at(0, m.now);
  const status = lib.page_start_here(ahead), took = performance.now() - begun;
  if (status >= 0) change(asked(START));
  say(status < 0 ? "coin_advance: " + statusWords(status) + "."
    : `No period to jump by: coin_advance went ${timeText(ahead)} ahead in ${short(took, 2)} ms.`);
}

function restAfter(time) {
  take(isLossy() ? m : { ...m, ...losses(law(), 1e-3) });
  const status = lib.page_rest_after(time);
  if (status >= 0) change(asked(LOSSES));
  else take(m), say("There are no such losses: " + statusWords(status) + ".");
}

async function copy(text, button) {
  const label = button.textContent, written = navigator.clipboard?.writeText(text);
  button.textContent = written ? await written.then(() => "Copied", () => "Not allowed") : "No clipboard";
  setTimeout(() => { button.textContent = label; }, 1500);
}

const ACTIONS = {
  play: () => play(!playing), reverse: () => { direction = -direction; play(true); },
  begin: () => pausedAt(0), back: () => pausedAt(m.now - m.dt), step: () => pausedAt(m.now + m.dt), here: startHere,
  million: () => jump(1e6), hundred: () => jump(1e8), near: () => jump(0),
  link: () => copy(location.href.replace(/#.*|$/, addressOf(m)), $("link")),
  copyc: () => copy($("listing").textContent, $("copyc")),
};
const KEYS = { " ": "play", r: "reverse", Home: "begin", ArrowLeft: "back", ArrowRight: "step", s: "here", l: "link" };
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

// ------------------------------------------------------------------- pointers --
const look = (az, el) => { m.az -= az; m.el = clamp(m.el + el, 0.08, 1.5); go(m.now); };
const zoom = f => { m.zoom = clamp(m.zoom * f, 0.3, 12); go(m.now); };

// Drag to look from elsewhere, or drag the coin to set it anew.
function listenToStage(canvas) {
  const fingers = new Map(), gap = (p, q) => Math.hypot(p.x - q.x, p.y - q.y);
  const spread = () => gap(...fingers.values());
  let grabbed = false, resume = false;
  canvas.addEventListener("pointerdown", e => {
    const [x, y] = stage.coinAt;
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    grabbed = fingers.size === 1 && Math.hypot(e.offsetX - x, e.offsetY - y) < Math.max(stage.coinSize, 14);
    if (!grabbed) return;
    resume = playing;
    play(false);
    startHere();
  });
  canvas.addEventListener("pointermove", e => {
    const finger = fingers.get(e.pointerId), before = fingers.size === 2 && spread();
    if (!finger) return;
    const dx = e.clientX - finger.x, dy = e.clientY - finger.y;
    Object.assign(finger, { x: e.clientX, y: e.clientY });
    if (before) { zoom(spread() / before); look(0, 0.004 * dy); }
    else if (grabbed) change({ theta: clamp(m.theta + 0.008 * dy, -1.5, 1.5), phi: m.phi + 0.01 * dx });
    else look(0.008 * dx, 0.006 * dy);
  });
  for (const kind of ["pointerup", "pointercancel"])
    canvas.addEventListener(kind, e => {
      fingers.delete(e.pointerId);
      if (grabbed && resume) play(true);
      grabbed = false;
    });
  canvas.addEventListener("wheel", e => { e.preventDefault(); zoom(Math.exp(e.deltaY / -700)); }, { passive: false });
}

function listen() {
  const on = (id, kind, act) => $(id).addEventListener(kind, e => act(e.target.value, e));
  for (const [id, act] of Object.entries(ACTIONS)) on(id, "click", () => act());
  for (const [id, [, read]] of Object.entries(SLIDERS))
    on(id, "input", x => change(read(Number(x)), !["mu", "dt", "speed"].includes(id)));
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
}

function begin() {
  for (const [id, g] of Object.entries(GRAPHS))
    Object.assign(g, { canvas: $(id + "graph"), value: $(id + "value"), still: document.createElement("canvas") });
  for (const [id, names] of Object.entries({ scene: sceneNames(), method: METHODS }))
    $(id).replaceChildren(...names.map((name, k) => new Option(name, k)));
  readColors();
  $("selftest").textContent = selfTest() ? "The library's bits: self-test passed" : "Other bits: self-test failed";
  scheduled = false;
  load(location.hash);
  listen();
}

loadLibrary().then(begin, error => { $("selftest").textContent = error.message + ": self-test failed"; });
