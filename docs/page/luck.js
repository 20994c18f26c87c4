// SPDX-License-Identifier: MIT
// luck.js: the map of luck.  Height and spin of a coin let go decide how it ends: each
// cell of the map is a toss, computed by coin_move in workers, from coarse to fine.

const MAP = { wide: 256, high: 224, coarsest: 32 }; // cells
const map = { key: "", image: null, pixels: null, queue: [], workers: [], shown: 0, drawnAt: 0 };

// What a worker does: the self-test, and rows of the map.
function work() {
  let lib;
  const doubles = (address, count) => new Float64Array(lib.memory.buffer, address, count);
  const words = at => new TextDecoder().decode(new Uint8Array(lib.memory.buffer, at, 99)).split("\0")[0];
  const hashes = () => Array.from({ length: lib.page_scene_count() }, (_, k) =>
    words(lib.page_scene_word(k, 0)) + " " + words(lib.page_hash(k))).join("\n");
  onmessage = ({ data }) => {
    lib ||= new WebAssembly.Instance(data.module).exports;
    if (data.module) return void (data.test && postMessage({ test: lib.page_selftest() === 0 && hashes() }));
    doubles(lib.page_asked(), data.asked.length).set(data.asked);
    lib.page_take();
    postMessage({ ...data, faces: data.heights.map(y => lib.page_luck(y, data.spin)) });
  };
}

// One worker tests the bits of this browser against those that the C library gave.
function beginWorkers(module) {
  const address = URL.createObjectURL(new Blob([`(${work})()`], { type: "text/javascript" }));
  const count = clamp((navigator.hardwareConcurrency || 2) - 1, 1, 4);
  const failed = () => showSelfTest(false);
  map.workers = Array.from({ length: count }, (_, k) => {
    const worker = new Worker(address);
    worker.onmessage = ({ data }) => "test" in data ? showSelfTest(data.test === $("hashes").textContent.trim())
      : received(worker, data);
    worker.onerror = k ? null : failed;
    worker.postMessage({ module, test: k === 0 });
    return worker;
  });
  map.workers.forEach(giveRow);
}

const showSelfTest = good => {
  $("selftest").textContent = good ? "The library's bits: self-test passed" : "Other bits: self-test failed";
};

// ------------------------------------------------------------------- its window --
// The whole map: heights of 1.3 to 20 radii, up to 8 sqrt(g/a) of spin.
const WHOLE = { y: [1.3, 20], w: [0, 8] };
const wholeMap = ({ radius, gravity }) => ({ mapy: radius * (WHOLE.y[0] + WHOLE.y[1]) / 2,
  mapw: Math.sqrt(gravity / radius) * (WHOLE.w[0] + WHOLE.w[1]) / 2, mapzoom: 1 });
const mapSpan = () => [m.radius * (WHOLE.y[1] - WHOLE.y[0]) / m.mapzoom,
  (WHOLE.w[1] - WHOLE.w[0]) / unit() / m.mapzoom];
const heightAt = x => m.mapy + (x - 0.5) * mapSpan()[0]; // of a part of the map, from the left
const spinAt = y => m.mapw + (0.5 - y) * mapSpan()[1]; // and from the top

// ---------------------------------------------------------------- coarse to fine --
// Rows of cells that the passes before have not had.
function rowsOf(step) {
  const rows = [];
  for (let row = 0; row < MAP.high; row += step) {
    const done = step < MAP.coarsest && row % (2 * step) === 0, columns = [];
    for (let column = done ? step : 0; column < MAP.wide; column += done ? 2 * step : step) columns.push(column);
    if (columns.length) rows.push({ row, step, columns });
  }
  return rows.sort((a, b) => Math.abs(a.row - MAP.high / 2) - Math.abs(b.row - MAP.high / 2));
}

// Begins the map again if what it shows has changed.
function renewMap() {
  const asked = ASKED.map(name => m[name]), place = (k, x) => { asked[ASKED.indexOf(k)] = x; };
  place("y", m.radius * 2);
  place("wX", 0);
  const key = [...asked, m.mapy, m.mapw, m.mapzoom].join();
  if (key === map.key || sceneName() !== "luck" || !isTossed()) return;
  Object.assign(map, { key, asked, queue: [], shown: 0 });
  for (let step = MAP.coarsest; step >= 1; step /= 2) map.queue.push(...rowsOf(step));
  for (const worker of map.workers) if (!worker.busy) giveRow(worker);
}

function giveRow(worker) {
  const row = map.queue.shift();
  worker.busy = Boolean(row);
  if (row) worker.postMessage({ ...row, key: map.key, asked: map.asked, spin: spinAt((row.row + 0.5) / MAP.high),
    heights: row.columns.map(x => heightAt((x + 0.5) / MAP.wide)) });
}

// Gold is heads, blue tails, red the edge; as pixels: alpha, blue, green, red.
const FACE_COLORS = { 1: 0xff52b6ec, 2: 0xff623e26, 3: 0xff3c3cd6 }, UNKNOWN = 0xff808080;
function received(worker, { key, row, step, columns, faces }) {
  giveRow(worker);
  if (key !== map.key) return;
  map.image ||= new ImageData(MAP.wide, MAP.high);
  map.pixels ||= new Uint32Array(map.image.data.buffer);
  columns.forEach((column, k) => {
    const color = FACE_COLORS[faces[k]] || UNKNOWN, end = Math.min(column + step, MAP.wide);
    for (let y = row; y < Math.min(row + step, MAP.high); ++y)
      map.pixels.fill(color, y * MAP.wide + column, y * MAP.wide + end);
  });
  map.shown += columns.length;
  if (map.queue.length && performance.now() - map.drawnAt < 100) return;
  map.drawnAt = performance.now();
  wake();
}

