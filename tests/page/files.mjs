// SPDX-License-Identifier: MIT
// What page-check says of the files: the bits, the sources, the budgets.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { claim, html, inside, OUT, SRC } from "./claims.mjs";

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
  claim("the scenes are those of scenes.h",
    [...readFileSync(join(SRC, "docs/examples/scenes.h"), "utf8").matchAll(/^ {4}\{"(\w+)", &/gm)]
      .map(x => x[1]).join() === native.trim().split("\n").map(line => line.split(" ")[0]).join());
}

// The page is its sources, its wasm apart: that depends on the compiler.
export function sources(scripts) {
  const folder = mkdtempSync(join(tmpdir(), "rollcoin-page-")), part = name => join(SRC, "docs/page", name);
  writeFileSync(join(folder, "wasm.txt"), inside("wasm"));
  const env = { ...process.env, wasm: join(folder, "wasm.txt"), hashes: join(OUT, "hashes.txt"),
    still: join(OUT, "still.svg"), style: part("style.css"), script: scripts.map(part).join(" ") };
  const built = execFileSync("awk", ["-f", part("embed.awk"), part("page.html")], { env, maxBuffer: 1e7 });
  claim("the committed page is what its sources make: else make page", built.toString() === html);
  rmSync(folder, { recursive: true });
}

// -------------------------------------------------------------- the budgets --
const BYTES = 220e3, LINES = 850, COLUMNS = 120;

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
  claim("it names no other place", !/\b(https?:)?\/\/[a-z]/i.test(rest));
}
