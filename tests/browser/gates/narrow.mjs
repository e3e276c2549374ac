// At 320 pixels, and at 200 %, a page does not scroll sideways, and nothing that cannot be scrolled to is cut off.
export const about = "no overflow at 320 px and at 200 %";
export const views = ["narrow", "zoomed"];

export async function look({ page, report }) {
  const { wide, window: room, out } = await page.evaluate(() => {
    const room = document.documentElement.clientWidth;
    // What a box of its own scrolls or hides on purpose does not widen the page.
    const held = (element) => {
      for (let box = element.parentElement; box && box !== document.body; box = box.parentElement) {
        if (["auto", "scroll", "hidden", "clip"].includes(getComputedStyle(box).overflowX) && box.getBoundingClientRect().right <= room + 1) return true;
      }
      return false;
    };
    const out = [];
    for (const element of document.body.querySelectorAll("*")) {
      if (element.closest("svg") && element.localName !== "svg") continue;
      const box = element.getBoundingClientRect();
      if (!box.width || !box.height || (box.right <= room + 1 && box.left >= -1)) continue;
      const style = getComputedStyle(element);
      if (style.position === "fixed" || (style.position === "absolute" && box.right < 0) || style.visibility === "hidden" || element.closest("[aria-hidden=true], .skip, .unseen")) continue;
      if (held(element) || out.some((other) => other.element.contains(element))) continue;
      out.push({ element, told: `${element.localName}${element.id ? `#${element.id}` : ""}${element.classList.length ? `.${[...element.classList].join(".")}` : ""} reaches from ${Math.round(box.left)} to ${Math.round(box.right)} px: ${element.textContent.trim().slice(0, 40)}` });
    }
    return { wide: document.documentElement.scrollWidth, window: room, out: out.map((one) => one.told) };
  });
  if (wide > room) report(`is ${wide} px wide in a window of ${room} px`);
  out.slice(0, 8).forEach(report);
  return 1;
}
