// SPDX-License-Identifier: MIT
// The gate of docs/page/index.html: its bits, its work in a browser, its C
// listing, its budgets.
//     node check.mjs SRC OUT CC LIBRARY
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { gunzipSync } from "node:zlib";
import { Browser } from "./browser.mjs";

const [SRC, OUT, CC, LIBRARY] = process.argv.slice(2);
const PAGE = join(SRC, "docs/page/index.html"), html = readFileSync(PAGE, "utf8");
const address = hash => pathToFileURL(PAGE).href + hash;
const inside = id => html.match(new RegExp(`<script type="text/plain" id="${id}">\n([^<]*)</script>`))[1];
let claims = 0, failures = 0;

function claim(text, holds, seen = "") {
  ++claims;
  if (holds === true)
    return;
  ++failures;
  console.log(`FAILED: ${text} ${seen === "" ? "" : JSON.stringify(seen)}`);
}

// ----------------------------------------------------------------- the bits --
async function bits() {
  const wasm = gunzipSync(Buffer.from(inside("wasm"), "base64"));
  const module = await WebAssembly.compile(wasm);
  claim("the wasm imports nothing", WebAssembly.Module.imports(module).length === 0);
  const lib = (await WebAssembly.instantiate(module, {})).exports;
  const text = at => Buffer.from(new Uint8Array(lib.memory.buffer, at, 99)).toString().split("\0")[0];
  const native = readFileSync(join(OUT, "hashes.txt"), "utf8");
  let here = "";
  for (let k = 0; k < lib.page_scene_count(); ++k)
    here += text(lib.page_scene_word(k, 0)) + " " + text(lib.page_hash(k)) + "\n";
  claim("the committed wasm gives this computer's bits: else make page", here === native, here);
  claim("the page compares itself with this computer's bits: else make page", inside("hashes") === native);
  claim("the scenes are those of scenes.h",
    [...readFileSync(join(SRC, "docs/examples/scenes.h"), "utf8").matchAll(/^ {4}\{"(\w+)", &/gm)].map(x => x[1]).join() ===
      native.trim().split("\n").map(line => line.split(" ")[0]).join());
}

// The page is its sources, its wasm apart: that depends on the compiler.
function sources(scripts) {
  const folder = mkdtempSync(join(tmpdir(), "rollcoin-page-")), part = name => join(SRC, "docs/page", name);
  writeFileSync(join(folder, "wasm.txt"), inside("wasm"));
  const env = { ...process.env, wasm: join(folder, "wasm.txt"), hashes: join(OUT, "hashes.txt"),
    still: join(OUT, "still.svg"), style: part("style.css"), script: scripts.map(part).join(" ") };
  const built = execFileSync("awk", ["-f", part("embed.awk"), part("page.html")], { env, maxBuffer: 1e7 });
  claim("the committed page is what its sources make: else make page", built.toString() === html);
  rmSync(folder, { recursive: true });
}

// -------------------------------------------------------------- the budgets --
const BYTES = 150e3, LINES = 650, COLUMNS = 120;

function budgets() {
  const script = html.slice(html.lastIndexOf("<script>") + 9, html.lastIndexOf("</script>")).split("\n");
  const code = script.filter(line => !/^\s*(\/\/.*)?$/.test(line));
  const size = Buffer.byteLength(html);
  console.log(`${size} bytes, ${code.length} lines of script (${script.length} with comments and blank lines)`);
  claim(`the file has at most ${BYTES} bytes`, size <= BYTES, size);
  claim(`the script has at most ${LINES} lines`, code.length <= LINES, code.length);
  claim(`of at most ${COLUMNS} columns`, script.every(line => line.length <= COLUMNS), Math.max(...script.map(l => l.length)));
  claim("it names no other place", !/\b(https?:)?\/\/[a-z]/i.test(html.replace(inside("wasm"), "").replace(/^\s*\/\/.*$/gm, "")));
}

// -------------------------------------------------------------- the browser --
const b = new Browser();
const DESKTOP = { width: 1280, height: 800 }, PHONE = { width: 360, height: 740, mobile: true };
const PAUSED = "scene=quarter&play=0&now=0.5";
const text = id => b.evaluate(`(e => e.matches("pre") ? e.textContent : e.innerText)(document.getElementById("${id}"))`);
const frame = () => b.evaluate("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(true))))");

// Opens another hash in the page that is there, and waits until it is drawn.
async function visit(hash) {
  await b.evaluate(`new Promise(done => {
    addEventListener("hashchange", done, { once: true });
    setTimeout(done, 200);
    location.hash = ${JSON.stringify(hash)};
  }).then(() => true)`);
  await frame();
  await b.until("!motion.more");
  await frame();
}

async function quiet(where) {
  claim(`no exception and no error ${where}`, b.problems.length === 0, b.problems);
  claim(`no request ${where}`, b.requests.length === 1 && b.requests[0].startsWith("file:"), b.requests);
}

const COLORS_OF = `id => {
  const c = document.getElementById(id), d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
  const seen = new Set();
  for (let k = 0; k < d.length; k += 4) seen.add(d[k] << 24 | d[k + 1] << 16 | d[k + 2] << 8 | d[k + 3]);
  return seen.size;
}`;

async function looks(name) {
  claim(`the self-test passes on a ${name}`, (await text("selftest")).endsWith("self-test passed"));
  for (const id of ["stage", "leangraph", "forcegraph", "phasegraph", "energygraph"])
    claim(`${id} is not blank on a ${name}`, await b.evaluate(`(${COLORS_OF})("${id}")`) > 8);
  const wide = await b.evaluate("document.documentElement.scrollWidth - innerWidth");
  claim(`nothing overflows on a ${name}`, wide <= 0, wide);
  const cut = await b.evaluate(`[...document.querySelectorAll("body *")].filter(e => e.getClientRects().length &&
    !e.closest("pre, svg, noscript, select") && e.getBoundingClientRect().right > innerWidth).map(e => e.id || e.tagName)`);
  claim(`nothing is cut off on a ${name}`, cut.length === 0, cut);
  const small = await b.evaluate(`[...document.querySelectorAll("a, button, input, select, summary")].filter(e => {
    const r = e.getBoundingClientRect(); return r.width < 24 || r.height < 24; }).map(e => e.id || e.textContent)`);
  claim(`targets have 24 pixels on a ${name}`, small.length === 0, small);
}

async function access() {
  const { nodes } = await b.send("Accessibility.getFullAXTree");
  const nameless = nodes.filter(n => n.properties?.some(p => p.name === "focusable" && p.value.value) &&
    n.role.value !== "RootWebArea" && !n.name?.value).map(n => n.role.value);
  claim("whatever takes the focus has a name", nameless.length === 0, nameless);
  claim("the verdict is the only live region", await b.evaluate(
    `[...document.querySelectorAll("[aria-live], [role=alert], [role=status], [role=log]")].map(e => e.id).join()`) === "verdict");
}

async function keys() {
  const state = () => b.evaluate("({ now: m.now, playing, theta: m.theta, at: motion.moment[1], az: m.az })");
  await visit(PAUSED);
  const before = await state();
  claim("it is paused where the address says so", !before.playing && before.now === 0.5, before);
  await b.key("ArrowRight");
  claim("the right arrow is one step", (await state()).now === 0.5 + 1e-3);
  await b.key("ArrowLeft");
  claim("the left arrow is one step back", Math.abs((await state()).now - 0.5) < 1e-12);
  await b.key(" ", "Space");
  await b.until("m.now > 0.51");
  claim("space plays", (await state()).playing);
  await b.key("r");
  await b.until("m.now < 0.45");
  claim("R reverses", await b.evaluate("direction") === -1);
  await b.key("r");
  await b.key(" ", "Space");
  claim("space pauses", !(await state()).playing);
  await frame();
  const { at } = await state();
  await b.key("s");
  await frame();
  claim("S starts from here", (await state()).theta === at && (await state()).now === 0);
  await b.key("Home");
  claim("Home is the start", (await state()).now === 0);
  await b.evaluate("document.getElementById('stage').focus()");
  const { az } = await state();
  await b.key("ArrowRight");
  claim("on the view an arrow turns it", (await state()).az !== az && (await state()).now === 0);
}

async function mouse(type, x, y, more = {}) {
  await b.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: type === "mouseReleased" ? 0 : 1, clickCount: 1, ...more });
}

