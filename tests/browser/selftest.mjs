// Whether every gate can fail: for each fault a copy of a small built book is broken, and the gate must tell it, and nothing of the unbroken copy.
//
//   node tests/browser/selftest.mjs BOOK.. [--only NAME,..]
//
// Of the books the first is taken in which the gate has something to see.
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { each, load, read, run } from "./gates.mjs";
import { find, launch, supervised } from "./browser.mjs";
import { ended } from "./patience.mjs";

const inText = (html) => (page) => page.replace("</article>", `${html}</article>`);
const inHead = (html) => (page) => page.replace("</head>", `${html}</head>`);
// A script that runs after those of the book.
const script = (code) => inHead(`<script>addEventListener("load", () => { ${code} });</script>`);
const heard = (keys) => script(`addEventListener("keydown", (event) => { if (${JSON.stringify(keys)}.includes(event.key)) { event.stopImmediatePropagation(); event.preventDefault(); } }, true);`);

// By gate: a name of the fault, what it does to the source of each page, and what must be told.
const FAULTS = {
  axe: [
    ["an unnamed field", inText('<input type="text">'), /label/],
    ["faint text", inText('<p style="color: #999; background: #fff">Faint</p>'), /color-contrast/],
    ["text that is faint in the dark", inText('<p style="color: light-dark(#000, #333)">Faint</p>'), /\(dark\).*color-contrast/],
    ["a picture without words", inText('<img src="data:image/gif;base64,R0lGODlhAQABAAAAACw=">'), /image-alt/],
  ],
  contrast: [["faint text in a drawing", inText('<svg width="200" height="40"><text x="9" y="20" fill="#bbb">Faint</text></svg>'), /Faint/],
    ["text on a dark shape", inText('<svg width="200" height="40"><rect width="200" height="40" fill="#222"/><text x="9" y="20" fill="#111">Dark</text></svg>'), /Dark/]],
  copy: [["a button that does nothing", script('document.querySelectorAll("button.copy").forEach((one) => one.replaceWith(one.cloneNode(true)));'), /says Copy/],
    ["code without a button", script('document.querySelector("button.copy").remove();'), /blocks of code/]],
  focus: [["no outline", inHead("<style>:focus-visible { outline: none !important }</style>"), /not seen/],
    ["no skip link", (page) => page.replace(/<a class="skip".*?<\/a>/, ""), /past the lists/]],
  folds: [["folds that stay closed", script('document.querySelectorAll("details").forEach((fold) => { fold.open = false; });'), /does not open the fold/]],
  glyphs: [["a character of another script", inText("<p>ก</p>"), /U\+0E01/]],
  html: [["a block in a phrase", inText("<span><div>Block</div></span>"), /element-permitted-content/], ["an element that is not closed", inText("<div>"), /close-order|unclosed/]],
  keys: [["arrows that do nothing", heard(["ArrowRight", "ArrowLeft"]), /ArrowRight leads to/], ["no help", heard(["?"]), /opens nothing/], ["arrows that always turn", script('document.querySelectorAll("a").forEach((link) => link.addEventListener("keydown", (event) => { if (event.key === "ArrowRight") location.href = "index.html"; }));'), /has the focus/]],
  links: [["a dead link", inText('<a href="nowhere.html">Nowhere</a>'), /leads to no file/], ["a dead place", inText('<a href="#nowhere">Nowhere</a>'), /leads to no place/], ["an id given twice", inText('<p id="main">Twice</p>'), /more than once/]],
  narrow: [["a wide box", inText('<div style="width: 700px; height: 9px; background: red">Wide</div>'), /Wide/], ["a word that does not break", inText(`<p style="overflow-wrap: normal">${"unbreakable".repeat(20)}</p>`), /px wide/]],
  notes: [["notes upon the text", inHead("<style>.side-note { margin-right: 0 !important; }</style>"), /not in the margin/], ["notes upon each other", inHead("<style>.side-note { position: absolute !important; top: 0; right: 0; float: none !important; }</style>"), /overlap/]],
  plain: [["text that needs a script", inText('<p style="visibility: hidden">Hidden</p>'), /Hidden/], ["a button that needs a script", inText('<button type="button">Dead</button>'), /Dead/]],
  present: [["keys that do nothing", heard(["ArrowRight", "ArrowDown", "PageDown", "n"]), /the walk ended at slide 1 of/]],
  previews: [["cards that are empty", script('new MutationObserver((all) => all.forEach(({ target }) => { const card = target.closest && target.closest(".preview"); if (card && card.textContent) card.textContent = ""; })).observe(document.body, { subtree: true, childList: true });'), /./], ["no cards", inHead("<style>.preview { display: none }</style>"), /no card/]],
  print: [["a button on paper", inText('<button type="button" style="display: block !important">Printed</button>'), /prints button/], ["pages that are empty", inText('<p style="break-before: page">One</p>'.repeat(30)), /pages on paper/]],
  quiet: [["another host", inText('<img alt="" src="https://example.org/x.png">'), /asks another host/], ["a file that is missing", inText('<img alt="" src="missing.png">'), /not loaded/], ["an error of a script", script('throw new Error("thrown");'), /thrown/]],
  search: [["/ does nothing", heard(["/"]), /does not open/], ["results that cannot be reached", heard(["ArrowDown"]), /first result/]],
  shift: [["what comes late", (page) => page.replace("<h1", '<p id="late"></p><h1').replace("</head>", '<script>let frames = 0; const late = () => { if (!document.documentElement.matches(".settling, .faceless, .parsing")) frames += 1; if (frames < 3) requestAnimationFrame(late); else document.getElementById("late").style.height = "300px"; }; addEventListener("load", late);</script></head>'), /shifts by/]],
  stepper: [["keys that do nothing", heard(["ArrowRight"]), /ArrowRight leads/], ["steps that are not told", script('document.querySelectorAll(".step-spoken").forEach((one) => one.remove());'), /./]],
  still: [["motion", inText('<p style="transition: color 1s">Moving</p>'), /transition/], ["gliding", inHead("<style>html { scroll-behavior: smooth !important }</style>"), /smoothly/]],
  theme: [["a button that does nothing", script('document.querySelectorAll(".theme-toggle").forEach((one) => one.replaceWith(one.cloneNode(true)));'), /after dark|after light/]],
};

