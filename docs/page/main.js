// SPDX-License-Identifier: MIT
// main.js: time, controls and what they say.

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
  while (motion.more && performance.now() - begun < 8)
    motion.more = lib.page_trail_on(lossy ? 1e12 * unit() : m.span, 100) === 0;
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

// ------------------------------------------------------------- what is said --
const say = text => { $("message").textContent = text; };

// Shows what the page says of a kind, with numbers where it has <b>.
function tell(id, kind, ...numbers) {
  for (const part of $(id).children) part.hidden = part.className !== kind;
  $(id).querySelectorAll(`.${kind} b`).forEach((b, k) => { b.textContent = numbers[k]; });
}

// The kind of the present, in a word, and why.
function verdict() {
  const s = motion.moment, bits = s[AT.bits], needs = "needs μ " + short(s[AT.ratio]);
  if (m.now >= motion.restsAt)
    return ["rests", isTossed() ? faceUp() : "At rest", "after " + timeText(motion.restsAt)];
  if (motion.flat && m.now >= motion.end) return ["rests", "Lies flat", "after " + timeText(motion.end)];
  if (motion.status < 0) return ["lifts", "Cannot be computed", statusWords(motion.status)];
  if (racing()) return raceVerdict();
  if (isReal() && bits & COIN.lifts) return ["lifts", "Flies", `${short(s[AT.y] / m.radius, 2)} radii high`];
  if (isReal() && bits & COIN.slips) return ["slips", "Slips", `it would need more than μ ${short(m.mu)}`];
  if (isReal()) return ["rolls", "Rolls", `${needs}, has ${short(m.mu)}`];
  if (bits & COIN.lifts)
    return ["lifts", "Is held down", `a real coin would lift off: N = ${short(s[AT.normal] / weight())} Mg`];
  return ["rolls", "Rolls", "a real coin " + needs];
}

const racerStatus = which => racer(which)[RACE.status];
const raceVerdict = () => [0, 1].some(which => racerStatus(which) < 0)
  ? ["rolls", "coin_advance gets through", "where a fixed step does not"]
  : ["rolls", "All three go on", "from the same start, until a step is too long"];

// What a racer comes to: it went through the table, it refused, or it errs.
function racerWords(which) {
  const r = racer(which), status = r[RACE.status], at = timeText(r[RACE.steps] * m.dt);
  if (status === COIN.through) return `went through the table at ${at}`;
  if (status < 0) return `refused at ${at}: the step would be wrong`;
  const off = r[RACE.pose] < 1e-12 ? "less than 10⁻¹²" : short(r[RACE.pose], 2);
  return `off by ${off}${status === COIN.coarse ? ", and warns: coarse" : ""}`;
}

function showRace() {
  const out = [0, 1].some(which => racerStatus(which) < 0), ours = out ? "gets through" : "chooses its steps";
  $("racers").hidden = !m.swings && (!racing() || races.tooMany);
  $("fixed").hidden = m.swings > 0;
  const words = m.swings ? farWords()
    : [racerName(0), racerWords(0), racerName(1), racerWords(1), "coin_advance", ours];
  $("racers").querySelectorAll("b, span").forEach((e, k) => { e.textContent = words[k]; });
}

function farWords() {
  const n = m.swings.toLocaleString("en"), at = Math.floor(far.steps * 0.1 * unit() / swing()).toLocaleString("en");
  const r = racer(0), off = `off by ${short(r[RACE.pose], 2)} rad, the energy by ${short(100 * r[RACE.energy], 2)} %`;
  const error = short(lib.page_orbit_error(farAhead() + motion.end, m.swings), 2);
  return ["RK4, steps of 0.1 √(a/g)", far.there ? off : `at swing ${at} of ${n}`, "", "", "coin_orbit_at",
    `is there without a step, off by at most ${error}`];
}

// Sign, word and reason change together, the word not more often than can be read.
function showTime(time) {
  const [kind, word, why] = verdict(), clock = timeText(m.now, 4), same = $("verdict").textContent === word;
  if (same) $("why").textContent = why;
  else if (!playing || time - verdictSince > 400) {
    $("light").dataset.kind = kind;
    $("verdict").textContent = word;
    $("why").textContent = why;
    verdictSince = time;
  }
  $("scrub").value = motion.end ? m.now / motion.end : 0;
  $("scrub").setAttribute("aria-valuetext", clock);
  const far = m.swings ? m.swings.toLocaleString("en") + " swings + " : "";
  $("clock").textContent = `${far}${clock} of ${short(motion.end)}`;
  showRace();
  if (!playing) [$("listing").textContent, $("digits").textContent] = [listing(), digits()];
}

// One sentence on what is seen.
function story() {
  const usual = defaultsOf(m.scene), own = ASKED.slice(0, 16).some(name => m[name] !== usual[name]);
  if (isTossed()) return "A tossed coin flies, bounces, slips, rolls and lies down";
  if (racing()) return "Three methods move one coin from the same start";
  if (m.swings) return `The same coin ${m.swings.toLocaleString("en")} swings later, without a step on the way`;
  if (isLossy()) return "Losses slow the coin until it lies flat";
  return own ? "A coin from a start of your own" : sceneWord(m.scene, 1);
}

