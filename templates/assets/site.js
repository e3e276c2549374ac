// The theme (automatic, light, dark), the opening of the page, the keyboard's way into what scrolls sideways, and what the other scripts share: `workbook`.
// The pages are complete without any script.
(function () {
  "use strict";
  var root = document.documentElement;
  var themes = ["automatic", "light", "dark"];

  // Storage may be refused, or kept per file, for pages opened from disk; the address then carries the choice.
  var store = {
    get: function (name) { try { return localStorage.getItem(name); } catch (_) { return null; } },
    set: function (name, value) { try { localStorage.setItem(name, value); } catch (_) { /* it lasts as long as the page */ } }
  };

  // What scripts do to parts of the page. A preview has it done again when parts have changed, so each leaves alone what it has done before.
  var doings = [];
  window.workbook = {
    store: store,
    each: function (does) { doings.push(does); does(); },
    again: function () { doings.forEach(function (does) { does(); }); reach(document); }
  };

  // Styles know by it that buttons will work, before anything is painted.
  root.classList.add("js");

  // The page is laid out once: when all of it is there, and in its own faces, so that nothing moves. Who has a slow line does not wait for it.
  var faces = ["", "italic ", "600 "].map(function (style) { return style + '1em "Workbook Serif"'; })
    .concat(['1em "Workbook Sans"', '1em "Workbook Mono"', '1em "Workbook Math"']);
  // What is done when all of it is laid out.
  var settled = function () {};
  function end(state) { return function () { root.classList.remove(state); }; }

  // Of a long page, what is far below the window is laid out piece by piece when the rest is there; all at once when the reader does anything.
  function postpone() {
    var later = Array.prototype.slice.call(document.querySelectorAll(".text > *"), 8);
    var opened = (performance.getEntriesByType("navigation")[0] || {}).type;
    if (later.length < 60 || location.hash || opened !== "navigate" || !window.requestIdleCallback) return;
    root.classList.add("settling");
    later.forEach(function (block) { block.classList.add("later"); });
    function settle(count) {
      later.splice(0, count).forEach(function (block) { block.classList.remove("later"); });
      if (later.length || !root.classList.contains("settling")) return;
      root.classList.remove("settling");
      settled();
    }
    function piece() {
      settle(20);
      if (later.length) requestIdleCallback(piece, { timeout: 50 });
    }
    // After the first frame, which must not wait for it.
    window.addEventListener("load", function () {
      requestAnimationFrame(function () { requestAnimationFrame(function () { requestIdleCallback(piece, { timeout: 200 }); }); });
    });
    ["keydown", "pointerdown", "wheel", "touchstart", "beforeprint", "hashchange"].forEach(function (event) {
      window.addEventListener(event, function () { settle(later.length); }, { once: true, capture: true, passive: true });
    });
  }

  if (document.fonts && document.readyState === "loading") {
    root.classList.add("parsing", "faceless");
    // Before the scripts that wait for the whole page, since they measure it.
    document.addEventListener("readystatechange", function () { postpone(); end("parsing")(); }, { once: true });
    setTimeout(end("parsing"), 250);
    setTimeout(end("faceless"), 400);
    Promise.all(faces.map(function (face) { return document.fonts.load(face); })).then(end("faceless"), end("faceless"));
  }

  function recall() {
    var asked = /[?&]theme=(light|dark)/.exec(location.search);
    return asked ? asked[1] : store.get("theme");
  }

  function apply(theme) {
    if (theme === "automatic") root.removeAttribute("data-theme");
    else root.setAttribute("data-theme", theme);
  }

  var theme = recall();
  if (themes.indexOf(theme) < 0) theme = "automatic";
  apply(theme);

  document.addEventListener("DOMContentLoaded", function () {
    var buttons = document.querySelectorAll(".theme-toggle");
    function show() {
      buttons.forEach(function (button) {
        button.title = "Theme: " + theme;
        button.setAttribute("aria-label", button.title);
      });
    }
    buttons.forEach(function (button) {
      button.addEventListener("click", function () {
        theme = themes[(themes.indexOf(theme) + 1) % themes.length];
        apply(theme);
        store.set("theme", theme);
        show();
      });
    });
    show();
  });

  // Not every browser lets the keyboard reach a box that scrolls. All are measured before any is changed, so that nothing is laid out twice.
  function reach(part) {
    var boxes = Array.prototype.slice.call(part.querySelectorAll(":is(.exhibit-body, .table-wrap, pre, math[display=block], .long-formula):not([inert] *)"));
    var wide = boxes.map(function (box) { return box.scrollWidth > box.clientWidth + 1; });
    boxes.forEach(function (box, at) {
      if (wide[at]) box.setAttribute("tabindex", "0");
      else box.removeAttribute("tabindex");
    });
  }
  settled = function () { reach(document); };
  window.addEventListener("load", function () { if (!root.classList.contains("settling")) settled(); });
  window.addEventListener("resize", function () { reach(document); });
  // What is folded has no width; the event does not bubble.
  document.addEventListener("toggle", function (event) { if (event.target.open) reach(event.target); }, true);

  document.addEventListener("click", function (event) {
    var link = event.target.closest && event.target.closest("a[href]");
    if (!link || location.protocol !== "file:" || link.protocol !== "file:") return;
    if (link.getAttribute("href").charAt(0) === "#") return;
    link.search = theme === "automatic" ? "" : "?theme=" + theme;
  });
})();
