// How long a page takes from its opening until it is complete: all of it loaded, its faces there, its largest part painted.
//
//   node benches/page/open.mjs [BOOK] [PAGE]
//
// PAGE is the longest of the book if none is given. Prints the median and the spread of eleven openings, each in a new context, so that nothing is
// kept from one to the next, after one that is not counted. The goal is 200 ms.
import { find, launch } from "../../tests/browser/browser.mjs";
import { read } from "../../tests/browser/gates.mjs";

const ROUNDS = 11;

function measure() {
  return new Promise((told) => {
    let largest = 0;
    new PerformanceObserver((list) => list.getEntries().forEach((entry) => { largest = Math.max(largest, entry.startTime); })).observe({ type: "largest-contentful-paint", buffered: true });
    document.fonts.ready.then(() => requestAnimationFrame(() => setTimeout(() => {
      const [navigation] = performance.getEntriesByType("navigation");
      const faces = Math.max(0, ...performance.getEntriesByType("resource").filter((entry) => entry.name.endsWith(".woff2")).map((entry) => entry.responseEnd));
      told({ load: navigation.loadEventEnd, faces, paint: largest });
    })));
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
  await page.goto(book.url(file), { waitUntil: "load" });
  const figures = await page.evaluate(measure);
  if (round) rounds.push({ ...figures, complete: Math.max(figures.load, figures.faces, figures.paint) });
  await context.close();
}
console.log(`${file}, ${(book.text(file).length / 1000).toFixed(0)} kB, ${ROUNDS} openings, ms: median (least to most)`);
for (const name of ["load", "faces", "paint", "complete"]) {
  const values = rounds.map((round) => round[name]).sort((a, b) => a - b);
  console.log(`${name.padEnd(9)} ${values[ROUNDS >> 1].toFixed(0).padStart(5)} (${values[0].toFixed(0)} to ${values[ROUNDS - 1].toFixed(0)})`);
}
await browser.close();
