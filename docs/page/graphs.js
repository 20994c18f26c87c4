// SPDX-License-Identifier: MIT
// graphs.js: height, speed, lean, force, phase portrait, errors and energy, in time.

const RACE_STEPS = 2e5; // at most
const races = { looks: [], tooMany: false }; // looks: t, errors of pose, energies

function runRaces() {
  races.tooMany = racing() && motion.end / m.dt > RACE_STEPS;
  const count = racing() && !races.tooMany ? lib.page_races(m.method, m.dt) : 0;
  races.looks = Array.from({ length: count }, (_, k) => doubles(lib.page_looks() + 40 * k, 5).slice());
}

const racerColor = which => which ? COLORS.method : COLORS.textbook;
const racerName = which => which ? METHODS[m.method] + ", fixed step" : m.swings ? "RK4" : "A textbook's RK4";
// Curves are lists of points, along the trail some 2000 at most, or of both racers.
const some = k => Math.min(k * Math.ceil(motion.count / 2000), motion.count - 1);
const curve = (x, y) =>
  [Array.from({ length: Math.min(motion.count, 2001) }, (_, k) => [x(some(k)), y(some(k))]), COLORS.path];
const column = (what, f = x => x) => k => f(knot(k, what));
const raceCurves = (at, f) => [0, 1].map(which =>
  [races.looks.map(row => [row[0] / second(), f(row[at + which])]), racerColor(which)]);
const extremes = what => [lib.page_extreme(what, 0), lib.page_extreme(what, 1)];
function around0(what, least, f = x => x) {
  const [low, high] = extremes(what).map(f), half = Math.max((high - low) * 0.56, least);
  return [(low + high) / 2 - half, (low + high) / 2 + half];
}

// A graph draws its curves once, and the present over them in each frame.
const speedAt = k => metersPerSecond(Math.hypot(knot(k, AT.vx), knot(k, AT.vy), knot(k, AT.vz)));
const speedOf = s => metersPerSecond(Math.hypot(s[AT.vx], s[AT.vy], s[AT.vz]));
const seconds = () => curveTime(x => x / second());
const curveTime = f => column(AT.t, f);
const nowIn = () => m.now / second();
const GRAPHS = {
  height: { shade: true, flight: true, curves: () => [curve(seconds(), column(AT.y, mm))],
    y: () => [0, 1.1 * mm(extremes(AT.y)[1])], now: s => [nowIn(), mm(s[AT.y])], say: s => lengthText(s[AT.y]) },
  speed: { shade: true, flight: true, curves: () => [curve(seconds(), speedAt)], y: () => [0, 1.1 * fastestSpeed()],
    now: s => [nowIn(), speedOf(s)], say: s => short(speedOf(s)) + " m/s" },
  lean: { shade: true, curves: () => [curve(seconds(), column(AT.theta, degrees))],
    y: () => around0(AT.theta, 0.5, degrees),
    now: s => [nowIn(), degrees(s[AT.theta])], say: s => short(degrees(s[AT.theta]), 4) + "°" },
  force: { shade: true, y: () => [0, isReal() ? 1.35 * m.mu || 1 : clamp(1.1 * extremes(AT.ratio)[1], 0.1, 2)],
    curves: () => [...(isReal() ? [[[[0, m.mu], [motion.end / second(), m.mu]], COLORS.good]] : []),
      curve(seconds(), k => flies(knot(k, AT.bits)) ? NaN : Math.min(knot(k, AT.ratio), 1e9))],
    now: s => [nowIn(), s[AT.ratio]], say: s => flies(s[AT.bits]) ? "in the air" : short(s[AT.ratio], 4) },
  phase: { curves: () => [curve(column(AT.theta, degrees), column(AT.wX, turns))],
    x: () => around0(AT.theta, 0.5, degrees), y: () => around0(AT.wX, 0.1, turns),
    now: s => [degrees(s[AT.theta]), turns(s[AT.wX])], say: s => short(turns(s[AT.wX])) + " turns/s" },
  error: { y: () => [-16, 2], tick: y => "10" + raised(y),
    curves: () => raceCurves(1, e => Math.log10(Math.max(e, 1e-16))),
    say: () => races.tooMany ? "too many steps"
      : [0, 1].map(k => racer(k)[RACE.status] < 0 ? "out" : short(racer(k)[RACE.pose], 2)).join(", ") },
  energy: {
    curves: () => [curve(seconds(), column(AT.energy, e => e / knot(0, AT.energy))), ...raceCurves(3, e => e)],
    y: () => [0, 1.06 * Math.max(1.1, ...races.looks.map(row => Math.min(Math.max(row[3] || 0, row[4] || 0), 2)))],
    now: s => [nowIn(), s[AT.energy] / knot(0, AT.energy)], say: s => short(s[AT.energy] / knot(0, AT.energy), 5) },
};

