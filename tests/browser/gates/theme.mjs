// The button of the theme: automatic, light, dark; the choice holds on the next page, and is there before anything is painted.
export const about = "the theme button, and the reader's system";

export async function walk({ book, open, visit, report }) {
  const file = book.pages[0];
  const ground = (page) => page.evaluate(() => {
    const colour = getComputedStyle(document.body).backgroundColor;
    const own = /rgba\(0, 0, 0, 0\)/.test(colour) ? getComputedStyle(document.documentElement).backgroundColor : colour;
    const canvas = document.createElement("canvas").getContext("2d");
    canvas.fillStyle = own;
    canvas.fillRect(0, 0, 1, 1);
    return canvas.getImageData(0, 0, 1, 1).data[0] < 128 ? "dark" : "light";
  });
  const name = (page) => page.evaluate(() => { const button = [...document.querySelectorAll(".theme-toggle")].find((one) => one.checkVisibility()); return button && (button.getAttribute("aria-label") || button.textContent); });
  for (const system of ["wide", "dark"]) {
    const { page } = await open(system, file);
    const own = system === "dark" ? "dark" : "light";
    if ((await ground(page)) !== own) report(file, `is not ${own} where the reader's system is`);
    for (const theme of ["light", "dark", "automatic"]) {
      const button = page.locator(".theme-toggle:visible").first();
      if (!(await button.count())) return report(file, "has no button of the theme");
      await button.click();
      const wanted = theme === "automatic" ? own : theme;
      if ((await ground(page)) !== wanted) report(file, `is not ${wanted} after ${theme} was chosen (system: ${own})`);
      if (!(await name(page))?.includes(theme)) report(file, `the button says ${await name(page)}, not ${theme}`);
    }
    await page.locator(".theme-toggle:visible").first().click();
    if (own === "light") await page.locator(".theme-toggle:visible").first().click();
    const chosen = own === "light" ? "dark" : "light";
    const links = page.locator('.sidebar a[href$=".html"]:visible, main a[href$=".html"]:visible').first();
    await links.click();
    await page.waitForLoadState("load");
    if ((await ground(page)) !== chosen) report(file, `the choice ${chosen} is lost on the next page (system: ${own})`);
    const early = await page.evaluate(() => !document.querySelector('script[src$="site.js"], script[src*="/site.js"]')?.defer);
    if (!early) report(file, "the theme is chosen only after the page is painted");
  }
  await visit((await open("wide")).page, book.url(file));
  return 8;
}
