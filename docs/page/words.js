// SPDX-License-Identifier: MIT
// words.js: what is said of the coin, in words and numbers.

const say = text => { $("message").textContent = text; };

// Statuses of the library in the words of someone who does not know it.
const PLAIN = {
  "-1": "no coin and no table is like that: a mass, a size, a friction or a loss is out of its range",
  "-2": "a coin cannot start so: it would be below the table, or past lying flat, or too fast",
  "-3": "the time is too long, or the step too long for this motion",
  "-4": "a number is not one that can be reckoned with",
  "-5": "no motion does that",
  "-6": "the coin falls flat before that",
  "-9": "the coin leaves all that can be reckoned: too far or too fast",
};
const plainWords = status => PLAIN[status] || statusWords(status);

// Shows what the page says of a kind, with numbers where it has <b>.
function tell(id, kind, ...numbers) {
  for (const part of $(id).children) part.hidden = part.className !== kind;
  $(id).querySelectorAll(`.${kind} b`).forEach((b, k) => { b.textContent = numbers[k]; });
}

// ------------------------------------------------------------------ the verdict --
const FACES = ["Heads", "Tails", "Edge"]; // in the order of coin.h, from 1
const faceUp = () => !hasFaces() || isDisk() ? "At rest" : FACES[lib.page_face() - 1];

// How often the contact has gone round until the coin rests.
function turnsOfContact() {
  let turned = 0;
  for (let k = 1; k < motion.count; ++k) {
    const by = (knot(k, AT.phi) - knot(k - 1, AT.phi)) / (2 * Math.PI);
    turned += by - Math.round(by);
  }
  return Math.abs(turned);
}

// A coin at rest.  One that only rolls may lie with its face still turning.
function restWords(at) {
  const turning = Math.abs(turns(motion.moment[AT.wZ]));
  if (sceneName() === "disk" && isReal())
    return ["rests", "Silence", `after ${timeText(at)} and ${short(turnsOfContact())} turns of the contact`];
  if (isReal()) return ["rests", faceUp(), `after ${timeText(at)}`];
  if (turning < 1e-3) return ["rests", "At rest", `after ${timeText(at)}`];
  return ["rests", "Lies flat", `after ${timeText(at)}; without pivoting friction its face turns on, ` +
    `${short(turning, 2)} times a second`];
}

// The kind of the present, in a word, and why.
function verdict() {
  const s = motion.moment, bits = s[AT.bits], needs = "needs friction of " + short(s[AT.ratio]);
  if (m.now >= motion.restsAt) return restWords(motion.restsAt);
  if (motion.rests && m.now >= motion.end) return ["rests", "Lies flat", "after " + timeText(motion.end)];
  if (motion.status < 0) return ["lifts", "Cannot be computed", plainWords(motion.status)];
  if (racing()) return raceVerdict();
  if (isReal() && bits & COIN.lifts) return ["lifts", "Flies", `${lengthText(s[AT.y], 2)} high`];
  if (isReal() && bits & COIN.slips)
    return ["slips", "Slips", `rolling would need more friction than ${short(m.mu, 2)}`];
  if (isReal()) return ["rolls", "Rolls", `${needs}, has ${short(m.mu, 2)}`];
  if (bits & COIN.lifts)
    return ["lifts", "Is held down", `a real coin would lift off: N = ${short(s[AT.normal] / weight())} Mg`];
  return ["rolls", "Rolls", "a real coin " + needs];
}

// ----------------------------------------------------------- where methods fail --
const racerStatus = which => racer(which)[RACE.status];
const raceVerdict = () => [0, 1].some(which => racerStatus(which) < 0)
  ? ["rolls", "Ours gets through", "where fixed steps do not"]
  : ["rolls", "All three go on", "from the same start, until a step is too long"];

// An error in radians, or in radii, as how far the rim is from where it should be.
const offText = error => lengthText(error * m.radius, 2);

