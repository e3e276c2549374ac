// Folds: a link to what is folded opens it, and one button opens or closes all hints and solutions of a page, for the next visit too.
// What is open is printed.
(function () {
  "use strict";
  var name = "unfolded:" + location.pathname;
  var button = null;
  var unfolded = workbook.store.get(name) === "yes";

  function set(open) {
    document.querySelectorAll("details.callout").forEach(function (fold) { fold.open = open; });
  }

  function show() {
    button.setAttribute("aria-pressed", String(unfolded));
  }

  workbook.each(function () {
    var found = document.querySelector(".fold-all button");
    if (!found || found === button) return;
    if (unfolded && !button) set(true);
    button = found;
    show();
    button.addEventListener("click", function () {
      // What is above the button may change its height; the button stays where it is pressed.
      var top = button.getBoundingClientRect().top;
      unfolded = !unfolded;
      set(unfolded);
      workbook.store.set(name, unfolded ? "yes" : "no");
      show();
      window.scrollBy({ top: button.getBoundingClientRect().top - top, behavior: "instant" });
    });
  });

  // A link to a place in a closed fold opens it; not every browser does that by itself.
  function unfold() {
    var target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    var fold = target && target.parentElement.closest("details:not([open])");
    if (!fold) return;
    for (; fold; fold = fold.parentElement.closest("details")) fold.open = true;
    target.scrollIntoView();
  }
  unfold();
  window.addEventListener("hashchange", unfold);
})();
