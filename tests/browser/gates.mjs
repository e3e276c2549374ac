// The gates of the pages: what a browser must see in a book before a change is taken.
//
//   node tests/browser/gates.mjs [BOOK] [--only NAME,..] [--pages PAGE,..]
//
// BOOK is the folder of a built book, `book` if none is given. A gate is a file in gates/. It exports a sentence `about`, and
// - `views` and `look({ page, seen, view, url, name, report })`: every page is opened once in each view, and all gates that name the view look at it,
//   those that export `last` after the others, since they change it;
// - or `walk({ browser, book, report, each, open })`: the gate opens what it needs; a gate that has both looks first.
// In the views of `SAMPLED` only some members of the catalogue are opened: they are all made from one template, and other views see all of them.
// `report(where, what)` tells a failure. What `look` and `walk` return is a count, which is printed as what was looked at.
// A gate that exports `needs` is skipped where the book has no such file. Without a browser the gates are skipped. Where the variable CI is set, what
// is skipped is a failure.
import { readdirSync, readFileSync, existsSync } from "node:fs";
import { join, resolve, dirname } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { ended, within } from "./patience.mjs";

const here = dirname(fileURLToPath(import.meta.url));
/** Pages at a time. */
const TOGETHER = 2;
const SAMPLED = ["dark", "zoomed", "still"];
/** Of so many members one is in a sample. */
const MEMBERS = 5;
/** After so many seconds a gate is not waited for any longer. */
const PATIENCE = 300;
/** The most failures of a gate that are printed. */
const TOLD = 20;

/** The gates by name, in the order of their names; those of `only` if it is given. */
export async function load(only) {
  const names = readdirSync(join(here, "gates")).filter((file) => file.endsWith(".mjs")).map((file) => file.slice(0, -4)).sort();
  for (const name of only ?? []) if (!names.includes(name)) throw new Error(`there is no gate ${name}: there are ${names.join(", ")}`);
  const gates = names.filter((name) => !only || only.includes(name));
  return Promise.all(gates.map(async (name) => ({ name, ...(await import(`./gates/${name}.mjs`)) })));
}

/** A built book: its pages, largest first, since the longest should not begin last. */
export function read(folder, only) {
  const root = resolve(folder);
  if (!existsSync(join(root, "index.html"))) throw new Error(`${folder} is no built book: it has no index.html`);
  const pages = readdirSync(root).filter((file) => file.endsWith(".html") && (!only || only.includes(file.slice(0, -5))));
  const texts = new Map(pages.map((file) => [file, readFileSync(join(root, file), "utf8")]));
  pages.sort((a, b) => texts.get(b).length - texts.get(a).length || (a < b ? -1 : 1));
  // Pages that only lead on to another are no places to look at.
  const moved = (file) => /<meta http-equiv="refresh"/i.test(texts.get(file));
  let members = 0;
  const sample = (file) => !texts.get(file).includes('<nav class="breadcrumb"') || members++ % MEMBERS === 0;
  return {
    root,
    pages: pages.filter((file) => !moved(file)),
    sample: pages.filter((file) => !moved(file) && sample(file)),
    text: (file) => texts.get(file),
    url: (file) => pathToFileURL(join(root, file)).href,
    has: (file) => existsSync(join(root, file)),
    /** The first page, from the largest, whose source has `part`. */
    with: (part) => pages.find((file) => !moved(file) && texts.get(file).includes(part)),
  };
}

/** Runs `work` on all items, some at a time. */
export async function each(items, work) {
  const left = [...items];
  const worker = async () => { while (left.length) await work(left.shift()); };
  await Promise.all(Array.from({ length: TOGETHER }, worker));
}

async function guarded(gate, where, work) {
  const begun = performance.now();
  try {
    const count = await within(PATIENCE, work());
    gate.seen += typeof count === "number" ? count : 0;
    gate.skipped = count === "skipped" ? true : gate.skipped;
  } catch (error) {
    gate.failures.push(`${where}: the gate itself failed: ${String(error.message ?? error).split("\n").slice(0, 3).join(" ")}`);
  }
  gate.time += performance.now() - begun;
}

