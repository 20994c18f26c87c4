// SPDX-License-Identifier: MIT
// What page-check asks of the first seconds and of the things to play with: the toss,
// the hand, the sound, the map of luck, where methods fail.
import { claim } from "./claims.mjs";
import { address, b, DESKTOP, frame, launch, says, see, text, visit } from "./see.mjs";

// The page opens on a toss: real time, high, large enough to be seen.
export async function opens() {
  await b.open(address(""), DESKTOP);
  claim("the page opens on the toss, and plays", await see("sceneName() === 'toss' && playing"));
  await says("in real time", "pace", /^real time$/);
  await b.until("!motion.more");
  const high = await see("mm(extremes(AT.y)[1])"), flight = await see(`Array.from({ length: motion.count },
    (_, k) => flies(knot(k, AT.bits))).filter(Boolean).length * lib.page_frame()`);
  claim("it flies 200 mm high", high > 200, high);
  claim("for more than .4 s", flight > 0.4, flight);
  await b.until("!playing");
  await frame();
  await says("and says a face in the end", "verdict", /^(Heads|Tails|Edge)$/);
  const { x, y, radius } = await see("coinOnStage()");
  claim("which is drawn where coinOnStage() says", radius > 40 &&
    await see(`document.elementFromPoint(${x}, ${y}) === $("stage")`), [x, y, radius]);
  await visit("scene=quarter&play=0");
}

// While it plays the coin is in the picture, whole, in frames of 1/60 s.
export async function follows() {
  await visit("scene=toss&play=0");
  const worst = await see(`(() => {
    const { clientWidth: w, clientHeight: h } = $("stage"), next = globalThis.requestAnimationFrame;
    let least = Infinity, time = performance.now() + 1e3;
    globalThis.requestAnimationFrame = () => 0;
    for (let k = 0; k < 6; ++k) {
      toss();
      while (motion.more) extendTrail();
      for (let n = 0; n < 90 && playing; ++n) {
        scheduled = false;
        frame(time += 1e3 / 60);
        const { coinAt: [x, y], coinSize: r } = stage;
        least = Math.min(least, Math.min(x, w - x, y, h - y) / r);
      }
    }
    globalThis.requestAnimationFrame = next;
    scheduled = false;
    wake();
    return least; })()`);
  claim("a coin that is tossed stays in the picture", worst >= 1, worst);
  await visit("scene=quarter&play=0");
}

// The button does not move, whatever is said beside it.
export async function stays() {
  await visit("scene=toss");
  const place = () => see("JSON.stringify($('toss').getBoundingClientRect())"), first = await place();
  for (let k = 0; k < 3; ++k) {
    await see("$('toss').click()");
    await frame();
    claim("the button stays while the coin flies", await place() === first);
    await see("pausedAt(1e9)");
    await b.until("!motion.more");
    await see("{ m.now = motion.end - 1e-3; play(true); }");
    await b.until("!playing");
    await frame();
    claim("and when it has come to rest", await place() === first);
  }
  for (const scene of ["disk", "tumble&wZ=0.05&dt=0.2&race=1&now=20&play=0", "generic&swings=1000&play=0"]) {
    await visit("scene=" + scene);
    claim(`and in the scene ${scene}`, await place() === first);
  }
  await visit("scene=quarter&play=0");
}

// In all scenes a coin that is grabbed stays under the finger, and is let go.
export async function carries() {
  const { mouse } = b.page;
  for (const scene of ["rosette", "generic", "toss&now=0.2", "toss&now=9", "disk&now=3"]) {
    await visit(`scene=${scene}&play=0`);
    const { x, y } = await see("coinOnStage()");
    let worst = 0;
    await mouse.move(x, y);
    await mouse.down();
    for (let k = 1; k <= 8; ++k) {
      await mouse.move(x + 6 * k, y - 8 * k);
      await frame();
      const at = await see("coinOnStage()");
      worst = Math.max(worst, Math.hypot(at.x - x - 6 * k, at.y - y + 8 * k));
    }
    await mouse.up();
    claim(`the coin of ${scene} stays under the finger`, worst < 3, worst);
    claim("and flies when it is let go", await see("playing && isTossed()"));
    if (scene !== "toss&now=9") continue;
    const counted = await text("tosses");
    await see("{ fly({ vx: 0, vy: 0, vz: 0, wX: 0, wY: 0, wZ: 0, y: 0.4 * m.radius }); }");
    await b.until("!playing && m.now > 0");
    await frame();
    claim("a coin that is only put down is not counted", await text("tosses") === counted, await text("tosses"));
  }
}

