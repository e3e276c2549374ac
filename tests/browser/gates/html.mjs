// The pages are valid HTML. Needs no browser.
import { HtmlValidate } from "html-validate";

export const about = "valid HTML";
export const browser = false;

const rules = new HtmlValidate({
  root: true,
  extends: ["html-validate:standard"],
  rules: {
    // Matters of style, not of validity.
    "no-inline-style": "off",
    "no-trailing-whitespace": "off",
    "attribute-boolean-style": "off",
    "attribute-empty-style": "off",
    "void-style": "off",
    "long-title": "off",
    "doctype-style": "off",
    "require-sri": "off",
    "no-implicit-button-type": "off",
    "prefer-native-element": "off",
    "no-redundant-role": "off",
    // Labels that differ by place are told by axe; lists and figures may be named.
    "aria-label-misuse": "off",
    "unique-landmark": "off",
  },
});

export async function walk({ book, report }) {
  for (const file of book.pages) {
    // Drawings are read as one element: the validator knows HTML, and their text is most of a page.
    const text = book.text(file).replace(/<svg\b[\s\S]*?<\/svg>/g, (drawing) => `<svg>${"\n".repeat(drawing.split("\n").length - 1)}</svg>`);
    const { results } = await rules.validateString(text, file);
    const told = new Map();
    for (const message of results.flatMap((result) => result.messages)) {
      const kind = `${message.ruleId}: ${message.message}`;
      if (!told.has(kind)) told.set(kind, `line ${message.line}, ${kind}`);
    }
    for (const what of told.values()) report(file, what);
  }
  return book.pages.length;
}
