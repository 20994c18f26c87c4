// SPDX-License-Identifier: MIT
// A headless Chromium, driven through a pipe by its DevTools protocol.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  constructor(program = process.env.CHROMIUM || "chromium") {
    this.folder = mkdtempSync(join(tmpdir(), "rollcoin-page-"));
    const options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
      "--no-first-run", "--hide-scrollbars", "--disable-extensions", "--disable-background-networking",
      "--remote-debugging-pipe",
      "--user-data-dir=" + this.folder];
    this.process = spawn(program, options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.process.on("error", error => { throw error; });
    this.calls = new Map();
    this.listeners = [];
    this.id = 0;
    let text = "";
    this.process.stdio[4].setEncoding("utf8").on("data", data => {
      const messages = (text + data).split("\0");
      text = messages.pop();
      messages.forEach(message => this.receive(JSON.parse(message)));
    });
  }

  receive({ id, method, params, result, error }) {
    if (method)
      this.listeners.forEach(listener => listener(method, params));
    if (!this.calls.has(id))
      return;
    const { resolve, reject, name } = this.calls.get(id);
    this.calls.delete(id);
    error ? reject(new Error(name + ": " + error.message)) : resolve(result);
  }

  send(method, params = {}) {
    const id = ++this.id, message = { id, method, params, sessionId: this.session };
    this.process.stdio[3].write(JSON.stringify(message) + "\0");
    return new Promise((resolve, reject) => this.calls.set(id, { resolve, reject, name: method }));
  }

  // A page of a given size; problems collects exceptions, errors and requests.
  async open(address, { width = 1280, height = 800, mobile = false, media = [] } = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    this.session = (await this.send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    this.problems = [];
    this.requests = [];
    this.listeners = [(method, p) => {
      if (method === "Runtime.exceptionThrown")
        this.problems.push(p.exceptionDetails.exception?.description || p.exceptionDetails.text);
      if (method === "Log.entryAdded" && p.entry.level === "error")
        this.problems.push(p.entry.text);
      if (method === "Network.requestWillBeSent")
        this.requests.push(p.request.url);
    }];
    for (const domain of ["Page", "Runtime", "Network", "Log"])
      await this.send(domain + ".enable");
    await this.send("Emulation.setDeviceMetricsOverride",
      { width, height, deviceScaleFactor: mobile ? 2 : 1, mobile });
    await this.send("Emulation.setTouchEmulationEnabled", { enabled: mobile });
    await this.send("Emulation.setEmulatedMedia", { features: media });
    await this.send("Page.navigate", { url: address });
    await this.until("document.readyState === 'complete' && " +
      "/self-test (passed|failed)$/.test(document.getElementById('selftest').textContent)");
  }

  async evaluate(expression) {
    const { result, exceptionDetails: wrong } = await this.send("Runtime.evaluate",
      { expression, returnByValue: true, awaitPromise: true });
    if (wrong)
      throw new Error(expression + ": " + (wrong.exception?.description || wrong.text));
    return result.value;
  }

  async until(expression, patience = 15000) {
    for (const begun = Date.now(); Date.now() - begun < patience;) {
      if (await this.evaluate(expression).catch(() => false))
        return;
      await new Promise(resolve => setTimeout(resolve, 20));
    }
    throw new Error("never: " + expression);
  }

  async key(key, code = key) {
    const text = key.length === 1 ? key : undefined;
    for (const type of ["keyDown", "keyUp"])
      await this.send("Input.dispatchKeyEvent", { type, key, code, text: type === "keyDown" ? text : undefined });
  }

  async screenshot(full = false) {
    return Buffer.from((await this.send("Page.captureScreenshot", { captureBeyondViewport: full })).data, "base64");
  }

  async close() {
    const gone = new Promise(resolve => this.process.once("exit", resolve));
    await this.send("Browser.close").catch(() => {});
    await gone;
    rmSync(this.folder, { recursive: true, force: true });
  }
}
