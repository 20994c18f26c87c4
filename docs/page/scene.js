// SPDX-License-Identifier: MIT
// scene.js: the coin on its table, in perspective.  Lengths are in radii.

const COLORS = {}; // by name, from style.css
function readColors() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ("ink muted faint panel table grid path warn good lift textbook method face back rim " +
    "notch mark").split(" "))
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
const tableRadius = () => 1.1 * motion.reach + 1.3;

function drawTable(c, camera) {
  const [x, z] = motion.center, R = tableRadius(), grid = new Path2D();
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

// The contact's path between two knots, a color for each stretch; `clear` is how
// opaque, in hexadecimal.
function drawPath(c, camera, first, last, width, clear) {
  for (let k = first; k < last;) {
    const color = knotColor(knot(k, AT.bits)), points = [contactAt(k)];
    do points.push(contactAt(++k)); while (k < last && knotColor(knot(k, AT.bits)) === color);
    line(c, camera, points, color + clear, width);
  }
}

// The whole path faint, and what is behind the coin.
function drawTrail(c, camera, width) {
  const now = lib.page_before(m.now), first = Math.max(0, now - SHOWN), s = motion.moment;
  c.lineJoin = "round";
  drawPath(c, camera, first, Math.min(motion.count - 1, now + SHOWN), 1, "50");
  drawPath(c, camera, first, now, width, "");
  line(c, camera, [contactAt(now), contact(s)], knotColor(s[AT.bits]), width);
}

// ------------------------------------------------------------------- the coin --
const THICK = 0.04; // half of it: the library's coin has none
const hole = () => Math.min(m.inner / m.radius, 0.94);

// Points of a coin from its pose, which begins at a place of an array: at a
// radius, an angle from e_X, and a height above the middle of the coin.
function coinFrom(s, at) {
  const [theta, phi, psi] = s.subarray(at, at + 3);
  const st = Math.sin(theta), ct = Math.cos(theta), sp = Math.sin(phi), cp = Math.cos(phi);
  const X = [cp, 0, -sp], Y = [st * sp, ct, st * cp], Z = [ct * sp, -st, ct * cp];
  const center = [s[at + 3] / m.radius, ct + THICK * Math.abs(st), s[at + 4] / m.radius];
  const point = (r, u, h) => sum(sum(sum(center, r * Math.cos(u), X), r * Math.sin(u), Y), h, Z);
  return { center, Z, psi, point, ring: (r, h) => around(64, u => point(r, u + psi, h)) };
}

const withHole = ring => m.inner > 0 ? [ring(1), ring(hole())] : [ring(1)];

const drawShadow = (c, camera, coin) => area(c, camera,
  withHole(r => coin.ring(r, 0).map(([x, y, z]) => [x + 0.28 * y, 0, z - 0.2 * y])), "#00000034");

// The edge, in notches that turn with the coin: those that look this way are
// the second half.
function drawEdge(c, camera, coin) {
  const front = coin.ring(1, THICK), back = coin.ring(1, -THICK), n = front.length;
  const facing = k => dot(sum(front[k], -1, coin.center), sum(camera.eye, -1, front[k])) > 0;
  for (const k of [...front.keys()].sort((p, q) => facing(p) - facing(q)))
    area(c, camera, [[front[k], front[(k + 1) % n], back[(k + 1) % n], back[k]]], k % 2 ? COLORS.rim : COLORS.notch);
}

function drawFace(c, camera, coin, side) {
  const h = side * THICK, ring = r => coin.ring(r, h), width = clamp(camera.scale / 60, 0.6, 2);
  const light = dot(coin.Z, [-0.5, 0.75, 0.43]) * side;
  area(c, camera, withHole(ring), side > 0 ? COLORS.face : COLORS.back);
  area(c, camera, withHole(ring), `rgba(${light > 0 ? "255, 255, 255" : "0, 0, 0"}, ${0.25 * Math.abs(light)})`);
  withHole(ring).forEach(points => line(c, camera, points, COLORS.rim, width, true));
  const middle = m.inner > 0 ? (1 + hole()) / 2 : 0.6, size = Math.min(0.14, 0.42 * (1 - hole()));
  const spot = coin.point(middle, coin.psi, h), a = sum(coin.point(middle + size, coin.psi, h), -1, spot);
  const b = sum(coin.point(middle, coin.psi + size / middle, h), -1, spot);
  if (m.inner === 0) {
    line(c, camera, ring(0.86), COLORS.rim, width, true);
    line(c, camera, [coin.point(0.38, coin.psi, h), coin.point(-0.72, coin.psi, h)], COLORS.mark, 1.6 * width);
  }
  area(c, camera, [around(24, u => sum(sum(spot, Math.cos(u), a), Math.sin(u), b))], COLORS.mark);
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
}

// The reaction, 1.3 radii long when it is the weight and 2 at most, and the cone
// that friction allows it.
function drawForce(c, camera) {
  const s = motion.moment, from = contact(s), R = [...s.subarray(AT.R, AT.R + 3)], color = knotColor(s[AT.bits]);
  const scale = Math.min(1.3 / weight(), 2 / Math.hypot(...R)), height = s[AT.normal] * scale;
  if (height > 0 && m.mu > 0 && m.mu < 10) {
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
const stage = { coinAt: [0, 0], coinSize: 0 };

function drawWorld(c, camera, coin) {
  drawTable(c, camera);
  drawShadow(c, camera, coin);
  drawTrail(c, camera, 2.2);
  if (racing() && !races.tooMany) [0, 1].forEach(which => drawGhost(c, camera, which));
  drawCoin(c, camera, coin);
  drawForce(c, camera);
}

function drawStage() {
  const { c, w, h } = cleared($("stage")), coin = coinFrom(motion.moment, AT.theta);
  const fit = 0.15 + Math.max(2.5 * h / w, Math.cos(m.el) + 2.5 * Math.sin(m.el)), [x, z] = motion.center;
  const middle = [x, 0.3, z], target = sum(middle, Math.max(0, 1 - 1 / m.zoom), sum(coin.center, -1, middle));
  const camera = cameraAt(target, fit * tableRadius() / m.zoom, w / 2, 0.48 * h, 1.15 * h);
  drawWorld(c, camera, coin);
  Object.assign(stage, { coinAt: camera.to(coin.center), coinSize: 1.15 * h / camera.view(coin.center)[2] });
  if (stage.coinSize < 36) drawInset(c, w, coin);
}

// A close look at a coin that is small, from the same direction.
function drawInset(c, w, coin) {
  const r = clamp(w * 0.11, 56, 92), x = w - r - 12, y = r + 12, circle = disc(x, y, r);
  fill(c, circle, COLORS.panel);
  c.save();
  c.clip(circle);
  drawWorld(c, cameraAt([coin.center[0], 0.6, coin.center[2]], 6, x, y, 2.9 * r), coin);
  c.restore();
  stroke(c, circle, COLORS.faint, 1.5);
}
