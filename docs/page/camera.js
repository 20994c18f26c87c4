// SPDX-License-Identifier: MIT
// camera.js: drawing in perspective, and what the eye follows.  Lengths are in radii.

const COLORS = {}; // by name, from style.css
function readColors() {
  const style = getComputedStyle(document.documentElement);
  for (const name of "ink muted faint panel grid path warn good lift textbook method wood grain seam".split(" "))
    COLORS[name] = style.getPropertyValue("--" + name).trim();
}

// A canvas as sharp as the screen, and as large as another, cleared.
function cleared(canvas, like = canvas) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2), c = canvas.getContext("2d");
  const w = like.clientWidth || 1, h = like.clientHeight || 1;
  const width = Math.round(w * ratio), height = Math.round(h * ratio);
  if (canvas.width === width && canvas.height === height) c.reset();
  else Object.assign(canvas, { width, height });
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
  const eye = sum(target, distance, toward);
  const ground = (px, py) => { // the point of the table in a direction, not too far off
    const d = sum(sum(toward.map(v => -v), (px - x) / size, right), (y - py) / size, up);
    return sum(eye, Math.min(d[1] < 0 ? -eye[1] / d[1] : Infinity, 7 * distance), d);
  };
  return { eye, ground, scale: size / distance, near: 0.05 * distance, view, screen,
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

// ---------------------------------------------------------------- what is seen --
// The middle of the picture, and how far the eye is from it.
const view = { x: 0, y: 0, z: 0, far: 6, held: null, fresh: true };
const LENS = 1.34, LEAST_SEEN = 2.4, LEAST = { real: 22, ideal: 56 }; // [1], [radii], [pixels]
const LAG = 0.12, SOON = 0.3; // [s]: how late the eye follows, and how far it looks ahead

const MARGIN = 1.7; // about the coin [radii]

// From so far a coin is seen at least as large as it has to be.
const farthest = (h, least) => LENS * h / Math.min(least, 0.15 * h);

// Sees the whole path of a coin that rolls, unless the coin would be too small: then
// it looks between the middle of the path and the coin.
function wantedOfPath(coin, w, h) {
  const [x, z] = motion.center, middle = [x, 0.5, z], R = Math.max(motion.reach + 0.8, LEAST_SEEN);
  const whole = R * (0.15 + Math.max(2.7 * h / w, Math.cos(m.el) + 2.5 * Math.sin(m.el)));
  const far = Math.min(whole, farthest(h, LEAST.ideal)), part = Math.max(0, 1 - 0.95 * far / m.zoom / whole);
  const [tx, ty, tz] = sum(middle, part, sum(coin.center, -1, middle));
  return { x: tx, y: ty, z: tz, far };
}

// Goes along with a real coin, sees it and the table below, and draws back before it
// rises.
function wantedOfCoin(coin, w, h) {
  const pace = playing ? m.speed * slow * tail() : 0, height = k => knot(k, AT.y) / m.radius;
  const first = lib.page_before(m.now), soon = lib.page_before(m.now + LAG * pace);
  let high = Math.max(coin.center[1], height(soon));
  for (let k = first, last = lib.page_before(m.now + SOON * pace); k < last; k += 4) high = Math.max(high, height(k));
  const lead = (what, at) => at + LAG * pace * motion.moment[what] / m.radius;
  const low = pace ? height(soon) : coin.center[1];
  const up = 0.45 * high, half = 0.5 / LENS * Math.min(1, w / h);
  const far = Math.max((Math.cos(m.el) * up + MARGIN) / half + Math.sin(m.el) * up, 5.5);
  return { x: lead(AT.vx, coin.center[0]), y: Math.max(0.55 * low, Math.min(0.6 * low, 0.6)),
    z: lead(AT.vz, coin.center[2]), far: Math.min(far, farthest(h, LEAST.real)) };
}

// Keeps the coin in the picture, however quick it is.
function keepInside(coin, w, h) {
  const half = 0.5 / LENS * Math.min(1, w / h), aside = 0.7 * half * view.far;
  const highest = (view.far - MARGIN / half) / (Math.cos(m.el) / half + Math.sin(m.el));
  view.x = clamp(view.x, coin.center[0] - aside, coin.center[0] + aside);
  view.z = clamp(view.z, coin.center[2] - aside, coin.center[2] + aside);
  view.y = Math.max(view.y, coin.center[1] - Math.max(highest, 0));
}

// The eye follows; where nothing plays or has been shown yet, at once.
function follow(coin, passed, w, h) {
  const part = playing && !view.fresh ? 1 - Math.exp(-passed / LAG) : 1;
  const wanted = (isReal() ? wantedOfCoin : wantedOfPath)(coin, w, h);
  for (const [name, value] of Object.entries(wanted)) view[name] += part * (value - view[name]);
  if (isReal()) keepInside(coin, w, h);
  view.fresh = false;
}

const stageCamera = (w, h) => cameraAt([view.x, view.y, view.z], view.far / m.zoom, w / 2, 0.5 * h, LENS * h);