// Not tried here: the search's logic has tests of its own.
const UNTRIED = ["match"];

/** Tries a gate on a book: one that looks at pages on the first and on the largest that has what it `sees`, since all of them show no more. */
async function tried(browser, gate, folder) {
  const whole = read(folder);
  const page = gate.sees ? whole.with(gate.sees) : whole.pages[0];
  if (!page) return { failures: [], skipped: true };
  const book = read(folder, gate.views ? [page.replace(".html", ""), "index"] : null);
  await run({ browser, book, gates: [gate] });
  return { failures: gate.failures, skipped: gate.skipped };
}

function copied(folder, scratch) {
  const copy = mkdtempSync(join(scratch, "book-"));
  cpSync(folder, copy, { recursive: true });
  return copy;
}

async function main() {
  const at = process.argv.indexOf("--only");
  const only = at < 0 ? null : process.argv.splice(at, 2)[1].split(",");
  const folders = process.argv.slice(2);
  const program = find();
  if (!program) {
    console.log("SKIPPED: there is no Chromium");
    console.log("0 passed, 0 failed, 1 skipped");
    return process.env.CI ? 1 : 0;
  }
  const browser = await launch(program);
  const scratch = mkdtempSync(join(tmpdir(), "gates-"));
  const counts = { passed: 0, failed: 0, skipped: 0 };
  const tell = (result, text) => { counts[result] += 1; if (result !== "passed") console.log(`${result.toUpperCase()} ${text}`); };
  await each(await load(only), async (gate) => {
    if (UNTRIED.includes(gate.name)) return;
    const faults = FAULTS[gate.name];
    if (!faults) { tell("failed", `${gate.name}: no fault is known that it finds`); return; }
    let whole = null, folder = null;
    for (const one of folders) {
      folder = one;
      whole = await tried(browser, gate, one);
      if (!whole.skipped) break;
    }
    if (whole.skipped) { tell("skipped", `${gate.name}: none of the books has what it looks at`); return; }
    for (const [name, fault, told] of faults) {
      const copy = copied(folder, scratch);
      for (const file of read(copy).pages) writeFileSync(join(copy, file), fault(readFileSync(join(copy, file), "utf8")));
      const { failures } = await tried(browser, gate, copy);
      // Only what the fault has added counts.
      const added = failures.filter((failure) => !whole.failures.includes(failure));
      if (added.some((failure) => told.test(failure) && !failure.includes("the gate itself failed"))) tell("passed", "");
      else tell("failed", `${gate.name} does not see ${name}: ${added[0] ?? "it tells nothing"}`);
      rmSync(copy, { recursive: true });
    }
  });
  rmSync(scratch, { recursive: true });
  console.log(`${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped`);
  await ended(browser);
  return counts.failed || (counts.skipped && process.env.CI) ? 1 : 0;
}

await supervised(main);
