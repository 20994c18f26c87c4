// SPDX-License-Identifier: MIT
// What the parts of page-check do in a browser: they see, say and set.
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { claim, PAGE } from "./claims.mjs";

export let b; // the browser
export const launch = async name => { b = await Browser.launch(name); };
export const address = hash => pathToFileURL(PAGE).href + hash;
export const DESKTOP = { width: 1280, height: 800 }, PHONE = { width: 360, height: 740, mobile: true };
export const LANDSCAPE = { width: 844, height: 390, mobile: true };
export const see = expression => b.evaluate(expression);
export const text = id => see(`(e => e.matches("pre") ? e.textContent : e.innerText)(document.getElementById("${id}"))`);
export const frame = () => b.evaluate("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(true))))");

export async function says(what, id, pattern) {
  const words = await text(id);
  claim(what, pattern.test(words), words);
}

// Opens another hash in the page that is there, and waits until it is drawn.
export async function visit(hash) {
  await see(`new Promise(done => {
    addEventListener("hashchange", done, { once: true });
    setTimeout(done, 1000);
    location.hash = ${JSON.stringify(hash)};
  }).then(() => true)`);
  await frame();
  await b.until("!motion.more");
  await frame();
}

export async function quiet(where) {
  claim(`no exception and no error ${where}`, b.problems.length === 0, b.problems);
  claim(`no request ${where}`, b.requests.every(url => /^(file|data|blob):/.test(url)) &&
    b.requests.filter(url => url.startsWith("file:")).length < 2, b.requests);
}

// Sets a control as a user does, and waits until the motion is there.
export async function set(id, value, kind = "input") {
  await see(`{ const e = $("${id}");
    e[e.type === "checkbox" ? "checked" : "value"] = ${JSON.stringify(value)};
    e.dispatchEvent(new Event("${kind}", { bubbles: true })); }`);
  await frame();
  await b.until("!motion.more");
  await frame();
}
