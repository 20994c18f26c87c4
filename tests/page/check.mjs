// SPDX-License-Identifier: MIT
// The gate of docs/page/index.html: its bits, its work in a browser, its C
// listing, its budgets.
//     node check.mjs SRC OUT CC LIBRARY
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { AXE } from "./browser.mjs";
import { CC, claim, count, LIBRARY, SRC } from "./claims.mjs";
import { bits, budgets, sources } from "./files.mjs";
import { carries, disk, follows, frames, luck, opens, scripts, sinks, sounds, stays, tails } from "./play.mjs";
import { address, b, DESKTOP, frame, LANDSCAPE, launch, PHONE, quiet, says, see, set, text, visit } from "./see.mjs";

const RACE = "scene=tumble&wZ=0.05&dt=0.2&race=1&now=20&play=0";
const ON_EDGE = "scene=toss&play=0&theta=0.05&y=0.02&wX=0&wY=0&wZ=0&vx=0&vy=0&vz=0&thickness=0.018&now=9";
// A call of coin_move() has not steps enough for the first frame.
const MORE = "scene=toss&play=0&thickness=0.008&now=0.0015&theta=-1.5687410100443862&phi=69.999211995609784" +
  "&psi=-67.878947543616846&x=0.0064474377337831699&z=0.026946341955956691&wX=-1.3933385313197304" +
  "&wY=0.0014279614062982511&wZ=0.69435234798559242&y=0.004024922525980002&vx=-0.00016188482589106604" +
  "&vy=-0.016889705686805985&vz=0.0023251640329910528";
const PAUSED = "scene=quarter&play=0&now=0.5";

// The part of a canvas that is drawn upon.
const DRAWN = `id => {
  const c = $(id), pixels = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
  return pixels.filter((x, k) => k % 4 === 3 && x > 0).length / (c.width * c.height);
}`;
const LEAST_DRAWN = { stage: 0.25, leangraph: 0.02, forcegraph: 0.02, phasegraph: 0.02, energygraph: 0.02 };

async function looks(name, { width, mobile }, graphs = Object.keys(LEAST_DRAWN)) {
  claim(`the self-test passes on a ${name}`, (await text("selftest")).endsWith("self-test passed"));
  for (const id of graphs) {
    const drawn = await see(`(${DRAWN})("${id}")`);
    claim(`${id} is not blank on a ${name}`, drawn > LEAST_DRAWN[id], drawn);
  }
  const wide = await see("document.documentElement.scrollWidth") - width;
  claim(`nothing overflows on a ${name}`, wide <= 0, wide);
  const cut = await see(`[...document.querySelectorAll("body *")].filter(e => e.getClientRects().length &&
    !e.closest("pre, svg, noscript, select, nav") && e.getBoundingClientRect().right > ${width})
    .map(e => e.id || e.tagName)`);
  claim(`nothing is cut off on a ${name}`, cut.length === 0, cut);
  const least = mobile ? 44 : 24;
  const small = await see(`[...document.querySelectorAll("a:not(#skip), button, input, select, summary")].filter(e => {
    const r = e.getBoundingClientRect(); return r.width && (r.width < ${least} || r.height < ${least});
  }).map(e => e.id || e.textContent)`);
  claim(`targets have ${least} pixels on a ${name}`, small.length === 0, small);
}

async function access(where) {
  await see(AXE);
  const { passes, violations } = await see("axe.run()");
  claim(`axe-core has rules for the page ${where}`, passes.length > 20, passes.length);
  claim(`none is violated ${where}`, violations.length === 0,
    violations.map(rule => [rule.id, rule.nodes.map(node => [node.target, node.failureSummary])]));
}

