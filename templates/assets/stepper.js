// Steppers: figures whose steps the reader chooses. Without this script a figure shows its last step, and key steps below it.
(function () {
  "use strict";
  var PACE = 1100; // milliseconds from step to step while playing
  var still = window.matchMedia("(prefers-reduced-motion: reduce)");
  var steppers = {};

  // "1-3,7" as a test of steps.
  function ranges(text) {
    var parts = text.split(",").map(function (part) { return part.split("-").map(Number); });
    return function (step) {
      return parts.some(function (part) { return step >= part[0] && step <= part[part.length - 1]; });
    };
  }

  // "1 10 20,5 30 20" as the place at a step: that of the last entry whose step is not above it.
  function places(text) {
    var entries = text.split(",").map(function (entry) { return entry.split(" ").map(Number); });
    return function (step) {
      var entry = entries.filter(function (entry) { return entry[0] <= step; }).pop() || entries[0];
      return "translate(" + entry[1] + "px, " + entry[2] + "px)";
    };
  }

  function all(root, selector) { return Array.prototype.slice.call(root.querySelectorAll(selector)); }

  function start(figure, box) {
    var count = Number(box.dataset.count);
    var groups = all(figure, ".exhibit-body [data-steps]").map(function (group) {
      return { group: group, has: ranges(group.dataset.steps) };
    });
    var movers = all(figure, ".exhibit-body [data-at]").map(function (mover) {
      return { mover: mover, at: places(mover.dataset.at) };
    });
    var part = function (name) { return box.querySelector(".step-" + name); };
    var captions = all(part("captions"), "p");
    var slider = part("slider"), counter = part("count"), play = part("play");
    var step = 0, timer = 0;

    // The captions lie on one another, so that the tallest keeps the place; a line of its own is read out.
    var spoken = document.createElement("p");
    spoken.className = "step-spoken";
    spoken.setAttribute("aria-live", "polite");
    captions.forEach(function (caption) { caption.hidden = false; caption.setAttribute("aria-hidden", "true"); });
    part("captions").appendChild(spoken);

    function show(next) {
      next = Math.min(Math.max(next, 1), count);
      if (next === step) return;
      var focused = box.contains(document.activeElement) && document.activeElement;
      // Only neighbouring steps move; longer ways are jumps.
      figure.classList.toggle("step-jump", Math.abs(next - step) > 1 || step === 0);
      step = next;
      groups.forEach(function (entry) { entry.group.dataset.on = entry.has(step) ? "1" : "0"; });
      movers.forEach(function (entry) { entry.mover.style.setProperty("--at", entry.at(step)); });
      spoken.innerHTML = captions[step - 1].innerHTML;
      slider.value = step;
      slider.setAttribute("aria-valuetext", "Step " + step + " of " + count);
      counter.querySelector("span").textContent = step;
      counter.href = "#" + figure.id + ":step=" + step;
      part("first").disabled = part("previous").disabled = step === 1;
      part("next").disabled = step === count;
      // A button that becomes disabled would lose the focus, and the keys with it: the slider takes it.
      if (focused && focused.disabled) slider.focus({ preventScroll: true });
    }

    function stop() {
      clearInterval(timer);
      timer = 0;
      play.setAttribute("aria-label", "Play");
      play.classList.remove("playing");
    }

    function go(next) { stop(); show(next); }

    play.addEventListener("click", function () {
      if (timer) return stop();
      show(step === count ? 1 : step + 1);
      if (step === count) return;
      play.setAttribute("aria-label", "Pause");
      play.classList.add("playing");
      timer = setInterval(function () {
        show(step + 1);
        if (step === count) stop();
      }, PACE);
    });

    part("first").addEventListener("click", function () { go(1); });
    part("previous").addEventListener("click", function () { go(step - 1); });
    part("next").addEventListener("click", function () { go(step + 1); });
    slider.addEventListener("input", function () { go(Number(slider.value)); });
    figure.addEventListener("keydown", function (event) {
      if (event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
      var body = event.target.closest(".exhibit-body");
      if (body && body.scrollWidth > body.clientWidth + 1) return; // its arrows scroll
      var next = { ArrowLeft: step - 1, ArrowRight: step + 1, Home: 1, End: count }[event.key];
      // The slider has more keys of its own, among them up and down.
      if (next === undefined) return;
      event.preventDefault();
      go(next);
    });
    document.addEventListener("visibilitychange", function () { if (document.hidden) stop(); });
    window.addEventListener("beforeprint", stop);

    figure.classList.add("stepping");
    part("controls").hidden = false;
    show(1);
    steppers[figure.id] = go;
  }

  // `#fig-x:step=5` leads to a step.
  function follow() {
    var asked = /^#(.+):step=(\d+)$/.exec(decodeURIComponent(location.hash));
    if (!asked || !steppers[asked[1]]) return;
    steppers[asked[1]](Number(asked[2]));
    var figure = document.getElementById(asked[1]);
    for (var fold = figure.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
    figure.scrollIntoView({ behavior: still.matches ? "auto" : "smooth", block: "nearest" });
  }

  workbook.each(function () {
    all(document, ".exhibit:not(.stepping) .stepper").forEach(function (box) { start(box.closest(".exhibit"), box); });
  });
  follow();
  window.addEventListener("hashchange", follow);
})();