async function pointer() {
  await visit(PAUSED);
  const box = await b.evaluate("(({ left, top, height }) => ({ left, top, height }))($('stage').getBoundingClientRect())");
  const az = await b.evaluate("m.az"), zoom = await b.evaluate("m.zoom");
  await mouse("mousePressed", box.left + 30, box.top + box.height - 30);
  await mouse("mouseMoved", box.left + 130, box.top + box.height - 30);
  await mouse("mouseReleased", box.left + 130, box.top + box.height - 30);
  claim("dragging looks from elsewhere", await b.evaluate("m.az") < az);
  await b.send("Input.dispatchMouseEvent", { type: "mouseWheel", x: box.left + 50, y: box.top + 50, deltaX: 0, deltaY: -200 });
  await b.until(`m.zoom > ${zoom}`);
  await frame();
  const at = await b.evaluate("motion.moment[1]");
  const [x, y] = await b.evaluate("stage.coinAt");
  await mouse("mousePressed", box.left + x, box.top + y);
  claim("grabbing the coin makes the present the start", await b.evaluate("m.theta") === at && await b.evaluate("m.now") === 0);
  await mouse("mouseMoved", box.left + x, box.top + y + 20);
  await mouse("mouseReleased", box.left + x, box.top + y + 20);
  claim("and dragging it leans it", await b.evaluate("m.theta") > at);
}

