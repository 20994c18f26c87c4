// SPDX-License-Identifier: MIT
// scene.js: the coin on its table, in perspective.  Lengths are in radii.

const COLORS = {}; // by name, from style.css
function readColors() {
  const style = getComputedStyle(document.documentElement);
  for (const name of "ink muted faint panel table grid path warn good lift textbook method".split(" "))
    COLORS[name] = style.getPropertyValue("--" + name).trim();
}

// A canvas as sharp as the screen, and as large as another, cleared.
function cleared(canvas, like = canvas) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2), c = canvas.getContext("2d");
  const w = like.clientWidth || 1, h = like.clientHeight || 1;
  canvas.width = Math.round(w * ratio);
  canvas.height = Math.round(h * ratio);
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { c, w, h };
}

const stroke = (c, path, color, width) => Object.assign(c, { strokeStyle: color, lineWidth: width }).stroke(path);
const fill = (c, path, color) => Object.assign(c, { fillStyle: color }).fill(path, "evenodd");
const around = (count, f) => Array.from({ length: count }, (_, k) => f(2 * Math.PI * k / count));
const polyline = (points, end = "") => new Path2D("M" + points.join("L") + end);
const disc = (x, y, r) => polyline(around(60, u => [x + r * Math.cos(u), y + r * Math.sin(u)]), "Z");

// --------------------------------------------------------------- perspective --
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sum = (a, f, b) => [a[0] + f * b[0], a[1] + f * b[1], a[2] + f * b[2]];

// Looks at target from a distance; its image is at (x, y) of the canvas.
function cameraAt(target, distance, x, y, size) {
  const sa = Math.sin(m.az), ca = Math.cos(m.az), se = Math.sin(m.el), ce = Math.cos(m.el);
  const toward = [ce * sa, se, ce * ca], right = [ca, 0, -sa], up = [-se * sa, ce, -se * ca];
  const view = p => {
    const d = sum(p, -1, target);
    return [dot(d, right), dot(d, up), distance - dot(d, toward)];
  };
  const screen = ([vx, vy, depth]) => [x + size * vx / depth, y - size * vy / depth];
  return { eye: sum(target, distance, toward), scale: size / distance, near: 0.05 * distance, view, screen,
    to: p => screen(view(p)) };
}

// Adds a line through points to a path, cut off where it comes behind the camera.
function trace(path, camera, points, closed) {
  const seen = (closed ? [...points, points[0]] : points).map(camera.view);
  let drawing = false;
  const to = v => { path[drawing ? "lineTo" : "moveTo"](...camera.screen(v)); drawing = true; };
  seen.forEach((v, k) => {
    const front = v[2] > camera.near, last = seen[k - 1];
    if (last && front !== last[2] > camera.near)
      to(sum(last, (camera.near - last[2]) / (v[2] - last[2]), sum(v, -1, last)));
    if (front) to(v);
    drawing = drawing && (front || Boolean(closed));
  });
  return path;
}

const line = (c, camera, points, color, width, closed) =>
  stroke(c, trace(new Path2D(), camera, points, closed), color, width);
const area = (c, camera, outlines, color) =>
  fill(c, outlines.reduce((path, points) => trace(path, camera, points, true), new Path2D()), color);

// ------------------------------------------------------- the table, the trail --
// What of the table is seen: a circle in radii.  It follows the path as that grows.
const LEAST_SEEN = 2.4;
const view = { x: 0, z: 0, R: LEAST_SEEN };
function follow() {
  const [x, z] = motion.center, R = Math.max(motion.reach + 0.8, 0.6 * motion.height, LEAST_SEEN);
  const part = playing ? 0.1 : 1;
  for (const [name, value] of Object.entries({ x, z, R })) view[name] += part * (value - view[name]);
}

function drawTable(c, camera) {
  const { x, z } = view, R = 1.25 * view.R, grid = new Path2D();
  const step = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].find(s => R / s < 9) || R / 5;
  area(c, camera, [around(96, u => [x + R * Math.cos(u), 0, z + R * Math.sin(u)])], COLORS.table);
  for (let k = -9; k <= 9; ++k) {
    const gx = (Math.round(x / step) + k) * step, gz = (Math.round(z / step) + k) * step;
    const hx = Math.sqrt(R * R - (gz - z) ** 2), hz = Math.sqrt(R * R - (gx - x) ** 2);
    if (hz > 0) trace(grid, camera, [[gx, 0, z - hz], [gx, 0, z + hz]]);
    if (hx > 0) trace(grid, camera, [[x - hx, 0, gz], [x + hx, 0, gz]]);
  }
  stroke(c, grid, COLORS.grid, 1);
}

