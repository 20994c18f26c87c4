// SPDX-License-Identifier: MIT
// hand.js: the coin tossed, carried and let go, and the view turned.

// A toss as by a thumb, to a height of some radii: the coin spins about a diameter
// as it rises.  Either face is up as often as the other.
function toss() {
  const any = (low, high) => low + (high - low) * Math.random(), rate = 1 / unit(), speed = m.radius * rate;
  const side = Math.random() < 0.5 ? 1 : -1;
  fly({ theta: side * any(0.9, 1.4), phi: any(-3, 3), psi: any(-3, 3), x: 0, z: 0,
    wX: side * any(2, 4) * rate, wY: any(-1, 1) * rate, wZ: any(-1, 1) * rate, y: 2 * m.radius,
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
