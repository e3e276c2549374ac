// What a reference leads to is shown on a card, for pointers and for the keyboard; the card takes no focus and can be closed.
export const about = "previews by hover and by focus";
export const needs = "assets/page.js";

const CARD = ".preview:not([hidden])";

export async function walk({ book, open, report }) {
  const file = book.pages.find((one) => /<a class="(reference|term|citation)"/.test(book.text(one)));
  if (!file) return "skipped";
  // A low window, so that what is led to is seldom in view: then no card is shown.
  const { page } = await open("zoomed", file);
  // Links whose target is on this page but far away, one of each kind; and one that leads to another page.
  const links = await page.evaluate(() => {
    const found = {};
    document.querySelectorAll("main p a:is(.reference, .term, .citation)").forEach((link, at) => {
      if (!link.checkVisibility()) return;
      link.dataset.gate = at;
      const here = link.pathname === location.pathname;
      const target = here && document.getElementById(decodeURIComponent(link.hash.slice(1)));
      if (here && (!target || Math.abs(target.getBoundingClientRect().top - link.getBoundingClientRect().top) < 600)) return;
      found[`${link.className} ${here ? "here" : "elsewhere"}`] ??= at;
    });
    return Object.entries(found);
  });
  let seen = 0;
  for (const [kind, at] of links) {
    const link = page.locator(`[data-gate="${at}"]`);
    if (kind.endsWith("elsewhere") && !book.has(`assets/previews/${file.replace(".html", ".js")}`)) continue;
    await link.scrollIntoViewIfNeeded();
    await page.mouse.move(2, 2);
    await link.hover();
    await checked(page, `${kind}, hover`, (what) => report(file, what), link);
    await page.keyboard.press("Escape");
    if (await page.locator(CARD).count()) report(file, `${kind}: Esc does not close the card`);
    await page.mouse.move(2, 2);
    await page.waitForTimeout(400);
    await link.evaluate((one) => one.focus({ focusVisible: true }));
    await checked(page, `${kind}, focus`, (what) => report(file, what), link);
    await link.evaluate((one) => one.blur());
    await page.waitForTimeout(400);
    if (await page.locator(CARD).count()) report(file, `${kind}: the card stays when the focus leaves`);
    seen += 2;
  }
  return seen || "skipped";
}

async function checked(page, name, report, link) {
  await page.waitForSelector(CARD, { timeout: 2000 }).catch(() => {});
  const card = page.locator(CARD);
  if (!(await card.isVisible())) return report(`${name}: no card is shown`);
  const { text, box, room, stops, ids } = await card.evaluate((one) => ({
    text: one.textContent.trim(),
    box: one.getBoundingClientRect().toJSON(),
    room: [document.documentElement.clientWidth, innerHeight],
    stops: one.querySelectorAll("a[href], button, input, [tabindex]").length,
    ids: one.querySelectorAll("[id]").length,
  }));
  if (text.length < 3) report(`${name}: the card is empty`);
  if (box.left < 0 || box.right > room[0] + 1 || box.top < -1 || box.bottom > room[1] + 1) report(`${name}: the card stands out of the window`);
  if (stops) report(`${name}: the card holds ${stops} things that take the focus`);
  if (ids) report(`${name}: the card repeats ids`);
  if (!(await link.getAttribute("aria-describedby"))) report(`${name}: the card does not describe its link`);
}
