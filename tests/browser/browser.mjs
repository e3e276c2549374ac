// The browser that is there, and the views in which pages are looked at. None is ever downloaded.
import { fork } from "node:child_process";
import { accessSync, constants } from "node:fs";
import { chromium } from "playwright-core";

const PLACES = [
  "/usr/bin/chromium",
  "/usr/bin/google-chrome-stable",
  "/usr/bin/google-chrome",
  "/usr/bin/chromium-browser",
  "/opt/google/chrome/chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
];

/** The program of a Chromium: what the variable CHROMIUM names, or one at the usual places; null if there is none. */
export function find() {
  const runs = (path) => {
    try { accessSync(path, constants.X_OK); return true; } catch { return false; }
  };
  if (process.env.CHROMIUM) {
    if (!runs(process.env.CHROMIUM)) throw new Error(`CHROMIUM names ${process.env.CHROMIUM}, which cannot be run`);
    return process.env.CHROMIUM;
  }
  return PLACES.find(runs) ?? null;
}

/** Starts it. It asks no host of anything by itself. */
export function launch(executablePath) {
  const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
  return chromium.launch({ executablePath, args });
}

/**
 * Runs `main`, which gives the status of the program, in a process of its own, and ends that by force once the status is known: Node.js now and then
 * waits for ever for its own threads when it exits (https://github.com/nodejs/node/issues/54918), which hung a whole run after its last test had passed.
 */
export async function supervised(main) {
  if (process.send) {
    process.send(await main().catch((error) => (console.error(error), 1)));
    return;
  }
  const child = fork(process.argv[1], process.argv.slice(2));
  process.exitCode = await new Promise((told) => {
    child.once("message", told);
    child.once("exit", (status) => told(status || 1));
  });
  child.kill("SIGKILL");
}

/** The views by name: what `browser.newContext` takes. */
export const VIEWS = {
  wide: { viewport: { width: 1280, height: 800 }, colorScheme: "light" },
  dark: { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  narrow: { viewport: { width: 320, height: 640 }, colorScheme: "light", hasTouch: true },
  // A window of 1280 by 800 pixels at 200 %.
  zoomed: { viewport: { width: 640, height: 400 }, deviceScaleFactor: 2, colorScheme: "light" },
  plain: { viewport: { width: 1280, height: 800 }, colorScheme: "light", javaScriptEnabled: false },
  still: { viewport: { width: 1280, height: 800 }, colorScheme: "light", reducedMotion: "reduce" },
  stage: { viewport: { width: 1280, height: 720 }, colorScheme: "light" },
};

// Layout shifts are kept from the start, since they are over when the page is there.
function keepShifts() {
  window.keptShifts = [];
  new PerformanceObserver((list) => list.getEntries().forEach((entry) => {
    if (entry.hadRecentInput) return;
    const what = (entry.sources || []).map((source) => source.node && (source.node.id || source.node.className || source.node.nodeName)).slice(0, 3);
    window.keptShifts.push({ value: entry.value, what: what.map(String) });
  })).observe({ type: "layout-shift", buffered: true });
}

/** A context of a view; its pages keep their layout shifts. No host can be reached: what is asked of one is kept as `requests`. */
export async function context(browser, view) {
  const made = await browser.newContext({ ...VIEWS[view], serviceWorkers: "block" });
  await made.addInitScript(keepShifts);
  return made;
}

/** Opens a page and keeps what it says and asks for: `{ page, seen }`. */
export async function open(made, url) {
  const page = await made.newPage();
  page.setDefaultTimeout(10000);
  page.setDefaultNavigationTimeout(30000);
  const seen = { messages: [], requests: [] };
  page.on("console", (message) => { if (["error", "warning", "assert"].includes(message.type())) seen.messages.push(`${message.type()}: ${message.text()}`); });
  page.on("pageerror", (error) => seen.messages.push(`error: ${error.message}`));
  // What is broken off when the page is left was not missing.
  page.on("requestfailed", (request) => request.failure()?.errorText !== "net::ERR_ABORTED" && seen.messages.push(`not loaded: ${request.url()} (${request.failure()?.errorText})`));
  page.on("request", (request) => { if (!/^(file|data|blob|about):/.test(request.url())) seen.requests.push(request.url()); });
  if (url) await visit(page, url);
  return { page, seen };
}

/** Goes to an address and waits until all of it is there: faces too, which load after the event, and what is laid out only then. */
export async function visit(page, url) {
  await page.goto(url, { waitUntil: "load" });
  await page.evaluate(() => document.fonts.ready.then(() => true));
  await page.waitForSelector("html:not(.settling, .faceless, .parsing)", { state: "attached", timeout: 10000 });
}
