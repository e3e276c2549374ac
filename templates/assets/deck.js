// The deck: one slide at a time, with the keys that people know from reveal.js. `slides.js` makes the slides, `speaker.js` the window of the
// speaker; `present.js` loads all three when they are first wanted.
(function () {
  "use strict";
  var workbook = window.workbook = window.workbook || {};
  var make = workbook.slides.make, list = workbook.slides.list;
  var root = document.documentElement;
  var WIDTH = 896, HEIGHT = 504; // of a slide, in its own pixels: see deck.css
  var SWIPE = 50;
  var article = document.querySelector("article.text");
  var deck = null, model = null, slides = [], at = 0, entered = null, paper = null, help = null, touch = null;
  var buttons = {}, progress = null;

  var KEYS = [
    ["→ ↓ Space PageDown N", "Next step or slide"], ["← ↑ PageUp P", "Previous step or slide"], ["Home End", "First, last slide"],
    ["O Esc", "Overview"], ["S", "Speaker’s window: notes, next slide, timer"], ["F", "Full screen"], ["B .", "Pause: a black screen"],
    ["?", "These keys"], ["Q", "Back to the page"]
  ];
  var COMMANDS = {
    ArrowRight: next, ArrowDown: next, PageDown: next, " ": next, n: next,
    ArrowLeft: previous, ArrowUp: previous, PageUp: previous, p: previous,
    Home: function () { go(0); }, End: function () { go(slides.length - 1); },
    o: overview, Escape: overview, s: speaker, f: fullscreen, b: pause, ".": pause, "?": keys, q: leave
  };

  function stepOf(slide) {
    var slider = slide.stepper && slide.stepper.querySelector(".step-slider");
    return slider && { now: Number(slider.value), count: Number(slider.max), slider: slider };
  }

  function step(slide, to) {
    var steps = stepOf(slide);
    if (!steps) return;
    steps.slider.value = Math.min(Math.max(to, 1), steps.count);
    steps.slider.dispatchEvent(new Event("input", { bubbles: true }));
  }

  function next() {
    var steps = stepOf(slides[at]);
    if (steps && steps.now < steps.count) { step(slides[at], steps.now + 1); tell(); }
    else if (at < slides.length - 1) go(at + 1);
  }

  function previous() {
    var steps = stepOf(slides[at]);
    if (steps && steps.now > 1) { step(slides[at], steps.now - 1); tell(); }
    else if (at > 0) go(at - 1, true);
  }

  function tell() { if (workbook.speaker) workbook.speaker.update(); }

  // Shows a slide; a stepper is at its first step, or at its last for those who come back.
  function go(to, back) {
    to = Math.min(Math.max(to, 0), slides.length - 1);
    slides[at].section.classList.remove("slide-now");
    slides[at].section.removeAttribute("aria-current");
    at = to;
    var slide = slides[at];
    workbook.slides.fit(slide);
    if (slide.stepper) step(slide, back ? Infinity : 1);
    slide.section.classList.add("slide-now");
    slide.section.setAttribute("aria-current", "true");
    buttons.count.textContent = at + 1 + " / " + slides.length;
    buttons.previous.disabled = at === 0;
    progress.style.width = 100 * (at + 1) / slides.length + "%";
    address("#/" + (at + 1));
    if (deck.classList.contains("deck-over")) slide.section.scrollIntoView({ block: "nearest" });
    slide.section.focus({ preventScroll: true });
    tell();
  }

  // Some browsers refuse to change the address of a file; the slides do not need it.
  function address(hash) {
    try { history.replaceState(null, "", hash || location.pathname + location.search.replace(/([?&])present\b&?/, "$1").replace(/[?&]$/, "")); } catch (_) { if (hash) location.replace(hash); }
  }

  function scale() {
    if (deck) deck.style.setProperty("--scale", Math.min(deck.clientWidth / WIDTH, deck.clientHeight / HEIGHT));
  }

  function fitAll() { slides.forEach(workbook.slides.fit); }

  // The others get their sizes while nothing else is to be done.
  function fitSoon() {
    var left = slides.filter(function (slide) { return !slide.fitted; });
    if (!left.length) return;
    workbook.slides.fit(left.find(function (slide) { return slides.indexOf(slide) > at; }) || left[0]);
    (window.requestIdleCallback || setTimeout)(fitSoon);
  }

  function overview() {
    fitAll();
    var open = deck.classList.toggle("deck-over");
    buttons.overview.setAttribute("aria-pressed", open);
    slides[at].section.scrollIntoView({ block: "center" });
    slides[at].section.focus({ preventScroll: true });
  }

  function pause() {
    var paused = deck.classList.toggle("deck-paused");
    deck.querySelector(".deck-said").textContent = paused ? "Paused" : "";
    tell();
  }

  function fullscreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else if (root.requestFullscreen) root.requestFullscreen().catch(function () { say("This browser refuses the full screen."); });
  }

  function speaker() { if (!workbook.speaker.open()) say("The browser blocked the speaker’s window: allow pop-ups for this page, and press S again."); }

  function say(text) {
    var box = deck.querySelector(".deck-said");
    box.textContent = text;
    setTimeout(function () { if (box.textContent === text) box.textContent = ""; }, 8000);
  }

  function keys() {
    if (!help) {
      help = make("dialog", "deck-keys", deck);
      help.setAttribute("aria-label", "Keys of the slides");
      var names = make("dl", "", help);
      KEYS.forEach(function (key) {
        var row = make("div", "", names), term = make("dt", "", row);
        key[0].split(" ").forEach(function (name) { make("kbd", "", term).textContent = name; });
        make("dd", "", row).textContent = key[1];
      });
      var form = make("form", "", help);
      form.method = "dialog";
      make("button", "", form).textContent = "Close";
    }
    if (help.open) help.close(); else help.showModal();
  }

  function button(name, label, run) {
    var made = make("button", "deck-" + name, deck.querySelector(".deck-bar"));
    made.type = "button";
    made.title = label;
    made.setAttribute("aria-label", label);
    made.addEventListener("click", run);
    return made;
  }

  function furniture() {
    deck = make("div", "deck", document.body);
    deck.setAttribute("role", "region");
    deck.setAttribute("aria-label", "Slides: " + document.querySelector("h1").textContent);
    var bar = make("div", "deck-bar", deck);
    bar.setAttribute("role", "group");
    bar.setAttribute("aria-label", "Slides");
    buttons.previous = button("previous", "Previous", previous);
    buttons.next = button("next", "Next", next);
    buttons.overview = button("overview", "Overview (O)", overview);
    button("speaker", "Speaker’s window (S)", speaker);
    button("full", "Full screen (F)", fullscreen);
    button("help", "Keys (?)", keys);
    button("leave", "Back to the page (Q)", leave);
    buttons.count = make("span", "deck-count", bar);
    make("p", "deck-said", deck).setAttribute("role", "status");
    progress = make("div", "deck-progress", deck);
  }

  // The slide of what the reader looks at.
  function inView() {
    if (window.scrollY < 80) return 0;
    var seen = list(article.children).filter(function (node) { return node.getClientRects().length && node.getBoundingClientRect().top < 0.35 * innerHeight; });
    return seen.pop();
  }

  function enter(to) {
    if (deck || !article) return;
    var from = inView();
    entered = { y: window.scrollY, at: 0, focus: document.activeElement };
    furniture();
    root.classList.add("presenting");
    model = workbook.slides.of(article, deck);
    slides = model.slides;
    paper = make("style", "", document.head);
    // A rule on pages cannot depend on a class.
    paper.textContent = "@page { size: 1280px 720px; margin: 0; }";
    scale();
    at = 0;
    entered.at = to !== undefined ? -1 : from ? model.of(from) : 0;
    go(to !== undefined ? to : entered.at);
    (window.requestIdleCallback || setTimeout)(fitSoon);
  }

  function leave() {
    if (!deck) return;
    if (document.fullscreenElement) document.exitFullscreen();
    var node = null, now = at, same = now === entered.at, y = entered.y;
    model.places.forEach(function (index, block) { if (index <= now && (!node || model.places.get(node) < index)) node = block; });
    model.restore();
    deck.remove();
    paper.remove();
    root.classList.remove("presenting");
    deck = model = help = null;
    slides = [];
    address("");
    if (workbook.speaker) workbook.speaker.update();
    if (same) window.scrollTo({ top: y, behavior: "instant" });
    else if (node) node.scrollIntoView({ block: "start", behavior: "instant" });
    entered.focus.focus({ preventScroll: true });
  }

  // Runs the command of a key; says whether there is one.
  function press(event) {
    if (!deck || event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return false;
    var target = event.target, dialog = document.querySelector("dialog[open]");
    if (dialog) return dialog === help && event.key === "?" ? (keys(), true) : false;
    if (event.key === "Escape" && target.matches("select")) return false;
    if (target.closest && target.closest("select, textarea, input:not([type=range], [type=radio])") && !/^(Page|Escape)/.test(event.key)) return false;
    if ((event.key === " " || event.key === "Enter") && target.closest && target.closest("button, a, summary, input")) return false;
    if (event.key === "Enter" && deck.classList.contains("deck-over")) { overview(); return true; }
    var command = COMMANDS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (event.key === " " && event.shiftKey) command = previous;
    // The page's other keys, such as that of the search, would act behind the slides.
    if (!command) return event.key.length === 1;
    command();
    return true;
  }

  function onKey(event) {
    if (!press(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  // Slides can be chosen in the overview; links within the page lead to the slide that has what they name.
  function onClick(event) {
    if (!deck || !deck.contains(event.target)) return;
    if (deck.classList.contains("deck-paused")) return pause();
    var section = event.target.closest(".slide");
    if (deck.classList.contains("deck-over") && section) {
      event.preventDefault();
      overview();
      return go(model.of(section));
    }
    var link = event.target.closest("a[href^='#']");
    var target = link && document.getElementById(decodeURIComponent(link.hash.slice(1)).replace(/:step=\d+$/, ""));
    if (!target) return;
    event.preventDefault();
    go(model.of(target));
  }

  function follow() {
    var asked = /^#\/(\d+)$/.exec(location.hash);
    if (asked && deck) go(Number(asked[1]) - 1);
    else if (asked) enter(Number(asked[1]) - 1);
    else if (deck) leave();
  }

  document.addEventListener("touchstart", function (event) {
    touch = deck && event.touches.length === 1 && !event.target.closest("input") ? event.touches[0] : null;
  }, { passive: true });
  document.addEventListener("touchend", function (event) {
    var end = event.changedTouches[0];
    if (!deck || !touch || deck.classList.contains("deck-over")) return;
    var right = end.clientX - touch.clientX;
    if (Math.abs(right) < SWIPE || Math.abs(right) < Math.abs(end.clientY - touch.clientY)) return;
    if (right < 0) next(); else previous();
  });

  // On paper every stepper is at its last step.
  var before = [];
  window.addEventListener("beforeprint", function () {
    fitAll();
    before = slides.filter(function (slide) { return slide.stepper; }).map(function (slide) { return [slide, stepOf(slide).now]; });
    before.forEach(function (pair) { step(pair[0], Infinity); });
  });
  window.addEventListener("afterprint", function () { before.forEach(function (pair) { step(pair[0], pair[1]); }); });

  window.addEventListener("keydown", onKey, true);
  window.addEventListener("resize", scale);
  window.addEventListener("hashchange", follow);
  document.addEventListener("click", onClick);

  workbook.deck = {
    press: press,
    enter: enter,
    state: function () { return { slides: slides, at: at, open: Boolean(deck), paused: Boolean(deck) && deck.classList.contains("deck-paused"), step: deck && stepOf(slides[at]) }; },
    next: next,
    previous: previous
  };
})();
