// The speaker's window: the slide that is shown and the next one, notes, a timer and the clock. It is an empty window that this page fills,
// so that it also opens from disk; what is pressed there goes to the slides here.
(function () {
  "use strict";
  var workbook = window.workbook = window.workbook || {};
  var make = workbook.slides.make, list = workbook.slides.list;
  var view = null, parts = {}, clock = 0;
  var elapsed = 0, since = null; // milliseconds that have been counted, and when counting went on

  function part(name, kind, parent, text) {
    var made = view.document.createElement(name);
    made.className = kind;
    if (text) made.textContent = text;
    parent.appendChild(made);
    return made;
  }

  function two(number) { return (number < 10 ? "0" : "") + number; }

  function tick() {
    if (!view || view.closed) return stop();
    var seconds = Math.floor((elapsed + (since === null ? 0 : Date.now() - since)) / 1000), now = new Date();
    parts.timer.textContent = Math.floor(seconds / 3600) + ":" + two(Math.floor(seconds / 60) % 60) + ":" + two(seconds % 60);
    parts.clock.textContent = two(now.getHours()) + ":" + two(now.getMinutes());
  }

  function stop() { clearInterval(clock); view = null; }

  function run() {
    if (since === null) since = Date.now();
    else { elapsed += Date.now() - since; since = null; }
    parts.run.textContent = since === null ? "Start" : "Pause";
    tick();
  }

  function reset() {
    elapsed = 0;
    if (since !== null) since = Date.now();
    tick();
  }

  function fill() {
    var page = view.document;
    page.title = "Speaker: " + document.title;
    page.documentElement.lang = document.documentElement.lang;
    page.documentElement.className = "speaker";
    page.head.textContent = page.body.textContent = "";
    list(document.querySelectorAll("link[rel=stylesheet]")).forEach(function (link) {
      var made = page.createElement("link");
      made.rel = "stylesheet";
      made.href = link.href;
      page.head.appendChild(made);
    });
    var bar = part("header", "speaker-bar", page.body);
    parts.timer = part("span", "speaker-timer", bar);
    parts.timer.setAttribute("role", "timer");
    parts.run = part("button", "", bar, "Start");
    parts.reset = part("button", "", bar, "Reset");
    parts.where = part("span", "speaker-where", bar);
    parts.previous = part("button", "", bar, "Previous");
    parts.next = part("button", "", bar, "Next");
    parts.clock = part("span", "speaker-clock", bar);
    parts.run.onclick = run;
    parts.reset.onclick = reset;
    parts.previous.onclick = function () { workbook.deck.previous(); };
    parts.next.onclick = function () { workbook.deck.next(); };
    parts.now = part("section", "speaker-now", page.body);
    parts.now.setAttribute("aria-label", "On the screen");
    parts.then = part("section", "speaker-next", page.body);
    parts.then.setAttribute("aria-label", "Next");
    parts.notes = part("section", "speaker-notes", page.body);
    parts.notes.setAttribute("aria-label", "Notes");
    parts.notes.tabIndex = 0;
    page.onkeydown = function (event) {
      // Space and arrows scroll the notes only while these have the focus.
      if (parts.notes.contains(event.target) && /^(Arrow(Up|Down)| )$/.test(event.key)) return;
      if (workbook.deck.press(event)) event.preventDefault();
    };
    clock = setInterval(tick, 250);
  }

  function shown(slide, box) {
    box.textContent = "";
    if (!slide) return part("p", "speaker-end", box, "The end");
    var copy = view.document.importNode(slide.section, true);
    copy.removeAttribute("tabindex");
    copy.inert = true;
    box.appendChild(copy);
  }

  function notes(slide) {
    parts.notes.textContent = "";
    // What the author wrote for the speaker comes first, then the text of the page.
    var own = slide.notes.filter(function (note) { return note.matches(".callout-notes"); });
    own.concat(slide.notes.filter(function (note) { return own.indexOf(note) < 0; })).forEach(function (note) {
      var copy = view.document.importNode(note, true);
      copy.hidden = false;
      if (copy.matches("details")) copy.open = true;
      parts.notes.appendChild(copy);
    });
    parts.notes.scrollTop = 0;
  }

  function update() {
    if (!view) return;
    if (view.closed) return stop();
    var state = workbook.deck.state(), slide = state.slides[state.at];
    view.document.documentElement.dataset.theme = document.documentElement.dataset.theme || "";
    parts.next.disabled = parts.previous.disabled = !state.open;
    if (!state.open) {
      parts.where.textContent = "No slides are shown";
      parts.now.textContent = parts.then.textContent = parts.notes.textContent = "";
      return;
    }
    var changed = parts.slide !== slide;
    parts.slide = slide;
    parts.where.textContent = "Slide " + (state.at + 1) + " of " + state.slides.length + (state.step ? ", step " + state.step.now + " of " + state.step.count : "") + (state.paused ? ", paused" : "");
    shown(slide, parts.now);
    if (!changed) return;
    if (state.slides[state.at + 1]) workbook.slides.fit(state.slides[state.at + 1]);
    shown(state.slides[state.at + 1], parts.then);
    notes(slide);
  }

  // Opens the window, or brings it to the front; says whether the browser let it.
  function open() {
    if (view && !view.closed) { view.focus(); return true; }
    view = window.open("", "workbook-speaker", "popup,width=1100,height=760");
    if (!view) return false;
    fill();
    parts.slide = null;
    if (since === null && !elapsed) run(); else parts.run.textContent = since === null ? "Start" : "Pause";
    tick();
    update();
    return true;
  }

  window.addEventListener("pagehide", function () { if (view && !view.closed) view.close(); });
  workbook.speaker = { open: open, update: update };
})();
