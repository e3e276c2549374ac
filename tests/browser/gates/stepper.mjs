// A figure with steps by keyboard alone: its controls in order, every step shown and told, its ends, playing, and links to a step.
export const about = "keyboard walk of the steppers";

export async function walk({ book, each, open, visit, report }) {
  const files = book.pages.filter((file) => book.text(file).includes('<div class="stepper"')).slice(0, 4);
  if (!files.length) return "skipped";
  let steps = 0;
  await each(files, async (file) => {
    const { page } = await open("wide", file);
    const figures = await page.evaluate(() => [...document.querySelectorAll(".exhibit:has(.stepper)")].map((figure) => figure.id));
    for (const id of figures) steps += await figure(page, id, (what) => report(file, `${id}: ${what}`));
    const last = figures[figures.length - 1];
    await visit(page, "about:blank");
    await visit(page, `${book.url(file)}#${last}:step=2`);
    // The way there may glide.
    await page.waitForFunction((id) => { const box = document.getElementById(id).getBoundingClientRect(); return box.bottom > 0 && box.top < innerHeight; }, last, { timeout: 3000 }).catch(() => {});
    const linked = await state(page, last);
    if (linked.step !== 2) report(file, `the link #${last}:step=2 leads to step ${linked.step}`);
    if (!linked.inView) report(file, `the link #${last}:step=2 does not lead to its figure`);
  });
  return steps;
}

function state(page, id) {
  return page.evaluate((id) => {
    const figure = document.getElementById(id);
    const box = figure.getBoundingClientRect();
    return {
      step: Number(figure.querySelector(".step-slider").value),
      count: Number(figure.querySelector(".stepper").dataset.count),
      text: figure.querySelector(".step-spoken")?.textContent,
      live: figure.querySelector(".step-spoken")?.getAttribute("aria-live"),
      value: figure.querySelector(".step-slider").getAttribute("aria-valuetext"),
      shown: [...figure.querySelectorAll(".exhibit-body [data-steps]")].map((group) => group.dataset.on).join("") + [...figure.querySelectorAll("[data-at]")].map((mover) => mover.style.getPropertyValue("--at")).join(),
      focus: document.activeElement.className,
      inView: box.bottom > 0 && box.top < innerHeight,
    };
  }, id);
}

async function figure(page, id, report) {
  await page.evaluate((id) => {
    for (let fold = document.getElementById(id).closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
    document.querySelector(`[id="${id}"] .step-play`).focus();
  }, id);
  const first = await state(page, id);
  if (first.step !== 1) report(`begins at step ${first.step}`);
  if (first.live !== "polite") report("does not tell its steps to screen readers");
  const order = [first.focus];
  for (let i = 0; i < 3; i += 1) {
    await page.keyboard.press("Tab");
    order.push((await state(page, id)).focus);
  }
  if (order.map((name) => name.replace(/ .*/, "")).join() !== "step-play,step-next,step-slider,step-count") report(`Tab leads through ${order.join(", ")}`);
  await page.keyboard.press("Shift+Tab");
  const drawn = new Set([first.shown]);
  for (let step = 2; step <= first.count; step += 1) {
    await page.keyboard.press("ArrowRight");
    const now = await state(page, id);
    if (now.step !== step) { report(`ArrowRight leads to step ${now.step}, not to ${step}`); break; }
    if (!now.text?.trim()) report(`step ${step} is not told`);
    if (!now.value?.startsWith(`Step ${step} of`)) report(`the slider says ${now.value} at step ${step}`);
    drawn.add(now.shown);
  }
  // Steps in which only the caption changes are allowed, but a figure all of them alike is none.
  if (drawn.size < 2) report("draws the same at every step");
  await page.keyboard.press("Home");
  if ((await state(page, id)).step !== 1) report("Home does not lead to the first step");
  await page.keyboard.press("End");
  const end = await state(page, id);
  if (end.step !== end.count) report("End does not lead to the last step");
  await page.keyboard.press("ArrowLeft");
  if ((await state(page, id)).step !== end.count - 1) report("ArrowLeft does not lead back");
  await page.evaluate((id) => document.querySelector(`[id="${id}"] .step-play`).focus(), id);
  await page.keyboard.press("Enter");
  const played = await state(page, id);
  if (played.step !== end.count) report(`playing from the step before the last leads to ${played.step}`);
  return end.count;
}
