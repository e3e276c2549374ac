// Present mode: present.mjs beside this folder walks through the slides of the longest chapter that has a stepper.
import { existsSync } from "node:fs";

export const about = "present mode: slides, steps, keys, the speaker's window, paper";
export const needs = "assets/deck.js";

export async function walk({ book, open, report }) {
  const script = new URL("../present.mjs", import.meta.url);
  const file = book.pages.find((one) => book.text(one).includes('<div class="stepper"') && book.text(one).includes("present.js")) ?? book.pages.find((one) => book.text(one).includes("present.js"));
  if (!file || !existsSync(script)) return "skipped";
  const { present } = await import(script);
  const { page } = await open("stage");
  return present({ page, url: book.url(file), report: (what) => report(file, what) });
}