// ------------------------------------------------------------------ the drawing --
const INSET = { left: 46, right: 6, top: 6, bottom: 32 };
const mapBox = (w, h) => [INSET.left, INSET.top, w - INSET.left - INSET.right, h - INSET.top - INSET.bottom];

function drawMap() {
  if (!$("map").clientWidth || !map.image) return;
  const { c, w, h } = cleared($("map")), [x, y, wide, high] = mapBox(w, h);
  map.canvas ||= Object.assign(document.createElement("canvas"), { width: MAP.wide, height: MAP.high });
  map.canvas.getContext("2d").putImageData(map.image, 0, 0);
  c.imageSmoothingEnabled = false;
  c.drawImage(map.canvas, x, y, wide, high);
  drawMapAxes(c, x, y, wide, high);
  const [dy, dw] = mapSpan();
  const px = x + wide * ((m.y - m.mapy) / dy + 0.5), py = y + high * (0.5 - (m.wX - m.mapw) / dw);
  if (px < x || px > x + wide || py < y || py > y + high) return;
  for (const [color, width] of [["#00000090", 5], ["#ffffff", 2.5]]) stroke(c, disc(px, py, 8), color, width);
}

const tickText = (v, step) => v.toFixed(clamp(Math.ceil(-Math.log10(step) + 0.001), 0, 15)).replace("-", "−");
function drawMapAxes(c, x, y, wide, high) {
  Object.assign(c, { font: "12px system-ui, sans-serif", fillStyle: COLORS.muted, textAlign: "center" });
  const heights = [heightAt(0), heightAt(1)].map(mm), spins = [spinAt(1), spinAt(0)].map(turns);
  if (m.mapzoom > 1e4) { // more digits than fit
    const text = `${short(mm(m.mapy), 12)} mm, over ${short(heights[1] - heights[0], 2)} mm`;
    c.fillText(text, x + wide / 2, y + high + 16);
    return;
  }
  const some = ticks(...heights).filter((_, k, all) => all.length < 5 || k % 2 === 0);
  for (const v of some) {
    const at = x + wide * (v - heights[0]) / (heights[1] - heights[0]);
    c.fillText(tickText(v, some[1] - some[0]), clamp(at, x + 14, x + wide - 24), y + high + 14);
  }
  c.fillText("height, mm", x + wide / 2, y + high + 29);
  c.textAlign = "right";
  const few = ticks(...spins);
  for (const v of few)
    c.fillText(tickText(v, few[1] - few[0]), x - 5, y + high * (spins[1] - v) / (spins[1] - spins[0]) + 4);
  c.save();
  c.translate(12, y + high / 2);
  c.rotate(-Math.PI / 2);
  c.textAlign = "center";
  c.fillText("turns in a second", 0, 0);
  c.restore();
}

// --------------------------------------------------------------------- the hand --
// Plays the toss of a part of the map.
const tossAt = (x, y) => fly({ y: heightAt(x), wX: spinAt(y) });
const tossAnywhere = () => tossAt(Math.random(), Math.random());

// Comes closer to the toss that is marked, if it is in the picture.
function zoomMap(f) {
  const [dy, dw] = mapSpan(), inside = Math.abs(m.y - m.mapy) < dy / 2 && Math.abs(m.wX - m.mapw) < dw / 2;
  const mapzoom = clamp(m.mapzoom * f, 1, 1e13);
  if (mapzoom === 1) Object.assign(m, wholeMap(m));
  else Object.assign(m, { mapzoom }, inside && f > 1 ? { mapy: m.y, mapw: m.wX } : {});
  renewMap();
  go(m.now);
}

// The toss beside the marked one, by so many cells.
function tossBeside(columns, rows) {
  const [dy, dw] = mapSpan();
  tossAt((m.y - m.mapy) / dy + 0.5 + columns / MAP.wide, 0.5 - (m.wX - m.mapw) / dw + rows / MAP.high);
}

function listenToMap(canvas) {
  let last = null;
  const part = e => {
    const [x, y, wide, high] = mapBox(canvas.clientWidth, canvas.clientHeight);
    return [(e.offsetX - x) / wide, (e.offsetY - y) / high];
  };
  canvas.addEventListener("pointerdown", e => { last = { at: part(e), moved: false }; });
  canvas.addEventListener("pointermove", e => { // drag: the map goes along
    if (!last || e.pointerType === "touch") return;
    const [x, y] = part(e), [dy, dw] = mapSpan();
    if (!last.moved && Math.hypot(x - last.at[0], y - last.at[1]) < 0.02) return;
    Object.assign(m, { mapy: Math.max(m.mapy - (x - last.at[0]) * dy, 0), mapw: m.mapw + (y - last.at[1]) * dw });
    last = { at: [x, y], moved: true };
    renewMap();
    go(m.now);
  });
  canvas.addEventListener("pointerup", e => {
    const [x, y] = part(e);
    if (last && !last.moved && x >= 0 && x <= 1 && y >= 0 && y <= 1) tossAt(x, y);
    last = null;
  });
  canvas.addEventListener("pointercancel", () => { last = null; });
}