// A toss that takes long is run faster in the end, and the page says so.
export async function tails() {
  await visit("scene=toss&thickness=0&dry=3e-7&spin=0&play=0");
  const end = await see("motion.end");
  claim("with little loss it takes long", end > 8, end);
  await see("{ m.now = 2; play(true); }");
  await b.until("$('pace').textContent === 'real time'");
  await see("{ m.now = 4.1; }");
  await b.until("$('pace').textContent === '4 times faster'");
  await see("{ m.now = motion.end - 0.9; }");
  await b.until("$('pace').textContent === 'real time'");
  await visit("scene=quarter&play=0");
}

// Sound begins with a gesture; it is heard until the coin rests, and can be off.
export async function sounds() {
  await b.open(address("#scene=toss&play=0"), DESKTOP);
  claim("there is no sound before a gesture", await see("sound.context === null"));
  await b.page.click("#toss");
  await b.until("sound.context && sound.context.state === 'running'");
  await b.until("sound.heard > 0");
  const loudness = `(() => { const x = new Float32Array(2048); sound.analyser.getFloatTimeDomainData(x);
    return Math.max(...x.map(Math.abs)); })()`;
  await b.until(`${loudness} > 0.01`);
  claim("impacts are heard", true);
  const [heard, fastest] = await see(`[lib.page_impact_count(), Math.max(...doubles(lib.page_impacts(),
    2 * lib.page_impact_count()).filter((_, k) => k % 2))]`);
  claim("one at least as fast as the coin falls", heard > 0 && fastest > 0.3, [heard, fastest]);
  await b.until("!playing", 30000);
  await b.until(`${loudness} < 1e-4`);
  claim("at rest it is silent", true);
  await b.page.click("#sound");
  await b.open(address("#scene=toss&play=0"), DESKTOP);
  claim("the switch is remembered", await see("!sound.on && $('sound').getAttribute('aria-pressed') === 'false'"));
  await b.page.click("#sound");
}

export async function disk() {
  await visit("scene=disk&play=0");
  const rates = await see(`[0.1, 0.5, 0.9, 0.99].map(part => { lib.page_near(part * motion.end);
    motion.moment = doubles(lib.page_now(), MOMENT); return tones()[0]; })`);
  claim("the hum rises to its end", rates.every((rate, k) => k === 0 || rate > rates[k - 1]) && rates[3] > 2 * rates[0], rates);
  await see("pausedAt(1e9)");
  await frame();
  await says("then there is silence", "verdict", /^Silence$/);
  await says("with the time and the turns", "why", /^after 2\d\.\d s and \d+ turns of the contact$/);
  claim("nothing moves any more", await see(`["wX", "wY", "wZ", "vx", "vy", "vz"].every(name =>
    motion.moment[AT[name]] === 0)`));
  claim("and nothing is heard", await see("tones().slice(1).every(x => x === 0)"));
}

