// Who asks for less motion sees none: no transition, no animation, no gliding.
export const about = "no motion for readers who ask for none";
export const views = ["still"];

export async function look({ page, report }) {
  const { told, seen } = await page.evaluate(() => {
    const told = new Set();
    const longest = (times) => Math.max(...times.split(",").map((time) => parseFloat(time) * (time.trim().endsWith("ms") ? 0.001 : 1)));
    const elements = document.querySelectorAll("*");
    for (const element of elements) {
      // A stepper moves when it steps.
      for (const part of [null, "::before", "::after"]) {
        if (part && element.closest("svg")) continue;
        const style = getComputedStyle(element, part);
        const name = `${element.localName}.${element.getAttribute("class") ?? ""}${part ?? ""}`;
        if (longest(style.transitionDuration) > 0.01) told.add(`${name} has a transition of ${style.transitionDuration}`);
        if (style.animationName !== "none" && longest(style.animationDuration) > 0.01) told.add(`${name} is animated by ${style.animationName}`);
        if (!part && style.scrollBehavior === "smooth") told.add(`${name} scrolls smoothly`);
      }
    }
    return { told: [...told], seen: elements.length };
  });
  told.slice(0, 10).forEach(report);
  return seen;
}
