// Nothing moves while a page loads.
export const about = "no layout shift while a page loads";
export const views = ["wide", "narrow"];

export async function look({ page, report }) {
  const shifts = await page.evaluate(async () => {
    for (let frame = 0; frame < 6; frame += 1) await new Promise(requestAnimationFrame);
    return window.keptShifts;
  });
  const sum = shifts.reduce((all, shift) => all + shift.value, 0);
  if (sum > 0.0005) report(`shifts by ${sum.toFixed(4)}: ${shifts.map((shift) => `${shift.value.toFixed(4)} ${shift.what.join(", ")}`).slice(0, 4).join("; ")}`);
  return shifts.length;
}