// Each cell of the map is the toss that plays.
export async function luck() {
  await b.open(address("#scene=luck&play=0"), DESKTOP);
  await b.until("map.shown === MAP.wide * MAP.high", 60000);
  const red = await see("map.pixels.indexOf(FACE_COLORS[3])");
  const edge = await see(`[${red} % MAP.wide, Math.floor(${red} / MAP.wide)]`);
  claim("some end on the edge", red >= 0 && await see("$('luck').querySelector('.edge').checkVisibility()"), red);
  const spots = [[10, 10], [40, 200], [90, 90], [128, 112], [200, 60], [250, 220], [70, 150], edge];
  for (const [column, row] of spots) {
    const cell = await see(`map.pixels[${row} * MAP.wide + ${column}]`);
    await see(`{ tossAt((${column} + 0.5) / MAP.wide, (${row} + 0.5) / MAP.high); play(false); }`);
    await b.until("!motion.more");
    const face = await see("lib.page_near(motion.end) >= 0 && lib.page_face()");
    const color = await see(`FACE_COLORS[${face}]`);
    claim(`the toss of cell ${column}, ${row} is what the map says`, cell === color, [cell, face]);
  }
  const height = await see("m.y");
  await see("$('map').focus()");
  await b.page.keyboard.press("ArrowRight");
  claim("an arrow key plays the toss beside", await see("m.y") > height && await see("playing"));
  await see("play(false)");
  claim("the map is the current thing to try", await see("document.querySelector('nav [aria-current]').textContent") ===
    "The map of luck");
  const link = await see("addressOf(m)"), state = await see("JSON.stringify(m)");
  await visit("scene=hoop");
  await visit(link.slice(1));
  claim("a point is a link", await see("JSON.stringify(m)") === state, link);
  await visit("scene=luck&play=0");
  await see("$('closer').click()");
  await b.until("map.shown === MAP.wide * MAP.high", 60000);
  claim("closer is closer", await see("m.mapzoom") === 4);
  const before = await see("map.key");
  await see("{ const e = $('mapbounce'); e.value = 0.2; e.dispatchEvent(new Event('input')); }");
  await b.until(`map.key !== ${JSON.stringify(before)}`);
  claim("its bounce can be changed", await see("m.bounce") === 0.2);
  const shown = await see("map.key");
  await see("{ const e = $('mapthick'); e.value = 1.5; e.dispatchEvent(new Event('input')); }");
  await b.until(`map.key !== ${JSON.stringify(shown)} && map.shown > 500`, 60000);
  claim("and its thickness", await see("m.thickness === 1.5 * m.radius") && await see("map.pixels.includes(FACE_COLORS[3])"));
  await visit("scene=quarter&play=0");
}

// The coin of the textbook is below the table, and ours is not.
export async function sinks() {
  await visit("scene=nearflat&wY=0.005&wZ=0.005&dt=0.16&race=1&now=4&play=0");
  const [theirs, ours] = await see("[ghost(0).center[1], coinNow().center[1]]");
  claim("a textbook's coin sinks through the table", theirs < -0.5 && ours > 0, [theirs, ours]);
  await visit("scene=quarter&play=0");
}

// Without scripts the animation of README is there.
export async function scripts() {
  const page = await b.program.newPage();
  await page.setJavaScriptEnabled(false);
  await page.goto(address(""));
  const moving = await page.$$eval("noscript svg animateTransform", all => all.length).catch(() => 0);
  claim("without scripts a coin moves", moving > 5, moving);
  await page.close();
}

// What a frame costs the page's thread, beside a fixed piece of work on the same thread:
// a machine that is slow, or busy, is slow at both.  How many frames there were depends
// on what else runs.
// A frame took .4 to .8 of a million sines.
const MOST = 2;
export async function frames() {
  await b.open(address("#scene=toss"), DESKTOP);
  const session = await b.page.createCDPSession();
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const busy = async () => (await session.send("Performance.getMetrics")).metrics.find(m => m.name === "TaskDuration").value;
  const work = async () => {
    const before = await busy();
    await see("(() => { let sum = 0; for (let i = 0; i < 1e6; ++i) sum += Math.sin(i); return sum; })()");
    return 1e3 * (await busy() - before);
  };
  for (const scene of ["toss", "disk", "luck", "rosette", "generic", "tumble&race=1&wZ=0.05&dt=0.2"]) {
    await visit("scene=" + scene);
    await work(); // compiled
    const unit = (await work() + await work() + await work()) / 3, before = await busy();
    const [count, passed] = await see(`new Promise(done => { const begun = performance.now(); let n = 0;
      play(true);
      const tick = () => { ++n; const passed = performance.now() - begun;
        if (!playing) play(true);
        if (passed < 1500) requestAnimationFrame(tick); else done([n, passed]); }; requestAnimationFrame(tick); })`);
    const cost = 1e3 * (await busy() - before) / count;
    console.log(`${scene}: ${cost.toFixed(1)} ms a frame, a million sines ${unit.toFixed(1)} ms, ${(1e3 * count / passed).toFixed(0)} frames in a second`);
    claim(`a frame of ${scene} takes less than ${MOST} times a million sines`, count > 10 && cost > 0 && cost < MOST * unit, [cost, unit, count]);
  }
}
