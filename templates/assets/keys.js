// The keys of a page: a register that other scripts add theirs to, the dialog that tells them, and those that every page has.
//
// workbook.keys.add({ key: "/", does: "Search", run: open })  a key: `shown` is how it is told, `free` asks that nothing has the focus
// workbook.keys.tell("← →", "Steps of a figure")              a key that is heard elsewhere
// workbook.keys.closes(close)                                 for Esc: `close` says whether it closed anything; the last added is asked first
(function () {
  "use strict";
  var keys = [];
  var closers = [];
  var dialog = null;

  function add(key) { keys.push(key); }
  function tell(shown, does) { keys.push({ shown: shown, does: does }); }
  function closes(close) { closers.unshift(close); }
  workbook.keys = { add: add, tell: tell, closes: closes };

  function element(name, text, parent) {
    var made = document.createElement(name);
    if (text) made.textContent = text;
    if (parent) parent.appendChild(made);
    return made;
  }

  function build() {
    dialog = element("dialog");
    dialog.className = "keys";
    dialog.setAttribute("aria-label", "Keys");
    element("h2", "Keys", dialog);
    var list = element("dl", "", dialog);
    keys.forEach(function (key) {
      var row = element("div", "", list);
      var names = element("dt", "", row);
      (key.shown || key.key).split(" ").forEach(function (name) { element("kbd", name, names); });
      element("dd", key.does, row);
    });
    var form = element("form", "", dialog);
    form.method = "dialog";
    element("button", "Close", form);
    // A press beside the dialog closes it: what is pressed is then the dialog itself, which has no padding.
    dialog.addEventListener("click", function (event) { if (event.target === dialog) dialog.close(); });
    document.body.appendChild(dialog);
  }

  function help() {
    if (!dialog) build();
    if (!dialog.open) dialog.showModal();
  }

  // Where keys mean letters, or have a use of their own.
  function writing(target) {
    return target.isContentEditable || Boolean(target.closest("input:not([type=radio], [type=checkbox], [type=range]), textarea, select"));
  }

  document.addEventListener("keydown", function (event) {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return;
    if (event.key === "Escape") {
      if (closers.some(function (close) { return close(); })) event.preventDefault();
      return;
    }
    if (!event.target.closest || writing(event.target) || document.querySelector("dialog[open]")) return;
    var free = document.activeElement === document.body || document.activeElement === null;
    keys.some(function (key) {
      if (!key.run || key.key !== event.key || (key.free && (!free || event.shiftKey))) return false;
      event.preventDefault();
      key.run(event);
      return true;
    });
  });

  // The neighbours of the page: as if the reader had followed the link.
  function turn(way, key, does) {
    var link = document.querySelector(".turn ." + way);
    if (link) add({ key: key, shown: key === "ArrowLeft" ? "←" : "→", does: does, free: true, run: function () { link.click(); } });
  }
  turn("previous", "ArrowLeft", "Previous chapter");
  turn("next", "ArrowRight", "Next chapter");
  if (document.querySelector(".stepper")) tell("← → Home End", "Steps of the figure that has the focus");
  add({ key: "?", does: "These keys", run: help });
  tell("Esc", "Close what is open");

  document.querySelectorAll(".keys-open").forEach(function (button) { button.addEventListener("click", help); });
  closes(function () {
    var menu = document.querySelector(".menu[open]");
    if (!menu) return false;
    menu.open = false;
    menu.querySelector("summary").focus();
    return true;
  });
})();