/** Runs gates on a book: each gate gets `failures`, `seen`, `time` and perhaps `skipped`. */
export async function run({ browser, book, gates, tell = () => {} }) {
  const { VIEWS, context, open, visit } = browser ? await import("./browser.mjs") : { VIEWS: {} };
  for (const gate of gates) Object.assign(gate, { failures: [], seen: 0, time: 0, pages: 0, skipped: false });
  const reporter = (gate) => (where, what) => gate.failures.push(`${where}: ${what}`);
  for (const view of Object.keys(VIEWS)) {
    const looking = gates.filter((gate) => gate.views?.includes(view)).sort((a, b) => Number(a.last ?? false) - Number(b.last ?? false));
    if (!looking.length) continue;
    const made = await context(browser, view);
    await each(SAMPLED.includes(view) ? book.sample : book.pages, async (file) => {
      const { page, seen } = await open(made);
      const url = book.url(file);
      try {
        await visit(page, url);
        for (const gate of looking) {
          gate.pages += 1;
          await guarded(gate, `${file} (${view})`, () => gate.look({ page, seen, view, url, file, book, report: (what) => reporter(gate)(`${file} (${view})`, what) }));
        }
      } catch (error) {
        looking.forEach((gate) => gate.failures.push(`${file} (${view}): not opened: ${error.message.split("\n")[0]}`));
      }
      await ended(page);
    });
    await ended(made);
  }
  looked(gates.filter((gate) => gate.look && !gate.walk), tell);
  for (const gate of gates.filter((gate) => gate.walk)) {
    if (!browser && gate.browser !== false) continue;
    const contexts = [];
    // A page of its own in a context of its own.
    const fresh = async (view, file) => {
      const made = await context(browser, view);
      contexts.push(made);
      return open(made, file && book.url(file));
    };
    if (gate.needs && !book.has(gate.needs)) {
      gate.skipped = true;
      looked([gate], tell);
      continue;
    }
    await guarded(gate, gate.name, () => gate.walk({ browser, book, each, open: fresh, visit, report: reporter(gate) }));
    await Promise.all(contexts.map(ended));
    looked([gate], tell);
  }
}

function looked(gates, tell) {
  for (const gate of gates) {
    const state = gate.failures.length ? `FAILED (${gate.failures.length})` : gate.skipped ? "skipped" : "ok";
    const pages = gate.pages ? `${gate.pages} views of pages, ` : "";
    tell(`${state.padEnd(7)} ${gate.name}: ${gate.about} [${pages}${gate.seen} seen, ${(gate.time / 1000).toFixed(1)} s]`);
    gate.failures.slice(0, TOLD).forEach((failure) => tell(`        ${failure}`));
    if (gate.failures.length > TOLD) tell(`        and ${gate.failures.length - TOLD} more`);
  }
}

function asked(name) {
  const at = process.argv.indexOf(name);
  return at < 0 ? null : process.argv.splice(at, 2)[1].split(",");
}

async function main() {
  const [only, pages] = [asked("--only"), asked("--pages")];
  const book = read(process.argv[2] ?? "book", pages);
  const { find, launch } = await import("./browser.mjs");
  const program = find();
  let gates = await load(only);
  let without = 0;
  if (!program) {
    const needs = gates.filter((gate) => gate.browser !== false);
    without = needs.length;
    console.log(`SKIPPED, since there is no Chromium (none is downloaded; install one, or name one in CHROMIUM): ${needs.map((gate) => gate.name).join(", ")}`);
    gates = gates.filter((gate) => gate.browser === false);
  }
  const browser = program ? await launch(program) : null;
  if (browser) console.log(`${program}, ${browser.version()}; ${book.pages.length} pages`);
  await run({ browser, book, gates, tell: console.log });
  const count = (test) => gates.filter(test).length;
  const failed = count((gate) => gate.failures.length);
  const skipped = without + count((gate) => gate.skipped && !gate.failures.length);
  console.log(`${gates.length - failed - (skipped - without)} passed, ${failed} failed, ${skipped} skipped`);
  if (browser) await ended(browser);
  return failed || (skipped && process.env.CI) ? 1 : 0;
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const { supervised } = await import("./browser.mjs");
  await supervised(main);
}
