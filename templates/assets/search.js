// The search: a dialog that `/` or its button opens. Its index is loaded when it is first opened, by a script, since pages may stand on a disk.
(function () {
  "use strict";
  var MOST = 40;
  var folder = document.currentScript.src.replace(/[^/]*$/, "");
  var root = folder.replace(/[^/]*\/$/, "");
  var dialog, input, count, list, found, index = null, opener = null;
  var book = window.workbook = window.workbook || {};
  book.search = { load: function (data) { book.search.data = data; } };

  function element(name, attributes, parent) {
    var made = document.createElement(name);
    Object.keys(attributes).forEach(function (key) {
      if (key === "text") made.textContent = attributes[key];
      else made.setAttribute(key, attributes[key]);
    });
    if (parent) parent.appendChild(made);
    return made;
  }

  function script(name, then) {
    var made = element("script", { src: folder + name });
    made.onload = then;
    made.onerror = function () { say("The index could not be loaded."); };
    document.head.appendChild(made);
  }

  function say(text) { count.textContent = text; }

  function build() {
    dialog = element("dialog", { "class": "search", "aria-label": "Search" });
    var form = element("form", { "class": "search-form", role: "search" }, dialog);
    input = element("input", { type: "text", role: "searchbox", "aria-label": "Search this book", "aria-controls": "search-results", placeholder: "Chapters, terms, figures, samplers …", autocomplete: "off", autocapitalize: "off", spellcheck: "false", enterkeyhint: "go" }, form);
    element("button", { type: "button", "class": "search-close", text: "Close" }, form).addEventListener("click", function () { dialog.close(); });
    count = element("p", { "class": "search-count", role: "status" }, dialog);
    list = element("ol", { "class": "search-results", id: "search-results", "aria-label": "Results" }, dialog);
    form.addEventListener("submit", function (event) {
      event.preventDefault();
      var first = list.querySelector("a");
      if (first) first.click();
    });
    input.addEventListener("input", show);
    dialog.addEventListener("keydown", keys);
    dialog.addEventListener("close", function () { if (opener && opener.isConnected) opener.focus(); });
    // A press beside the dialog closes it: what is pressed is then the dialog itself.
    dialog.addEventListener("click", function (event) {
      if (event.target === dialog || event.target.closest(".search-results a")) dialog.close();
    });
    document.body.appendChild(dialog);
    script("search-match.js", function () {
      script("search-index.js", function () {
        index = book.search.index(book.search.data);
        show();
      });
    });
  }

  function open() {
    if (!dialog) build();
    if (dialog.open) return;
    opener = document.activeElement;
    dialog.showModal();
    input.focus();
    input.select();
  }

  function write(text, meant, parent) {
    book.search.marked(text, meant).forEach(function (piece) {
      if (piece.mark) element("mark", { text: piece.text }, parent);
      else parent.appendChild(document.createTextNode(piece.text));
    });
  }

  function result(one) {
    var entry = one.entry;
    var link = element("a", { href: root + entry.page + (entry.id ? "#" + entry.id : "") }, element("li", {}, list));
    var head = element("span", { "class": "search-kind" }, link);
    write(entry.kind + (entry.number ? "\u00a0" + entry.number : ""), one.words, head);
    link.appendChild(document.createTextNode(" "));
    write(entry.title, one.words, element("span", { "class": "search-title" }, link));
    var meant = book.search.words(entry.title + " " + entry.more + " " + entry.kind + " " + entry.number);
    var more = entry.more;
    var inside = Array.from(one.words).filter(function (word) { return meant.indexOf(word) < 0; });
    if (inside.length && book.search.hasText(entry)) more = "In the text: " + inside.slice(0, 6).join(", ") + (inside.length > 6 ? " …" : "");
    if (more) {
      link.appendChild(document.createTextNode(" "));
      write(more, one.words, element("span", { "class": "search-more" }, link));
    }
    var chapter = entry.id ? index.chapter(entry.page) : null;
    if (chapter) {
      link.appendChild(document.createTextNode(" "));
      element("span", { "class": "search-where", text: (chapter.number ? chapter.number + " " : "") + chapter.title }, link);
    }
  }

  function show() {
    var question = input.value.trim();
    list.textContent = "";
    if (!index) return say(question ? "Loading the index …" : "");
    found = index.find(question);
    found.results.slice(0, MOST).forEach(result);
    list.scrollTop = 0;
    var number = found.results.length;
    var told = number === 0 ? "Nothing found." : number === 1 ? "1 result" : number > MOST ? "The first " + MOST + " of " + number + " results" : number + " results";
    if (number && !found.whole) told += "; none has all words";
    say(question ? told : "");
  }

  // Arrows go through the results and back to the question; letters typed there go on with the question; Tab stays within.
  function keys(event) {
    if (event.isComposing) return;
    var links = Array.from(list.querySelectorAll("a"));
    var at = links.indexOf(document.activeElement);
    var to = null;
    if (event.key === "ArrowDown") to = links[at + 1];
    else if (event.key === "ArrowUp") to = at > 0 ? links[at - 1] : at === 0 ? input : null;
    else if (event.key === "Home" && at >= 0) to = links[0];
    else if (event.key === "End" && at >= 0) to = links[links.length - 1];
    else if (event.key === "Tab") {
      var all = [input, dialog.querySelector(".search-close")].concat(links);
      var here = all.indexOf(document.activeElement);
      to = event.shiftKey ? all[(here <= 0 ? all.length : here) - 1] : all[(here + 1) % all.length];
    } else if (at >= 0 && (event.key.length === 1 || event.key === "Backspace") && !event.ctrlKey && !event.metaKey && !event.altKey && event.key !== " ") {
      input.focus();
      return;
    } else return;
    event.preventDefault();
    if (to) to.focus();
    if (to === input) input.select();
  }

  // Without this script the links lead to the index of terms; with it they are buttons.
  document.querySelectorAll("a.search-open").forEach(function (link) {
    var button = element("button", { type: "button", "class": link.className, "aria-haspopup": "dialog", "aria-keyshortcuts": "/", "aria-label": "Search", title: "Search (/)" });
    element("span", { text: "Search" }, button);
    button.addEventListener("click", open);
    link.replaceWith(button);
  });
  if (book.keys) book.keys.add({ key: "/", does: "Search", run: open });
  else document.addEventListener("keydown", function (event) {
    var writing = event.target.isContentEditable || (event.target.closest && event.target.closest("input, textarea, select"));
    if (event.key !== "/" || event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented || writing) return;
    event.preventDefault();
    open();
  });
})();