async function tabulator() {
  const live = await see(`[...document.querySelectorAll("[aria-live], [role=alert], [role=status], [role=log]")]
    .map(e => e.id).join()`);
  claim("the verdict is the only live region", live === "verdict", live);
  const all = await see(`(document.activeElement.blur(), [...document.querySelectorAll(
    "a, button, input, select, summary, [tabindex]")].filter(e => e.checkVisibility()).length)`);
  const reached = new Set();
  for (let k = 0; k < all; ++k) {
    await b.page.keyboard.press("Tab");
    reached.add(await see("document.activeElement.id || document.activeElement.textContent"));
  }
  claim("the tabulator reaches all that a mouse does", reached.size === all, [reached.size, all]);
  await see("document.activeElement.blur(), scrollTo(0, 0)");
}

async function keys() {
  const state = () => b.evaluate("({ now: m.now, playing, theta: m.theta, at: motion.moment[1], az: m.az })");
  await visit(PAUSED);
  const before = await state();
  claim("it is paused where the address says so", !before.playing && before.now === 0.5, before);
  await b.page.keyboard.press("ArrowRight");
  claim("the right arrow is one step", (await state()).now === 0.5 + 1e-3);
  await b.page.keyboard.press("ArrowLeft");
  claim("the left arrow is one step back", Math.abs((await state()).now - 0.5) < 1e-12);
  await b.page.keyboard.press(" ");
  await b.until("m.now > 0.51");
  claim("space plays", (await state()).playing);
  await b.page.keyboard.press("r");
  await b.until("m.now < 0.45");
  claim("R reverses", await see("direction") === -1);
  await b.page.keyboard.press("r");
  await b.page.keyboard.press(" ");
  claim("space pauses", !(await state()).playing);
  await frame();
  const { at } = await state();
  await b.page.keyboard.press("s");
  await frame();
  claim("S starts from here", (await state()).theta === at && (await state()).now === 0);
  await b.page.keyboard.press("Home");
  claim("Home is the start", (await state()).now === 0);
  await see("document.getElementById('stage').focus()");
  const { az } = await state();
  await b.page.keyboard.press("ArrowRight");
  claim("on the view an arrow turns it", (await state()).az !== az && (await state()).now === 0);
}

async function pointer() {
  await visit(PAUSED);
  const { mouse } = b.page;
  const box = await see("$('stage').getBoundingClientRect().toJSON()");
  const az = await see("m.az"), zoom = await see("m.zoom");
  await mouse.move(box.left + 30, box.top + box.height - 30);
  await mouse.down();
  await mouse.move(box.left + 130, box.top + box.height - 30);
  await mouse.up();
  claim("dragging looks from elsewhere", await see("m.az") < az);
  await mouse.move(box.left + 50, box.top + 50);
  await mouse.wheel({ deltaY: 200 });
  await b.until("scrollY > 0");
  claim("a wheel over the coin scrolls the page", await see("m.zoom") === zoom);
  await see("scrollTo(0, 0)");
  await b.page.keyboard.down("Control");
  await mouse.wheel({ deltaY: -200 });
  await b.page.keyboard.up("Control");
  await b.until(`m.zoom > ${zoom}`);
  await frame();
  const at = await see("motion.moment[1]");
  const [x, y] = await see("stage.coinAt");
  await mouse.move(box.left + x, box.top + y);
  await mouse.down();
  claim("grabbing the coin makes the present the start", await see("m.now") === 0 && await see("m.theta") === at);
  // The clock of events is ours: a machine that is busy throws as far.
  const clock = k => see(`void Object.defineProperty(Event.prototype, "timeStamp",
    { configurable: true, get: () => ${1e6 + 10 * k} })`);
  for (let k = 0; k <= 8; ++k) {
    await clock(k);
    await mouse.move(box.left + x + 4 * k, box.top + y - 10 * k);
    await frame();
    const { x: cx, y: cy } = await see("coinOnStage()");
    claim(`the coin stays under the finger, ${k}`, Math.hypot(cx - box.left - x - 4 * k, cy - box.top - y + 10 * k) < 3, [cx, cy]);
  }
  claim("dragging lifts it", await see("!playing && m.y > 1.3 * m.radius * Math.cos(m.theta)"));
  await mouse.up();
  const thrown = await see("metersPerSecond(m.vy)"); // by 1000 pixels in a second
  claim("and letting it go throws it up, as a hand does", await see("playing && isTossed()") && thrown > 1 && thrown < 2.8, thrown);
}

