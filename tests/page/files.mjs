// SPDX-License-Identifier: MIT
// What page-check says of the files: the bits, the sources, the budgets.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { claim, html, inside, OUT, SCRIPTS, SRC } from "./claims.mjs";

// ----------------------------------------------------------------- the bits --
export async function bits() {
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
  claim("the scenes are those of tosses.h and scenes.h",
    ["docs/page/tosses.h", "docs/examples/scenes.h"].flatMap(file =>
      [...readFileSync(join(SRC, file), "utf8").matchAll(/^ {4}\{+"(\w+)", &/gm)].map(x => x[1])).join() === native.trim().split("\n").map(line => line.split(" ")[0]).join());
}

// The page is its sources, its wasm apart: that depends on the compiler.
export function sources() {
  const folder = mkdtempSync(join(tmpdir(), "rollcoin-page-")), part = name => join(SRC, "docs/page", name);
  writeFileSync(join(folder, "wasm.txt"), inside("wasm"));
  const env = { ...process.env, wasm: join(folder, "wasm.txt"), hashes: join(OUT, "hashes.txt"),
    rolling: join(OUT, "rolling.svg"), style: part("style.css"), script: SCRIPTS };
  const built = execFileSync("awk", ["-f", part("embed.awk"), part("page.html")], { env, maxBuffer: 1e7 });
  claim("the committed page is what its sources make: else make page", built.toString() === html);
  rmSync(folder, { recursive: true });
}

// -------------------------------------------------------------- the budgets --
const BYTES = 260e3, LINES = 1450, COLUMNS = 120;

export function budgets() {
  const script = html.slice(html.lastIndexOf("<script>") + 9, html.lastIndexOf("</script>")).split("\n");
  const code = script.filter(line => !/^\s*(\/\/.*)?$/.test(line));
  const size = Buffer.byteLength(html);
  console.log(`${size} bytes, ${code.length} lines of script (${script.length} with comments and blank lines)`);
  claim(`the file has at most ${BYTES} bytes`, size <= BYTES, size);
  claim(`the script has at most ${LINES} lines`, code.length <= LINES, code.length);
  const widest = Math.max(...script.map(line => line.length));
  claim(`of at most ${COLUMNS} columns`, widest <= COLUMNS, widest);
  const rest = html.replace(inside("wasm"), "").replace(/^\s*\/\/.*$/gm, "");
  const picture = readFileSync(join(SRC, "docs/page", html.match(/"og:image" content="([^"]*)"/)[1]));
  const frame = picture.indexOf(Buffer.from([0xff, 0xc0])); // of a JPEG: then its height and width
  claim("its preview is a picture of 1200 x 630", picture.readUInt16BE(frame + 5) === 630 &&
    picture.readUInt16BE(frame + 7) === 1200 && picture.length < 1.5e5, picture.length);
  claim("it has a description and an icon", /name="description" content="[^"]{50,}"/.test(html) && /rel="icon" href="data:image/.test(html));
  claim("it names no other place", !/\b(https?:)?\/\/[a-z]/i.test(rest));
}
