// Every character is in a face of the book: none falls back to what the reader's machine has, or to an empty box.
export const about = "every character is in the faces of the book";

export const views = ["wide"];

/** By book, the characters of each style of type, and where each was seen first. */
const characters = new WeakMap();

export async function look({ page, file, book }) {
  if (!characters.has(book)) characters.set(book, new Map());
  const styles = characters.get(book);
  const found = await page.evaluate(() => {
    const styles = {};
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const known = new Map();
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (!walker.currentNode.data.trim() || parent.closest("script, style, title, desc, template")) continue;
      if (!known.has(parent)) {
        const style = getComputedStyle(parent);
        known.set(parent, JSON.stringify([style.fontFamily, style.fontWeight, style.fontStyle, parent.namespaceURI.endsWith("MathML") ? style.mathStyle : "", style.fontVariantCaps]));
      }
      const set = (styles[known.get(parent)] ??= new Set());
      for (const character of walker.currentNode.data) if (!/\s/.test(character)) set.add(character);
    }
    return Object.entries(styles).map(([style, set]) => [style, [...set].join("")]);
  });
  for (const [style, text] of found) {
    if (!styles.has(style)) styles.set(style, new Map());
    for (const character of text) if (!styles.get(style).has(character)) styles.get(style).set(character, file);
  }
}

export async function walk({ book, open, report }) {
  const styles = characters.get(book) ?? new Map();
  const { page } = await open("wide", "index.html");
  const session = await page.context().newCDPSession(page);
  // Written anew, one element a character, on a page with the same faces.
  const fonts = async (style, characters) => {
    await page.evaluate(async ({ style, characters }) => {
      const [family, weight, slant] = JSON.parse(style);
      document.body.innerHTML = "<div id=probes></div>";
      const holder = document.getElementById("probes");
      Object.assign(holder.style, { fontFamily: family, fontWeight: weight, fontStyle: slant });
      holder.textContent = characters;
      await document.fonts.ready;
      await new Promise((told) => requestAnimationFrame(() => requestAnimationFrame(told)));
      await document.fonts.ready;
    }, { style, characters });
    const { root } = await session.send("DOM.getDocument", { depth: 0 });
    const { nodeId } = await session.send("DOM.querySelector", { nodeId: root.nodeId, selector: "#probes" });
    return (await session.send("CSS.getPlatformFontsForNode", { nodeId })).fonts;
  };
  await session.send("DOM.enable");
  await session.send("CSS.enable");
  let seen = 0;
  for (const [style, characters] of styles) {
    // What not even the machine has is drawn as the first face draws a character that does not exist.
    for (const character of await boxes(page, style, [...characters.keys()])) report(characters.get(character), `${named(character)} is in no face: ${JSON.parse(style)[0].split(",")[0]} draws an empty box`);
    const strangers = async (list) => {
      const used = await fonts(style, list.join(" "));
      if (used.every((font) => font.isCustomFont)) return [];
      if (list.length === 1) return [[list[0], used.find((font) => !font.isCustomFont).familyName]];
      const half = list.length >> 1;
      return [...(await strangers(list.slice(0, half))), ...(await strangers(list.slice(half)))];
    };
    const list = [...characters.keys()].sort();
    seen += list.length;
    for (const [character, font] of await strangers(list)) {
      const [family, weight, slant] = JSON.parse(style);
      report(characters.get(character), `${named(character)} is not in ${family.split(",")[0]} ${weight} ${slant}; the machine's ${font} stands in`);
    }
  }
  return seen;
}

const named = (character) => `${character} (U+${character.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")})`;

function boxes(page, style, characters) {
  return page.evaluate(({ style, characters }) => {
    const [family, weight, slant] = JSON.parse(style);
    const canvas = Object.assign(document.createElement("canvas"), { width: 64, height: 64 });
    const ink = canvas.getContext("2d", { willReadFrequently: true });
    ink.font = `${slant} ${weight} 32px ${family}`;
    const drawn = (character) => {
      ink.clearRect(0, 0, 64, 64);
      ink.fillText(character, 8, 44);
      return ink.getImageData(0, 0, 64, 64).data.join();
    };
    const none = drawn("\u0378");
    return characters.filter((character) => drawn(character) === none);
  }, { style, characters });
}