// A tossed coin: what it does until it lies.
async function toss() {
  await visit("scene=quarter&play=0");
  await b.page.keyboard.press("t");
  await b.until("!motion.more && motion.moment[AT.y] > 2.5 * m.radius");
  claim("T tosses the coin", await see("playing && isReal() && isTossed()"));
  await b.until("$('verdict').textContent === 'Flies'");
  const modes = await see(`[...new Set(Array.from({ length: motion.count }, (_, k) => knot(k, AT.bits)))].sort().join()`);
  claim("it flies, slips and rests", /^(0,)?1,16,2$/.test(modes), modes);
  claim("its energy never rises", await see(`Array.from({ length: motion.count - 1 },
    (_, k) => knot(k + 1, AT.energy) / knot(k, AT.energy)).every(ratio => ratio < 1 + 1e-5)`));
  claim("it stays above the table", await see(`Array.from({ length: motion.count },
    (_, k) => knot(k, AT.y) / m.radius - Math.cos(knot(k, AT.theta))).every(gap => gap > -1e-12)`));
  const slowly = await see("slow");
  await see("$('slow').click()");
  claim("slow motion is slower", await see("slow") < slowly);
  await b.until("$('pace').textContent === '8 times slower'");
  await see("$('slow').click()");
  const before = { Heads: await text("countHeads"), Tails: await text("countTails") };
  await see("{ m.now = motion.end - m.speed / 30; wake(); }");
  await b.until("!playing");
  await frame();
  const face = await see("motion.moment[AT.theta] < 0 ? 'Heads' : 'Tails'");
  await says("at rest a face is up", "verdict", new RegExp(`^${face}$`));
  claim("the toss is counted once", await text("count" + face) === String(Number(before[face]) + 1), before);
  claim("and the others are not", await text("count" + (face === "Heads" ? "Tails" : "Heads")) === before[face === "Heads" ? "Tails" : "Heads"]);
}

// The rims are drawn where they are.
async function rims() {
  for (const start of ["whirl", "whirl&theta=-0.4&thickness=0.01", "edge", "rosette"]) {
    await visit(`scene=${start}&play=0`);
    const heights = await see("[-1, 1].map(side => coinNow().point(1, -Math.PI / 2, side * half())[1])");
    claim(`the lower rim of ${start} is drawn on the table`, Math.abs(Math.min(...heights)) < 1e-12 && Math.max(...heights) > 1e-3, heights);
    const [x, , z] = await see(`coinNow().point(1, -Math.PI / 2, ${heights[0] < heights[1] ? -1 : 1} * reckoned())`);
    const at = await see("[AT.cx, AT.cz].map(what => motion.moment[what] / m.radius)");
    claim(`and touches it where the contact of ${start} is`, Math.hypot(x - at[0], z - at[1]) < 1e-12, [x, z, at]);
  }
}

