// How long it takes from the saving of a file until the page shows it, in a real browser; and whether a preview of a thousand edits grows.
//
//   node benches/serve/edit.mjs [--edits N] [--rebuilds N] [--chapters N] [--only prose,made,parameter,memory]
//
// The program is that in target/release, or the one that the variable WORKBOOK names. Both courses are copies, and gone at the end. Goals: 95 of 100 edits of
// prose within 100 ms in this course, and within 150 ms in a made one of 100 chapters and 1,000 exhibits; an edited parameter within 100 ms of
// its experiment's own time; memory that does not grow.
import { spawn } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as rest } from "node:timers/promises";
import { find, launch } from "../../tests/browser/browser.mjs";
import { make } from "./course.mjs";

const option = (name, usual) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? usual : process.argv[at + 1];
};
const edits = Number(option("edits", 60)), rebuilds = Number(option("rebuilds", 1000)), chapters = Number(option("chapters", 100));
const only = option("only", "prose,made,parameter,memory").split(",");
const program = process.env.WORKBOOK ?? "target/release/workbook";

const children = [];

/** Serves a course; `ran` has how long experiments took, in milliseconds. */
async function serve(root) {
  const child = spawn(program, ["serve", "--root", root, "--port", "0"], { stdio: ["ignore", "pipe", "pipe"] });
  children.push(child);
  const served = { child, ran: {} };
  child.stderr.on("data", (data) => {
    for (const [, ids, time, unit] of String(data).matchAll(/^ran (.*) \(([\d.]+)(µs|ms|s)\)$/gm)) {
      for (const id of ids.split(", ")) served.ran[id] = Number(time) * { µs: 1e-3, ms: 1, s: 1e3 }[unit];
    }
  });
  served.address = await new Promise((told) => child.stdout.once("data", (data) => told(String(data).trim())));
  return served;
}

function memory(served) {
  return Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${served.child.pid}/status`, "utf8"))[1]) / 1000;
}

// Tells when what has changed is on the screen: behind the frame that draws it.
function watch() {
  window.shown = [];
  document.addEventListener("workbook:changed", () => requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => window.shown.push({ time: Date.now(), text: document.querySelector("main").textContent, stale: document.querySelectorAll(".live-stale").length });
    channel.port2.postMessage(0);
  }));
}

async function open(browser, served, name) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
  await page.addInitScript(watch);
  await page.goto(served.address + name);
  const whole = () => document.querySelector("main") && !document.querySelector(".live-blank, .live-stale, .live-bar > .live-stale");
  await page.waitForFunction(whole, null, { timeout: 600_000 });
  await rest(1000);
  await page.waitForFunction(whole, null, { timeout: 600_000 });
  return page;
}

/** Saves as editors do, and waits until the page shows `mark`; gives the milliseconds. */
async function save(page, path, text, mark) {
  writeFileSync(`${path}~`, text);
  const begun = Date.now();
  renameSync(`${path}~`, path);
  const seen = await page.waitForFunction(
    (mark) => window.shown.find((shown) => (mark ? shown.text.includes(mark) : !shown.stale) && !shown.used) || null, mark, { timeout: 120_000, polling: 5 });
  const time = (await seen.jsonValue()).time - begun;
  await page.evaluate(() => { window.shown = []; });
  return time;
}

function told(name, times, goal) {
  times.sort((a, b) => a - b);
  const at = (share) => times[Math.min(times.length - 1, Math.ceil(share * times.length) - 1)];
  console.log(`${name.padEnd(46)} median ${at(0.5).toFixed(0).padStart(4)}, p95 ${at(0.95).toFixed(0).padStart(4)}, most ${at(1).toFixed(0).padStart(4)} ms (goal ${goal})`);
}

async function prose(browser, root, name, file, opening, goal) {
  const served = await serve(root);
  const page = await open(browser, served, name);
  await rest(3000);
  const path = join(root, "chapters", file), text = readFileSync(path, "utf8"), times = [];
  if (!text.includes(opening)) throw new Error(`${file} has no ${opening}`);
  const before = await page.screenshot();
  for (let edit = 0; edit < edits; edit += 1) {
    const mark = `edit-${edit}-of-many`;
    times.push(await save(page, path, text.replace(opening, `${mark} ${opening}`), mark));
    // As somebody does who thinks between two savings; the looking through the whole book falls into some of the pauses.
    await rest(150 + (edit % 5) * 150);
  }
  if (before.equals(await page.screenshot())) throw new Error("no pixel has changed");
  told(`prose, ${name || "index.html"}`, times, goal);
  return { served, page, path, text };
}

async function parameter({ served, page, path, text }, id) {
  const fence = text.indexOf(`id = "${id}"`), times = [];
  const line = fence + text.slice(fence).indexOf("\n");
  for (let seed = 11; seed < 19; seed += 1) {
    delete served.ran[id];
    const total = await save(page, path, `${text.slice(0, line)}\nseed = ${seed}${text.slice(line)}`, "");
    // The first that is shown may be the page that waits.
    while (!(id in served.ran)) await rest(5);
    times.push(total - served.ran[id]);
    await rest(500);
  }
  told(`parameter of ${id}, beyond its experiment`, times, 100);
}

const browser = await launch(find());
const folder = mkdtempSync(join(tmpdir(), "workbook-serve-"));
try {
  const own = join(folder, "own");
  for (const part of ["chapters", "templates"]) cpSync(part, join(own, part), { recursive: true });
  try { cpSync(".workbook", join(own, ".workbook"), { recursive: true }); } catch { /* computed anew */ }
  if (only.some((part) => ["prose", "parameter", "memory"].includes(part))) {
    const state = await prose(browser, own, "estimators.html", "02-estimators.md", option("opening", "After this chapter"), 100);
    if (only.includes("parameter")) await parameter(state, option("id", "fig-estimator-steps"));
    if (only.includes("memory")) {
      const sizes = [];
      for (let edit = 0; edit <= rebuilds; edit += 1) {
        const mark = `rebuild-${edit}-of-many`;
        await save(state.page, state.path, state.text.replace("The ", `${mark} The `), mark);
        if (edit % Math.ceil(rebuilds / 10) === 0) { await rest(1500); sizes.push(memory(state.served).toFixed(0)); }
      }
      console.log(`memory over ${rebuilds} rebuilds, MB: ${sizes.join(" ")}`);
    }
    state.served.child.kill();
  }
  if (only.includes("made")) {
    const made = join(folder, "made");
    make(made, chapters);
    const file = readdirSync(join(made, "chapters")).filter((name) => name.endsWith(".md"))[Math.floor(chapters / 2)];
    const state = await prose(browser, made, `${file.replace(/^\d+-/, "").replace(/\.md$/, "")}.html`, file, "The opening", 150);
    console.log(`memory of the made course: ${memory(state.served).toFixed(0)} MB`);
    state.served.child.kill();
  }
} catch (error) {
  console.error(error);
  process.exitCode = 1;
} finally {
  await browser.close();
  children.forEach((child) => child.kill());
  await rest(500);
  rmSync(folder, { recursive: true, force: true });
}
