// Text in drawings stands out from what is painted behind it; axe reads only the text of HTML.
export const about = "text in drawings has a contrast of 4.5 (3 where it is large), light and dark";
export const views = ["wide", "dark"];

export async function look({ page, report }) {
  const { told, seen } = await page.evaluate(() => {
    const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const known = new Map();
    const rgba = (colour) => {
      if (!known.has(colour)) {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = "#000";
        canvas.fillStyle = colour;
        canvas.fillRect(0, 0, 1, 1);
        const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
        known.set(colour, [r, g, b, a / 255]);
      }
      return known.get(colour);
    };
    const over = (top, below) => top.slice(0, 3).map((value, at) => value * top[3] + below[at] * (1 - top[3])).concat(1);
    const luminance = (colour) => {
      const [r, g, b] = colour.map((value) => (value / 255 <= 0.03928 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (a, b) => {
      const [x, y] = [luminance(a), luminance(b)];
      return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
    };
    // What is painted behind a text: shapes that come before it and hold its middle, and the backgrounds around the drawing.
    const shapes = new Map();
    const shapesOf = (svg) => {
      if (!shapes.has(svg)) {
        const list = [...svg.querySelectorAll("rect, path, circle, polygon, ellipse")].map((shape) => ({ shape, style: getComputedStyle(shape), box: shape.getBoundingClientRect() }));
        shapes.set(svg, list.filter(({ style, box }) => style.fill !== "none" && style.display !== "none" && Number(style.opacity) * Number(style.fillOpacity) > 0.02 && box.width * box.height > 60));
      }
      return shapes.get(svg);
    };
    const layers = (element, x, y) => {
      const found = [];
      for (const { shape, style, box } of shapesOf(element.ownerSVGElement)) {
        if (!(shape.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING)) continue;
        if (x < box.left || x > box.right || y < box.top || y > box.bottom) continue;
        const at = new DOMPoint(x, y).matrixTransform(shape.getScreenCTM().inverse());
        if (!shape.isPointInFill(at)) continue;
        const [r, g, b, a] = rgba(style.fill);
        found.push([r, g, b, a * Number(style.opacity) * Number(style.fillOpacity)]);
      }
      return found;
    };
    const around = (svg) => {
      const found = [];
      for (let box = svg; box; box = box.parentElement) found.unshift(rgba(getComputedStyle(box).backgroundColor));
      return found.reduce((below, colour) => over(colour, below), [255, 255, 255, 1]);
    };
    const told = new Map();
    let seen = 0;
    for (const svg of document.querySelectorAll("main svg")) {
      if (!svg.checkVisibility()) continue;
      const ground = around(svg);
      for (const text of svg.querySelectorAll("text")) {
        const box = text.getBoundingClientRect();
        if (!box.width || !text.textContent.trim() || !text.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
        const style = getComputedStyle(text);
        const behind = layers(text, box.left + box.width / 2, box.top + box.height / 2).reduce((below, colour) => over(colour, below), ground);
        const [r, g, b, a] = rgba(style.fill);
        const ink = over([r, g, b, a * Number(style.fillOpacity)], behind);
        const scale = Math.abs(text.getScreenCTM().a) || 1;
        const size = parseFloat(style.fontSize) * scale;
        const least = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
        // A halo in the colour of the page parts the text from what is behind it.
        const halo = style.paintOrder.startsWith("stroke") && style.stroke !== "none" ? contrast(ink, over(rgba(style.stroke), behind)) : 0;
        const value = Math.max(contrast(ink, behind), halo);
        seen += 1;
        if (value < least) {
          const key = `${style.fill} on ${behind.slice(0, 3).map(Math.round)}`;
          if (!told.has(key)) told.set(key, { value, where: text.closest("[id]")?.id, text: text.textContent.slice(0, 30), count: 0 });
          told.get(key).count += 1;
        }
      }
    }
    return { seen, told: [...told].map(([key, one]) => `${key} is ${one.value.toFixed(2)}, ${one.count} times, first "${one.text}" in ${one.where}`) };
  });
  told.forEach(report);
  return seen;
}