// What a racer comes to: it went through the table, it refused, or it errs.
function racerWords(which) {
  const r = racer(which), status = r[RACE.status], at = timeText(r[RACE.steps] * m.dt);
  if (status === COIN.through) return `sank through the table at ${at}`;
  if (status < 0) return `stopped at ${at}: it sees that the step would be wrong`;
  const off = r[RACE.pose] < 1e-12 ? "less than 10⁻¹⁰ mm" : offText(r[RACE.pose]);
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
  const r = racer(0), lost = short(100 * r[RACE.energy], 2);
  const off = `off by ${offText(r[RACE.pose])}, the energy by ${lost} %`;
  const error = offText(lib.page_orbit_error(farAhead() + motion.end, m.swings));
  return [`RK4, steps of ${timeText(0.1 * unit())}`, far.there ? off : `at swing ${at} of ${n}`, "", "",
    "coin_orbit_at", `is there without a step, off by at most ${error}`];
}

// -------------------------------------------------------------- time and tallies --
// How fast time goes, beside that of a clock.
function paceText() {
  const pace = m.speed * slow * tail() / second();
  if (Math.abs(pace - 1) < 0.02) return "real time";
  const times = x => `${Number(x.toPrecision(2))} times`;
  return pace < 1 ? times(1 / pace) + " slower" : times(pace) + " faster";
}

function showTally() {
  for (const face of FACES) $("count" + face).textContent = tosses[face];
}

// Sign, word and reason change together, the word not more often than can be read.
function showTime(time) {
  const [kind, word, why] = verdict(), clock = clockText(m.now), same = $("verdict").textContent === word;
  if (same) $("why").textContent = why;
  else if (!playing || kind === "rests" || time - verdictSince > 400) {
    $("light").dataset.kind = kind;
    $("verdict").textContent = word;
    $("why").textContent = why;
    verdictSince = time;
  }
  $("scrub").value = motion.end ? m.now / motion.end : 0;
  $("scrub").setAttribute("aria-valuetext", clock);
  const far = m.swings ? m.swings.toLocaleString("en") + " swings + " : "";
  $("clock").textContent = `${far}${clock} of ${clockText(motion.end)}`;
  $("pace").textContent = paceText();
  showRace();
  if (!playing || !$("listing").textContent)
    [$("listing").textContent, $("digits").textContent] = [listing(), digits()];
}

// One sentence on what is seen.
function story() {
  const usual = defaultsOf(m.scene), own = ASKED.slice(0, 16).some(name => m[name] !== usual[name]);
  if (sceneName() === "luck") return sceneWord(m.scene, 1);
  if (isTossed()) return "A tossed coin flies, bounces, slips, rolls and lies down";
  if (racing()) return "Three methods move one coin from the same start";
  if (m.swings) return `The same coin ${m.swings.toLocaleString("en")} swings later, without a step on the way`;
  if (!own) return sceneWord(m.scene, 1);
  if (isReal()) return "A real coin slips where the friction of the table does not hold it";
  return isLossy() ? "Losses slow the coin until it lies flat" : "A coin from a start of your own";
}

// What changes with the start only.
function describe() {
  const orbit = lib.page_orbit(), rest = motion.restsAt > 0 ? "rests" : motion.more ? "moves" : "never";
  $("story").textContent = story() + ".";
  Object.assign(document.body.dataset,
    { race: racing(), scene: sceneName(), flight: isTossed(), thick: m.thickness > 0 });
  for (const link of document.querySelectorAll("nav a"))
    link.toggleAttribute("aria-current", link.hash.slice(7).split("&")[0] === sceneName());
  tell("resttext", rest, timeText(motion.restsAt));
  tell("fartext", isLossy() || isReal() ? "lossy" : !orbit ? "none" : m.swings ? "far" : "orbit",
    m.swings ? offText(lib.page_orbit_error(farAhead() + motion.end, m.swings)) : timeText(swing()));
  tell("racetext", isLossy() || isReal() ? "lossy" : races.tooMany ? "many" : "equal");
  $("natural").textContent = `Here a natural unit of time is √(a/\u2060g) = ${timeText(unit())}, one of length is ` +
    `the radius, ${lengthText(m.radius)}.`;
}
