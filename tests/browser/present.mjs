// The gate of the slides: a walk by keys through a chapter that has a stepper, and what slides must hold on the way.
//
// `present({ page, url, report })` takes a playwright page of 1280 by 720 pixels, the address of a chapter's page, and `report(text)` for what
// is wrong. It says how many slides it has seen.

/** What the page knows of its slides. */
function state(page) {
  return page.evaluate(() => {
    const { slides, at, open, paused, step } = window.workbook.deck.state();
    return { count: slides.length, at, open, paused, step: step && step.now, steps: step && step.count, hash: location.hash };
  });
}

/** Opens the slides by their key. */
async function begin(page) {
  await page.evaluate(() => document.fonts.ready);
  await page.keyboard.press("p");
  await page.waitForSelector(".slide-now");
}

/** Whether every slide holds what is on it, at a size that can be read. */
function slidesThatFail(page) {
  return page.evaluate(() => {
    const deck = window.workbook.deck.state().slides;
    return deck.flatMap((slide, at) => {
      window.workbook.slides.fit(slide);
      const told = [];
      const name = `slide ${at + 1}, ${slide.title}`;
      if (slide.body.scrollHeight > slide.body.clientHeight + 6) told.push(`${name}: is cut off below`);
      if (slide.body.scrollWidth > slide.body.clientWidth + 1) told.push(`${name}: is cut off at its side`);
      if (Number(slide.fit.style.zoom) < 0.6) told.push(`${name}: is too small (${slide.fit.style.zoom})`);
      if (!slide.title) told.push(`${name}: has no title`);
      if (!slide.section.getAttribute("aria-label")) told.push(`${name}: has no label`);
      if (!slide.fit.textContent.trim() && !slide.fit.querySelector("svg, img")) told.push(`${name}: is empty`);
      return told;
    });
  });
}

/** The text of the page that is on no slide and in no notes. */
function lostText(page) {
  return page.evaluate(() => {
    const slides = window.workbook.deck.state().slides;
    const noted = new Set(slides.flatMap((slide) => slide.notes));
    return [...document.querySelectorAll("article.text > p:not(.fold-all)")].filter((p) => !noted.has(p)).map((p) => p.textContent.slice(0, 60));
  });
}

/** Goes forwards through all slides and steps, then back, and tells where a step or a slide was left out. */
async function walk(page, report) {
  let last = await state(page);
  const moves = { count: 0, steps: 0 };
  for (;;) {
    await page.keyboard.press(["ArrowRight", "PageDown", "n", "ArrowDown"][moves.count % 4]);
    const now = await state(page);
    if (now.at === last.at && now.step === last.step) break;
    moves.count += 1;
    const stepped = now.at === last.at && now.step === last.step + 1;
    const turned = now.at === last.at + 1 && (last.step === null || last.step === last.steps) && (now.step === null || now.step === 1);
    if (!stepped && !turned) report(`from slide ${last.at + 1}, step ${last.step}, a key led to slide ${now.at + 1}, step ${now.step}`);
    if (now.hash !== `#/${now.at + 1}`) report(`the address of slide ${now.at + 1} is ${now.hash}`);
    moves.steps += stepped ? 1 : 0;
    last = now;
  }
  if (last.at !== last.count - 1) report(`the walk ended at slide ${last.at + 1} of ${last.count}`);
  if (moves.steps === 0 && (await page.locator(".stepper").count()) > 0) report("no step of a stepper was met");
  for (let left = moves.count; left > 0; left -= 1) await page.keyboard.press(["ArrowLeft", "PageUp", "ArrowUp"][left % 3]);
  const first = await state(page);
  if (first.at !== 0) report(`${moves.count} keys back led to slide ${first.at + 1}, not to the first`);
}

