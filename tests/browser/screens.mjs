// Pictures of every page at 390, 820 and 1440 pixels, light and dark, to look at: node tests/browser/screens.mjs [BOOK] [--pages PAGE,..]
//
// They are written to target/screens as PAGE-WIDTH-THEME-NN.png, slices of 2400 pixels from above, and target/screens/index.html shows all of them.
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { read } from "./gates.mjs";
import { find, launch, visit } from "./browser.mjs";

const WIDTHS = [390, 820, 1440];
const SLICE = 2400;

const at = process.argv.indexOf("--pages");
const only = at < 0 ? null : process.argv.splice(at, 2)[1].split(",");
const book = read(process.argv[2] ?? "book", only);
const program = find();
if (!program) {
  console.log("SKIPPED: there is no Chromium");
  process.exit(process.env.CI ? 1 : 0);
}
const folder = resolve(dirname(fileURLToPath(import.meta.url)), "../../target/screens");
mkdirSync(folder, { recursive: true });
const browser = await launch(program);
const made = [];
for (const colorScheme of ["light", "dark"]) {
  for (const width of WIDTHS) {
    const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
    // One after the other: a page that is not in front may wait for ever to be drawn.
    for (const file of book.pages) {
      const page = await context.newPage();
      await visit(page, book.url(file));
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      for (let y = 0, slice = 0; y < height; y += SLICE, slice += 1) {
        const name = `${file.replace(".html", "")}-${width}-${colorScheme}-${String(slice).padStart(2, "0")}.png`;
        await page.screenshot({ path: join(folder, name), fullPage: true, clip: { x: 0, y, width, height: Math.min(SLICE, height - y) } });
        made.push(name);
      }
      await page.close();
    }
    await context.close();
    console.log(`${colorScheme}, ${width} px: ${book.pages.length} pages`);
  }
}
await browser.close();
made.sort();
writeFileSync(join(folder, "index.html"), `<!doctype html><meta charset="utf-8"><title>Screens</title><style>body { columns: 5 16rem; } figure { margin: 0 0 1rem; } img { width: 100%; }</style>${made.map((name) => `<figure><a href="${name}"><img loading="lazy" src="${name}" alt=""></a><figcaption>${name}</figcaption></figure>`).join("")}\n`);
console.log(`${made.length} pictures in ${folder}`);
