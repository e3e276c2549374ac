// Links open the folds that hold what they lead to; one button opens all, also on the next visit.
export const about = "links open folds, one button opens all";

export async function walk({ book, open, visit, report }) {
  const has = (file) => /<details[^>]*class="[^"]*callout/.test(book.text(file));
  const file = book.pages.find(has);
  if (!file) return "skipped";
  const { page } = await open("wide", file);
  let seen = 0;
  const inside = await page.evaluate(() => [...document.querySelectorAll("details:not([open]) [id]:not(svg *)")].map((element) => element.id).slice(0, 4));
  for (const id of inside) {
    await visit(page, "about:blank");
    await visit(page, `${book.url(file)}#${encodeURIComponent(id)}`);
    // Scrolling to a place may glide, and a place near the end of a page may stand below its middle.
    await page.waitForFunction((id) => { const box = document.getElementById(id).getBoundingClientRect(); return box.bottom > 0 && box.top < innerHeight; }, id, { timeout: 2000 }).catch(() => {});
    const { shown, box, room } = await page.evaluate((id) => ({ shown: document.getElementById(id).checkVisibility(), box: document.getElementById(id).getBoundingClientRect().toJSON(), room: innerHeight }), id);
    seen += 1;
    if (!shown) report(file, `the link #${id} does not open the fold that holds it`);
    else if (box.bottom < 0 || box.top > room) report(file, `the link #${id} does not lead to its place`);
  }
  await visit(page, "about:blank");
  await visit(page, book.url(file));
  const summary = page.locator("details.callout:visible > summary").first();
  if (await summary.count()) {
    await summary.focus();
    await page.keyboard.press("Enter");
    if (!(await summary.evaluate((one) => one.parentElement.open))) report(file, "Enter does not open a fold");
    await page.keyboard.press("Enter");
  }
  const button = page.locator(".fold-all button:visible").first();
  if (await button.count()) {
    const closed = () => page.evaluate(() => document.querySelectorAll("details.callout:not([open])").length);
    const top = () => button.evaluate((one) => Math.round(one.getBoundingClientRect().top));
    await button.scrollIntoViewIfNeeded();
    const before = await top();
    await button.click();
    if (await closed()) report(file, "the button for all folds leaves some closed");
    if (Math.abs((await top()) - before) > 2) report(file, "the button for all folds moves away when it is pressed");
    await page.reload();
    await page.waitForTimeout(100);
    if (await closed()) report(file, "open folds are closed on the next visit");
    await page.locator(".fold-all button:visible").first().click();
    const { folds } = await page.evaluate(() => ({ folds: document.querySelectorAll("details.callout").length }));
    if ((await closed()) !== folds) report(file, "the button for all folds leaves some open");
    seen += folds;
  }
  return seen;
}
