// A button at each listing and block of code that copies it, also from pages opened from disk, and says so.
(function () {
  "use strict";
  var said = document.createElement("p");
  said.className = "unseen";
  said.setAttribute("role", "status");
  document.body.appendChild(said);

  // What is only for the eye, such as numbers of lines, is not copied.
  function code(block) {
    var copy = block.cloneNode(true);
    copy.querySelectorAll("[aria-hidden=true]").forEach(function (part) { part.remove(); });
    return copy.textContent.replace(/\n?$/, "\n");
  }

  // Without a secure context there is no clipboard but that of the selection.
  function select(text) {
    var area = document.createElement("textarea");
    area.className = "unseen";
    area.value = text;
    area.setAttribute("aria-hidden", "true");
    document.body.appendChild(area);
    var focused = document.activeElement;
    area.select();
    var done = false;
    try { done = document.execCommand("copy"); } catch (_) { /* refused */ }
    area.remove();
    if (focused) focused.focus({ preventScroll: true });
    return done;
  }

  function copy(text, tell) {
    if (!navigator.clipboard || !window.isSecureContext) return tell(select(text));
    navigator.clipboard.writeText(text).then(function () { tell(true); }, function () { tell(select(text)); });
  }

  function enhance(block) {
    var frame = document.createElement("div");
    frame.className = "copying";
    block.parentNode.insertBefore(frame, block);
    frame.appendChild(block);
    var button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "Copy";
    frame.appendChild(button);
    var later = 0;
    button.addEventListener("click", function () {
      copy(code(block), function (done) {
        button.textContent = done ? "Copied" : "Not copied";
        said.textContent = done ? "Copied to the clipboard." : "The browser did not copy it.";
        clearTimeout(later);
        later = setTimeout(function () { button.textContent = "Copy"; said.textContent = ""; }, 2500);
      });
    });
  }

  workbook.each(function () {
    document.querySelectorAll("main pre").forEach(function (block) { if (!block.closest(".copying")) enhance(block); });
  });
})();