/** Pause, overview, help, and the ends. */
async function otherKeys(page, report) {
  const has = (selector) => page.evaluate((what) => document.querySelector(what) !== null, selector);
  await page.keyboard.press("End");
  const end = await state(page);
  if (end.at !== end.count - 1) report("End does not lead to the last slide");
  await page.keyboard.press("Home");
  if ((await state(page)).at !== 0) report("Home does not lead to the first slide");
  for (const key of ["b", "."]) {
    await page.keyboard.press(key);
    if (!(await state(page)).paused) report(`${key} does not pause`);
    await page.keyboard.press(key);
    if ((await state(page)).paused) report(`${key} does not end the pause`);
  }
  for (const key of ["o", "Escape"]) {
    await page.keyboard.press(key);
    if (!(await has(".deck-over"))) report(`${key} does not open the overview`);
    await page.keyboard.press(key);
    if (await has(".deck-over")) report(`${key} does not close the overview`);
  }
  await page.keyboard.press("?");
  if (!(await has(".deck-keys[open]"))) report("? does not tell the keys");
  await page.keyboard.press("Escape");
  if (await has("dialog[open]")) report("Esc does not close the keys");
  if (!(await page.evaluate(() => document.activeElement.matches(".slide-now, .slide-now *")))) report("the slide has not got the focus");
}

/** The window of the speaker follows, and leads. */
async function speaker(page, report) {
  const opened = page.waitForEvent("popup", { timeout: 5000 }).catch(() => null);
  await page.keyboard.press("s");
  const view = await opened;
  if (!view) return report("the speaker's window does not open");
  const where = () => view.evaluate(() => document.querySelector(".speaker-where").textContent);
  await page.keyboard.press("ArrowRight");
  if (!(await where()).startsWith("Slide 2 of")) report(`the speaker's window does not follow: ${await where()}`);
  await view.keyboard.press("ArrowRight");
  if ((await state(page)).at !== 2) report("the speaker's window does not lead");
  const parts = await view.evaluate(() => ["now", "next", "timer", "clock"].filter((part) => !document.querySelector(`.speaker-${part}`).textContent.trim()));
  const [noted, notes] = [await page.evaluate(() => window.workbook.deck.state().slides[2].notes.length), await view.locator(".speaker-notes > *").count()];
  if (noted !== notes) report(`the speaker's window has ${notes} of ${noted} notes`);
  if (parts.length) report(`empty in the speaker's window: ${parts.join(", ")}`);
  await view.close();
}

/** Each slide is a page of its own, and steppers are at their last step. */
async function print(page, report) {
  const { count } = await state(page);
  const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
  const pages = (pdf.match(/\/Type\s*\/Page\b/g) || []).length;
  const sizes = new Set(pdf.match(/\/MediaBox\s*\[[^\]]*\]/g));
  if (pages !== count) report(`${count} slides are ${pages} pages on paper`);
  if (sizes.size !== 1 || ![...sizes][0].includes("960 540")) report(`pages of slides are of the sizes ${[...sizes].join(", ")}`);
}

export async function present({ page, url, report }) {
  await page.goto(url);
  const before = await page.evaluate(() => ({ text: document.querySelector("article.text").textContent, ids: document.querySelectorAll("[id]").length }));
  await begin(page);
  (await slidesThatFail(page)).forEach(report);
  (await lostText(page)).forEach((text) => report(`neither on a slide nor in its notes: ${text}`));
  await walk(page, report);
  await otherKeys(page, report);
  await speaker(page, report);
  await print(page, report);
  const { count } = await state(page);
  await page.keyboard.press("Home");
  await page.keyboard.press("q");
  const after = await page.evaluate(() => ({ text: document.querySelector("article.text").textContent, ids: document.querySelectorAll("[id]").length, decks: document.querySelectorAll(".deck").length, hash: location.hash }));
  if (after.decks || after.hash) report("leaving leaves something behind");
  if (after.ids !== before.ids || after.text.length < before.text.length) report("leaving does not give the page back as it was");
  await page.goto("about:blank");
  await page.goto(`${url}#/3`);
  await page.waitForSelector(".slide-now");
  if ((await state(page)).at !== 2) report("the address #/3 does not lead to the third slide");
  return count;
}
