// Slides from the page: which of its blocks stand on which slide, and which go to the speaker's notes. `deck.js` shows them.
//
// Headings give titles. Exhibits, listings and exercises have slides of their own; between them stand definitions, equations and lists, with
// the first sentence of each paragraph and those that define or stress something. Whole paragraphs go to the notes. Marks of the author,
// `[!SLIDE]` and `[!NOTES]`, go before these rules. What is shown moves to its slide, and back when the slides are closed.
(function () {
  "use strict";
  var workbook = window.workbook = window.workbook || {};
  var SHORT = 140;  // a second sentence is shown if both are not longer than this
  var LEAD = 230;   // text that is not longer than this stands above the exhibit that follows it
  var BELOW = 170;  // and text that is not longer than this below it, if it is a drawing
  var WHOLE = 330;  // paragraphs of bugs that are not longer than this are shown whole
  var LINES = 12;   // longer listings stand alone,
  var ROWS = 8;     // and longer tables,
  var PICTURES = 3; // and more pictures than that
  var SMALL = 0.65; // a table that would have to be smaller than this goes on to another slide
  var NO_TEXT = ".permalink, .footnote-reference, .side-note";

  function list(things) { return Array.prototype.slice.call(things); }

  function make(name, kind, parent) {
    var made = document.createElement(name);
    made.className = kind;
    if (parent) parent.appendChild(made);
    return made;
  }

  // What a copy shows: no ids, since the page has them, and nothing that is only for reading.
  function bare(root) {
    list(root.querySelectorAll("[id]")).forEach(function (node) { node.removeAttribute("id"); });
    list(root.querySelectorAll(NO_TEXT)).forEach(function (node) { node.remove(); });
    return root;
  }

  function copy(node) {
    var range = document.createRange();
    range.selectNodeContents(node);
    return bare(range.cloneContents());
  }

  function length(fragment) {
    var text = 0;
    list(fragment.childNodes).forEach(function (node) {
      // A formula is about as wide as half of its text, which has its source too.
      text += node.nodeName === "math" ? node.textContent.length / 2 : node.textContent.length;
    });
    return text;
  }

  // The sentences of a paragraph, each a fragment. A full stop ends one before a space and a capital, a formula or an element.
  function sentences(paragraph) {
    var walker = document.createTreeWalker(paragraph, NodeFilter.SHOW_TEXT);
    var start = document.createRange(), found = [], node, stop;
    start.selectNodeContents(paragraph);
    var whole = start.cloneRange();
    function cut(set) {
      var range = start.cloneRange();
      set(range);
      var fragment = bare(range.cloneContents());
      if (fragment.textContent.trim()) found.push(fragment);
      start.setStart(range.endContainer, range.endOffset);
    }
    while ((node = walker.nextNode())) {
      if (node.parentElement.closest("math, code, .label, " + NO_TEXT)) continue;
      var stops = /[.!?][”’)]*/g;
      while ((stop = stops.exec(node.data))) {
        var end = stop.index + stop[0].length, after = node.data.slice(end);
        if (/(^|[\s(])(e\.g|i\.e|cf|vs|al|pp?|No|St|Dr|[A-Z])$/.test(node.data.slice(0, stop.index))) continue;
        if (!/^\s+([\p{Lu}“‘(\d]|$)/u.test(after)) continue;
        cut(function (range) { range.setEnd(node, end); });
      }
    }
    cut(function (range) { range.setEnd(whole.endContainer, whole.endOffset); });
    return found;
  }

  // Keeps formulas with what touches them behind; the joiners of the page are not enough where the line is scaled.
  function keep(node) {
    list(node.querySelectorAll("math:not([display=block]), .value")).forEach(function (part) {
      var text = part.nextSibling, touching = text && text.nodeType === 3 && /^[^\s]+/.exec(text.data);
      if (!touching || touching[0].length > 4) return;
      var whole = make("span", "slide-whole");
      part.before(whole);
      whole.append(part, touching[0]);
      text.data = text.data.slice(touching[0].length);
    });
  }

  // What a slide shows of a paragraph: paragraphs of neighbouring sentences.
  function points(paragraph, whole) {
    var all = sentences(paragraph), shown = [];
    var open = !/[.!?][”’)]*$/.test(paragraph.textContent.trim()); // it leads on to what follows
    var sizes = all.map(length), sum = sizes.reduce(function (a, b) { return a + b; }, 0);
    all.forEach(function (sentence, at) {
      if (!/[\p{L}\d]/u.test(sentence.textContent)) return; // such as the box at the end of a proof
      var shows = at === 0 || sum <= whole || sentence.querySelector("dfn, strong") || (open && at === all.length - 1) ||
        (at === 1 && sizes[0] + sizes[1] <= SHORT);
      if (!shows) return;
      var point = shown.length && shown[shown.length - 1].last === at - 1 ? shown[shown.length - 1] : null;
      if (!point) shown.push(point = { node: make("p", "point"), size: 0 });
      point.node.append(point.size ? " " : "", sentence);
      point.last = at;
      point.size += sizes[at];
    });
    shown.forEach(function (point, at) {
      keep(point.node);
      point.leads = open && at === shown.length - 1;
      if (/^\s*[a-z]/.test(point.node.textContent)) point.node.className = "point point-on";
    });
    return shown;
  }

  // Whether the slide holds more than it has room for; accents and roots may reach a little below their line.
  function over(slide) {
    if (slide.body.scrollHeight > slide.body.clientHeight + 6 || slide.body.scrollWidth > slide.body.clientWidth + 1) return true;
    return list(slide.fit.querySelectorAll("pre, .table-wrap, .exhibit-body, math[display=block]")).some(function (box) {
      return box.scrollWidth > box.clientWidth + 1;
    });
  }

  // A formula that is too wide for the slide is made smaller by itself, and not all that stands around it.
  function narrow(slide) {
    list(slide.fit.querySelectorAll("math[display=block]")).forEach(function (math) {
      for (var part = 0.95; part > 0.6 && math.scrollWidth > math.clientWidth + 1; part -= 0.05) math.style.fontSize = part.toFixed(2) + "em";
    });
  }

  // The largest of the sizes at which the slide holds all that is on it.
  function size(slide, most) {
    var least = 0.3;
    for (var zoom = most; zoom > least; zoom -= zoom > 1.5 ? 0.1 : 0.05) {
      slide.fit.style.zoom = zoom.toFixed(2);
      if (zoom <= 1) narrow(slide);
      if (!over(slide)) return;
    }
  }

  // How many letters stand in what is pending; blocks are too large to stand beside an exhibit.
  function weight(items) {
    return items.reduce(function (sum, item) { return sum + (item.block ? LEAD + 1 : item.node.textContent.length); }, 0);
  }

  var MOST = { text: 1.2, code: 1.25, table: 1.3, pictures: 3, figure: 1, opening: 1 };

  // Gives a slide its size, when it is first wanted: measuring takes time.
  function fit(slide) {
    if (slide.fitted) return;
    slide.fitted = true;
    // A sentence that stands alone is said plainly.
    var lone = slide.kind === "text" && slide.fit.children.length === 1 && slide.fit.firstChild.matches(".point") && length(slide.fit) <= LEAD;
    slide.section.classList.toggle("slide-lone", lone);
    size(slide, lone ? 1.5 : MOST[slide.kind]);
  }

  function Deck(article, deck) {
    this.article = article;
    this.deck = deck;
    this.slides = [];
    this.places = new Map(); // blocks of the page, and the index of the slide that shows each
    this.moved = [];
    this.pending = [];
    this.loose = [];
    this.slide = null;
    this.title = null;
    this.authored = false;
  }

  Deck.prototype = {
    take: function (node) {
      var mark = document.createComment("");
      node.replaceWith(mark);
      this.moved.push([node, mark]);
      return node;
    },

    restore: function () {
      this.slides.forEach(function (slide) {
        list(slide.fit.querySelectorAll("math[display=block]")).forEach(function (math) { math.removeAttribute("style"); });
        list(slide.fit.querySelectorAll(".slide-off")).forEach(function (row) {
          row.classList.remove("slide-off");
          if (!row.className) row.removeAttribute("class");
        });
      });
      this.moved.reverse().forEach(function (pair) { pair[1].replaceWith(pair[0]); });
      this.moved = [];
    },

    open: function (kind) {
      var section = make("section", "slide slide-" + kind, this.deck);
      section.tabIndex = -1;
      section.setAttribute("aria-roledescription", "slide");
      var head = make("h2", "slide-title", section);
      if (this.title) head.append(this.title.cloneNode(true));
      var body = make("div", "slide-body", section);
      this.slide = { section: section, head: head, body: body, fit: make("div", "slide-fit", body), kind: kind, notes: this.loose, stepper: null };
      this.loose = [];
      this.slides.push(this.slide);
      return this.slide;
    },


    // The speaker's text goes to what was shown last, or waits for what comes next.
    note: function (node) {
      var last = this.pending[this.pending.length - 1];
      (last ? last.notes : this.slide ? this.slide.notes : this.loose).push(node);
    },

    put: function (node, from, leads, block) {
      this.pending.push({ node: node, from: from, leads: leads, block: block, notes: [] });
    },

    placed: function (from) { if (!this.places.has(from)) this.places.set(from, this.slides.length - 1); },

    // Lays what is pending on as many slides as it takes, about equally full.
    flush: function () {
      var items = this.pending, self = this;
      this.pending = [];
      if (!items.length || this.follow(items)) return;
      var slide = this.open("text");
      items.forEach(function (item) { slide.fit.append(item.node); });
      var room = slide.body.clientHeight;
      var edges = items.map(function (item) { return [item.node.offsetTop, item.node.offsetTop + item.node.offsetHeight]; });
      var share = edges[edges.length - 1][1] / Math.ceil(edges[edges.length - 1][1] / room), start = 0, first = 0;
      items.forEach(function (item, at) {
        var full = edges[at][1] - start > room, fair = share < room && (edges[at][0] + edges[at][1]) / 2 - start > share;
        var from = at;
        // What leads on stays with what it leads to, and a sentence with the formula that it goes on from.
        while (from > first && (items[from].block ? items[from - 1].leads : items[from].node.matches(".point-on"))) from -= 1;
        if ((full || fair) && from > first) {
          slide = self.open("text");
          items.slice(from).forEach(function (item) { slide.fit.append(item.node); });
          first = from;
          start = edges[from][0];
        }
        slide.notes.push.apply(slide.notes, item.notes);
        self.placed(item.from);
      });
    },

    // Little text behind an exhibit stands below it.
    follow: function (items) {
      var slide = this.slide, self = this;
      if (!slide || !slide.room || weight(items) > slide.room) return false;
      slide.room = 0;
      var after = make("div", "slide-after");
      slide.body.append(after);
      items.forEach(function (item) {
        after.append(item.node);
        slide.notes.push.apply(slide.notes, item.notes);
        self.placed(item.from);
      });
      return true;
    },

    // An exhibit or a listing has a slide, with the text before it if that is short.
    exhibit: function (node, from) {
      var lead = this.pending, self = this;
      var long = node.querySelectorAll("tbody tr").length > ROWS || node.querySelectorAll(".picture").length > PICTURES ||
        (node.matches(".listing") && node.textContent.split("\n").length > LINES);
      if (weight(lead) > LEAD || long) { this.flush(); lead = []; }
      this.pending = [];
      var kind = node.matches(".listing") ? "code" : node.matches(".exhibit-table, .table-wrap") ? "table" : node.matches(".exhibit-pictures") ? "pictures" : "figure";
      var slide = this.open(kind);
      if (lead.length) slide.body.insertBefore(make("div", "slide-before"), slide.fit);
      lead.forEach(function (item) {
        slide.body.firstChild.append(item.node);
        slide.notes.push.apply(slide.notes, item.notes);
        self.placed(item.from);
      });
      slide.fit.append(this.take(node));
      if (node.querySelector(".stepper")) slide.stepper = node;
      var caption = document.getElementById(node.id + "-caption");
      if (caption) {
        // The steps of a stepper have captions of their own.
        if (slide.stepper) make("p", "slide-label", slide.section).append(bare(caption.querySelector(".label").cloneNode(true)));
        else make("p", "slide-caption", slide.body).append(sentences(caption)[0]);
        slide.notes.push(caption);
      }
      slide.room = long ? 0 : (kind === "figure" ? BELOW : LEAD) - weight(lead);
      this.placed(from);
      if (kind === "table") this.pages(slide, node);
    },

    // A long table goes on, with its head, on as many slides as it takes.
    pages: function (slide, node) {
      var rows = node.querySelectorAll("tbody tr").length;
      var count = Math.min(Math.ceil(slide.fit.offsetHeight * SMALL / (slide.body.clientHeight - 50)), rows), each = Math.ceil(rows / count);
      if (count < 2) return;
      var whole = copy(node.parentElement), caption = slide.body.querySelector(".slide-caption"), self = this;
      function only(root, page) {
        list(root.querySelectorAll("tbody tr")).forEach(function (row, at) { row.classList.toggle("slide-off", Math.floor(at / each) !== page); });
        if (page < count - 1) list(root.querySelectorAll("tfoot")).forEach(function (foot) { foot.classList.add("slide-off"); });
      }
      only(slide.fit, 0);
      for (var page = 1; page < count; page++) {
        var more = self.open("table");
        more.fit.append(whole.cloneNode(true));
        only(more.fit, page);
        if (caption) more.body.append(caption.cloneNode(true));
        more.notes = slide.notes;
      }
    },

    heading: function (fragment) {
      this.flush();
      this.title = fragment;
      this.slide = null;
      this.authored = false;
    },

    // A callout with slides of its own: its head is their title, and its parts flow.
    apart: function (node, from) {
      var before = this.title, authored = this.authored, self = this;
      var head = node.querySelector(":scope > .callout-title");
      this.heading(copy(head));
      // The question of an exercise is never cut.
      var whole = node.matches(".callout-exercise") ? Infinity : WHOLE;
      list(node.children).forEach(function (child) { if (child !== head) self.block(child, from, whole); });
      this.flush();
      this.heading(before);
      this.authored = authored;
    },

    // A mark of the author: a new slide, with its title if it has one, and what it says instead of the paragraphs that follow.
    mark: function (node) {
      var self = this, name = node.querySelector(":scope > .callout-title > .callout-name");
      this.heading(name ? copy(name) : this.title);
      list(node.children).slice(1).forEach(function (child) {
        self.authored = true;
        self.put(self.take(child), node, false, true);
      });
    },

    block: function (node, from, whole) {
      var self = this;
      if (/^H[2-6]$/.test(node.nodeName)) {
        this.heading(copy(node));
        return this.places.set(from, this.slides.length);
      }
      if (node.matches("header, .footnotes, .side-note, .fold-all, script, hr")) return node.nodeName === "HR" && this.flush();
      if (node.matches("details, .callout-notes")) return this.note(node);
      if (node.matches(".callout-slide")) return this.mark(node);
      if (node.matches("figure") || (node.matches(".table-wrap") && node.querySelectorAll("tbody tr").length > LINES)) return this.exhibit(node, from);
      if (node.matches(".callout-bug, .callout-exercise, .callout-goals, .callout-remember")) return this.apart(node, from);
      var before = this.pending[this.pending.length - 1];
      if (before && before.leads && node.matches("ul, ol")) before.node.classList.add("point-list");
      if (!node.matches("p")) return this.put(this.take(node), from, false, true);
      if (!this.authored) points(node, whole).forEach(function (point) { self.put(point.node, from, point.leads, false); });
      this.note(node);
    },

    opening: function (header) {
      var slide = this.open("opening");
      slide.head.remove();
      slide.fit.append(copy(header));
      this.placed(header);
      this.heading(copy(header.querySelector("h1")));
    },

    build: function () {
      var self = this;
      list(this.article.children).forEach(function (node) {
        if (node.matches(".opening")) self.opening(node);
        else self.block(node, node, 0);
      });
      this.flush();
      this.slides.forEach(function (slide, at) {
        var title = slide.section.querySelector("h1, .slide-title").textContent.replace(/\s+/g, " ").trim();
        slide.title = title;
        slide.section.setAttribute("aria-label", at + 1 + " of " + self.slides.length + ": " + title);
      });
      return this;
    },

    // The slide that shows a part of the page: its own, or that of what stands before it.
    of: function (node) {
      var section = node.closest(".slide");
      if (section) return this.slides.findIndex(function (slide) { return slide.section === section; });
      while (node && node.parentElement !== this.article) node = node.parentElement;
      while (node && !this.places.has(node)) node = node.previousElementSibling;
      return node ? Math.min(this.places.get(node), this.slides.length - 1) : -1;
    }
  };

  workbook.slides = { make: make, copy: copy, list: list, fit: fit, of: function (article, deck) { return new Deck(article, deck).build(); } };
})();