// What is seen: the coin is large and in the picture all the time.
async function views() {
  for (const name of (await see("sceneNames().join()")).split(",")) {
    await visit(`scene=${name}&play=0`);
    const worst = await see(`(() => {
      const all = Array.from({ length: 40 }, (_, k) => {
        const { clientWidth: w, clientHeight: h } = $("stage");
        m.now = motion.end * k / 40;
        lib.page_at(0, m.now);
        motion.moment = doubles(lib.page_now(), MOMENT);
        drawStage();
        const [x, y] = stage.coinAt, r = stage.coinSize;
        return [r, Math.min(x, w - x, y, h - y) - 0.5 * r];
      });
      return [0, 1].map(k => Math.min(...all.map(row => row[k])));
    })()`);
    const least = await see("isReal()") ? 22 : 40; // one that is thrown is seen from afar
    claim(`the coin of ${name} has a radius of ${least} pixels`, worst[0] >= least, worst[0]);
    claim(`and stays in the picture: ${name}`, worst[1] >= 0, worst[1]);
  }
  await visit("scene=rosette");
  claim("the rosette closes: angles to 1e-9, but for whole turns", await see(`[1, 2, 3].every(k =>
    Math.abs(Math.sin((knot(motion.count - 1, k) - knot(0, k)) / 2)) < 1e-9)`));
  await see("{ m.now = motion.end - 0.01; play(true); }");
  await b.until("m.now < 0.5 * motion.end");
  claim("and begins again", await see("playing"));
}

async function files() {
  await visit("scene=quarter&play=0");
  const [head, first, ...rest] = (await see("csv()")).trim().split("\n");
  claim("the CSV has a column for each number", head.split(",").length === first.split(",").length, head);
  claim("and a row for each knot", rest.length + 1 === await see("motion.count"));
  const saved = await see(`new Promise(done => { save = (name, blob) => done(name + " " + blob.type); picture(); })`);
  claim("the picture is a PNG", saved === "coin.png image/png", saved);
}

async function pinch() {
  const zoom = await see("m.zoom");
  await see("$('stage').scrollIntoView()");
  const top = await see("$('stage').getBoundingClientRect().top");
  const fingers = [];
  for (const x of [110, 190])
    fingers.push(await b.page.touchscreen.touchStart(x, top + 30));
  for (const gap of [60, 100]) {
    await fingers[0].move(150 - gap, top + 30);
    await fingers[1].move(150 + gap, top + 30);
  }
  for (const finger of fingers)
    await finger.end();
  claim("pinching comes closer", await see("m.zoom") > 1.5 * zoom);
}

async function controls() {
  const near = async (text, expression, value, error) => {
    const x = await see(expression);
    claim(text, Math.abs(x - value) <= error, x);
  };
  await visit(PAUSED);
  await set("mu", 0.1);
  await see("pausedAt(0.1)");
  await frame();
  claim("the slider of mu makes the coin slip", await text("verdict") === "Slips", await text("verdict"));
  await set("mu", 1.05);
  claim("its end is the ideal coin", await see("m.mu === Infinity") && await text("verdict") === "Rolls");
  await set("lean", 30);
  await near("that of the lean is in degrees", "m.theta", Math.PI / 6, 1e-15);
  await set("wZ", 1.5);
  await near("those of rates are in turns a second", "m.wZ", 1.5 * 2 * Math.PI, 1e-12);
  await set("hole", 0.5);
  await near("that of the hole is in radii", "m.inner / m.radius", 0.5, 1e-12);
  await set("scrub", 0.25);
  await near("that of time is a part of the axis", "m.now / motion.end", 0.25, 1e-12);
  await set("method", 3, "change");
  await set("race", true, "change");
  claim("a race begins", /^off by /.test(await text("racer1")), await text("racer1"));
  await set("scene", await see("sceneNames().indexOf('spin')"), "change");
  claim("a scene can be chosen", await see("sceneNames()[m.scene]") === "spin" && await see("m.wZ") === 0);
  await see("play(false)");
  await set("rest", 0.7, "change");
  // coin_losses_fit() is good to m^1.2, and m is 0.026 here.
  await near("a coin rests when it is told to", "motion.restsAt / second()", 0.7, 0.7 * 0.026 ** 1.2);
  await set("strength", -2);
  await near("a loss is in natural units", "m.dry", 1e-2, 1e-12);
  await set("law", "viscous", "change");
  claim("another law has the same size", await see("Math.abs(m.viscous - 1e-2) < 1e-12 && m.dry === 0"));
  await set("thick", 0.4);
  claim("with a thickness it is a real coin, without a hole", await see("isReal() && m.inner === 0"));
  await near("that of the thickness is in radii", "m.thickness / m.radius", 0.4, 1e-12);
  await set("mu", 1.05);
  claim("an ideal coin is thin", await see("m.thickness === 0 && !isReal()"));
  await b.until("location.hash === addressOf(m)");
  await see("$('link').click()");
  await b.until("$('link').textContent !== 'Copy link'");
}