const SHOWN = 5000; // knots at most, on each side of the present
const knotColor = bits => bits & COIN.lifts ? COLORS.lift : bits & COIN.slips ? COLORS.warn : COLORS.path;
const contact = s => [s[AT.cx] / m.radius, 0, s[AT.cz] / m.radius];
const contactAt = k => [knot(k, AT.cx) / m.radius, 0, knot(k, AT.cz) / m.radius];

const flies = bits => isReal() && (bits & COIN.lifts) !== 0;
const pathAt = k => flies(knot(k, AT.bits))
  ? [AT.theta + 3, AT.y, AT.theta + 4].map(what => knot(k, what) / m.radius) : contactAt(k);

// The path between two knots, a colour for each stretch: of the contact, in the
// air of the centre.  It has a gap where the contact leaps, as in a bounce.  Where
// the coin slips it leaves a broad mark.  `clear` is how opaque, in hexadecimal.
function drawPath(c, camera, first, last, width, clear) {
  for (let k = first; k < last;) {
    const bits = knot(k, AT.bits), points = [pathAt(k)];
    while (++k <= last) {
      const step = sum(pathAt(k), -1, points.at(-1));
      if (flies(knot(k, AT.bits)) !== flies(bits) || dot(step, step) > 0.25) break;
      points.push(pathAt(k));
      if (knotColor(knot(k, AT.bits)) !== knotColor(bits)) break;
    }
    c.setLineDash(flies(bits) ? [1, 5] : []);
    line(c, camera, points, knotColor(bits) + clear, bits & COIN.slips ? 2.2 * width : width);
  }
  c.setLineDash([]);
}

// The whole path faint, but not what a tossed coin is yet to do; and what is
// behind the coin.
function drawTrail(c, camera, width) {
  const now = lib.page_before(m.now), first = Math.max(0, now - SHOWN), s = motion.moment;
  c.lineJoin = c.lineCap = "round";
  if (!isTossed()) drawPath(c, camera, first, Math.min(motion.count - 1, now + SHOWN), 1, "50");
  drawPath(c, camera, first, now, width, "");
  if (!isReal()) line(c, camera, [contactAt(now), contact(s)], knotColor(s[AT.bits]), width);
}

// ------------------------------------------------------------------- the coin --
const THICK = 0.06; // half of it: the library's coin has none
const LIGHT = [-0.42, 0.85, 0.32]; // where it comes from, as in README's animation
const hole = () => Math.min(m.inner / m.radius, 0.94);

// Points of a coin from its pose, which begins at a place of an array, and its
// height: at a radius, an angle from e_X, and a height above the middle of the coin.
function coinFrom(s, at, y = Math.cos(s[at])) {
  const [theta, phi, psi] = s.subarray(at, at + 3);
  const st = Math.sin(theta), ct = Math.cos(theta), sp = Math.sin(phi), cp = Math.cos(phi);
  const X = [cp, 0, -sp], Y = [st * sp, ct, st * cp], Z = [ct * sp, -st, ct * cp];
  const center = [s[at + 3] / m.radius, y + THICK * Math.abs(st), s[at + 4] / m.radius];
  const point = (r, u, h) => sum(sum(sum(center, r * Math.cos(u), X), r * Math.sin(u), Y), h, Z);
  return { center, Z, psi, point, ring: (r, h) => around(64, u => point(r, u + psi, h)) };
}

const withHole = ring => m.inner > 0 ? [ring(1), ring(hole())] : [ring(1)];

const drawShadow = (c, camera, coin) => area(c, camera, withHole(r => coin.ring(r, 0).map(([x, y, z]) =>
  [x - y * LIGHT[0] / LIGHT[1], 0, z - y * LIGHT[2] / LIGHT[1]])), "#10182038");

