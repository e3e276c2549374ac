// Previews: what a reference, a term or a citation leads to, on a card beside it, for pointers and for the keyboard.
// The card is built from the target on this page; targets on other pages stand in `previews/PAGE.js`, which the build writes and which is
// loaded when a link to that page is first asked for. Cards hold no links and nothing that takes the focus.
(function () {
  "use strict";
  var WAIT = 250;   // milliseconds before a card opens, so that a pointer passing by opens none
  var GRACE = 300;  // and before it closes, so that the pointer can move into it
  var GAP = 6;      // pixels between the link and the card
  var LINKS = "a.reference, a.term, a.citation";
  var folder = document.currentScript.getAttribute("src").replace(/[^/]*$/, "previews/");
  var pages = {};   // by page: the targets' HTML by id, or what waits for it
  var card = document.createElement("div");
  var open = null;  // the link whose card is shown
  var timer = 0;

  card.className = "preview";
  card.id = "preview-card";
  card.setAttribute("role", "tooltip");
  card.hidden = true;
  document.body.appendChild(card);

  // What other pages hold may have changed with this one.
  workbook.each(function () { pages = {}; });

  // The files of other pages call this.
  workbook.previews = function (page, targets) {
    var waiting = pages[page];
    pages[page] = targets;
    if (Array.isArray(waiting)) waiting.forEach(function (then) { then(targets); });
  };

  function load(page, then) {
    if (Array.isArray(pages[page])) return pages[page].push(then);
    if (pages[page]) return then(pages[page]);
    pages[page] = [then];
    var script = document.createElement("script");
    script.src = folder + page.replace(/\.html$/, ".js");
    script.onerror = function () { pages[page] = {}; };
    document.head.appendChild(script);
  }

  // What a term is defined in.
  function around(target) {
    return target.closest("section.callout-definition") || target.closest(".side-note, p, li, td, figcaption") || target;
  }

  // The first paragraph of a section, if it has one before its next part.
  function opening(heading) {
    var next = heading.nextElementSibling;
    return next && next.localName === "p" ? next : null;
  }

  function parts(target) {
    if (/^h\d$/.test(target.localName)) return [target, opening(target)];
    if (target.localName === "dfn") return [around(target)];
    if (!target.matches(".exhibit")) return [target];
    var caption = target.querySelector("figcaption > p") || target.querySelector("figcaption");
    var pictured = target.querySelector(".exhibit-body");
    return target.matches(".exhibit-table") ? [caption, pictured] : [pictured, caption];
  }

  // A copy without what acts, and without ids, which must stay unique. Links become plain text.
  function inert(part) {
    var copy = part.cloneNode(true);
    copy.querySelectorAll("details, button, .permalink, .note-number, .side-note, .footnote-reference, .exhibit-notes, .fold-all, .flip").forEach(function (out) { out.remove(); });
    [copy].concat(Array.prototype.slice.call(copy.querySelectorAll("*"))).forEach(function (element) {
      ["id", "tabindex", "aria-labelledby", "aria-describedby"].forEach(function (name) { element.removeAttribute(name); });
    });
    copy.querySelectorAll("a").forEach(function (link) {
      var plain = document.createElement("span");
      plain.className = link.className;
      plain.append.apply(plain, link.childNodes);
      link.replaceWith(plain);
    });
    return copy;
  }

  function fill(target) {
    card.textContent = "";
    card.classList.toggle("stepping", target.classList.contains("stepping"));
    parts(target).forEach(function (part) {
      if (!part) return;
      var copy = inert(part);
      // The caption says in words what the drawing shows.
      if (copy.matches(".exhibit-body:not(:has(table))")) copy.setAttribute("aria-hidden", "true");
      if (/^h\d$/.test(copy.localName)) copy = heading(copy);
      card.appendChild(copy);
    });
  }

  // A heading of the card is none of the page.
  function heading(copy) {
    var title = document.createElement("p");
    title.className = "preview-title";
    title.append.apply(title, copy.childNodes);
    return title;
  }

  // Above the link or below it, where there is more room, and never on it.
  function place(link) {
    var box = link.getBoundingClientRect();
    var below = window.innerHeight - box.bottom, above = box.top;
    card.style.maxHeight = "";
    card.style.left = "0px";
    var under = below >= card.offsetHeight + 2 * GAP || below >= above;
    card.style.maxHeight = Math.max(under ? below : above, 80) - 2 * GAP + "px";
    var wide = document.documentElement.clientWidth;
    var first = link.getClientRects()[0] || box;
    var left = Math.max(Math.min(first.left, wide - card.offsetWidth - 12), 12);
    card.style.left = left + window.scrollX + "px";
    card.style.top = (under ? box.bottom + GAP : box.top - GAP - card.offsetHeight) + window.scrollY + "px";
  }

  function show(link, target) {
    if (!target || !target.matches) return;
    close();
    fill(target);
    if (!card.textContent.trim()) return;
    card.hidden = false;
    card.scrollTop = 0;
    place(link);
    open = link;
    link.setAttribute("aria-describedby", card.id);
  }

  function close() {
    clearTimeout(timer);
    if (!open) return false;
    open.removeAttribute("aria-describedby");
    open = null;
    card.hidden = true;
    card.textContent = "";
    return true;
  }

  // What the reader sees already needs no card, which would only cover it.
  function inView(target) {
    var box = target.getBoundingClientRect();
    return box.height > 0 && box.top >= 0 && box.bottom <= window.innerHeight;
  }

  function ask(link) {
    var page = link.pathname.split("/").pop(), id = decodeURIComponent(link.hash.slice(1));
    if (link.pathname === location.pathname) {
      var target = document.getElementById(id);
      return target && inView(target) ? close() : show(link, target);
    }
    var asked = (timer = setTimeout(function () {}, 0));
    load(page, function (targets) {
      if (timer !== asked || !targets[id]) return;
      var holder = document.createElement("template");
      holder.innerHTML = targets[id];
      show(link, holder.content.querySelector("#" + CSS.escape(id)));
    });
  }

  function later(what, wait) {
    clearTimeout(timer);
    timer = setTimeout(what, wait);
  }

  function link(event) {
    return event.target.closest ? event.target.closest(LINKS) : null;
  }

  // A finger follows a link; it has nothing to hover with.
  document.addEventListener("pointerover", function (event) {
    if (event.pointerType === "touch") return;
    var over = link(event);
    if (over && !card.contains(over)) {
      if (over !== open) later(function () { ask(over); }, WAIT);
      else clearTimeout(timer);
    } else if (card.contains(event.target)) clearTimeout(timer);
    else later(close, GRACE);
  });
  document.addEventListener("focusin", function (event) {
    var on = link(event);
    if (on && on.matches(":focus-visible")) later(function () { ask(on); }, WAIT);
    else if (open) close();
  });
  document.addEventListener("focusout", function (event) { if (event.target === open) close(); });
  document.documentElement.addEventListener("pointerleave", function () { later(close, GRACE); });
  window.addEventListener("resize", close);
  window.addEventListener("pagehide", close);
  document.addEventListener("click", function (event) { if (link(event)) close(); });
  workbook.keys.closes(close);
})();