const FULL = "scene=ring&theta=0.5123456789012346&phi=-1.1&psi=0.30000000000000004&x=1e-7&z=-3&wX=0.15" +
  "&wY=0.7123&wZ=-1.2&inner=0.8765432109876543&radius=1.25&gravity=0.9&mass=2&mu=0.123456789&dt=0.0123" +
  "&span=33.3&now=7.000000001&speed=0.7&az=-2.5&el=1.1&zoom=1.7&method=symplectic4&race=1&play=0";
const LOSSY = "scene=spin&dry=0.001&viscous=0.0001&soft=0.002&play=0&now=3.25";

async function addresses() {
  for (const hash of [FULL, LOSSY, PAUSED, "scene=generic&swings=1000000&now=1.5&play=0"]) {
    await visit(hash);
    const said = await text("message"), state = await see("JSON.stringify(m)"), written = await see("addressOf(m)");
    claim(`an address is understood: ${hash}`, said === "", said);
    const shown = await text("digits");
    await visit("scene=hoop");
    await visit(written);
    const again = await see("JSON.stringify(m)"), then = await text("digits");
    claim(`and written again it is the same: ${hash}`, again === state && then === shown, written);
    for (const part of hash.split("&").filter(p => !p.startsWith("scene=")))
      claim(`it holds ${part}`, written.includes(part), written);
  }
}

const HOSTILE = [
  "scene=", "scene=nope", "scene=__proto__", "theta=", "theta=NaN", "theta=Infinity", "theta=2",
  "theta=1e999", "theta=inf", "theta=0x1", "theta=1,2", "theta=%00", "%", "%E0%A4%A", "=", "a=b=c", "__proto__=1",
  "constructor=1", "toString=1", "knots=1", "theta=0.1&theta=0.2", "mass=-1", "mass=0", "radius=1e308",
  "inner=2", "gravity=-9.8", "mu=-1", "mu=NaN", "mu=5", "bounce=2", "y=-1", "y=2e9", "dry=-1", "dry=1e200", "wX=1e300", "phi=1e10", "x=1e999",
  "now=-1", "now=1e300", "span=0", "dt=0", "dt=-1", "swings=-1", "swings=1e12", "zoom=0", "el=9",
  "speed=0", "thickness=-1", "thickness=0.1", "scene=quarter&thickness=0.001",
  "scene=toss&inner=0.001", "mapzoom=0", "method=euler", "race=2", "play=yes", "<img src=x onerror=alert(1)>",
  "theta=<script>alert(1)</script>", "javascript:alert(1)", "theta=1 ", "a".repeat(5000), "&".repeat(4000),
  "theta=" + "9".repeat(200), "scene=quarter&\u0000=1",
];

async function hostile() {
  for (const hash of HOSTILE) {
    await see("say('')");
    await visit(hash);
    const name = hash.slice(0, 40);
    await says(`refused with a message: ${name}`, "message", /^This link has parts that mean nothing here/);
    claim(`and a coin is there: ${name}`, await see("motion.status >= 0 && motion.count > 1 && m.now >= 0"));
  }
  await see("load('#theta=<b>1</b>')"); // as an address, a browser would encode it
  claim("nothing of an address becomes markup", (await text("message")).includes("<b>"), await text("message"));
}