// The edge: copper, milled.  Those of its pieces that look this way are the
// second half.
function drawEdge(c, camera, coin) {
  const front = coin.ring(1, THICK), back = coin.ring(1, -THICK), n = front.length;
  const facing = k => dot(sum(front[k], -1, coin.center), sum(camera.eye, -1, front[k])) > 0;
  for (const k of [...front.keys()].sort((p, q) => facing(p) - facing(q))) {
    const lit = clamp(0.5 + 0.55 * dot(sum(front[k], -1, coin.center), LIGHT), 0, 1), groove = k % 2 ? 1 : 0.86;
    const color = [93 + 145 * lit, 70 + 138 * lit, 54 + 126 * lit].map(v => Math.round(v * groove));
    area(c, camera, [[front[k], front[(k + 1) % n], back[(k + 1) % n], back[k]]], `rgb(${color})`);
  }
}

// What is embossed on a face, as outlines in radii: a star on heads (+Z), a wheel
// on tails.
const at = (r, u) => [r * Math.cos(u), r * Math.sin(u)];
const circle = r => around(40, u => at(r, u));
const STAR = around(10, u => at(Math.round(5 * u / Math.PI) % 2 ? 0.21 : 0.55, u));
const spoke = u => [[-0.05, -0.05], [0.45, -0.05], [0.45, 0.05], [-0.05, 0.05]]
  .map(([x, y]) => [x * Math.cos(u) - y * Math.sin(u), x * Math.sin(u) + y * Math.cos(u)]);
const RELIEF = { heads: [[STAR]], tails: [[circle(0.55), circle(0.43)], ...around(6, u => [spoke(u)])] };

// A face as the light falls on it: metal, a raised rim, relief, and the dot that
// shows how it turns.
function drawFace(c, camera, coin, side) {
  const h = side * THICK, ring = r => coin.ring(r, h), width = clamp(camera.scale / 60, 0.6, 2.2);
  const normal = coin.Z.map(v => v * side), toEye = sum(camera.eye, -1, coin.center);
  const half = sum(LIGHT, 1 / Math.hypot(...toEye), toEye);
  const light = 0.62 + 0.42 * Math.max(0, dot(normal, LIGHT));
  const shine = 90 * (Math.max(0, dot(normal, half)) / Math.hypot(...half)) ** 24;
  const metal = (...rgb) => `rgb(${rgb.map(v => Math.round(clamp(v * light + shine, 0, 255)))})`;
  const dark = metal(120, 131, 142);
  const emboss = (outlines, color) => area(c, camera, outlines.map(points =>
    points.map(([x, y]) => coin.point(Math.hypot(x, y), Math.atan2(y, x) + coin.psi, h))), color);
  area(c, camera, withHole(ring), metal(221, 226, 231));
  if (m.inner === 0) {
    area(c, camera, [ring(0.88)], metal(198, 205, 212));
    line(c, camera, ring(0.88), dark, 0.7 * width, true);
    RELIEF[side > 0 ? "heads" : "tails"].forEach(outlines => emboss(outlines, dark));
  }
  const middle = m.inner > 0 ? (1 + hole()) / 2 : 0.72, size = Math.min(0.085, 0.42 * (1 - hole()));
  emboss([circle(size).map(([x, y]) => [x + middle, y])], "#d55e00");
  withHole(ring).forEach(points => line(c, camera, points, dark, 0.6 * width, true));
}

function drawCoin(c, camera, coin) {
  const side = dot(coin.Z, sum(camera.eye, -1, coin.center)) > 0 ? 1 : -1;
  if (m.inner > 0) drawFace(c, camera, coin, -side);
  drawEdge(c, camera, coin);
  drawFace(c, camera, coin, side);
}

// A coin that fixed steps have moved: its outline.
function drawGhost(c, camera, which) {
  const coin = coinFrom(racer(which), RACE.shown), color = racerColor(which);
  if (!Number.isFinite(dot(coin.center, coin.Z))) return;
  area(c, camera, withHole(r => coin.ring(r, 0)), color + "24");
  withHole(r => coin.ring(r, 0)).forEach(points => line(c, camera, points, color, 2, true));
  line(c, camera, [coin.point(hole(), coin.psi, 0), coin.point(1, coin.psi, 0)], color, 2);
  nameCoin(c, camera, coin, racerName(which), color, which ? "right" : "left", which ? 20 : 4);
}

