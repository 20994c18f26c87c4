// SPDX-License-Identifier: MIT
// coin.js: the coin: its faces are painted once, and laid into the picture.

const LIGHT = [-0.27, 0.94, 0.21]; // where it comes from
const hole = () => Math.min(m.inner / m.radius, 0.94);

// Half the thickness that is drawn, in radii: what the library reckons with, or else
// that of a quarter.  A coin that is thin to the library is drawn on the table.
const reckoned = () => m.thickness / m.radius / 2;
const half = () => reckoned() || (isDisk() ? 0.17 : QUARTER.thickness / QUARTER.radius / 2);

// Points of a coin from its pose, which begins at a place of an array, and its
// height: at a radius, an angle from e_X, and a height above the middle of the coin.
function coinFrom(s, at, y = Math.cos(s[at])) {
  const [theta, phi, psi] = s.subarray(at, at + 3);
  const st = Math.sin(theta), ct = Math.cos(theta), sp = Math.sin(phi), cp = Math.cos(phi);
  const X = [cp, 0, -sp], Y = [st * sp, ct, st * cp], Z = [ct * sp, -st, ct * cp];
  const center = [s[at + 3] / m.radius, y + (half() - reckoned()) * Math.abs(st), s[at + 4] / m.radius];
  const point = (r, u, h) => sum(sum(sum(center, r * Math.cos(u), X), r * Math.sin(u), Y), h, Z);
  return { center, Z, psi, point, ring: (r, h) => around(72, u => point(r, u + psi, h)) };
}

// ------------------------------------------------------------------- its faces --
const FACE = 400; // pixels across
const metal = (c, r, light, dark) => {
  const shade = c.createLinearGradient(-r, -r, r, r);
  shade.addColorStop(0, light);
  shade.addColorStop(1, dark);
  return shade;
};

// What is raised: its shadow, its light side, itself.
function raise(c, path) {
  for (const [by, color] of [[0.022, "#4a525c"], [-0.018, "#ffffff"], [0, "#c3cad2"]]) {
    c.save();
    c.translate(by, by);
    c.fillStyle = color;
    c.fill(path, "evenodd");
    c.restore();
  }
}

// A word along the rim, from an angle that its middle has.  Letters are drawn larger
// and made smaller: browsers round what is less than a pixel.
function engrave(c, text, r, middle, flip) {
  c.font = "700 17px Georgia, 'DejaVu Serif', serif";
  Object.assign(c, { textAlign: "center", textBaseline: "middle" });
  [...text].forEach((letter, k) => {
    const u = middle + flip * (k - (text.length - 1) / 2) * 0.2;
    c.save();
    c.rotate(u);
    c.translate(0, -flip * r);
    c.scale(0.01, 0.01);
    for (const [by, color] of [[1.2, "#ffffff"], [-0.8, "#454e58"], [0, "#6c7782"]]) {
      c.fillStyle = color;
      c.fillText(letter, by, by);
    }
    c.restore();
  });
}

const HEAD = "M.16 .62C.2 .5 .17 .42 .06 .4-.05 .4-.12 .37-.13 .29-.13 .25-.1 .23-.13 .2-.16 .18-.18 .16-.15 .13-." +
  "17 .1-.16 .08-.2 .05-.26 .02-.27 0-.24-.05-.18-.13-.15-.2-.16-.28-.12-.42 .02-.5 .16-.48 .33-.45 .42" +
  "-.3 .4-.14 .4 0 .34 .1 .3 .2 .3 .32 .36 .44 .46 .55 .36 .6 .26 .62 .16 .62z";
const EAGLE = "M0-.2C.05-.27 .1-.3 .07-.36 .02-.4-.06-.38-.08-.33L-.12-.3-.07-.28C-.08-.24-.12-.2-.14-.14-.3-.3-.48" +
  "-.36-.62-.3-.56-.24-.54-.2-.53-.14-.48-.14-.46-.1-.45-.05-.4-.05-.38 0-.36 .05-.3 .05-.26 .1-.16 .12" +
  "-.14 .2-.1 .26-.06 .3L-.12 .48 0 .42 .12 .48 .06 .3C.1 .26 .14 .2 .16 .12 .26 .1 .3 .05 .36 .05 .38 " +
  "0 .4-.05 .45-.05 .46-.1 .48-.14 .53-.14 .54-.2 .56-.24 .62-.3 .48-.36 .3-.3 .14-.14 .1-.18 .05-.2 0-" +
  ".2z";

const HAIR = "M-.1-.33C.03-.43 .22-.4 .33-.22M-.09-.23C.03-.33 .2-.3 .3-.12M0-.2C.08-.25 .17-.21 .22-.08M.13-.02C" +
  ".2-.05 .22 .05 .15 .12M-.14-.12C-.1-.14-.07-.13-.05-.11";
const FEATHERS = "M-.52-.23L-.2-.08M-.46-.13L-.2-.01M-.37-.03L-.18 .05M.52-.23L.2-.08M.46-.13L.2-.01M.37-.03L" +
  ".18 .05M0-.14V.2M-.07 .3L-.03 .4M.07 .3L.03 .4";

// What is cut in.
function score(c, path) {
  c.lineCap = "round";
  for (const [by, color] of [[0.014, "#f2f5f8"], [0, "#79838e"]]) {
    c.save();
    c.translate(by, by);
    stroke(c, path, color, 0.02);
    c.restore();
  }
}