// --------------------------------------------------------------- the coins --
async function coins() {
  const scenes = await see("sceneNames().join()");
  for (const name of [...scenes.split(","), "spin&dry=0.01", "flick&viscous=1e-7", "hoop&dry=0.01&damping=0.01"]) {
    await visit(`scene=${name}&play=0`);
    const chord = await see(`Math.max(...Array.from({ length: motion.count - 1 }, (_, k) =>
      Math.hypot(knot(k + 1, AT.cx) - knot(k, AT.cx), knot(k + 1, AT.cz) - knot(k, AT.cz)) / m.radius))`);
    claim(`chords of the trail are below 0.12 radii in ${name}`, chord < 0.12 || await see("isReal()"), chord);
    claim(`the trail reaches the end in ${name}`, await see(
      "(motion.restsAt || m.span) === motion.end && knot(motion.count - 1, 0) === motion.end"));
  }
  const links = await see("[...document.querySelectorAll('nav a')].map(a => a.getAttribute('href'))");
  claim("there are eight things to try", links.length === 8);
  for (const link of links) {
    await visit(link);
    claim(`a thing to try is an address: ${link}`, await text("message") === "", await text("message"));
  }
}

async function verdicts() {
  const said = async hash => { await visit(hash); return `${await text("verdict")}: ${await text("why")}`; };
  const expect = async (hash, pattern) => {
    const words = await said(hash);
    claim(`${hash} says ${pattern}`, pattern.test(words), words);
  };
  await expect("scene=quarter&play=0", /^Rolls: a real coin needs friction of 0\.19\d$/);
  await expect("scene=quarter&play=0&mu=0.3", /^Rolls: needs friction of 0\.19\d, has 0\.30$/);
  await expect("scene=quarter&play=0&mu=0.1&now=0.1", /^Slips: rolling would need more friction than 0\.10$/);
  await expect("scene=nearflat&play=0&now=2.3205", /^Is held down: a real coin would lift off: N = −/);
  await expect("scene=quarter&play=0&y=0.1&now=0.01&mu=0.3", /^Flies: 1\.0·10² mm high$|^Flies: 99 mm high$|^Flies: 100 mm high$/);
  await expect("scene=spin&play=0&dry=0.01&now=500",
    /^Lies flat: after [\d.]+ s; without pivoting friction its face turns on, [\d.]+ times a second$/);
  claim("the light has a shape for it", await see("$('light').dataset.kind") === "rests");
  claim("the energy falls all the way", await see(`Array.from({ length: motion.count - 1 },
    (_, k) => knot(k + 1, AT.energy) / knot(k, AT.energy)).every(ratio => ratio < 1 + 1e-9) &&
    motion.moment[AT.energy] < 0.5 * knot(0, AT.energy)`));
  await says("and the time of rest is stated", "resttext", /^It rests after [\d.]+ s/);
  await expect("scene=nearflat&play=0&wY=0&wZ=0&now=9", /^Lies flat: after/);
  for (const table of ["", "&mu=0.3"])
    await expect(`scene=wobble&play=0&theta=0&dry=0.01&now=1e3${table}`, /^(At rest|Edge): after [\d.]+ s$/);
  await expect("scene=wobble&play=0&theta=0&wZ=0&y=2&mu=0.3&now=50", /^Edge: after/);
  await expect(ON_EDGE, /^Edge: after/);
  await expect(MORE, /^(Slips|Rolls): /);
  claim("what takes more steps than a call makes is gone on with", await text("message") === "" && await see("motion.rests"));
  await expect("scene=generic&play=0", /^Rolls: /);
  claim("a time of too many steps is refused", await see("lib.page_at(0, 1e9 * unit())") < 0);
}

