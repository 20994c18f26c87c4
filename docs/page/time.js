// SPDX-License-Identifier: MIT
// time.js: the motion, its frames, playing and changing it.

const SLOW = 1 / 8; // slow motion
let playing = false, direction = 1, slow = 1, scheduled = true, lastFrame = 0, verdictSince = 0, keeping;
const tosses = { Heads: 0, Edge: 0, Tails: 0, counted: false };

// ------------------------------------------------------------------- motion --
// The time of a swing; of a steady motion, that of a small one.  0: no period.
function swing() {
  const orbit = lib.page_orbit(), lambda2 = lib.page_lambda2();
  return orbit && (doubles(orbit, 1)[0] || 2 * Math.PI * (lambda2 < 0 ? 1 / Math.sqrt(-lambda2) : unit()));
}
const farAhead = () => m.swings * swing();

// Makes the motion of m.  If the library refuses it, that before stays.
function rebuild(before) {
  const status = take(m);
  if (status < 0) {
    say("That start was refused: " + plainWords(status) + ".");
    take(Object.assign(m, before));
  }
  if (m.swings && !(swing() > 0 && lib.page_at(farAhead(), 0) >= 0)) {
    say("No orbit leads so far ahead: this is the start.");
    m.swings = 0;
  }
  lib.page_trail(farAhead());
  motion.moment ||= doubles(lib.page_now(), MOMENT);
  motion.more = true;
  extendTrail();
  wake();
}

// Computes more of the trail, for some milliseconds, and what hangs on it.
function extendTrail() {
  const begun = performance.now(), lossy = isLossy();
  while (motion.more && performance.now() - begun < 8) {
    const status = lib.page_trail_on(lossy ? 1e12 * unit() : m.span, 100);
    motion.more = status === 0;
    if (status < 0) say("It goes no further: " + plainWords(status) + ".");
  }
  const count = motion.count = lib.page_knot_count();
  motion.knots = doubles(lib.page_knots(), MOMENT * count);
  const last = knot(count - 1, AT.t);
  motion.rests = !motion.more && (knot(count - 1, AT.bits) & COIN.rests) > 0;
  motion.restsAt = (lossy || isReal()) && motion.rests ? last : NaN;
  motion.end = lossy ? last : Math.min(m.span, motion.more ? m.span : last);
  if (!motion.more) m.now = Math.min(m.now, motion.end);
  const [x0, x1, z0, z1] = [AT.cx, AT.cz].flatMap(extremes).map(x => x / m.radius);
  motion.center = [(x0 + x1) / 2, (z0 + z1) / 2];
  motion.reach = Math.hypot(x1 - x0, z1 - z0) / 2.6;
  motion.height = extremes(AT.y)[1] / m.radius;
  if (!motion.more || performance.now() - motion.drawnAt > 120) showMotion();
}

// What hangs on the whole trail.
function showMotion() {
  motion.drawnAt = performance.now();
  runRaces();
  describe();
  renewMap();
  Object.values(GRAPHS).forEach(drawGraph);
}

const wake = () => { if (!scheduled) requestAnimationFrame(frame); scheduled = true; };

// A long tail of a toss is run faster, and the page says so.
const TAIL = { after: 4, left: 1, faster: 4 }; // [s], [s], [1]
const tail = () => isTossed() && playing && direction > 0 && slow === 1 && m.now > TAIL.after * second() &&
  !(motion.restsAt - m.now < TAIL.left * second()) ? TAIL.faster : 1;

function frame(time) {
  const passed = clamp((time - lastFrame) / 1000, 0, 0.1), from = m.now;
  lastFrame = time;
  scheduled = false;
  if (motion.more) extendTrail();
  if (playing) m.now = clamp(m.now + direction * slow * tail() * m.speed * passed, 0, lastTime());
  if (!hand.carried || !hand.grabbed) {
    const now = Math.min(m.now, lastTime());
    motion.status = playing && motion.count > 1500 ? lib.page_near(now) : lib.page_at(farAhead(), now);
    motion.moment = doubles(lib.page_now(), MOMENT);
  }
  if (m.swings) goFar();
  if (racing() && !races.tooMany)
    [0, 1].forEach(k => lib.page_race(k, k ? m.method : -1, m.dt, -1, playing ? 0 : 1));
  drawStage(passed);
  soundOn(from, m.now, passed);
  if (!playing || time - saidAt > 70) showNumbers(time);
  if (playing && !motion.more && m.now === (direction > 0 ? motion.end : 0)) atTheEnd();
  if (playing || motion.more || m.swings && !far.there) wake();
}

// What is read rather than watched, some times a second.
let saidAt = 0;
function showNumbers(time) {
  saidAt = time;
  drawMap();
  Object.values(GRAPHS).forEach(markGraph);
  showTime(time);
}

// A real coin waits for its trail; the ideal one can be asked for any time.
const lastTime = () => !motion.more ? motion.end : isReal() ? knot(motion.count - 1, AT.t) : 1e99;

// An RK4 on the way to the same swing, some milliseconds in each frame,
// and on from there.
const far = { steps: 0, there: false };
function goFar() {
  const begun = performance.now(), dt = 0.1 * unit();
  do {
    far.steps = lib.page_far(farAhead(), dt, 2e4);
    far.there = far.steps >= farAhead() / dt;
  } while (!far.there && performance.now() - begun < 8);
  if (far.there) lib.page_race(0, 0, dt, -1, 0);
}

// Below the energy of balancing on a rim no coin can turn over: that is no toss.
const isToss = () => FACES.includes(faceUp()) && knot(0, AT.energy) >= weight() * Math.hypot(m.radius, m.thickness / 2);

// A coin at rest stays there, and is counted once if it was tossed; another begins
// again.
function atTheEnd() {
  if (!motion.rests) m.now = motion.end - m.now;
  else play(false);
  if (!motion.rests || !isReal() || !isToss() || tosses.counted || direction < 0) return;
  tosses.counted = true;
  ++tosses[faceUp()];
  showTally();
}

// ------------------------------------------------------------------- playing --
function play(on) {
  const end = direction > 0 ? motion.end : 0;
  if (on && m.now === end && !motion.more) m.now = motion.end - end;
  playing = on;
  $("play").setAttribute("aria-label", on ? "Pause" : "Play");
  $("play").dataset.on = on;
  $("reverse").setAttribute("aria-pressed", direction < 0);
  go(m.now);
}

const go = t => { m.now = clamp(t, 0, motion.more ? Infinity : motion.end); keep(); wake(); };
const pausedAt = t => { play(false); go(t); };

// Keeps the state in the address, soon: browsers limit how often.
const write = () => history.replaceState(null, "", addressOf(m));
const keep = () => { clearTimeout(keeping); keeping = setTimeout(write, 250); };

// Changes m; a change of the start begins at t = 0.
function change(parts, restart = true) {
  const before = { ...m };
  say("");
  Object.assign(m, restart ? { now: 0, swings: 0 } : {}, parts);
  rebuild(before);
  showControls();
  keep();
}