async function pinch() {
  const zoom = await b.evaluate("m.zoom");
  await b.evaluate("$('stage').scrollIntoView()");
  const top = await b.evaluate("$('stage').getBoundingClientRect().top");
  for (const [type, gap] of [["touchStart", 40], ["touchMove", 60], ["touchMove", 100]])
    await b.send("Input.dispatchTouchEvent", { type,
      touchPoints: [{ x: 150 - gap, y: top + 30, id: 1 }, { x: 150 + gap, y: top + 30, id: 2 }] });
  await b.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  claim("pinching comes closer", await b.evaluate("m.zoom") > 1.5 * zoom);
}

const FULL = "scene=ring&theta=0.5123456789012346&phi=-1.1&psi=0.30000000000000004&x=1e-7&z=-3&wX=0.15&wY=0.7123&wZ=-1.2" +
  "&inner=0.8765432109876543&radius=1.25&gravity=0.9&mass=2&mu=0.123456789&dt=0.0123&span=33.3&now=7.000000001&speed=0.7" +
  "&az=-2.5&el=1.1&zoom=1.7&method=symplectic4&race=1&play=0";
const LOSSY = "scene=spin&dry=0.001&viscous=0.0001&soft=0.002&play=0&now=3.25";

async function addresses() {
  for (const hash of [FULL, LOSSY, PAUSED, "scene=generic&swings=1000000&now=1.5&play=0"]) {
    await visit(hash);
    const [said, state, written] = [await text("message"), await b.evaluate("JSON.stringify(m)"), await b.evaluate("addressOf(m)")];
    claim(`an address is understood: ${hash}`, said === "", said);
    const shown = await text("digits");
    await visit("scene=hoop");
    await visit(written);
    claim(`and written again it is the same: ${hash}`, await b.evaluate("JSON.stringify(m)") === state && await text("digits") === shown, written);
    for (const part of hash.split("&").filter(p => !p.startsWith("scene=")))
      claim(`it holds ${part}`, written.includes(part), written);
  }
}

const HOSTILE = ["scene=", "scene=nope", "scene=__proto__", "theta=", "theta=NaN", "theta=Infinity", "theta=2", "theta=1e999",
  "theta=0x1", "theta=1,2", "theta=%00", "%", "%E0%A4%A", "=", "a=b=c", "__proto__=1", "constructor=1", "toString=1", "knots=1",
  "theta=0.1&theta=0.2", "mass=-1", "mass=0", "radius=1e308", "inner=2", "gravity=-9.8", "mu=-1", "mu=NaN", "dry=-1", "dry=1e200",
  "wX=1e300", "phi=1e10", "x=1e999", "now=-1", "now=1e300", "span=0", "dt=0", "dt=-1", "swings=-1", "swings=1e12", "zoom=0", "el=9",
  "speed=0", "method=euler", "race=2", "play=yes", "<img src=x onerror=alert(1)>", "theta=<script>alert(1)</script>",
  "javascript:alert(1)", "theta=1 ", "a".repeat(5000), "&".repeat(4000), "theta=" + "9".repeat(200), "scene=quarter&\u0000=1"];

