// The theme button (automatic, light, dark), the keyboard's way into what scrolls sideways, and folds that open for links and for paper.
// The pages are complete without this script.
(function () {
  "use strict";
  var root = document.documentElement;
  var themes = ["automatic", "light", "dark"];

  // Storage may be refused, or kept per file, for pages opened from disk; the address then carries the choice.
  function recall() {
    var asked = /[?&]theme=(light|dark)/.exec(location.search);
    if (asked) return asked[1];
    try { return localStorage.getItem("theme") || "automatic"; } catch (_) { return "automatic"; }
  }

  function remember(theme) {
    try { localStorage.setItem("theme", theme); } catch (_) { /* the choice lasts as long as the page */ }
  }

  function apply(theme) {
    if (theme === "light" || theme === "dark") root.setAttribute("data-theme", theme);
    else root.removeAttribute("data-theme");
  }

  var theme = recall();
  if (themes.indexOf(theme) < 0) theme = "automatic";
  apply(theme);

  document.addEventListener("DOMContentLoaded", function () {
    var buttons = document.querySelectorAll(".theme-toggle");
    function show() {
      buttons.forEach(function (button) {
        button.hidden = false;
        button.querySelector("span").textContent = theme;
      });
    }
    buttons.forEach(function (button) {
      button.addEventListener("click", function () {
        theme = themes[(themes.indexOf(theme) + 1) % themes.length];
        apply(theme);
        remember(theme);
        show();
      });
    });
    show();
  });

  // Not every browser lets the keyboard reach a box that scrolls.
  function reach() {
    document.querySelectorAll(".exhibit-body, .table-wrap, pre, math").forEach(function (box) {
      if (box.scrollWidth > box.clientWidth + 1) box.setAttribute("tabindex", "0");
      else box.removeAttribute("tabindex");
    });
  }
  window.addEventListener("load", reach);
  window.addEventListener("resize", reach);
  // What is folded has no width; the event does not bubble.
  document.addEventListener("toggle", reach, true);

  // A link to a place in a closed fold opens it; not every browser does that by itself.
  function unfold() {
    var target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    var fold = target && target.parentElement.closest("details:not([open])");
    if (!fold) return;
    for (; fold; fold = fold.parentElement.closest("details")) fold.open = true;
    target.scrollIntoView();
  }
  document.addEventListener("DOMContentLoaded", unfold);
  window.addEventListener("hashchange", unfold);

  // Hints and solutions are printed, and folded again afterwards.
  var printed = [];
  window.addEventListener("beforeprint", function () {
    printed = Array.prototype.slice.call(document.querySelectorAll("details.callout:not([open])"));
    printed.forEach(function (fold) { fold.open = true; });
  });
  window.addEventListener("afterprint", function () {
    printed.forEach(function (fold) { fold.open = false; });
    printed = [];
  });

  document.addEventListener("click", function (event) {
    var link = event.target.closest && event.target.closest("a[href]");
    if (!link || location.protocol !== "file:" || link.protocol !== "file:") return;
    if (link.getAttribute("href").charAt(0) === "#") return;
    link.search = theme === "automatic" ? "" : "?theme=" + theme;
  });
})();
