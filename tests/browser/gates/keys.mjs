// The keys of a page: arrows turn chapters only when nothing has the focus, `?` tells the keys, Esc closes.
export const about = "arrows turn chapters, ? tells the keys, Esc closes";
export const needs = "assets/page.js";

export async function walk({ book, open, visit, report }) {
  const file = book.pages.find((one) => /class="previous"/.test(book.text(one)) && /class="next"/.test(book.text(one)));
  if (!file) return "skipped";
  const { page } = await open("wide", file);
  const where = () => page.evaluate(() => location.pathname.split("/").pop());
  const turned = async (key) => {
    await page.keyboard.press(key);
    await page.waitForTimeout(250);
    await page.waitForLoadState("load");
    return where();
  };
  for (const [key, way] of [["ArrowRight", "next"], ["ArrowLeft", "previous"]]) {
    await visit(page, book.url(file));
    const href = await page.locator(`.turn .${way}`).getAttribute("href");
    const to = await turned(key);
    if (to !== href) report(file, `${key} leads to ${to}, not to ${href}`);
    await visit(page, book.url(file));
    await page.locator("main a:visible").first().focus();
    if ((await turned(key)) !== file) report(file, `${key} turns the chapter though a link has the focus`);
    await visit(page, book.url(file));
    if ((await turned(`Shift+${key}`)) !== file) report(file, `Shift and ${key} turn the chapter`);
  }
  await visit(page, book.url(file));
  await page.keyboard.press("?");
  const dialog = page.locator("dialog[open]");
  if (!(await dialog.count())) return report(file, "? opens nothing");
  const told = await dialog.locator("kbd").allTextContents();
  for (const key of ["?", "←", "→", "Esc"]) if (!told.includes(key)) report(file, `the dialog of the keys does not tell ${key}`);
  if (!(await dialog.getAttribute("aria-label")) && !(await dialog.getAttribute("aria-labelledby"))) report(file, "the dialog of the keys has no name");
  if ((await turned("ArrowRight")) !== file) report(file, "an arrow turns the chapter behind the dialog");
  await page.keyboard.press("Escape");
  if (await page.locator("dialog[open]").count()) report(file, "Esc does not close the dialog");
  const button = page.locator(".keys-open:visible").first();
  if (await button.count()) {
    await button.focus();
    await page.keyboard.press("Enter");
    if (!(await page.locator("dialog[open]").count())) report(file, "the button of the keys opens nothing");
    await page.keyboard.press("Escape");
    if (!(await page.evaluate(() => document.activeElement.matches(".keys-open")))) report(file, "the focus does not come back to the button of the keys");
  }
  return told.length;
}