async function races() {
  await visit(RACE);
  await access("in a race");
  await says("a textbook RK4 goes through the table", "racer0",
    /^sank through the table at 0\.3\d* s$/);
  await says("the library refuses the step", "racer1", /^stopped at 0\.3\d* s: it sees that the step would be wrong$/);
  await says("coin_advance gets through", "racer2", /^gets through$/);
  await says("and the verdict agrees", "verdict", /^Ours gets through$/);
  const drawn = await see(`(${DRAWN})("errorgraph")`);
  claim("errorgraph is not blank", drawn > 0.01, drawn);
  await visit("scene=generic&race=1&dt=0.1&now=10.05&play=0&method=rk4");
  const whole = await see("racer(1)[RACE.steps]"), errors = await see("[0, 1].map(k => racer(k)[RACE.pose])");
  claim("whole steps and a shorter one", whole === 100, whole);
  claim("both RK4 err alike at one time", errors.every(x => x > 1e-9 && x < 1e-3), errors);
  await visit("scene=generic&race=1&dt=0.5&now=10&play=0&method=rk4");
  await says("coarse steps are called so", "racer1", /and warns: coarse$/);
  await visit("scene=generic&race=1&dt=0.6&span=3000&now=2900&play=0&method=rk4");
  const [apart, path] = await see("[racer(1)[RACE.pose], Math.hypot(racer(1)[RACE.shown + 3] - motion.moment[AT.x], " +
    "racer(1)[RACE.shown + 4] - motion.moment[AT.z])]");
  claim("angles are apart by half a turn at most", apart <= Math.max(Math.PI, path + 1e-9) && apart > 0.1, [apart, path]);
  await visit("scene=generic&race=1&dt=0.00001&now=10&play=0");
  await says("a race of too many steps is not begun", "racetext", /^Too many steps/);
}

async function far() {
  await visit("scene=generic&swings=1000&play=0&now=1");
  await b.until("far.there");
  await frame();
  const words = await text("racers");
  claim("an RK4 is off by then", /^RK4, steps of 3\.52 ms\s+off by [\d.]+ mm, the energy by −.* %/.test(words), words);
  claim("and the orbit is not", /coin_orbit_at\s+is there without a step, off by at most \d/.test(words), words);
  await visit("scene=generic&play=0&now=1");
  await see("$('million').click()");
  await frame();
  await says("a million swings by the orbit, its error stated", "fartext", /coin_orbit_at is here off by at most \d/);
  const lean = await see("motion.moment[1]");
  await visit("scene=generic&play=0&now=1");
  claim("where the lean is as at the start", Math.abs(await see("motion.moment[1]") - lean) < 1e-6);
  await visit("scene=spin&dry=0.01&swings=1000000&play=0");
  await says("where no orbit leads, that is said", "message", /^No orbit leads so far/);
  claim("and the start is shown", await see("m.swings") === 0);
  // An unstable circle, which has no period.
  const T = Math.tan(0.2), wZ = 0.3, wY = (-1.5 * wZ + Math.sqrt(2.25 * wZ * wZ + T * Math.sin(0.2))) / (0.5 * T);
  await visit(`scene=circle&theta=0.2&wZ=0.3&wY=${wY}&play=0`);
  await see("$('million').click()");
  await frame();
  await says("without a period it stays", "fartext", /^No period/);
  claim("at swing 0", await see("m.swings") === 0);
}

// -------------------------------------------------------------- the listing --
async function listings() {
  const folder = mkdtempSync(join(tmpdir(), "rollcoin-page-"));
  for (const hash of [PAUSED, FULL, LOSSY, "scene=generic&swings=1000000&now=2.5&play=0",
    "scene=spin&dry=0.01&now=500&play=0", "scene=flick&race=1&now=0.7&play=0",
    "scene=nearflat&wY=0&wZ=0&now=9&play=0", "scene=quarter&mu=0.1&now=0.3456&play=0",
    "scene=quarter&mu=0.3&y=0.1&vx=0.2&wX=80&dry=1e-5&now=0.7654&play=0", "scene=toss&now=0.6&play=0", ON_EDGE, MORE,
    "scene=disk&now=1.5&play=0"]) {
    await visit(hash);
    writeFileSync(join(folder, "page.c"), await text("listing"));
    execFileSync(CC, ["-std=c99", "-Wall", "-Wextra", "-Werror", "-I" + join(SRC, "include"),
      "-o", join(folder, "page"), join(folder, "page.c"), LIBRARY, "-lm"]);
    const printed = spawnSync(join(folder, "page")).stdout.toString();
    const shown = await text("digits");
    claim(`the C program prints the page's digits: ${hash}`, printed === shown, printed + shown);
  }
  rmSync(folder, { recursive: true });
}

