// SPDX-License-Identifier: MIT
// listing.js: the same computation as a C program, and what it prints.

const listsRace = () => racing() && !m.swings && racer(1)[RACE.status] >= 0;

// The program of page.html: lines of a kind that is there, and numbers put in.
function listing() {
  const n = x => Object.is(x, -0) ? "-0.0" : String(x);
  const frames = isReal() ? lib.page_before(m.now) : 0, from = isReal() ? knot(frames, AT.t) : 0;
  const list = (from, to) => ASKED.slice(from, to).map(k => n(m[k])).join(", ");
  const held = !isReal() && isLossy(), ideal = !isReal() && !isLossy();
  const kinds = { far: m.swings > 0, held, ideal, real: isReal(), thrown: isTossed(), begun: isReal() && !isTossed(),
    thick: m.thickness > 0, thin: m.thickness === 0,
    state: !isReal(), lossy: isLossy(), steps: ideal && !m.swings, race: listsRace() };
  const steps = racer(1)[RACE.steps], name = METHODS[m.method];
  const parts = { pose: list(0, 5), rates: list(5, 8), flight: list(8, 12), body: list(12, 16),
    cylinder: [m.mass, m.radius, m.thickness, m.gravity].map(n).join(", "),
    losses: list(16, 26) + ", {0, 0}", table: `${n(m.mu)}, ${n(0.9 * m.mu)}, ${n(m.bounce)}`, now: n(m.now),
    frames, frame: n(lib.page_frame()), left: n(m.now - from),
    far: n(farAhead() + m.now), method: name, METHOD: name.toUpperCase(), dt: n(m.dt), steps: n(steps),
    rest: n(m.now - steps * m.dt) };
  return $("program").textContent.trimStart().split("\n").map(line => /^(?:(\w+)\|)?(.*)$/.exec(line))
    .filter(([, kind]) => !kind || kinds[kind])
    .map(([, , text]) => text.replace(/@(\w+)@/g, (_, part) => parts[part])).join("\n");
}

function digits() {
  const s = motion.moment, names = ["lean", "heading", "roll", "x", "z", "wX", "wY", "wZ"];
  const lines = [...names.map((name, k) => [name, s[1 + k]]), ["energy", s[AT.energy]], ["F/N", s[AT.ratio]]];
  if (listsRace()) lines.push([METHODS[m.method] + ": lean", racer(1)[RACE.shown]]);
  const shown = motion.status < 0 ? [] : lines.map(([name, x]) => name + " " + g17(x));
  return [...shown, statusWords(motion.status), ""].join("\n");
}
