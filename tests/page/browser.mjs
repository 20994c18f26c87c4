// SPDX-License-Identifier: MIT
// Headless browsers, driven by puppeteer: Chromium by its DevTools protocol,
// Firefox by WebDriver BiDi.  page.mk has installed the packages.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { OUT } from "./claims.mjs";

const need = createRequire(join(OUT, "npm", "package.json"));
const puppeteer = need("puppeteer-core");
export const AXE = readFileSync(need.resolve("axe-core/axe.min.js"), "utf8");

const PROGRAM = { chrome: "chromium", firefox: "firefox-esr" };

export class Browser {
  static async launch(browser) {
    const executablePath = execFileSync("sh", ["-c", `command -v ${PROGRAM[browser]}`]).toString().trim();
    const args = browser === "chrome" ? ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"] : [];
    const b = new Browser();
    b.name = browser;
    b.program = await puppeteer.launch({ browser, executablePath, args });
    return b;
  }

  // A page of a given size; problems collects exceptions, errors and requests.
  async open(address, { width = 1280, height = 800, mobile = false, media = [] } = {}) {
    await this.page?.close();
    const page = this.page = await this.program.newPage();
    this.problems = [];
    this.requests = [];
    page.on("pageerror", error => this.problems.push(error.message));
    page.on("console", message => message.type() === "error" && this.problems.push(message.text()));
    page.on("request", request => this.requests.push(request.url().slice(0, 99)));
    const isMobile = mobile && this.name === "chrome"; // Firefox has no such mode
    await page.setViewport({ width, height, deviceScaleFactor: mobile ? 2 : 1, isMobile, hasTouch: mobile });
    if (media.length)
      await page.emulateMediaFeatures(media);
    await page.goto(address);
    await this.until("/self-test (passed|failed)$/.test(document.getElementById('selftest').textContent)");
  }

  evaluate(expression) {
    return this.page.evaluate(expression);
  }

  async until(expression, patience = 15000) {
    for (const begun = Date.now(); Date.now() - begun < patience;) {
      if (await this.evaluate(expression).catch(() => false))
        return;
      await new Promise(resolve => setTimeout(resolve, 20));
    }
    throw new Error("never: " + expression);
  }
}