// Its name right of a coin, or left of it, so many pixels below its centre and
// within the picture.
function nameCoin(c, camera, coin, name, color, side, below = 4) {
  const [x, y] = camera.to(coin.center), off = 1.2 * camera.scale, edge = $("stage").clientWidth - 4;
  Object.assign(c, { font: "600 13px system-ui, sans-serif", fillStyle: color, strokeStyle: COLORS.table,
    lineWidth: 4 });
  const wide = c.measureText(name).width, left = side === "right" ? x + off : x - off - wide;
  for (const draw of ["strokeText", "fillText"]) c[draw](name, clamp(left, 4, edge - wide), y + below);
}

// The reaction, 2.2 radii long when it is the weight and 3 at most, and the cone
// that friction allows it.  The coin hides what is behind it.
function drawForce(c, camera) {
  const s = motion.moment, from = contact(s), R = [...s.subarray(AT.R, AT.R + 3)], color = knotColor(s[AT.bits]);
  const scale = Math.min(2.2 / weight(), 3 / Math.hypot(...R)), height = s[AT.normal] * scale;
  if (s[AT.bits] & COIN.rests || !R.some(x => x)) return;
  if (height > 0 && m.mu > 0 && isReal()) {
    const rim = around(48, u => sum(from, height, [m.mu * Math.cos(u), 1, m.mu * Math.sin(u)]));
    const tip = camera.to(from), slope = ([x, y]) => (x - tip[0]) / (tip[1] - y || 1);
    const sides = rim.map(camera.to).sort((p, q) => slope(p) - slope(q));
    line(c, camera, rim, COLORS.good + "90", 1.4, true);
    stroke(c, polyline([sides[0], tip, sides.pop()]), COLORS.good + "90", 1.4);
    area(c, camera, [rim], COLORS.good + "20");
  }
  const to = sum(from, scale, R), [ax, ay] = camera.to(from), [bx, by] = camera.to(to);
  const turn = Math.atan2(by - ay, bx - ax), barb = u => [bx + 9 * Math.cos(turn + u), by + 9 * Math.sin(turn + u)];
  line(c, camera, [from, to], color, 2.5);
  stroke(c, polyline([barb(2.6), [bx, by], barb(-2.6)]), color, 2.5);
}

// ------------------------------------------------------------------ the stage --
const stage = { coinAt: [0, 0], coinSize: 0, camera: null };
// The radius of a coin in the middle of the picture, in pixels.
const least = h => Math.min(56, 0.15 * h);

function drawWorld(c, camera, coin) {
  drawTable(c, camera);
  drawShadow(c, camera, coin);
  drawTrail(c, camera, 2.2);
  drawForce(c, camera);
  if (racing() && !races.tooMany) [0, 1].forEach(which => drawGhost(c, camera, which));
  if (m.swings && far.there) drawGhost(c, camera, 0);
  drawCoin(c, camera, coin);
  if (racing() || m.swings)
    nameCoin(c, camera, coin, m.swings ? "coin_orbit_at" : "coin_advance", COLORS.path, "right");
}

// Sees the whole path, unless the coin would be too small: then it looks between
// the middle of the path and the coin, so that the coin stays in the picture.
function stageCamera(w, h, coin) {
  const middle = [view.x, 0.5, view.z], size = 1.34 * h;
  const fit = 0.15 + Math.max(2.7 * h / w, Math.cos(m.el) + 2.5 * Math.sin(m.el));
  const whole = fit * view.R, distance = Math.min(whole, size / least(h)) / m.zoom;
  const part = Math.max(0, 1 - 0.95 * distance / whole);
  const target = sum(middle, part, sum(coin.center, -1, middle));
  target[1] = Math.max(target[1], 0.65 * coin.center[1]);
  return cameraAt(target, distance, w / 2, 0.5 * h, size);
}

function drawStage() {
  const { c, w, h } = cleared($("stage")), s = motion.moment;
  follow();
  const coin = coinFrom(s, AT.theta, s[AT.y] / m.radius), camera = stageCamera(w, h, coin);
  drawWorld(c, camera, coin);
  Object.assign(stage, { camera, coinAt: camera.to(coin.center),
    coinSize: 1.34 * h / camera.view(coin.center)[2] });
}
