// SPDX-License-Identifier: MIT
// docs/page/preview.jpg, which links to the page show: a coin in the air.
//     node preview.mjs SRC OUT
import { join } from "node:path";
import { SRC } from "./claims.mjs";
import { address, b, launch, see } from "./see.mjs";

await launch("chrome");
await b.open(address("?embed=1#scene=toss&play=0&theta=-0.55&phi=0.35&psi=0.2&y=0.02&el=0.42&zoom=0.95"), { width: 1200, height: 630 });
await b.until("!motion.more");
await see("{ $('why').textContent = ''; $('light').dataset.kind = 'rests'; $('verdict').textContent = 'Heads or tails?'; }");
await see("{ $('pace').hidden = $('hint').hidden = true; $('pace').style.display = 'none'; }");
await see("drawStage()");
await b.page.screenshot({ path: join(SRC, "docs/page/preview.jpg"), type: "jpeg", quality: 88 });
await b.program.close();