async function hostile() {
  for (const hash of HOSTILE) {
    await visit("scene=quarter");
    await visit(hash);
    claim(`refused with a message: ${hash.slice(0, 40)}`, (await text("message")).startsWith("Parts of the address were not used"));
    claim(`and a coin is there: ${hash.slice(0, 40)}`, await b.evaluate("motion.status >= 0 && motion.count > 1 && m.now >= 0"));
  }
  claim("nothing of an address becomes markup", await b.evaluate("document.querySelectorAll('#message *, img').length") === 0);
}

// --------------------------------------------------------------- the coins --
async function coins() {
  const scenes = await b.evaluate("sceneNames().join()");
  for (const name of scenes.split(",")) {
    await visit(`scene=${name}&play=0`);
    const chord = await b.evaluate(`Math.max(...Array.from({ length: motion.count - 1 }, (_, k) =>
      Math.hypot(knot(k + 1, AT.cx) - knot(k, AT.cx), knot(k + 1, AT.cz) - knot(k, AT.cz)) / m.radius))`);
    claim(`chords of the trail are below 0.12 radii in ${name}`, chord < 0.12, chord);
    claim(`the trail reaches the end in ${name}`, await b.evaluate("motion.end === m.span && knot(motion.count - 1, 0) === m.span"));
  }
  const links = await b.evaluate("[...document.querySelectorAll('nav a')].map(a => a.getAttribute('href'))");
  claim("there are five things to try", links.length === 5);
  const guide = readFileSync(join(SRC, "docs/guide.md"), "utf8");
  for (const link of links) {
    await visit(link);
    claim(`a thing to try is an address: ${link}`, await text("message") === "", await text("message"));
    claim(`and the guide has it: ${link}`, guide.includes(`page/index.html${link}`));
  }
}

async function verdicts() {
  const said = async hash => { await visit(hash); return `${await text("verdict")}: ${await text("why")}`; };
  const expect = async (hash, pattern) => { const words = await said(hash); claim(`${hash} says ${pattern}`, pattern.test(words), words); };
  await expect("scene=quarter&play=0", /^Rolls: needs μ 0\.19\d, has 0\.300$/);
  await expect("scene=quarter&play=0&mu=0.1", /^Would slip: needs μ 0\.19\d, has 0\.100$/);
  await expect("scene=nearflat&play=0&now=2.7", /^(Would lift off: .* N = −|Would slip)/);
  await expect("scene=spin&play=0&dry=0.01&now=500", /^At rest: after [\d.]+ √\(a\/g\)$/);
  claim("the light has a shape for it", await b.evaluate("$('light').dataset.kind") === "rests");
  claim("the energy falls all the way", await b.evaluate(`Array.from({ length: motion.count - 1 },
    (_, k) => knot(k + 1, AT.energy) / knot(k, AT.energy)).every(ratio => ratio < 1 + 1e-9) &&
    motion.moment[AT.energy] < 0.5 * knot(0, AT.energy)`));
  claim("and the time of rest is stated", /^By the quasi-steady model it rests after: [\d.]+ .*\. It does after [\d.]+ /.test(await text("resttext")), await text("resttext"));
  await expect("scene=nearflat&play=0&wY=0&wZ=0&now=9", /^Falls flat: after/);
}

async function races() {
  await visit("scene=tumble&wZ=0.05&dt=0.2&race=1&now=20&play=0");
  claim("a textbook RK4 goes through the table", /^Textbook RK4: went through the table at 9\.\d/.test(await text("racer0")), await text("racer0"));
  claim("the library refuses the step", /^rk8: refused the step at 8\.\d/.test(await text("racer1")), await text("racer1"));
  await visit("scene=generic&race=1&dt=0.1&now=10.05&play=0&method=rk4");
  const [whole, errors] = [await b.evaluate("racer(1)[RACE.steps]"), await b.evaluate("[0, 1].map(k => racer(k)[RACE.pose])")];
  claim("whole steps and a shorter one", whole === 100, whole);
  claim("both RK4 err alike at one time", errors[0] > 1e-9 && errors[0] < 1e-3 && errors[1] > 1e-9 && errors[1] < 1e-3, errors);
  await visit("scene=generic&race=1&dt=0.5&now=10&play=0&method=rk4");
  claim("coarse steps are called so", (await text("racer1")).endsWith("COARSE"), await text("racer1"));
  await visit("scene=generic&race=1&dt=0.00001&now=10&play=0");
  claim("a race of too many steps is not begun", (await text("racetext")).startsWith("Too many steps"));
}

