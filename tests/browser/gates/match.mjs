// What the search finds: search-match.mjs beside this folder. Needs no browser.
import { existsSync } from "node:fs";
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";

export const about = "the search finds what readers ask for";
export const browser = false;
export const needs = "assets/search-match.js";

export async function walk({ book, report }) {
  const script = fileURLToPath(new URL("../search-match.mjs", import.meta.url));
  if (!existsSync(script)) return "skipped";
  // Only the course itself can answer what is asked of it.
  const course = book.has("stratification.html") ? [book.root] : [];
  const { stdout, stderr, status } = spawnSync(process.execPath, [script, ...course], { encoding: "utf8" });
  const failed = stdout.split("\n").filter((line) => line.startsWith("FAILED"));
  if (status !== 0) (failed.length ? failed : [stderr.slice(0, 300)]).forEach((line) => report("search", line));
  return stdout.split("\n").filter((line) => line.startsWith("ok ")).length;
}
