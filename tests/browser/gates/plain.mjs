// Without scripts everything can be read: text, formulas, drawings; nothing is shown that would do nothing.
export const about = "without scripts everything is readable";
export const views = ["plain"];

export async function look({ page, report }) {
  const { told, seen } = await page.evaluate(() => {
    const told = [];
    const name = (element) => `${element.localName}${element.id ? `#${element.id}` : element.className ? `.${String(element.className.baseVal ?? element.className).split(" ")[0]}` : ""} ${element.textContent.trim().slice(0, 40)}`;
    // Readers open folds without a script too.
    document.querySelectorAll("details").forEach((fold) => { fold.open = true; });
    const shown = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && element.getBoundingClientRect().height > 0;
    // What only a script could do anything with is hidden on purpose.
    const steps = ".step-captions > p:not(.step-final), .step-controls, .step-controls *, .fold-all, .fold-all *";
    let seen = 0;
    for (const element of document.querySelectorAll("main :is(p, li, h1, h2, h3, h4, pre, td, th, dt, dd, figcaption, math, figure svg, img)")) {
      if (element.closest(steps) || (!element.textContent.trim() && !element.matches("svg, img"))) continue;
      if (element.closest("math") && element.localName !== "math") continue;
      seen += 1;
      if (!shown(element)) told.push(`cannot be seen: ${name(element)}`);
    }
    for (const button of document.querySelectorAll("button, input, [role=button]")) if (shown(button)) told.push(`is shown but does nothing: ${name(button)} ${button.getAttribute("aria-label") ?? ""}`);
    for (const exhibit of document.querySelectorAll("figure.exhibit")) {
      const drawn = [...exhibit.querySelectorAll(".exhibit-body :is(svg, img, table, p)")].some(shown);
      if (!drawn) told.push(`the exhibit ${exhibit.id} shows nothing`);
      const final = exhibit.querySelector(".step-captions > .step-final");
      if (exhibit.querySelector(".stepper") && !(final && shown(final))) told.push(`the stepper ${exhibit.id} does not tell its last step`);
    }
    for (const picture of document.images) if (picture.complete && !picture.naturalWidth) told.push(`the picture ${picture.getAttribute("src").slice(0, 60)} is not there`);
    if (!document.querySelector("main")?.textContent.trim()) told.push("has no text");
    return { told, seen };
  });
  told.forEach(report);
  return seen;
}