async function desktop(parts) {
  await b.open(address("#" + PAUSED), DESKTOP);
  await looks("desktop", DESKTOP);
  await access("in light");
  await tabulator();
  for (const part of parts)
    await part();
  await quiet("on a desktop");
}

async function phone(parts) {
  await b.open(address("#" + PAUSED), PHONE);
  await see("document.querySelectorAll('details').forEach(d => { d.open = true; })");
  await looks("phone", PHONE);
  await access("on a phone");
  for (const part of parts)
    await part();
  for (const id of ["lean", "mu", "race", "speed"]) {
    await see(`$("${id}").scrollIntoView({ block: "start" })`);
    await frame();
    const [top, bottom, of] = await see(`(({ top, bottom }) => [top, bottom, $("${id}").getBoundingClientRect().top])(
      $("view").getBoundingClientRect())`);
    claim(`the coin is in view while ${id} is changed`, top >= 0 && bottom > 150 && of >= bottom, [top, bottom, of]);
  }
  await quiet("on a phone");
}

async function embedded() {
  await b.open(address("?embed=1#scene=quarter"), { width: 480, height: 320 });
  claim("embedded, the coin fills the frame", await see("$('view').getBoundingClientRect().height") === 320);
  claim("and nothing else is there", await see("document.documentElement.scrollHeight") === 320);
  await see("$('skip').click()");
  claim("the skip link leads to the coin", await see("document.activeElement.id === 'stage' && sceneName() === 'quarter'"));
  await access("embedded");
}

async function dark() {
  await b.open(address("#scene=quarter"), { ...DESKTOP, media: [{ name: "prefers-reduced-motion", value: "reduce" },
    { name: "prefers-color-scheme", value: "dark" }] });
  claim("reduced motion starts paused", await see("playing") === false);
  claim("dark is dark", await see("getComputedStyle(document.body).backgroundColor") === "rgb(20, 18, 15)");
  await access("in the dark");
  await visit(RACE);
  await access("in a dark race");
  await visit("scene=luck&play=0");
  await access("beside the map in the dark");
  await quiet("in the dark");
  await b.open(address("#scene=quarter"), DESKTOP);
  claim("else it plays", await see("playing") === true);
  await frame();
  claim("with a program to read", /coin_advance/.test(await text("listing")));
}

async function landscape() {
  await b.open(address("#scene=toss"), LANDSCAPE);
  await looks("phone on its side", LANDSCAPE, []);
  const { top, bottom } = await see("$('toss').getBoundingClientRect().toJSON()");
  claim("the button is in view on a phone on its side", top >= 0 && bottom <= LANDSCAPE.height, [top, bottom]);
  await access("on a phone on its side");
}

try {
  await bits();
  sources();
  budgets();
  await launch("chrome");
  await desktop([opens, keys, pointer, carries, toss, rims, follows, tails, stays, views, files, controls, addresses, hostile, coins, verdicts, sounds,
    disk, luck, races, sinks, far, listings]);
  await phone([pinch]);
  await landscape();
  await embedded();
  await dark();
  await scripts();
  await frames();
  await b.program.close();
  await launch("firefox");
  await desktop([opens, keys, pointer, toss, follows, controls, verdicts, luck, races, sinks, far]);
  await phone([]);
} finally {
  await b?.program.close();
}
console.log(`page-check: ${count.claims} claims, ${count.failures} failed`);
process.exitCode = count.failures ? 1 : 0;
