// The buttons that copy code copy all of it and nothing else, and say so.
export const about = "buttons copy code";
export const needs = "assets/page.js";

export async function walk({ book, open, report }) {
  const file = book.with("<pre");
  if (!file) return "skipped";
  const { page } = await open("wide", file);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const [blocks, buttons] = [await page.locator("main pre").count(), await page.locator("button.copy").count()];
  if (blocks !== buttons) report(file, `has ${blocks} blocks of code and ${buttons} buttons`);
  await page.evaluate(() => document.querySelectorAll("details").forEach((fold) => { fold.open = true; }));
  let seen = 0;
  for (let at = 0; at < Math.min(buttons, 3); at += 1) {
    const button = page.locator("button.copy").nth(at);
    if (!(await button.isVisible())) continue;
    await button.focus();
    await page.keyboard.press("Enter");
    await page.waitForTimeout(150);
    const said = await button.textContent();
    if (said !== "Copied") report(file, `button ${at + 1} says ${said}`);
    const [copied, wanted] = await page.evaluate(async (at) => {
      const block = document.querySelectorAll("main pre")[at].cloneNode(true);
      block.querySelectorAll("[aria-hidden=true]").forEach((part) => part.remove());
      return [await navigator.clipboard.readText(), block.textContent];
    }, at);
    if (copied.trimEnd() !== wanted.trimEnd()) report(file, `button ${at + 1} copies ${JSON.stringify(copied.slice(0, 60))}`);
    seen += 1;
  }
  return seen;
}