// What changes with the start only.
function describe() {
  const orbit = lib.page_orbit();
  const rest = motion.restsAt > 0 ? "rests" : motion.more ? "moves" : "never";
  $("story").textContent = story() + ".";
  document.body.dataset.race = racing();
  tell("resttext", rest, timeText(motion.restsAt, 4));
  tell("fartext", isLossy() || isReal() ? "lossy" : !orbit ? "none" : m.swings ? "far" : "orbit",
    m.swings ? short(lib.page_orbit_error(farAhead() + motion.end, m.swings), 2) : timeText(swing(), 4));
  tell("racetext", isLossy() || isReal() ? "lossy" : races.tooMany ? "many" : "equal");
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

// A toss as by a thumb, to a height of some radii: the coin spins about a diameter
// as it rises.
function toss() {
  const any = (low, high) => low + (high - low) * Math.random(), rate = 1 / unit(), speed = m.radius * rate;
  fly({ theta: any(0.9, 1.4), phi: any(-3, 3), psi: any(-3, 3), x: 0, z: 0,
    wX: any(2, 4) * rate, wY: any(-1, 1) * rate, wZ: any(-1, 1) * rate, y: 2 * m.radius,
    vx: any(-0.5, 0.5) * speed, vy: any(2.5, 3.5) * speed, vz: any(-0.5, 0.5) * speed });
}

// Lets a real coin go.
function fly(parts) {
  tosses.counted = false;
  direction = 1;
  change({ ...parts, mu: isReal() ? m.mu : 0.3, race: 0, speed: 4 * unit(),
    ...(isLossy() ? {} : losses("dry", 0.01)) });
  play(true);
}

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

// ------------------------------------------------------------------- pointers --
const look = (az, el) => { m.az -= az; m.el = clamp(m.el + el, 0.08, 1.5); go(m.now); };
const zoom = f => { m.zoom = clamp(m.zoom * f, 0.3, 12); go(m.now); };

// Carries the coin over the table by so many pixels, at rest and turning as it did.
function carry(dx, dy) {
  const radii = 1 / stage.coinSize, along = dx * radii * m.radius;
  change({ mu: isReal() ? m.mu : 0.3, race: 0, x: m.x + along * Math.cos(m.az), z: m.z - along * Math.sin(m.az),
    y: Math.max((isTossed() ? m.y : m.radius * Math.cos(m.theta)) - dy * radii * m.radius,
      m.radius * Math.cos(m.theta)), vx: 0, vy: 0, vz: 0 });
}

// Lets it go with the speed of the pointer [pixels in a second], as the page shows
// time; it spins the faster the faster it goes.
function letGo(vx, vy) {
  const speed = m.radius / stage.coinSize * Math.max(1 / (4 * unit()), 1), across = vx * speed, up = -vy * speed;
  const most = 4 * m.radius / unit(), part = Math.min(1, most / Math.hypot(across, up));
  fly({ vx: part * across * Math.cos(m.az), vz: -part * across * Math.sin(m.az), vy: part * up,
    wX: m.wX + 0.8 * part * up / m.radius });
}

// Drag the table to look from elsewhere; drag the coin and let it go to throw it.
function listenToStage(canvas) {
  const fingers = new Map(), gap = (p, q) => Math.hypot(p.x - q.x, p.y - q.y);
  const spread = () => gap(...fingers.values());
  const isCoin = (x, y) => Math.hypot(x - stage.coinAt[0], y - stage.coinAt[1]) < Math.max(stage.coinSize, 22);
  let grabbed = false, carried = false, resume = false;
  canvas.addEventListener("pointerdown", e => {
    $("hint").hidden = true;
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, { x: e.clientX, y: e.clientY, time: e.timeStamp, vx: 0, vy: 0 });
    grabbed = fingers.size === 1 && isCoin(e.offsetX, e.offsetY);
    carried = false;
    if (!grabbed) return;
    resume = playing;
    play(false);
    startHere();
  });
  canvas.addEventListener("pointermove", e => {
    const finger = fingers.get(e.pointerId), before = fingers.size === 2 && spread();
    if (!finger) return;
    const dx = e.clientX - finger.x, dy = e.clientY - finger.y, passed = Math.max(e.timeStamp - finger.time, 1) / 1e3;
    Object.assign(finger, { x: e.clientX, y: e.clientY, time: e.timeStamp,
      vx: (finger.vx + dx / passed) / 2, vy: (finger.vy + dy / passed) / 2 });
    if (before) { zoom(spread() / before); look(0, 0.004 * dy); }
    else if (grabbed) { carry(dx, dy); carried = true; }
    else look(0.008 * dx, 0.006 * dy);
  });
  for (const kind of ["pointerup", "pointercancel"])
    canvas.addEventListener(kind, e => {
      const { vx, vy, time } = fingers.get(e.pointerId) || {}, still = !(e.timeStamp - time < 80);
      fingers.delete(e.pointerId);
      if (grabbed && carried) letGo(still ? 0 : vx, still ? 0 : vy);
      else if (grabbed && resume) play(true);
      grabbed = false;
    });
  canvas.addEventListener("touchstart", e => { // else a finger on the coin would scroll the page
    const { left, top } = canvas.getBoundingClientRect(), { clientX, clientY } = e.touches[0];
    if (e.touches.length > 1 || isCoin(clientX - left, clientY - top)) e.preventDefault();
  }, { passive: false });
  canvas.addEventListener("wheel", e => { e.preventDefault(); zoom(Math.exp(e.deltaY / -700)); }, { passive: false });
}

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
