// SPDX-License-Identifier: MIT
// table.js: the table, the shadow and the trail of the coin.

// A number between 0 and 1 for each board and each line of its grain.
const chance = (a, b) => { const x = Math.sin(12.9898 * a + 78.233 * b) * 43758.5453; return x - Math.floor(x); };

// Where the corners of the picture look at the table: its part that is seen.
function seenTable(camera, w, h) {
  const spots = [[0, 0], [w, 0], [0, h], [w, h]].map(([x, y]) => camera.ground(x, y));
  const range = k => [Math.min(...spots.map(p => p[k])), Math.max(...spots.map(p => p[k]))];
  return { x: range(0), z: range(2) };
}

// Boards of wood along x: their tones, the grain, and the ends of boards.
const BOARD = 9; // the width of a board [radii]
function drawTable(c, camera, w, h) {
  const { x, z } = seenTable(camera, w, h), many = (z[1] - z[0]) / 200;
  const wide = BOARD * 2 ** Math.max(0, Math.ceil(Math.log2(many)));
  const grain = new Path2D(), seams = new Path2D();
  for (let k = Math.floor(z[0] / wide); k * wide < z[1]; ++k) {
    const near = k * wide, length = 6 * wide, shift = length * chance(k, 1);
    for (let n = Math.floor((x[0] - shift) / length); n * length + shift < x[1]; ++n) {
      const from = Math.max(n * length + shift, x[0]), to = Math.min((n + 1) * length + shift, x[1]);
      const tone = Math.round(22 * chance(k, n) - 11);
      area(c, camera, [[[from, 0, near], [to, 0, near], [to, 0, near + wide], [from, 0, near + wide]]],
        `hsl(${COLORS.wood.replace(/,\s*([\d.]+)%$/, (_, l) => `, ${l * (1 + tone / 100)}%`)})`);
      for (let g = 1; g < 5; ++g) {
        const at = near + wide * (g - 0.8 + 0.6 * chance(k + 0.37 * g, n)) / 4.6, bend = 0.05 * wide * chance(n, g);
        trace(grain, camera, Array.from({ length: 17 }, (_, i) =>
          [from + (to - from) * i / 16, 0, at + bend * Math.sin(i * 0.65 + 9 * chance(g, k))]));
      }
      trace(seams, camera, [[to, 0, near], [to, 0, near + wide]]);
    }
    trace(seams, camera, [[x[0], 0, near], [x[1], 0, near]]);
  }
  stroke(c, grain, COLORS.grain, 1);
  stroke(c, seams, COLORS.seam, 1.4);
}

// A pool of light on the table, about the coin; it is dark around.
function drawLight(c, camera, w, h, coin) {
  const [x, y] = camera.to([coin.center[0], 0, coin.center[2]]), low = isDisk();
  const glow = c.createRadialGradient(x, y, 0, x, y, (low ? 0.62 : 1.05) * Math.max(w, h * 1.4));
  const [bright, dim] = low ? ["rgba(255, 196, 120, 0.10)", "rgba(6, 5, 8, 0.96)"]
    : ["rgba(255, 244, 214, 0.30)", "rgba(12, 8, 4, 0.62)"];
  glow.addColorStop(0, bright);
  glow.addColorStop(low ? 0.22 : 0.3, low ? "rgba(20, 12, 8, 0.45)" : "rgba(255, 240, 210, 0.08)");
  glow.addColorStop(1, dim);
  c.fillStyle = glow;
  c.fillRect(0, 0, w, h);
}

const withHole = ring => m.inner > 0 ? [ring(1), ring(hole())] : [ring(1)];

// The outline of the shadow: of each point of a rim, or of that of the other rim, what
// is farther out.  A hole has one rim.
function shadowOf(coin, r) {
  const [low, high] = [-1, 1].map(side => coin.ring(r, m.inner > 0 ? 0 : side * half())
    .map(([x, y, z]) => [x - y * LIGHT[0] / LIGHT[1], 0, z - y * LIGHT[2] / LIGHT[1]]));
  const n = low.length, cross = (p, q) => p[0] * q[2] - p[2] * q[0], to = (p, q) => sum(q, -1, p);
  const way = Math.sign(cross(to(low[0], low[n / 4]), to(low[0], low[n / 2])));
  return low.map((p, k) => way * cross(to(low[(k + n - 1) % n], low[(k + 1) % n]), to(p, high[k])) < 0 ? high[k] : p);
}

// The shadow is the softer the higher the coin is.
function drawShadow(c, camera, coin) {
  const soft = 0.04 + 0.1 * Math.min(coin.center[1], 8), alpha = 0.085 / (1 + 0.25 * coin.center[1]);
  for (let grow = 2.1; grow > -0.9; grow -= 0.2)
    area(c, camera, withHole(r => shadowOf(coin, Math.max(r + (r === 1 ? 1 : -1) * grow * soft, 0.05))),
      `rgba(20, 10, 4, ${alpha})`);
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
const POINTS = 1500; // of a path at most, or nearly
function drawPath(c, camera, first, last, width, clear) {
  const step = Math.ceil((last - first) / POINTS), next = k => Math.min(k + step, last);
  for (let k = first; k < last;) {
    const bits = knot(k, AT.bits), points = [pathAt(k)];
    while (k < last) {
      k = next(k);
      const stride = sum(pathAt(k), -1, points.at(-1));
      if (flies(knot(k, AT.bits)) !== flies(bits) || dot(stride, stride) > 0.25 * step ** 2) break;
      points.push(pathAt(k));
      if (knotColor(knot(k, AT.bits)) !== knotColor(bits)) break;
    }
    c.setLineDash(flies(bits) ? [1, 5] : []);
    line(c, camera, points, knotColor(bits) + clear, bits & COIN.slips ? 2.2 * width : width);
  }
  c.setLineDash([]);
}

// The whole path faint and what is behind the coin; of a real coin, that is half a
// second, which fades.
function drawTrail(c, camera, width) {
  const now = lib.page_before(m.now), first = Math.max(0, now - SHOWN), s = motion.moment;
  c.lineJoin = c.lineCap = "round";
  if (isReal()) {
    const pieces = ["18", "30", "58", "90", "c0"], from = lib.page_before(m.now - 0.5 * m.speed);
    const at = k => Math.round(from + (now - from) * k / pieces.length);
    pieces.forEach((clear, k) => drawPath(c, camera, at(k), at(k + 1), width * (k + 2) / 6, clear));
    return;
  }
  drawPath(c, camera, first, Math.min(motion.count - 1, now + SHOWN), 1, "50");
  drawPath(c, camera, first, now, width, "");
  if (!isReal()) line(c, camera, [contactAt(now), contact(s)], knotColor(s[AT.bits]), width);
}
