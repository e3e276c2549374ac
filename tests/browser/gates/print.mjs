// Paper: about as many pages as the text needs, nothing that acts, links spelt out, hints and solutions as they stand on the screen.
export const about = "print: page count, what is left out, links, folds as chosen";

const MM = 96 / 25.4;

export async function walk({ book, each, open, report }) {
  const chapters = book.pages.filter((file) => /class="[^"]*\bchapter\b/.test(book.text(file)));
  const files = new Set([...chapters.slice(0, 2), chapters[chapters.length - 1], "index.html", "terms.html"].filter((file) => file && book.has(file)));
  let papers = 0;
  await each(files, async (file) => {
    const { page } = await open("wide", file);
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: Math.round(166 * MM), height: Math.round(255 * MM) });
    const { height, told } = await page.evaluate(() => {
      const told = [];
      const shown = (element) => element.checkVisibility({ visibilityProperty: true });
      document.querySelectorAll("button, input, nav:not(.chapter-list), dialog, .permalink, .skip, .preview").forEach((element) => { if (shown(element)) told.push(`prints ${element.localName}.${element.className}`); });
      document.querySelectorAll("article.text > p a[href^='http'], article.text li a[href^='http']").forEach((link) => {
        if (shown(link) && !link.closest(".bibliography") && !getComputedStyle(link, "::after").content.includes("http") && !link.textContent.includes("http")) told.push(`does not spell out ${link.href}`);
      });
      for (const fold of document.querySelectorAll("main details.callout")) {
        const body = fold.querySelector(":scope > :not(summary)");
        if (!body) continue;
        fold.open = true;
        if (!fold.parentElement.closest("details:not([open])") && !shown(body)) told.push(`does not print an open fold: ${fold.textContent.trim().slice(0, 40)}`);
        fold.open = false;
        if (shown(body)) told.push(`prints a closed fold: ${fold.textContent.trim().slice(0, 40)}`);
      }
      const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
      if (wide > 1) told.push(`is ${wide} px wider than the paper`);
      return { height: document.documentElement.scrollHeight, told: [...new Set(told)] };
    });
    told.slice(0, 6).forEach((what) => report(file, what));
    const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
    const count = (pdf.match(/\/Type\s*\/Page\b/g) || []).length;
    const least = Math.floor(0.8 * height / (255 * MM)), most = Math.ceil(1.35 * height / (255 * MM)) + 2;
    if (count < least || count > most) report(file, `is ${count} pages on paper; its text needs ${least} to ${most}`);
    papers += count;
    await page.close();
  });
  return papers;
}
