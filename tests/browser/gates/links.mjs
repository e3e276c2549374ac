// Every link within the book leads to a page and a place that are there, also those that scripts make; ids are unique.
export const about = "links lead somewhere, ids are unique";
export const views = ["wide", "plain"];

const ids = new Map();
function idsOf(book, file) {
  const key = `${book.root} ${file}`;
  if (!ids.has(key)) ids.set(key, new Set([...book.text(file).matchAll(/\sid="([^"]*)"/g)].map((match) => match[1])));
  return ids.get(key);
}

export async function look({ page, book, file, report }) {
  const { links, twice } = await page.evaluate(() => {
    const links = [...document.querySelectorAll("a[href], link[href]:not([rel=canonical]), area[href]")].map((link) => link.getAttribute("href"));
    const seen = new Set(), twice = new Set();
    document.querySelectorAll("[id]").forEach((element) => (seen.has(element.id) ? twice : seen).add(element.id));
    return { links: [...new Set(links)], twice: [...twice] };
  });
  for (const id of twice) report(`the id ${id} is there more than once`);
  for (const link of links) {
    if (/^(https?|mailto|data|javascript):/.test(link)) {
      if (link.startsWith("javascript:")) report(`a link runs a script: ${link}`);
      continue;
    }
    const [path, hash] = link.split("#");
    const target = decodeURIComponent(path.split("?")[0]) || file;
    if (!book.has(target)) { report(`the link ${link} leads to no file`); continue; }
    const place = hash && decodeURIComponent(hash).replace(/:step=\d+$/, "");
    if (place && target.endsWith(".html") && book.text(target) !== undefined && !idsOf(book, target).has(place)) report(`the link ${link} leads to no place`);
  }
  return links.length;
}
