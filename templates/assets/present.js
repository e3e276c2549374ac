// The way into the slides: a button, the key `p`, and addresses that end in `?present` or `#/3`. The scripts and the look of the slides are
// loaded when they are first wanted. The page is complete without this script.
(function () {
  "use strict";
  var workbook = window.workbook = window.workbook || {};
  var assets = document.currentScript.src.replace(/[^/]*$/, "");
  var ready = null;

  function loaded(name, kind, address) {
    return new Promise(function (done, failed) {
      var made = document.createElement(kind);
      made.onload = done;
      made.onerror = failed;
      if (kind === "link") made.rel = "stylesheet";
      else made.async = false;
      made[address] = assets + name;
      document.head.appendChild(made);
    });
  }

  function load() {
    ready = ready || Promise.all([
      loaded("deck.css", "link", "href"), loaded("slides.js", "script", "src"), loaded("speaker.js", "script", "src"), loaded("deck.js", "script", "src")
    ]);
    return ready;
  }

  // The slide `to` counts from 0; without it the slides begin with what the reader looks at. Sizes are measured, so the fonts must be there.
  function open(to) {
    load().then(function () { return document.fonts.ready; }).then(function () { workbook.deck.enter(to); });
  }

  function follow() {
    var asked = /^#\/(\d+)$/.exec(location.hash);
    if (asked) open(Number(asked[1]) - 1);
    else if (/[?&]present\b/.test(location.search)) open(0);
  }

  // Where the page has no register of keys, `p` is heard here.
  if (workbook.keys) workbook.keys.add({ key: "p", does: "Present this chapter as slides", run: function () { open(); } });
  else document.addEventListener("keydown", function (event) {
    if (event.key !== "p" || event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
    if (!event.target.closest("input, textarea, select, dialog")) open();
  });

  // The button stands beside that of the theme, wherever this is: as an icon among icons, as words among words.
  document.querySelectorAll(".theme-toggle").forEach(function (beside) {
    var icon = beside.classList.contains("tool"), button = document.createElement("button");
    button.type = "button";
    button.className = icon ? "tool present-open" : "present-open";
    if (icon) button.setAttribute("aria-label", "Present as slides");
    else button.textContent = "Present as slides";
    button.title = "Present as slides (P)";
    button.addEventListener("click", function () { open(); });
    beside.after(button);
  });

  // The other scripts have done their part by then. Later changes of the address are for the slides, once they are there.
  document.addEventListener("DOMContentLoaded", follow);
  window.addEventListener("hashchange", function () { if (!workbook.deck) follow(); });
})();
