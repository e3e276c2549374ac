// The logic of the search, tested without a browser: `node tests/browser/search-match.mjs [BOOK]`. With the folder of this course's book
// it also asks the index that was built.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const require = createRequire(import.meta.url);
const { index, marked, words, slips, unpack } = require("../../templates/assets/search-match.js");

// An index as the build writes one: four sections, of which the first is the chapter.
const small = index({
  pages: ["strata.html", "terms.html"],
  kinds: ["Chapter", "Section", "Figure", "Term", "Sampler"],
  entries: [
    [0, 0, "", "3", "Stratification", "Cells of equal volume."],
    [1, 0, "sec-jitter", "3.1", "Jittered sampling"],
    [2, 0, "fig-jitter", "3.1", "Jittered points and Sobol’s, with strata", "jittered sobol"],
    [3, 0, "term-stratum", "", "stratum"],
    [1, 0, "sec-nets", "3.2", "Nets of Grünschloß"],
    [1, 0, "sec-last", "3.2.1", "What remains"],
    [4, 0, "fig-jitter", "", "Sobol’ sequence", "sobol: points"],
  ],
  words: "0haltom 5n 0sobol 1trata 5um",
  posts: "0 12 2 03 02",
  common: "of the",
});
const titles = (question) => small.find(question).results.map((result) => result.entry.title);
const first = (question) => titles(question)[0];

const tests = {
  "words are folded and numbers keep their points"() {
    assert.deepEqual(words("Grünschloß’ Figure 3.2, (0,2)-nets"), ["grunschloss", "figure", "3.2", "0", "2", "nets"]);
  },
  "posts are read as they were written"() {
    // Section 0 and 3 of the text are the chapter and the last section.
    assert.deepEqual(titles("halton"), ["Jittered sampling", "What remains"]);
    assert.deepEqual(new Set(titles("strata")), new Set(["Jittered points and Sobol’s, with strata", "Stratification", "What remains"]));
  },
  "large differences take more letters"() {
    const sections = [];
    unpack({ words: "0a", posts: "0uv1C3Dw1" }, (word, section) => sections.push(section));
    assert.deepEqual(sections, [0, 30, 61, 161, 1161]);
  },
  "slips are counted, exchanged neighbours as one"() {
    assert.deepEqual(slips("halotn", "halton", 1), { whole: 1, beginning: 1 });
    assert.deepEqual(slips("stratificaton", "stratification", 2), { whole: 1, beginning: 1 });
    assert.equal(slips("strtif", "stratification", 1).beginning, 1);
    assert.equal(slips("abcdef", "uvwxyz", 2).whole, 3);
    assert.equal(slips("longerword", "word", 2).whole, 3);
  },
  "a title goes before a heading, a term, a caption and the text"() {
    assert.equal(first("strat"), "Stratification");
    assert.deepEqual(titles("jittered").slice(0, 2), ["Jittered sampling", "Jittered points and Sobol’s, with strata"]);
    assert.equal(first("sobol"), "Sobol’ sequence");
    assert.equal(first("stratum"), "stratum");
  },
  "every beginning of a word finds it"() {
    for (let length = 1; length <= "stratification".length; length++) {
      assert.ok(titles("stratification".slice(0, length)).includes("Stratification"), `${length} letters`);
    }
  },
  "slips of the pen are forgiven, in short words less"() {
    assert.equal(first("stratifcation"), "Stratification");
    assert.equal(first("jiterred"), "Jittered sampling");
    assert.equal(first("soobl"), "Sobol’ sequence");
    assert.deepEqual(titles("xyz"), []);
    assert.deepEqual(titles("zzzzzzzzz"), []);
    // What is there as it was asked is not mixed with what only resembles it.
    assert.deepEqual(titles("haltom"), ["Stratification"]);
    assert.ok(!titles("halton").includes("Stratification"));
  },
  "all words are asked for, and that there is none with all is told"() {
    assert.deepEqual(titles("jittered strata"), ["Jittered points and Sobol’s, with strata"]);
    assert.equal(small.find("jittered strata").whole, true);
    const none = small.find("jittered volume");
    assert.equal(none.whole, false);
    assert.ok(none.results.length > 1);
  },
  "numbers name what they number"() {
    assert.equal(first("figure 3.1"), "Jittered points and Sobol’s, with strata");
    assert.equal(first("section 3.2.1"), "What remains");
  },
  "words that say nothing are not required"() {
    assert.equal(first("the nets of grunschloss"), "Nets of Grünschloß");
    assert.equal(small.find("the stratum").whole, true);
  },
  "an empty question finds nothing"() {
    assert.deepEqual(titles(""), []);
    assert.deepEqual(titles("  ,;"), []);
  },
  "what was meant is marked, and the text stays"() {
    const pieces = marked("Nets of Grünschloß, nets", new Set(["grunschloss", "nets"]));
    assert.deepEqual(pieces.filter((piece) => piece.mark).map((piece) => piece.text), ["Nets", "Grünschloß", "nets"]);
    assert.equal(pieces.map((piece) => piece.text).join(""), "Nets of Grünschloß, nets");
  },
};

const book = process.argv[2];
if (book) {
  tests["the course's index answers what readers ask"] = () => {
    let data = null;
    globalThis.workbook = { search: { load: (loaded) => { data = loaded; } } };
    (0, eval)(readFileSync(join(book, "assets/search-index.js"), "utf8"));
    const course = index(data);
    const start = performance.now();
    for (const [question, kind, part] of [
      ["stratification", "Chapter", /stratif/i],
      ["stratifcation", "Chapter", /stratif/i],
      ["koksma", "", /koksma/i],
      ["halotn", "", /halton/i],
      ["owen", "", /owen/i],
      ["radical inverse", "", /radical/i],
      // Who asks by the very name of a sampler gets it, before the chapter that is called after it.
      ["latin hypercube", "Sampler", /^latin hypercube/i],
      ["latin hypercubes", "Chapter", /latin/i],
      ["figure 3.2", "Figure", /./],
    ]) {
      const [best] = course.find(question).results;
      assert.ok(best, question);
      assert.ok(!kind || best.entry.kind === kind, `${question}: ${best.entry.kind} ${best.entry.title}`);
      assert.match(best.entry.title + best.entry.more, part, question);
    }
    console.log(`   ${course.entries.length} entries, ${course.vocabulary} words, 8 questions in ${(performance.now() - start).toFixed(0)} ms`);
  };
}

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    test();
    console.log(`ok ${name}`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED ${name}\n   ${error.message}`);
  }
}
console.log(`${Object.keys(tests).length - failed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
