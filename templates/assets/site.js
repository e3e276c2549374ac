// The theme (automatic, light, dark), the keyboard's way into what scrolls sideways, and what the other scripts share: `workbook`.
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
    again: function () { doings.forEach(function (does) { does(); }); reach(); }
  };

  // Styles know by it that buttons will work, before anything is painted.
  root.classList.add("js");

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

  // Not every browser lets the keyboard reach a box that scrolls.
  function reach() {
    document.querySelectorAll(".exhibit-body, .table-wrap, pre, math, .long-formula").forEach(function (box) {
      if (box.scrollWidth > box.clientWidth + 1) box.setAttribute("tabindex", "0");
      else box.removeAttribute("tabindex");
    });
  }
  window.addEventListener("load", reach);
  window.addEventListener("resize", reach);
  // What is folded has no width; the event does not bubble.
  document.addEventListener("toggle", reach, true);

  document.addEventListener("click", function (event) {
    var link = event.target.closest && event.target.closest("a[href]");
    if (!link || location.protocol !== "file:" || link.protocol !== "file:") return;
    if (link.getAttribute("href").charAt(0) === "#") return;
    link.search = theme === "automatic" ? "" : "?theme=" + theme;
  });
})();
