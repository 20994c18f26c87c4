// SPDX-License-Identifier: MIT
// words.js: what is said of the coin, in words and numbers.

const say = text => { $("message").textContent = text; };

// Shows what the page says of a kind, with numbers where it has <b>.
function tell(id, kind, ...numbers) {
  for (const part of $(id).children) part.hidden = part.className !== kind;
  $(id).querySelectorAll(`.${kind} b`).forEach((b, k) => { b.textContent = numbers[k]; });
}

// The kind of the present, in a word, and why.
function verdict() {
  const s = motion.moment, bits = s[AT.bits], needs = "needs μ " + short(s[AT.ratio]);
  if (m.now >= motion.restsAt)
    return ["rests", isTossed() ? faceUp() : "At rest", "after " + timeText(motion.restsAt)];
  if (motion.flat && m.now >= motion.end) return ["rests", "Lies flat", "after " + timeText(motion.end)];
  if (motion.status < 0) return ["lifts", "Cannot be computed", statusWords(motion.status)];
  if (racing()) return raceVerdict();
  if (isReal() && bits & COIN.lifts) return ["lifts", "Flies", `${short(s[AT.y] / m.radius, 2)} radii high`];
  if (isReal() && bits & COIN.slips) return ["slips", "Slips", `rolling would need more than μ ${short(m.mu)}`];
  if (isReal()) return ["rolls", "Rolls", `${needs}, has ${short(m.mu)}`];
  if (bits & COIN.lifts)
    return ["lifts", "Is held down", `a real coin would lift off: N = ${short(s[AT.normal] / weight())} Mg`];
  return ["rolls", "Rolls", "a real coin " + needs];
}

const racerStatus = which => racer(which)[RACE.status];
const raceVerdict = () => [0, 1].some(which => racerStatus(which) < 0)
  ? ["rolls", "coin_advance gets through", "where a fixed step does not"]
  : ["rolls", "All three go on", "from the same start, until a step is too long"];

// What a racer comes to: it went through the table, it refused, or it errs.
function racerWords(which) {
  const r = racer(which), status = r[RACE.status], at = timeText(r[RACE.steps] * m.dt);
  if (status === COIN.through) return `went through the table at ${at}`;
  if (status < 0) return `refused at ${at}: the step would be wrong`;
  const off = r[RACE.pose] < 1e-12 ? "less than 10⁻¹²" : short(r[RACE.pose], 2);
  return `off by ${off}${status === COIN.coarse ? ", and warns: coarse" : ""}`;
}

function showRace() {
  const out = [0, 1].some(which => racerStatus(which) < 0), ours = out ? "gets through" : "chooses its steps";
  $("racers").hidden = !m.swings && (!racing() || races.tooMany);
  $("fixed").hidden = m.swings > 0;
  const words = m.swings ? farWords()
    : [racerName(0), racerWords(0), racerName(1), racerWords(1), "coin_advance", ours];
  $("racers").querySelectorAll("b, span").forEach((e, k) => { e.textContent = words[k]; });
}

function farWords() {
  const n = m.swings.toLocaleString("en"), at = Math.floor(far.steps * 0.1 * unit() / swing()).toLocaleString("en");
  const r = racer(0), off = `off by ${short(r[RACE.pose], 2)} rad, the energy by ${short(100 * r[RACE.energy], 2)} %`;
  const error = short(lib.page_orbit_error(farAhead() + motion.end, m.swings), 2);
  return ["RK4, steps of 0.1 √(a/g)", far.there ? off : `at swing ${at} of ${n}`, "", "", "coin_orbit_at",
    `is there without a step, off by at most ${error}`];
}

// Sign, word and reason change together, the word not more often than can be read.
function showTime(time) {
  const [kind, word, why] = verdict(), clock = timeText(m.now, 4), same = $("verdict").textContent === word;
  if (same) $("why").textContent = why;
  else if (!playing || time - verdictSince > 400) {
    $("light").dataset.kind = kind;
    $("verdict").textContent = word;
    $("why").textContent = why;
    verdictSince = time;
  }
  $("scrub").value = motion.end ? m.now / motion.end : 0;
  $("scrub").setAttribute("aria-valuetext", clock);
  const far = m.swings ? m.swings.toLocaleString("en") + " swings + " : "";
  $("clock").textContent = `${far}${clock} of ${short(motion.end)}`;
  showRace();
  if (!playing || !$("listing").textContent)
    [$("listing").textContent, $("digits").textContent] = [listing(), digits()];
}

// One sentence on what is seen.
function story() {
  const usual = defaultsOf(m.scene), own = ASKED.slice(0, 16).some(name => m[name] !== usual[name]);
  if (isTossed()) return "A tossed coin flies, bounces, slips, rolls and lies down";
  if (racing()) return "Three methods move one coin from the same start";
  if (m.swings) return `The same coin ${m.swings.toLocaleString("en")} swings later, without a step on the way`;
  if (isReal()) return "A real coin slips where the friction of the table does not hold it";
  if (isLossy()) return "Losses slow the coin until it lies flat";
  return own ? "A coin from a start of your own" : sceneWord(m.scene, 1);
}

// What changes with the start only.
function describe() {
  const orbit = lib.page_orbit();
  const rest = motion.restsAt > 0 ? "rests" : motion.more ? "moves" : "never";
  $("story").textContent = story() + ".";
  document.body.dataset.race = racing();
  tell("resttext", rest, timeText(motion.restsAt, 4));
  tell("fartext", isLossy() || isReal() ? "lossy" : !orbit ? "none" : m.swings ? "far" : "orbit",
    m.swings ? short(lib.page_orbit_error(farAhead() + motion.end, m.swings), 2) : timeText(swing(), 4));
  tell("racetext", isLossy() || isReal() ? "lossy" : races.tooMany ? "many" : "equal");
}
