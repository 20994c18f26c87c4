// SPDX-License-Identifier: MIT
// Serves this folder to a browser, and prints what its page says: the address
// "said?" and a text.  A page that says nothing within two minutes fails.
//     node serve.mjs PAGE
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";

const TYPES = { html: "text/html", mjs: "text/javascript", wasm: "application/wasm" };
const profile = mkdtempSync("./profile-");
let browser;

function end(said, code) {
  console.log(said);
  browser.on("close", () => {
    rmSync(profile, { recursive: true, force: true, maxRetries: 20 });
    process.exit(code);
  });
  process.kill(-browser.pid, "SIGKILL"); // and its children, which write into the profile
}

const server = createServer((request, response) => {
  const { pathname, search } = new URL(request.url, "http://localhost");
  if (pathname === "/said") {
    response.end();
    end(decodeURIComponent(search.slice(1)), 0);
    return;
  }
  try {
    const bytes = readFileSync("." + pathname);
    response.writeHead(200, { "content-type": TYPES[pathname.split(".").pop()] ?? "text/plain" }).end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});
server.listen(0, "127.0.0.1", () => {
  browser = spawn("chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
    `--user-data-dir=${profile}`, "--remote-debugging-port=0",
    `http://127.0.0.1:${server.address().port}/${process.argv[2]}`], { detached: true, stdio: "ignore" });
  setTimeout(() => end("the page says nothing", 1), 120e3);
});
