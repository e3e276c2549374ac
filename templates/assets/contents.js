// The lists of sections follow the reading: the section in view is marked, and kept in view where its list scrolls.
(function () {
  "use strict";
  if (!window.IntersectionObserver) return;
  var lists = [], headings = [], passed = {}, atEnd = false, line = null;

  function mark(list, at) {
    var link = null;
    // A list may leave out the deeper sections.
    for (; at >= 0 && !link; at--) link = list.querySelector('a[href="#' + CSS.escape(headings[at].id) + '"]');
    var last = list.querySelector("[aria-current]");
    if (last === link) return;
    if (last) last.removeAttribute("aria-current");
    if (!link) return;
    link.setAttribute("aria-current", "true");
    var box = list.closest(".sidebar") || list;
    var inner = link.getBoundingClientRect(), outer = box.getBoundingClientRect();
    if (inner.top < outer.top) box.scrollTop -= outer.top - inner.top + 40;
    if (inner.bottom > outer.bottom) box.scrollTop += inner.bottom - outer.bottom + 40;
  }

  function follow() {
    var at = headings.length - 1;
    if (!atEnd) while (at >= 0 && !passed[headings[at].id]) at--;
    lists.forEach(function (list) { mark(list, at); });
  }

  // A heading is passed when it is above a line at a third of the window's height.
  workbook.each(function () {
    lists = Array.prototype.slice.call(document.querySelectorAll(".on-this-page, .sidebar .sections"));
    headings = Array.prototype.slice.call(document.querySelectorAll("main :is(h2, h3, h4)[id]"));
    if (line) line.disconnect();
    line = new IntersectionObserver(function (entries) {
      entries.forEach(function (entry) { passed[entry.target.id] = entry.isIntersecting; });
      follow();
    }, { rootMargin: "1000000px 0px -66% 0px" });
    headings.forEach(function (heading) { line.observe(heading); });
  });
  if (!lists.length) return;

  // The last sections may be too short ever to pass it.
  var end = new IntersectionObserver(function (entries) {
    atEnd = entries[entries.length - 1].isIntersecting;
    follow();
  });
  end.observe(document.querySelector(".colophon"));
})();