function fastestSpeed() {
  let most = 1e-3;
  for (let k = 0; k < motion.count; k += Math.ceil(motion.count / 2000)) most = Math.max(most, speedAt(k));
  return most;
}

// Round numbers between two, three to six of them.
function ticks(low, high) {
  const step = 10 ** Math.floor(Math.log10(high - low));
  const big = [5, 2, 1, 0.5, 0.2].find(f => (high - low) / (f * step) >= 2) * step;
  return Array.from({ length: 12 }, (_, k) => (Math.ceil(low / big) + k) * big).filter(v => v <= high)
    .map(v => Number(v.toPrecision(6)));
}

const EDGE = { left: 40, right: 8, top: 3, bottom: 16 };
const isShown = g => g.canvas.clientWidth > 0;
function drawGraph(g) {
  if (!isShown(g)) return;
  const { c, w, h } = cleared(g.still, g.canvas), [y0, y1] = g.y();
  const [x0, x1] = g.x ? g.x() : [0, motion.end / second() || 1];
  const { left, right, top, bottom } = EDGE, wide = w - left - right, high = h - top - bottom;
  g.X = x => left + wide * (x - x0) / (x1 - x0);
  g.Y = y => clamp(top + high * (y1 - y) / (y1 - y0), -h, 2 * h);
  if (g.shade) shade(c, g, high);
  Object.assign(c, { font: "11px system-ui, sans-serif", fillStyle: COLORS.muted, textAlign: "right" });
  for (const y of ticks(y0, y1)) {
    c.fillText(g.tick ? g.tick(y) : String(y).replace("-", "−"), left - 5, g.Y(y) + 4);
    stroke(c, polyline([[left, g.Y(y)], [w - right, g.Y(y)]]), COLORS.grid, 1);
  }
  c.textAlign = "center";
  for (const x of ticks(x0, x1))
    if (g.X(x) < w - 14) c.fillText(String(x).replace("-", "−"), g.X(x), h - 3);
  c.clip(new Path2D(`M${left},${top}h${wide}v${high}h${-wide}z`));
  for (const [points, color] of g.curves())
    stroke(c, polyline(points.filter(([, y]) => Number.isFinite(y)).map(([x, y]) => [g.X(x), g.Y(y)])), color, 1.6);
}

// Bands where the coin slips or is in the air, or an ideal one would lift off.
function shade(c, g, high) {
  for (let k = 1; k < motion.count;) {
    const color = knotColor(knot(k, AT.bits)), x = g.X(knot(k - 1, AT.t) / second());
    do ++k; while (k < motion.count && knotColor(knot(k, AT.bits)) === color);
    c.fillStyle = color + "2c";
    if (color !== COLORS.path) c.fillRect(x, EDGE.top, g.X(knot(k - 1, AT.t) / second()) - x, high);
  }
}

// The present: a line at its time, and a dot on the curve.
function markGraph(g) {
  if (!isShown(g) || !g.X) return;
  const { c, w, h } = cleared(g.canvas), low = h - EDGE.bottom;
  c.drawImage(g.still, 0, 0, w, h);
  if (!g.x) stroke(c, polyline([[g.X(nowIn()), EDGE.top], [g.X(nowIn()), low]]), COLORS.muted, 1);
  const [x, y] = g.now ? g.now(motion.moment) : [];
  if (g.now) fill(c, disc(g.X(x), clamp(g.Y(y), EDGE.top, low), 3.4), COLORS.ink);
  g.value.textContent = g.say(motion.moment);
}
