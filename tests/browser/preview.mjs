// Whether `workbook serve` keeps an open page right: a course is edited, broken, mended and lost, and a real browser looks on.
//
//   node tests/browser/preview.mjs PROGRAM COURSE
//
// PROGRAM is the workbook generator, COURSE a folder with `chapters/`, of which a copy is edited. All of it is one reader's session.
import { spawn } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { context, find, launch, open, supervised } from "./browser.mjs";
import { ended } from "./patience.mjs";

const PATIENCE = 60_000;
const CHAPTER = "01-preview.md";
const TEXT = `+++
title = "Preview"
summary = "A chapter that is edited."
+++

## First {#sec-first}

The opening paragraph.

\`\`\`rust
fn first() {}
\`\`\`

${"A paragraph that only takes up room, so that there is something to scroll through. ".repeat(12).trim()}

${"Another one of them, with other words, which stands between the opening and the end. ".repeat(12).trim()}

## Second {#sec-second}

A note in the text [^margin].

[^margin]: A note that stands in the margin.

\`\`\`experiment
id = "fig-curve"
kind = "running-mean"
integrand = "x"
samplers = ["independent"]
n = 32
runs = 3
seed = 11
caption = 'Running means.'
\`\`\`

${"And more of it below the figure, so that the page is longer than the window by far. ".repeat(12).trim()}

The closing paragraph, see @fig-curve.
`;

/** A course of one chapter beside the configuration of `course`, and how its chapter is edited. */
function copied(course) {
  const root = mkdtempSync(join(tmpdir(), "preview-"));
  cpSync(join(course, "chapters"), join(root, "chapters"), { recursive: true, filter: (path) => !path.endsWith(".md") });
  const path = join(root, "chapters", CHAPTER);
  writeFileSync(path, TEXT);
  // As editors save: a file beside it, which then takes its name.
  const edit = (old, now) => {
    const text = readFileSync(path, "utf8");
    if (!text.includes(old)) throw new Error(`the chapter has no ${JSON.stringify(old)}`);
    writeFileSync(`${path}~`, text.replace(old, now));
    renameSync(`${path}~`, path);
  };
  return { root, edit };
}

async function serve(program, root, port = 0) {
  const child = spawn(program, ["serve", "--quiet", "--root", root, "--port", String(port)], { stdio: ["ignore", "pipe", "ignore"] });
  const address = await new Promise((told, failed) => {
    child.stdout.once("data", (data) => told(String(data).trim()));
    child.once("exit", () => failed(new Error("the preview has ended")));
  });
  return { child, address };
}

const shows = (page, text) => page.waitForFunction((text) => document.querySelector("main")?.textContent.includes(text), text, { timeout: PATIENCE });
const top = (page, selector) => page.evaluate((selector) => document.querySelector(selector).getBoundingClientRect().top, selector);

/** What is edited is shown in its place, and all else stays as it was: nodes, scrolling, and what a reader has chosen. */
async function edits({ page, edit, check }) {
  await page.evaluate(() => document.querySelector("#fig-curve").scrollIntoView({ block: "center", behavior: "instant" }));
  await page.evaluate(() => { document.querySelector("#fig-curve").kept = true; document.querySelector("#fig-curve details").open = true; });
  const before = await top(page, "#fig-curve");
  for (const count of ["two", "three", "four"]) {
    edit("The opening paragraph.", `The opening paragraph.\n\nParagraph ${count}, which is new and pushes all below it down.`);
    await shows(page, `Paragraph ${count},`);
    const moved = (await top(page, "#fig-curve")) - before;
    check(Math.abs(moved) < 2, `the figure moves by ${moved.toFixed(1)} px with edit ${count}`);
  }
  check(await page.evaluate(() => document.querySelector("#fig-curve").kept && document.querySelector("#fig-curve details").open), "an exhibit that did not change was replaced");
}

