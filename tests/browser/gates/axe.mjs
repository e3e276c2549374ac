// axe-core finds nothing. In the dark only colours can differ, so that there only the rules on colours are asked again.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

export const about = "axe-core without violations, light and dark";
export const views = ["wide", "dark"];
/** Folds are opened, which other gates must not see. */
export const last = true;

const source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const COLOURS = ["color-contrast", "link-in-text-block"];

export async function look({ page, view, report }) {
  // What is folded is read as well; exhibits' provenance is alike on all pages, so that one of them is enough.
  await page.evaluate(() => {
    document.querySelectorAll("main details:not(.provenance)").forEach((fold) => { fold.open = true; });
    const first = document.querySelector("details.provenance");
    if (first) first.open = true;
    // Axe has no rules for the inside of drawings and of formulas, which are most of a page: without it, it is several times as fast.
    document.querySelectorAll("svg").forEach((drawing) => { for (const part of [...drawing.children]) if (!/^(title|desc)$/.test(part.localName)) part.remove(); });
    document.querySelectorAll("math").forEach((formula) => { const text = document.createElementNS(formula.namespaceURI, "mtext"); text.textContent = formula.textContent; formula.replaceChildren(text); });
  });
  await page.evaluate(source);
  const results = await page.evaluate(async (rules) => {
    const options = { resultTypes: ["violations"], preload: false };
    if (rules) options.runOnly = { type: "rule", values: rules };
    else options.runOnly = { type: "tag", values: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] };
    const found = await window.axe.run(document, options);
    return { asked: found.passes.length + found.violations.length, violations: found.violations.map((one) => ({ id: one.id, help: one.help, nodes: one.nodes.map((node) => `${node.target.join(" ")}: ${node.html.slice(0, 100)}${(node.any[0] || node.all[0] || node.none[0] || {}).message ? ` (${(node.any[0] || node.all[0] || node.none[0]).message})` : ""}`) })) };
  }, view === "dark" ? COLOURS : null);
  for (const { id, help, nodes: all } of results.violations) {
    // axe does not read MathML: a heading that is a formula is empty to it, and to no screen reader.
    const nodes = id === "empty-table-header" ? all.filter((node) => !node.includes("<math")) : all;
    if (!nodes.length) continue;
    report(`${id}: ${help}, ${nodes.length} times: ${nodes.slice(0, 3).join(" | ")}`);
  }
  return results.asked;
}
