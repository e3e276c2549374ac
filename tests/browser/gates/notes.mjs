// Notes stand in the margin where there is room, beside the text and clear of everything else, and in the text where there is none.
export const about = "notes in the margin touch nothing, and on small screens stand in the text";
export const views = ["wide", "narrow", "plain"];
/** What a page's source must hold for the gate to have anything to see: the self-test chooses its page by it. */
export const sees = 'class="side-note"';

export async function look({ page, view, report }) {
  const { told, seen } = await page.evaluate((margin) => {
    const told = [];
    const shown = (element) => element.checkVisibility({ contentVisibilityAuto: true }) && element.getBoundingClientRect().height > 0;
    const notes = [...document.querySelectorAll(".side-note")].filter(shown).map((element) => ({ element, box: element.getBoundingClientRect() }));
    const name = (element) => element.textContent.trim().slice(0, 40);
    const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    const text = document.querySelector("article.text");
    const others = [...document.querySelectorAll("main :is(.exhibit-body, .exhibit > figcaption, .listing, .table-wrap, .equation > math, pre, h2, h3), .on-this-page")].filter(shown).map((element) => ({ element, box: element.getBoundingClientRect() }));
    for (const [at, { element, box }] of notes.entries()) {
      if (box.right > document.documentElement.clientWidth + 1 || box.left < 0) told.push(`a note stands out of the window: ${name(element)}`);
      for (const other of notes.slice(at + 1)) if (meet(box, other.box)) told.push(`two notes overlap: ${name(element)}; ${name(other.element)}`);
      for (const other of others) if (!element.contains(other.element) && !other.element.contains(element) && meet(box, other.box)) told.push(`a note overlaps ${other.element.localName}.${other.element.className}: ${name(element)}`);
      const holder = element.closest("p, li, td, blockquote, .callout") ?? text;
      const beside = box.left >= Math.min(holder.getBoundingClientRect().right, text.getBoundingClientRect().right) - 1;
      if (margin && text.closest(".chapter") && !element.closest("td") && !beside && holder !== text) told.push(`a note is not in the margin: ${name(element)}`);
    }
    for (const link of document.querySelectorAll(".footnote-reference a")) if (!document.getElementById(decodeURIComponent(link.hash.slice(1)))) told.push(`the reference ${link.hash} leads to no note`);
    return { told, seen: notes.length };
  }, view !== "narrow");
  told.slice(0, 8).forEach(report);
  return seen || undefined;
}