/** What scripts do to a page is done to new parts too, with every edit. */
async function scripts({ page, edit, check }) {
  for (const [old, now, count] of [["fn first() {}", "fn first() {}\n```\n\n```rust\nfn second() {}", 2], ["fn second() {}", "fn second() {}\n```\n\n```rust\nfn third() {}", 3]]) {
    edit(old, now);
    await shows(page, now.split("\n").pop());
    const buttons = await page.locator("main .copying:has(pre) button.copy").count();
    check(buttons === count, `${buttons} of ${count} blocks of code can be copied`);
  }
  edit("## Second {#sec-second}", "## Third {#sec-third}\n\nText of the third.\n\n## Second {#sec-second}");
  await shows(page, "Text of the third.");
  const listed = await page.locator(".on-this-page a[href$='#sec-third']").count();
  check(listed > 0, "the list of sections has no new section");
  check((await page.locator("#sec-second").textContent()).includes("1.3"), "sections behind a new one keep their numbers");
  await page.locator("main a[href$='#fig-curve']").last().hover();
  await page.waitForSelector(".preview:not([hidden])", { timeout: 5000 }).catch(() => check(false, "a reference in a new part shows no card"));
  await page.mouse.move(1, 1);
}

/** An experiment that is computed anew: its figure stays until there is another. */
async function parameters({ page, edit, check }) {
  const drawing = () => page.evaluate(() => document.querySelector("#fig-curve svg").outerHTML);
  const before = await drawing();
  edit("seed = 11", "seed = 12");
  await page.waitForFunction((before) => document.querySelector("#fig-curve svg")?.outerHTML !== before && !document.querySelector(".live-stale"), before, { timeout: PATIENCE });
  check((await drawing()) !== before, "the figure is the old one");
}

/** Mistakes are told with their places, the page stays, and they go when they are mended. */
async function mistakes({ page, edit, check }) {
  for (const time of ["first", "second"]) {
    edit('samplers = ["independent"]', 'samplers = ["indepndent"]');
    const panel = page.locator(".live-panel-errors");
    await panel.waitFor({ timeout: PATIENCE });
    const text = await panel.textContent();
    check(text.includes("did you mean `independent`?"), `the ${time} mistake is told without help: ${text}`);
    check((await panel.locator("a").first().getAttribute("href")).includes(CHAPTER), "a mistake does not link to its file");
    check(await page.locator("#fig-curve svg").count() > 0, "the figure has gone");
    await page.keyboard.press("Escape");
    await panel.waitFor({ state: "detached", timeout: 5000 }).catch(() => check(false, "Escape does not close the mistakes"));
    edit('samplers = ["indepndent"]', 'samplers = ["independent"]');
    await page.waitForFunction(() => !document.querySelector(".live-errors"), null, { timeout: PATIENCE });
  }
}

/** A preview that stops is told, and the page goes on with the next at the same address. */
async function lost({ page, served, program, root, edit, check }) {
  served.child.kill();
  await page.waitForSelector(".live-lost", { timeout: PATIENCE });
  edit("The closing paragraph", "The very last paragraph");
  const again = await serve(program, root, Number(new URL(served.address).port));
  await shows(page, "The very last paragraph").catch(() => check(false, "the page does not go on with the next preview"));
  return again;
}

async function main() {
  const [program, course] = process.argv.slice(2);
  const chromium = find();
  if (!chromium) {
    console.log("SKIPPED: there is no Chromium");
    return process.env.CI ? 1 : 0;
  }
  const { root, edit } = copied(course);
  const browser = await launch(chromium);
  let served = await serve(program, root), failed = 0;
  const check = (holds, what) => { if (!holds) { failed += 1; console.log(`FAILED ${what}`); } };
  try {
    const { page, seen } = await open(await context(browser, "wide"), `${served.address}preview.html`);
    await page.waitForFunction(() => document.querySelector("#fig-curve svg") && !document.querySelector(".live-stale"), null, { timeout: PATIENCE });
    const session = { page, edit, check, served, program, root };
    for (const part of [edits, scripts, parameters, mistakes]) await part(session);
    // The address cannot be reached for a while, which browsers tell of themselves.
    const messages = [...seen.messages];
    served = await lost(session);
    check(!messages.length, `the page complains: ${messages.slice(0, 3).join("; ")}`);
    console.log(failed ? `${failed} failed` : "the preview follows its author");
  } finally {
    served.child.kill();
    await ended(browser);
    rmSync(root, { recursive: true, force: true });
  }
  return failed ? 1 : 0;
}

await supervised(main);
