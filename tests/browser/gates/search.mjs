// The search by keyboard alone: opened by /, asked, walked through, followed, closed.
export const about = "keyboard walk of the search";
export const needs = "assets/page.js";

export async function walk({ book, open, visit, report }) {
  const file = book.pages[0];
  const { page, seen } = await open("wide", file);
  // A word of a chapter's title, and the same with a slip.
  const word = await page.evaluate(() => [...document.querySelectorAll(".chapters .title")].flatMap((title) => title.textContent.match(/\p{L}{6,}/gu) ?? [])[0]?.toLowerCase());
  if (!word) return "skipped";
  const results = page.locator("dialog[open] .search-results a");
  const ask = async (question) => {
    await page.keyboard.press("ControlOrMeta+a");
    await page.keyboard.type(question);
    await page.waitForTimeout(200);
    return results.count();
  };
  await page.keyboard.press("/");
  if (!(await page.locator("dialog[open]").count())) return report(file, "/ does not open the search");
  if (!(await page.evaluate(() => document.activeElement.matches("dialog input")))) report(file, "the question has not got the focus");
  await page.keyboard.type(word);
  await results.first().waitFor({ timeout: 5000 }).catch(() => report(file, `${word} finds nothing`));
  const found = await results.count();
  const slip = word.slice(0, 3) + word[4] + word[3] + word.slice(5);
  if (!(await ask(slip))) report(file, `${slip} finds nothing`);
  if (await ask("qqzzxxqq")) report(file, "nonsense is found");
  if (!(await page.locator("dialog[open] [role=status]").textContent())?.trim()) report(file, "that nothing was found is not told");
  await ask(word);
  const at = () => page.evaluate(() => [...document.querySelectorAll("dialog .search-results a")].indexOf(document.activeElement));
  await page.keyboard.press("ArrowDown");
  if ((await at()) !== 0) report(file, "ArrowDown does not lead to the first result");
  if (found > 1) {
    await page.keyboard.press("ArrowDown");
    if ((await at()) !== 1) report(file, "ArrowDown does not lead to the second result");
    await page.keyboard.press("ArrowUp");
  }
  await page.keyboard.press("ArrowUp");
  if (!(await page.evaluate(() => document.activeElement.matches("dialog input")))) report(file, "ArrowUp does not lead back to the question");
  await page.keyboard.press("Shift+Tab");
  if (!(await page.evaluate(() => document.activeElement.closest("dialog")))) report(file, "Tab leaves the dialog");
  await page.keyboard.press("Escape");
  if (await page.locator("dialog[open]").count()) report(file, "Esc does not close the search");
  await page.keyboard.press("/");
  await ask(word);
  await page.keyboard.press("ArrowDown");
  const href = await page.evaluate(() => document.activeElement.href);
  await page.keyboard.press("Enter");
  await page.waitForTimeout(300);
  await page.waitForLoadState("load");
  const now = await page.evaluate(() => location.href);
  const bare = (url) => (url ?? "").replace(/\?[^#]*/, "");
  if (bare(now) !== bare(href)) report(file, `Enter on a result leads to ${now.split("/").pop()}, not to ${String(href).split("/").pop()}`);
  await visit(page, book.url(file));
  const button = page.locator("button.search-open:visible").first();
  if (!(await button.count())) report(file, "has no button of the search");
  else {
    await button.focus();
    await page.keyboard.press("Enter");
    await page.keyboard.press("Escape");
    if (!(await page.evaluate(() => document.activeElement.matches(".search-open")))) report(file, "the focus does not come back to the button of the search");
  }
  seen.requests.concat(seen.messages).forEach((what) => report(file, what));
  return found;
}
