// SPDX-License-Identifier: MIT
// What the parts of page-check share: the page, and the count of claims.
import { readFileSync } from "node:fs";
import { join } from "node:path";

export const [SRC, OUT, CC, LIBRARY, SCRIPTS] = process.argv.slice(2);
export const PAGE = join(SRC, "docs/page/index.html"), html = readFileSync(PAGE, "utf8");
export const inside = id => html.match(new RegExp(`<script type="text/plain" id="${id}">\n([^<]*)</script>`))[1];
export const count = { claims: 0, failures: 0 };

export function claim(text, holds, seen = "") {
  ++count.claims;
  if (holds === true)
    return;
  ++count.failures;
  console.log(`FAILED: ${text} ${seen === "" ? "" : JSON.stringify(seen)}`);
}
