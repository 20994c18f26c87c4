// SPDX-License-Identifier: MIT
// stage.js: all that is drawn about the coin, what is behind first.

const stage = { coinAt: [0, 0], coinSize: 0, camera: null };

// A coin that fixed steps have moved: its outline.
function drawGhost(c, camera, which) {
  const coin = ghost(which), color = GHOSTS[which];
  if (!Number.isFinite(dot(coin.center, coin.Z))) return;
  area(c, camera, withHole(r => coin.ring(r, 0)), color + "3c");
  withHole(r => coin.ring(r, 0)).forEach(points => line(c, camera, points, color, 2, true));
  line(c, camera, [coin.point(hole() * (m.inner > 0), coin.psi, 0), coin.point(1, coin.psi, 0)], color, 2);
}

// One that has gone through the table falls on: nothing holds it there.
function ghost(which) {
  const r = racer(which), fallen = Math.max(m.now - (r[RACE.steps] + 1) * m.dt, 0) / unit();
  if (r[RACE.status] !== COIN.through) return coinFrom(r, RACE.shown);
  return coinFrom(r, RACE.shown, Math.cos(r[RACE.shown]) - fallen ** 2 / 2);
}
const GHOSTS = ["#ff7fb0", "#bfe070"], OURS = "#8fd0ff";
const nameGhost = (c, camera, which) => nameCoin(c, camera, ghost(which), racerName(which), GHOSTS[which],
  which ? "right" : "left", which ? 20 : 4);

// Its name right of a coin, or left of it, so many pixels below its centre and
// within the picture.
function nameCoin(c, camera, coin, name, color, side, below = 4) {
  const [x, at] = camera.to(coin.center), lowest = $("stage").clientHeight - $("racers").offsetHeight - 30;
  const y = clamp(at, 24, lowest), off = 1.2 * camera.scale, edge = $("stage").clientWidth - 4;
  if (!Number.isFinite(x + y)) return;
  c.font = "600 14px system-ui, sans-serif";
  const wide = c.measureText(name).width;
  const left = clamp(side === "right" ? x + off : x - off - wide, 10, edge - wide - 8);
  fill(c, polyline([[left - 6, y + below - 14], [left + wide + 6, y + below - 14], [left + wide + 6, y + below + 6],
    [left - 6, y + below + 6]], "Z"), "rgba(10, 12, 16, 0.72)");
  c.fillStyle = color;
  c.fillText(name, left, y + below);
}

// The reaction, 2.2 radii long when it is the weight and 3 at most, and the cone
// that friction allows it.
function drawForce(c, camera) {
  const s = motion.moment, from = contact(s), R = [...s.subarray(AT.R, AT.R + 3)], color = knotColor(s[AT.bits]);
  const scale = Math.min(2.2 / weight(), 3 / Math.hypot(...R)), height = s[AT.normal] * scale;
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

// Whether there is a force to be drawn; and whether it is on the eye's side of the coin.
function forceSide(camera, coin) {
  const s = motion.moment, R = [...s.subarray(AT.R, AT.R + 3)], quick = isReal() && playing && slow === 1;
  if (quick || s[AT.bits] & COIN.rests || !R.some(x => x)) return "none";
  const tip = sum(contact(s), 1 / Math.hypot(...R), R), side = p => Math.sign(dot(coin.Z, sum(p, -1, coin.center)));
  return side(tip) === side(camera.eye) ? "front" : "behind";
}

// A coin that tumbles by much from frame to frame leaves what a film would show: where
// it was a moment before.
const BLUR = [[0.011, 0.16], [0.0055, 0.34]]; // [s], how opaque
function drawBlur(c, camera) {
  const s = motion.moment, pace = m.speed * slow, turned = Math.hypot(s[AT.wX], s[AT.wY]) * pace * BLUR[0][0];
  if (!playing || !flies(s[AT.bits]) || turned < 0.25) return;
  for (const [late, opaque] of BLUR) {
    if (m.now < late * pace) continue;
    lib.page_near(m.now - late * pace * direction);
    c.globalAlpha = opaque;
    drawCoin(c, camera, coinFrom(motion.moment, AT.theta, motion.moment[AT.y] / m.radius));
  }
  c.globalAlpha = 1;
  lib.page_near(m.now);
}

// Ghosts go behind or before the coin, by their distance; those that have sunk are
// seen through the table.
function drawWorld(c, camera, w, h, coin) {
  const ghosts = (racing() && !races.tooMany ? [0, 1] : m.swings && far.there ? [0] : [])
    .filter(which => Number.isFinite(dot(ghost(which).center, ghost(which).center)));
  const depth = thing => camera.view(thing.center)[2], sunk = which => ghost(which).center[1] < 0;
  const force = forceSide(camera, coin), draw = which => drawGhost(c, camera, which);
  ghosts.filter(sunk).forEach(draw);
  c.globalAlpha = ghosts.length ? 0.55 : 1;
  drawTable(c, camera, w, h);
  c.globalAlpha = 1;
  drawLight(c, camera, w, h, coin);
  drawShadow(c, camera, coin);
  drawTrail(c, camera, 2.4);
  ghosts.filter(which => !sunk(which) && depth(ghost(which)) >= depth(coin)).forEach(draw);
  if (force === "behind") drawForce(c, camera);
  drawBlur(c, camera);
  drawCoin(c, camera, coin);
  if (force === "front") drawForce(c, camera);
  ghosts.filter(which => !sunk(which) && depth(ghost(which)) < depth(coin)).forEach(draw);
  ghosts.forEach(which => nameGhost(c, camera, which));
  if (ghosts.length)
    nameCoin(c, camera, coin, m.swings ? "coin_orbit_at" : "coin_advance", OURS, "right", -14);
}

const coinNow = () => coinFrom(motion.moment, AT.theta, motion.moment[AT.y] / m.radius);

function drawStage(passed = 0) {
  const { c, w, h } = cleared($("stage")), coin = coinNow();
  if (!view.held) follow(coin, passed, w, h);
  const camera = view.held || stageCamera(w, h);
  drawWorld(c, camera, w, h, coin);
  Object.assign(stage, { camera, coinAt: camera.to(coin.center), coinSize: LENS * h / camera.view(coin.center)[2] });
}

// For tests: where the coin is drawn, in pixels of the window, and how large.
globalThis.coinOnStage = () => {
  const { left, top } = $("stage").getBoundingClientRect();
  return { x: left + stage.coinAt[0], y: top + stage.coinAt[1], radius: stage.coinSize };
};
