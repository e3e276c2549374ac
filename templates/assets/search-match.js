// What a question finds: the index read into words, words compared (whole, by their beginning, with a slip), and what is found put in order.
// No part of the page is touched here, so that it can be tested without one: `require` gives `index`, which a page has as `workbook.search.index`.
(function () {
  "use strict";
  var LETTERS = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  var HALF = 31;
  // What a word is worth by where it stands: title > heading > term > caption > text.
  var TITLES = {
    Chapter: 100, Appendix: 100, Catalogue: 90, Section: 80, Sampler: 75, Scramble: 75, Integrand: 75, Measure: 75, Scene: 75, Term: 70, Definition: 65,
    Exercise: 45, Page: 60, Figure: 40, Table: 40, Listing: 40, "Kind of experiment": 35
  };
  var LABEL = 45, MORE = 22, TEXT = 12;
  // The sections of the text, in the order in which the words count them.
  function hasText(entry) { return entry.kind === "Section" || (!entry.id && entry.kind !== "Page"); }

  var PLAIN = { "ß": "ss", "ø": "o", "ł": "l", "æ": "ae", "œ": "oe", "đ": "d", "ı": "i" };

  function fold(text) {
    return text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "").replace(/[ßøłæœđı]/g, function (letter) { return PLAIN[letter]; });
  }

  // Runs of letters and digits; a number keeps its points, so that 3.2 is one word.
  function words(text) {
    return fold(text).match(/[\p{L}\p{N}]+(?:\.\p{N}+)*/gu) || [];
  }

  // The words and their sections, as the build wrote them: see `posts.rs`.
  function unpack(data, see) {
    var posts = data.posts.split(" ");
    var before = "";
    data.words.split(" ").forEach(function (coded, at) {
      if (!coded) return;
      before = Array.from(before).slice(0, LETTERS.indexOf(coded[0])).join("") + coded.slice(1);
      var section = 0, value = 0, scale = 1;
      Array.from(posts[at] || "").forEach(function (letter) {
        var digit = LETTERS.indexOf(letter);
        value += (digit % HALF) * scale;
        scale *= HALF;
        if (digit >= HALF) return;
        section += value;
        see(before, section);
        value = 0;
        scale = 1;
      });
    });
  }

  // How many letters of `asked` are wrong, missing, too many or exchanged with the next, against `word`: as a whole, and as its beginning.
  // Both are more than `most` as soon as that is certain.
  function slips(asked, word, most) {
    var beyond = { whole: most + 1, beginning: most + 1 };
    if (asked.length - word.length > most) return beyond;
    var older = [], old = [], row = [];
    for (var j = 0; j <= word.length; j++) old[j] = j;
    for (var i = 1; i <= asked.length; i++) {
      row = [i];
      var least = i;
      for (j = 1; j <= word.length; j++) {
        var same = asked[i - 1] === word[j - 1] ? 0 : 1;
        var cost = Math.min(old[j] + 1, row[j - 1] + 1, old[j - 1] + same);
        if (i > 1 && j > 1 && asked[i - 1] === word[j - 2] && asked[i - 2] === word[j - 1]) cost = Math.min(cost, older[j - 2] + 1);
        row[j] = cost;
        if (cost < least) least = cost;
      }
      if (least > most) return beyond;
      older = old;
      old = row;
    }
    return { whole: old[word.length], beginning: Math.min.apply(null, old) };
  }

  function allowed(length) { return length < 4 ? 0 : length < 8 ? 1 : 2; }

  // How well a word answers: 1 if it is the word, less if it only begins so.
  function begins(asked, word) {
    if (word === asked) return 1;
    return word.startsWith(asked) ? 0.55 + 0.35 * asked.length / word.length : 0;
  }

  function nearly(asked, word) {
    var most = allowed(asked.length);
    if (!most) return 0;
    var found = slips(asked, word, most);
    if (found.whole <= most) return 0.6 - 0.15 * found.whole;
    return asked.length > 4 && found.beginning <= most ? 0.45 - 0.15 * found.beginning : 0;
  }

  function index(data) {
    var entries = data.entries.map(function (row) {
      return { kind: data.kinds[row[0]], page: data.pages[row[1]], id: row[2] || "", number: row[3] || "", title: row[4] || "", more: row[5] || "" };
    });
    var common = new Set(data.common.split(" "));
    // Each word with what it is worth to each entry.
    var known = new Map();
    function enter(word, entry, worth) {
      var worths = known.get(word);
      if (!worths) known.set(word, worths = new Map());
      if (!(worths.get(entry) >= worth)) worths.set(entry, worth);
    }
    entries.forEach(function (entry, at) {
      words(entry.title).forEach(function (word) { enter(word, at, TITLES[entry.kind] || LABEL); });
      words(entry.kind + " " + entry.number).forEach(function (word) { if (entry.number) enter(word, at, LABEL); });
      words(entry.more).forEach(function (word) { enter(word, at, MORE); });
    });
    var written = [];
    entries.forEach(function (entry, at) { if (hasText(entry)) written.push(at); });
    unpack(data, function (word, section) { if (section < written.length) enter(word, written[section], TEXT); });

    // The entries that a word finds, each with its worth and the words that were meant.
    function answer(asked) {
      var found = new Map();
      [begins, nearly].some(function (compare) {
        known.forEach(function (worths, word) {
          var quality = compare(asked, word);
          if (quality) worths.forEach(function (worth, at) {
            var one = found.get(at) || { worth: 0, words: [] };
            one.worth = Math.max(one.worth, worth * quality);
            one.words.push(word);
            found.set(at, one);
          });
        });
        return found.size > 0;
      });
      return found;
    }

    // What is found, the best first; `whole` says whether it has every word that was asked for.
    function find(question) {
      var asked = words(question);
      var rare = asked.filter(function (word) { return !common.has(word); });
      var needed = rare.length ? rare : asked;
      var answers = asked.map(answer);
      var scores = new Map();
      answers.forEach(function (found, at) {
        found.forEach(function (one, entry) {
          var score = scores.get(entry) || { worth: 0, count: 0, words: [] };
          score.worth += one.worth;
          score.count += needed.indexOf(asked[at]) >= 0 ? 1 : 0;
          score.words = score.words.concat(one.words);
          scores.set(entry, score);
        });
      });
      var most = 0;
      scores.forEach(function (score) { most = Math.max(most, score.count); });
      var phrase = asked.join(" ");
      var results = [];
      scores.forEach(function (score, at) {
        if (score.count < most || !most) return;
        var title = words(entries[at].title).join(" ");
        var bonus = title === phrase ? 40 : title.startsWith(phrase + " ") ? 15 : (" " + title + " ").indexOf(" " + phrase + " ") >= 0 ? 8 : 0;
        results.push({ entry: entries[at], worth: score.worth + bonus, words: new Set(score.words), at: at });
      });
      results.sort(function (a, b) { return b.worth - a.worth || a.at - b.at; });
      return { results: results, whole: most === needed.length };
    }

    // The chapter of a page, for the line that says where something stands.
    function chapter(page) {
      return entries.find(function (entry) { return entry.page === page && !entry.id; });
    }
    return { find: find, chapter: chapter, entries: entries, vocabulary: known.size };
  }

  // A text cut into pieces, those that are among the words that were meant marked.
  function marked(text, meant) {
    var pieces = [], last = 0;
    var pattern = /[\p{L}\p{N}\p{M}]+(?:\.\p{N}+)*/gu, match;
    while ((match = pattern.exec(text))) {
      if (!meant.has(fold(match[0]))) continue;
      if (match.index > last) pieces.push({ text: text.slice(last, match.index), mark: false });
      pieces.push({ text: match[0], mark: true });
      last = match.index + match[0].length;
    }
    if (last < text.length) pieces.push({ text: text.slice(last), mark: false });
    return pieces;
  }

  var parts = { hasText: hasText, index: index, unpack: unpack, marked: marked, words: words, slips: slips };
  if (typeof module === "object" && module.exports) module.exports = parts;
  else Object.assign(workbook.search, parts);
})();