async function far() {
  await visit("scene=generic&play=0&now=1");
  await b.evaluate("$('million').click()");
  await frame();
  claim("a million swings by the orbit, its error stated", /coin_orbit_at is here off by at most \d/.test(await text("fartext")), await text("fartext"));
  const lean = await b.evaluate("motion.moment[1]");
  await visit("scene=generic&play=0&now=1");
  claim("where the lean is as at the start", Math.abs(await b.evaluate("motion.moment[1]") - lean) < 1e-6);
  await visit("scene=spin&dry=0.01&swings=1000000&play=0");
  claim("where no orbit leads, that is said", (await text("message")).startsWith("No orbit leads so far"), await text("message"));
  claim("and the start is shown", await b.evaluate("m.swings") === 0);
  // An unstable circle, which has no period.
  const T = Math.tan(0.2), wZ = 0.3, wY = (-1.5 * wZ + Math.sqrt(2.25 * wZ * wZ + T * Math.sin(0.2))) / (0.5 * T);
  await visit(`scene=circle&theta=0.2&wZ=0.3&wY=${wY}&play=0`);
  await b.evaluate("$('million').click()");
  await frame();
  claim("without a period it steps, and says so", (await text("message")).startsWith("No period to jump by: coin_advance went"), await text("message"));
}

// -------------------------------------------------------------- the listing --
async function listings() {
  const folder = mkdtempSync(join(tmpdir(), "rollcoin-page-"));
  for (const hash of [PAUSED, FULL, LOSSY, "scene=generic&swings=1000000&now=2.5&play=0", "scene=spin&dry=0.01&now=500&play=0",
    "scene=flick&race=1&now=0.7&play=0", "scene=nearflat&wY=0&wZ=0&now=9&play=0"]) {
    await visit(hash);
    writeFileSync(join(folder, "page.c"), await text("listing"));
    execFileSync(CC, ["-std=c99", "-Wall", "-Wextra", "-Werror", "-I" + join(SRC, "include"), "-o", join(folder, "page"),
      join(folder, "page.c"), LIBRARY, "-lm"]);
    const printed = execFileSync(join(folder, "page")).toString();
    claim(`the C program prints the page's digits: ${hash}`, printed === await text("digits"), printed + await text("digits"));
  }
  rmSync(folder, { recursive: true });
}

async function browser() {
  await b.open(address("#" + PAUSED), DESKTOP);
  await looks("desktop");
  await access();
  for (const part of [keys, pointer, addresses, hostile, coins, verdicts, races, far, listings])
    await part();
  await quiet("on a desktop");
  await b.open(address("#" + PAUSED), PHONE);
  await b.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })");
  await looks("phone");
  await pinch();
  await quiet("on a phone");
  await b.open(address("#scene=quarter"), { ...DESKTOP, media: [{ name: "prefers-reduced-motion", value: "reduce" },
    { name: "prefers-color-scheme", value: "dark" }] });
  claim("reduced motion starts paused", await b.evaluate("playing") === false);
  claim("dark is dark", await b.evaluate("getComputedStyle(document.body).backgroundColor") === "rgb(20, 23, 26)");
  await quiet("in the dark");
  await b.open(address("#scene=quarter"), DESKTOP);
  claim("else it plays", await b.evaluate("playing") === true);
}

try {
  await bits();
  sources(["core.js", "address.js", "scene.js", "graphs.js", "listing.js", "main.js"]);
  budgets();
  await browser();
} finally {
  await b.close();
}
console.log(`page-check: ${claims} claims, ${failures} failed`);
process.exitCode = failures ? 1 : 0;