// Steel from the lathe: light and dark about the centre.
function turned(c, canvas) {
  const shade = c.createConicGradient(0.6, 0, 0);
  for (let k = 0; k <= 12; ++k) shade.addColorStop(k / 12, ["#f6f8fa", "#8d97a3", "#cfd6dd"][k % 3]);
  fill(c, disc(0, 0, 0.96), shade);
  for (let r = 0.12; r < 0.95; r += 0.09) stroke(c, disc(0, 0, r), "rgba(40, 48, 58, 0.22)", 0.012);
  fill(c, disc(0, 0, 0.07), "#78828d");
  return canvas;
}

// The face of a coin, of a ring or of Euler's disk.
function paintFace(kind) {
  const canvas = document.createElement("canvas"), c = canvas.getContext("2d");
  canvas.width = canvas.height = FACE;
  c.setTransform(FACE / 2.06, 0, 0, FACE / 2.06, FACE / 2, FACE / 2);
  fill(c, disc(0, 0, 1.03), metal(c, 1, "#f4f6f8", "#aab2bb"));
  if (kind === "ring") return canvas;
  if (kind === "disk") return turned(c, canvas);
  fill(c, disc(0, 0, 0.93), "#5f6973");
  fill(c, disc(0.008, 0.008, 0.915), metal(c, 0.9, "#b4bcc5", "#dfe4e9"));
  c.save();
  c.translate(0, -0.04);
  c.scale(0.92, 0.92);
  raise(c, new Path2D(kind === "heads" ? HEAD : EAGLE));
  score(c, new Path2D(kind === "heads" ? HAIR : FEATHERS));
  c.restore();
  engrave(c, kind.toUpperCase(), 0.77, 0, 1);
  engrave(c, kind === "heads" ? "ROLLCOIN" : "QUARTER", 0.77, 0, -1);
  return canvas;
}

const faces = {};
const faceOf = kind => faces[kind] ||= paintFace(kind);

// Lays a painted face between the images of its two diameters.
function layFace(c, camera, coin, h, side, kind) {
  const at = (r, u) => camera.to(coin.point(r, u + coin.psi, h));
  const [px, py] = at(1, 0), [qx, qy] = at(-1, 0), [ux, uy] = at(1, Math.PI / 2), [vx, vy] = at(-1, Math.PI / 2);
  c.transform(side * (px - qx) / 2, side * (py - qy) / 2, (vx - ux) / 2, (vy - uy) / 2, (px + qx + ux + vx) / 4,
    (py + qy + uy + vy) / 4);
  c.drawImage(faceOf(kind), -1.05, -1.05, 2.1, 2.1);
}

const isDisk = () => sceneName() === "disk";
const faceKind = side => !hasFaces() ? "ring" : isDisk() ? "disk" : side > 0 ? "heads" : "tails";

// A face as the light falls on it.
function drawFace(c, camera, coin, side) {
  const h = side * half(), rim = trace(new Path2D(), camera, coin.ring(1, h), true);
  const path = withHole(r => coin.ring(r, h)).reduce((p, ring) => trace(p, camera, ring, true), new Path2D());
  const normal = coin.Z.map(v => v * side), toEye = sum(camera.eye, -1, coin.center);
  const middle = sum(LIGHT, 1 / Math.hypot(...toEye), toEye), lit = Math.max(0, dot(normal, LIGHT));
  const shine = (Math.max(0, dot(normal, middle)) / Math.hypot(...middle)) ** 20;
  c.save();
  c.clip(path, "evenodd");
  c.save();
  layFace(c, camera, coin, h, side, faceKind(side));
  c.restore();
  fill(c, rim, `rgba(10, 14, 24, ${(0.5 * (1 - lit)).toFixed(3)})`);
  fill(c, rim, `rgba(255, 252, 240, ${(0.62 * shine).toFixed(3)})`);
  c.restore();
  stroke(c, path, "rgba(50, 56, 64, 0.7)", 0.8);
}

const NICKEL = [214, 219, 226], COPPER = [232, 164, 118];

// The edge: copper between nickel, milled; Euler's disk is of steel.  Those of its pieces that look this way
// are the second half.
function drawEdge(c, camera, coin) {
  const layers = [1, 0.55, -0.55, -1].map(h => coin.ring(1, h * half())), n = layers[0].length;
  const outward = coin.ring(1, 0).map(p => sum(p, -1, coin.center));
  const toEye = k => dot(outward[k], sum(camera.eye, -1, layers[0][k])), facing = k => toEye(k) > 0;
  const seen = [...layers[0].keys()].filter(k => m.inner > 0 || toEye(k) > -0.2);
  for (const k of seen.sort((p, q) => facing(p) - facing(q))) {
    const groove = k % 2 || isDisk() ? 1 : 0.86, next = (k + 1) % n;
    const lit = groove * clamp(0.4 + 0.6 * dot(outward[k], LIGHT), 0.12, 1);
    for (const [part, rgb] of [[0, NICKEL], [1, isDisk() ? NICKEL : COPPER], [2, NICKEL]])
      area(c, camera, [[layers[part][k], layers[part][next], layers[part + 1][next], layers[part + 1][k]]],
        `rgb(${rgb.map(v => Math.round(v * lit))})`);
  }
}

function drawCoin(c, camera, coin) {
  const before = dot(coin.Z, sum(camera.eye, -1, coin.center)), side = before > 0 ? 1 : -1;
  if (m.inner > 0) drawFace(c, camera, coin, -side);
  drawEdge(c, camera, coin);
  if (Math.abs(before) > half()) drawFace(c, camera, coin, side); // else the eye is between the faces
}
