// SPDX-License-Identifier: MIT
// controls.js: sliders, buttons and keys; files and links; the beginning.

// Sliders: what they show of m, what m becomes, and their text.
const rate = name => [() => turns(m[name]), x => ({ [name]: perTurn(x) }), () => short(turns(m[name])) + " turns/s"];
const share = () => [() => m.bounce, x => ({ bounce: x }), () => short(m.bounce, 2)];
const thick = () => [() => m.thickness / m.radius,
  x => ({ thickness: x < 1e-3 ? 0 : x * m.radius, inner: 0, ...(isReal() ? {} : onTable()) }),
  () => m.thickness > 0 ? lengthText(m.thickness) : "none"];
const UNITS_OF_TIME = { viscous: 1, layer: 1.5, gap: 1, spin: 1 };
const torqueUnit = name => weight() * m.radius * unit() ** (UNITS_OF_TIME[name] || 0);
const lossUnit = name => ({ damping: 1, angular: 1 / unit() })[name] || torqueUnit(name);
const law = () => LOSSES.find(name => m[name] > 0) || $("law").value;
const losses = (name, x) => ({ ...Object.fromEntries(LOSSES.map(other => [other, 0])), [name]: x * lossUnit(name) });
const loss = () => m[law()] / lossUnit(law());
const IDEAL = { mu: Infinity, y: 0, vx: 0, vy: 0, vz: 0, thickness: 0 };
const SLIDERS = {
  lean: [() => degrees(m.theta), x => ({ theta: x * Math.PI / 180 }), () => short(degrees(m.theta)) + "°"],
  wX: rate("wX"), wY: rate("wY"), wZ: rate("wZ"),
  height: [() => mm(m.y), x => ({ y: x < 0.5 ? 0 : x / mm(1), ...(isReal() ? {} : onTable()) }),
    () => isTossed() ? lengthText(m.y) : "on the table"],
  hole: [() => m.inner / m.radius, x => ({ inner: x * m.radius, thickness: 0 }), () => lengthText(m.inner)],
  strength: [() => isLossy() ? Math.log10(loss()) : -7, x => losses(law(), x < -6.99 ? 0 : 10 ** x),
    () => isLossy() ? power(loss()) : "none"],
  mu: [() => Math.min(m.mu, 1.05), x => x > 1 ? IDEAL : { mu: x },
    () => isReal() ? short(m.mu, 2) : "it never slips"],
  bounce: share(), mapbounce: share(), thick: thick(), mapthick: thick(),
  dt: [() => Math.log10(m.dt / unit()), x => ({ dt: 10 ** x * unit() }), () => timeText(m.dt)],
  speed: [() => Math.log10(m.speed / second()), x => ({ speed: 10 ** x * second() }), paceText],
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
  else take(m), say("No losses do that: " + plainWords(status) + ".");
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

const copyLink = button => copy(location.href.replace(/#.*|$/, addressOf(m)), button);
const ACTIONS = {
  play: () => play(!playing), reverse: () => { direction = -direction; play(true); },
  begin: () => pausedAt(0), back: () => pausedAt(m.now - m.dt), step: () => pausedAt(m.now + m.dt), here: startHere,
  toss, slow: () => { slow = slow === 1 ? SLOW : 1; $("slow").setAttribute("aria-pressed", slow < 1); wake(); },
  sound: () => switchSound(!sound.on), closer: () => zoomMap(4), farther: () => zoomMap(1 / 4),
  maplink: () => copyLink($("maplink")),
  million: () => jump(1e6), near: () => jump(0),
  csv: () => save("run.csv", new Blob([csv()], { type: "text/csv" })), picture,
  link: () => copyLink($("link")),
  copyc: () => copy($("listing").textContent, $("copyc")),
};
const KEYS = { " ": "play", r: "reverse", Home: "begin", ArrowLeft: "back", ArrowRight: "step", s: "here", l: "link",
  t: "toss", w: "slow", m: "sound" };
const ARROWS = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };

function onKey(e) {
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.closest("input, select, summary, pre")) return;
  if (e.key === " " && e.target.closest("button, a")) return;
  const onStage = e.target === $("stage"), act = ACTIONS[KEYS[e.key]];
  if (onStage && ARROWS[e.key]) look(...ARROWS[e.key]);
  else if (e.target === $("map") && ARROWS[e.key]) tossBeside(...ARROWS[e.key].map(x => -30 * x));
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
  on("rest", "change", x => restAfter(Number(x) * second()));
  for (const g of Object.values(GRAPHS).filter(graph => !graph.x))
    g.canvas.addEventListener("pointerdown", e =>
      pausedAt((e.offsetX - g.X(0)) / (g.X(motion.end / second()) - g.X(0)) * motion.end));
  document.addEventListener("keydown", onKey);
  $("skip").addEventListener("click", e => { e.preventDefault(); $("stage").focus(); });
  window.addEventListener("hashchange", e => load(new URL(e.newURL).hash));
  window.addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  for (const kind of ["pointerdown", "click", "keydown"]) document.addEventListener(kind, beginSound);
  for (const e of document.querySelectorAll("details")) e.addEventListener("toggle", redraw);
  listenToStage($("stage"));
  listenToMap($("map"));
}

const redraw = () => { readColors(); Object.values(GRAPHS).forEach(drawGraph); wake(); };

// ----------------------------------------------------------------- beginning --
function load(hash) {
  const { state, complaints } = readAddress(hash);
  clearTimeout(keeping);
  m = state;
  direction = 1;
  tosses.counted = !isTossed();
  motion.drawnAt = 0;
  view.fresh = true;
  say("");
  rebuild(state);
  if (complaints.length) say("This link has parts that mean nothing here: " + complaints.join("; ") + ".");
  showControls();
  play(m.play && !matchMedia("(prefers-reduced-motion: reduce)").matches);
  write();
}

function begin(module) {
  for (const [id, g] of Object.entries(GRAPHS))
    Object.assign(g, { canvas: $(id + "graph"), value: $(id + "value"), still: document.createElement("canvas") });
  for (const [id, names] of Object.entries({ scene: sceneNames(), method: METHODS }))
    $(id).replaceChildren(...names.map((name, k) => new Option(name, k)));
  readColors();
  document.body.classList.toggle("embed", new URLSearchParams(location.search).get("embed") === "1");
  for (const e of document.querySelectorAll(".drawer")) e.open = matchMedia("(min-width: 901px)").matches;
  scheduled = false;
  const chosen = location.hash !== "";
  load(location.hash);
  if (!chosen && playing) toss();
  listen();
  sound.on = remembered();
  showSound();
  beginWorkers(module);
}

loadLibrary().then(begin, error => { $("selftest").textContent = error.message + ": self-test failed"; });
