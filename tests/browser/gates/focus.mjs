// What has the focus is seen to have it, and the first press of Tab leads past the lists of chapters.
export const about = "the focus is visible, and the skip link comes first";

export async function walk({ book, each, open, report }) {
  const files = new Set([book.with('<div class="stepper"'), "index.html", "made.html", "exhibits.html", "terms.html", book.with("<pre")].filter((file) => file && book.has(file)));
  let seen = 0;
  await each(files, async (file) => {
    const { page } = await open("wide", file);
    await page.keyboard.press("Tab");
    const first = await page.evaluate(() => ({ link: document.activeElement.getAttribute("href"), box: document.activeElement.getBoundingClientRect().toJSON() }));
    if (first.link !== "#main") {
      // Another key would leave the page.
      report(file, `the first press of Tab leads to ${first.link}, not past the lists`);
      return;
    }
    if (first.box.left < 0 || first.box.top < 0 || !first.box.width) report(file, "the skip link cannot be seen when it has the focus");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    if (!(await page.evaluate(() => document.activeElement === document.body || document.querySelector("main").contains(document.activeElement)))) report(file, "the skip link does not lead into the text");
    const { told, count } = await page.evaluate(async () => {
      const opened = new Set();
      // One fold of each class is opened: a page with all of them open is slow to lay out.
      document.querySelectorAll("details").forEach((fold) => { if (!opened.has(fold.className)) fold.open = true; opened.add(fold.className); });
      document.documentElement.style.scrollBehavior = "auto";
      const told = [], kinds = new Set();
      let count = 0;
      const look = (element) => {
        const style = getComputedStyle(element);
        return { outline: style.outlineStyle === "none" ? 0 : parseFloat(style.outlineWidth), paint: [style.boxShadow, style.backgroundColor, style.borderColor, style.textDecorationColor, style.textDecorationThickness].join() };
      };
      for (const element of document.querySelectorAll("a[href], button, input, summary, select, [tabindex='0']")) {
        // One of a kind is enough: kinds are told by their classes and those around them.
        const kind = [element.localName, element.className, element.parentElement.localName, element.closest("nav, main, .exhibit, .callout, .bar, .sidebar, footer")?.classList[0]].join(" ");
        if (kinds.has(kind) || kinds.size > 40) continue;
        if (!element.checkVisibility({ visibilityProperty: true }) || element.disabled) continue;
        kinds.add(kind);
        const before = look(element);
        element.focus({ focusVisible: true, preventScroll: true });
        if (document.activeElement !== element) { told.push(`cannot get the focus: ${element.outerHTML.slice(0, 90)}`); continue; }
        const after = look(element);
        count += 1;
        if (after.outline < 1 && before.paint === after.paint) told.push(`the focus is not seen on ${element.outerHTML.slice(0, 90)}`);
        element.blur();
      }
      return { told, count };
    });
    told.forEach((what) => report(file, what));
    seen += count;
  });
  return seen;
}
