// SPDX-License-Identifier: MIT
// hand.js: the coin tossed, carried and let go, and the view turned.

// A toss as by a thumb, from where the coin is: it spins about a diameter as it
// rises.  Either face is up as often as the other.
function toss() {
  if (sceneName() === "luck") return tossAnywhere();
  const any = (low, high) => low + (high - low) * Math.random(), rate = 1 / unit(), speed = m.radius * rate;
  const side = Math.random() < 0.5 ? 1 : -1, now = motion.moment;
  const far = Math.hypot(now[AT.x], now[AT.z]) > 40 * m.radius;
  fly({ theta: side * any(0.9, 1.4), phi: any(-3, 3), psi: any(-3, 3), x: far ? 0 : now[AT.x], z: far ? 0 : now[AT.z],
    wX: side * any(1.2, 2.4) * rate, wY: any(-0.3, 0.3) * rate, wZ: any(-0.4, 0.4) * rate, y: 3.5 * m.radius,
    vx: any(-0.3, 0.3) * speed, vy: any(5.4, 6.6) * speed, vz: any(-0.3, 0.3) * speed });
}

// The table of a coin that is thrown, and losses that bring it to rest.
const LOSS = 2e-3, PIVOTING = 1e-3;
const onTable = () => ({ mu: isReal() ? m.mu : 0.3, race: 0, speed: isReal() ? m.speed : second(),
  ...(isReal() && isLossy() ? {} : { ...losses("dry", LOSS), spin: PIVOTING * lossUnit("spin") }) });

// Lets a real coin go.
function fly(parts) {
  tosses.counted = false;
  direction = 1;
  change({ ...parts, ...onTable() });
  play(true);
}

const look = (az, el) => { m.az -= az; m.el = clamp(m.el + el, 0.08, 1.5); go(m.now); };
const zoom = f => { m.zoom = clamp(m.zoom * f, 0.3, 12); go(m.now); };

// ------------------------------------------------------------------- the carrying --
// Brings the coin to a place of the picture: up from the table, and on the table to
// and fro.  The eye keeps still as long as it is held.
function carryTo(x, y) {
  const { center } = coinNow(), [cx, cy] = view.held.to(center);
  const size = LENS * $("stage").clientHeight / view.held.view(center)[2];
  const least = m.radius * Math.cos(m.theta) + m.thickness / 2 * Math.abs(Math.sin(m.theta));
  const high = isTossed() ? m.y : least;
  const up = high - (y - cy) / size * m.radius / Math.cos(m.el), toward = Math.max(least - up, 0) / Math.tan(m.el);
  const along = (x - cx) / size * m.radius;
  Object.assign(m, onTable(), { now: 0, swings: 0, y: Math.max(up, least * (1 + 1e-9)), vx: 0, vy: 0, vz: 0,
    x: m.x + along * Math.cos(m.az) + toward * Math.sin(m.az),
    z: m.z - along * Math.sin(m.az) + toward * Math.cos(m.az) });
  take(m);
  lib.page_trail(0);
  const knots = doubles(lib.page_knots(), MOMENT);
  Object.assign(motion, { count: 1, more: false, end: 0, restsAt: NaN, rests: false, knots, moment: knots.slice() });
  wake();
}

// Lets it go with the speed of the pointer [pixels in a second].  A flick over the
// height of the stage in a second is one of 4 sqrt(g a), 1.4 m/s for a quarter, and
// less to the side; the coin spins the faster the faster it goes.
const FLICK = { up: 4, aside: 0.8, most: 8, spin: 0.3 };
function letGo(vx, vy) {
  const flick = m.radius / unit() / $("stage").clientHeight, most = FLICK.most * m.radius / unit();
  const across = clamp(FLICK.aside * flick * vx, -most, most), up = clamp(-FLICK.up * flick * vy, -most, most);
  fly({ vx: across * Math.cos(m.az), vz: -across * Math.sin(m.az), vy: up, wX: m.wX + FLICK.spin * up / m.radius });
}

// A finger on the stage: it carries the coin or turns the view; two come closer.
const hand = { fingers: new Map(), grabbed: false, carried: false, resume: false, off: [0, 0] };
const spread = () => { const [p, q] = hand.fingers.values(); return Math.hypot(p.x - q.x, p.y - q.y); };
const isCoin = (x, y) => Math.hypot(x - stage.coinAt[0], y - stage.coinAt[1]) < Math.max(stage.coinSize, 24);

function grab(e) {
  const off = [e.offsetX - stage.coinAt[0], e.offsetY - stage.coinAt[1]];
  Object.assign(hand, { resume: playing, carried: false, off });
  play(false);
  startHere();
  view.held = stage.camera;
}

function moveFinger(e) {
  const finger = hand.fingers.get(e.pointerId), before = hand.fingers.size === 2 && spread();
  if (!finger) return;
  const dx = e.clientX - finger.x, dy = e.clientY - finger.y, passed = Math.max(e.timeStamp - finger.time, 1) / 1e3;
  Object.assign(finger, { x: e.clientX, y: e.clientY, time: e.timeStamp,
    vx: (finger.vx + dx / passed) / 2, vy: (finger.vy + dy / passed) / 2 });
  if (before) { zoom(spread() / before); look(0, 0.004 * dy); }
  else if (!hand.grabbed) look(0.008 * dx, 0.006 * dy);
  else if (hand.carried || Math.hypot(dx, dy) > 0) {
    hand.carried = true;
    const { left, top } = $("stage").getBoundingClientRect();
    carryTo(e.clientX - left - hand.off[0], e.clientY - top - hand.off[1]);
  }
}

function releaseFinger(e) {
  const { vx, vy, time } = hand.fingers.get(e.pointerId) || {}, still = !(e.timeStamp - time < 80);
  hand.fingers.delete(e.pointerId);
  if (!hand.grabbed) return;
  hand.grabbed = false;
  if (hand.carried) letGo(still ? 0 : vx, still ? 0 : vy);
  else if (hand.resume) play(true);
  view.held = null;
}

// The page scrolls under a wheel and under a finger, unless it is on the coin.
function listenToStage(canvas) {
  canvas.addEventListener("pointerdown", e => {
    $("hint").hidden = true;
    canvas.setPointerCapture(e.pointerId);
    hand.fingers.set(e.pointerId, { x: e.clientX, y: e.clientY, time: e.timeStamp, vx: 0, vy: 0 });
    hand.grabbed = hand.fingers.size === 1 && isCoin(e.offsetX, e.offsetY);
    if (hand.grabbed) grab(e);
  });
  canvas.addEventListener("pointermove", moveFinger);
  for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, releaseFinger);
  canvas.addEventListener("touchstart", e => {
    const { left, top } = canvas.getBoundingClientRect(), { clientX, clientY } = e.touches[0];
    if (e.touches.length > 1 || isCoin(clientX - left, clientY - top)) e.preventDefault();
  }, { passive: false });
  canvas.addEventListener("wheel", e => {
    if (!e.ctrlKey) return;
    e.preventDefault();
    zoom(Math.exp(e.deltaY / -300));
  }, { passive: false });
}
