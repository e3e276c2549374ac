// How long a page takes from its opening until it is complete: all of it loaded, its faces there, its largest part painted.
//
//   node benches/page/open.mjs [BOOK] [PAGE]
//
// PAGE is the longest of the book if none is given. Prints the median and the spread of eleven openings, each in a new context, so that nothing is
// kept from one to the next, after one that is not counted. The goal is 200 ms. What is far below the window is laid out afterwards, unless the
// reader moves before; that time is printed as well. Other work on the machine shows in all of them.
import { find, launch, visit } from "../../tests/browser/browser.mjs";
import { read } from "../../tests/browser/gates.mjs";

const ROUNDS = 11;
/** How long a new window has to be made, in ms. */
const WINDOW = 2000;

// The page tells by classes what it still waits for: when each of them went is kept.
function keepStates() {
  window.keptStates = {};
  new MutationObserver(() => ["faceless", "settling"].forEach((state) => {
    const there = document.documentElement.classList.contains(state);
    if (there) window.keptStates[state] = null;
    else if (window.keptStates[state] === null) window.keptStates[state] = performance.now();
  })).observe(document, { subtree: true, attributes: true, attributeFilter: ["class"] });
}

function measure() {
  return new Promise((told) => {
    const [navigation] = performance.getEntriesByType("navigation");
    new PerformanceObserver((list) => {
      const paint = Math.max(...list.getEntries().map((entry) => entry.startTime));
      told({ load: navigation.loadEventEnd, faces: window.keptStates.faceless ?? 0, paint, rest: window.keptStates.settling ?? 0 });
    }).observe({ type: "largest-contentful-paint", buffered: true });
  });
}

const book = read(process.argv[2] ?? "book");
const file = process.argv[3] ? `${process.argv[3].replace(/\.html$/, "")}.html` : book.pages[0];
const program = find();
if (!program) {
  console.log("SKIPPED: there is no Chromium");
  process.exit(0);
}
const browser = await launch(program);
const rounds = [];
for (let round = 0; round <= ROUNDS; round += 1) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  await page.addInitScript(keepStates);
  // A new context is a new window, whose own parts are made meanwhile: a reader's browser is open already.
  await page.goto("about:blank");
  await page.waitForTimeout(WINDOW);
  await visit(page, book.url(file));
  const figures = await page.evaluate(measure);
  if (round) rounds.push({ ...figures, complete: Math.max(figures.load, figures.faces, figures.paint) });
  await context.close();
}
console.log(`${file}, ${(book.text(file).length / 1000).toFixed(0)} kB, ${ROUNDS} openings, ms: median (least to most)`);
for (const name of ["load", "faces", "paint", "complete", "rest"]) {
  const values = rounds.map((round) => round[name]).sort((a, b) => a - b);
  console.log(`${name.padEnd(9)} ${values[ROUNDS >> 1].toFixed(0).padStart(5)} (${values[0].toFixed(0)} to ${values[ROUNDS - 1].toFixed(0)})`);
}
await browser.close();
