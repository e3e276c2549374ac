// The page follows its author: `workbook serve` puts this script first into each page that it serves, and no built book has it.
//
// The server says when there is a new edition. Then the page asks what has changed since the one that it shows, and gets the blocks that are
// new; all others stay as they are, with what a reader has opened in them and where they stand on the screen.
(function () {
  "use strict";
  var me = document.currentScript;
  var own = me.src.replace(/[^/]*$/, "");
  var digest = me.dataset.digest, path = me.dataset.path;
  var assets = me.dataset.assets, scripts = me.dataset.scripts;
  var root = document.documentElement;
  var FRAME = ".book-title, .chapters, .shelves-head, .matter, .on-this-page, .opening, .members, .turn, .colophon";
  var NOT_BLOCK = 8; // the type of comment nodes, which stand between blocks

  function list(things) { return Array.prototype.slice.call(things); }
  function frame(of) { return list(of.querySelectorAll(FRAME)).filter(function (piece) { return !piece.parentElement.closest(FRAME + ", article.text > :not(header)"); }); }
  function source(piece) { return piece.outerHTML; }

  // What is around the text as the server made it, before other scripts add to it.
  var around = frame(document).map(source);
  var edition = 0, asking = false, again = false, news = {}, lost = false, dismissed = "", announced = false;

  // --- What has changed ---

  function isMark(node) { return node.nodeType === NOT_BLOCK && node.data === "block"; }

  // The blocks of the article, each with the mark behind it; none if they cannot be told apart.
  function blocks(article) {
    var found = [], block = null;
    list(article ? article.childNodes : []).forEach(function (node) {
      if (block) block.push(node);
      if (isMark(node)) {
        if (block) found.push(block);
        block = [];
      }
    });
    return found;
  }

  function made(html) {
    var holder = document.createElement("template");
    holder.innerHTML = html;
    // A picture under the same name may be another now.
    holder.content.querySelectorAll("img").forEach(function (image) {
      var from = image.getAttribute("src") || "";
      if (!/^[a-z]+:/i.test(from)) image.setAttribute("src", from + "?" + edition);
    });
    return list(holder.content.childNodes).concat(document.createComment("block"));
  }

  function elements(nodes) { return nodes.filter(function (node) { return node.nodeType === 1; }); }

  function within(nodes, selector) {
    return elements(nodes).reduce(function (found, element) {
      return found.concat(element.matches(selector) ? [element] : [], list(element.querySelectorAll(selector)));
    }, []);
  }

  function keyOf(fold) {
    var summary = fold.querySelector("summary"), around = fold.parentElement && fold.parentElement.closest("[id]");
    return [fold.className, around ? around.id : "", summary ? summary.textContent : ""].join("|");
  }

  // What a reader has chosen in parts that go, for those that come in their places.
  function choices(nodes) {
    var kept = { folds: {}, steps: {}, views: {} };
    within(nodes, "details").forEach(function (fold) {
      (kept.folds[keyOf(fold)] = kept.folds[keyOf(fold)] || []).push(fold.open);
    });
    within(nodes, ".exhibit").forEach(function (figure) {
      var slider = figure.querySelector(".step-slider"), view = figure.querySelector(".flip select");
      var radios = list(figure.querySelectorAll(".flip input"));
      if (slider) kept.steps[figure.id] = slider.value;
      if (view) kept.views[figure.id] = view.selectedIndex;
      else if (radios.length) kept.views[figure.id] = radios.findIndex(function (radio) { return radio.checked; });
    });
    return kept;
  }

  function choose(nodes, kept) {
    within(nodes, "details").forEach(function (fold) {
      var open = (kept.folds[keyOf(fold)] || []).shift();
      if (open !== undefined) fold.open = open;
    });
    within(nodes, ".exhibit").forEach(function (figure) {
      var slider = figure.querySelector(".step-slider"), view = figure.querySelector(".flip select");
      var radio = figure.querySelectorAll(".flip input")[kept.views[figure.id]];
      if (slider && kept.steps[figure.id]) {
        slider.value = kept.steps[figure.id];
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
      if (view && kept.views[figure.id]) {
        view.selectedIndex = kept.views[figure.id];
        view.dispatchEvent(new Event("change", { bubbles: true }));
      } else if (radio && !radio.checked) {
        radio.checked = true;
        radio.dispatchEvent(new Event("change", { bubbles: true }));
      }
    });
  }

  // What stays and is on the screen, or else is nearest above it: it is to stay where the reader sees it.
  function anchor(staying) {
    var above = null;
    for (var at = 0; at < staying.length; at++) {
      var box = staying[at].getBoundingClientRect();
      if (!box.height) continue;
      if (box.bottom > 0 && box.top >= 0 && box.top < innerHeight) return { element: staying[at], edge: "top", at: box.top };
      if (box.bottom > 0 && box.top < 0) above = { element: staying[at], edge: box.bottom < innerHeight ? "bottom" : "top", at: box.bottom < innerHeight ? box.bottom : box.top };
      else if (box.bottom <= 0) above = { element: staying[at], edge: "bottom", at: box.bottom };
      else break;
    }
    return above;
  }

  function hold(held) {
    if (!held) return;
    var moved = held.element.getBoundingClientRect()[held.edge] - held.at;
    if (Math.abs(moved) > 0.5) window.scrollBy({ top: moved, behavior: "instant" });
  }

  // Puts the new blocks in. Says whether it could.
  function change(parts) {
    var article = document.querySelector("article.text"), old = blocks(article);
    if (!old.length) return false;
    var inner = parts.slice(1, -1), stays = {};
    if (inner.some(function (part) { return typeof part === "number" && !old[part - 1]; })) return false;
    inner.forEach(function (part) { if (typeof part === "number") stays[part - 1] = true; });
    var going = old.filter(function (_, at) { return !stays[at]; });
    var staying = old.filter(function (_, at) { return stays[at]; });
    var held = anchor(staying.reduce(function (found, block) { return found.concat(elements(block)); }, []));
    var gone = going.reduce(function (found, block) { return found.concat(block); }, []), kept = choices(gone);
    var next = old[0][0], come = [];
    var place = document.createComment("");
    article.insertBefore(place, next);
    gone.forEach(function (node) { node.remove(); });
    inner.forEach(function (part) {
      var nodes = typeof part === "number" ? old[part - 1] : made(part);
      if (typeof part !== "number") come = come.concat(nodes);
      // What is in its place already is not touched: it may have the focus.
      if (place.nextSibling !== nodes[0]) nodes.forEach(function (node) { article.insertBefore(node, place); });
      else article.insertBefore(place, nodes[nodes.length - 1].nextSibling);
    });
    place.remove();
    workbook.again();
    choose(come, kept);
    hold(held);
    return true;
  }

  function other(text) { return new DOMParser().parseFromString(text, "text/html"); }

  // What is around the text: lists of chapters and sections, the opening, the links to the neighbours.
  function reframe(text) {
    var next = other(text), pieces = frame(next), sources = pieces.map(source), shown = frame(document);
    if (next.body.className !== document.body.className.replace(/ ?live-\w+/g, "") || pieces.length !== around.length || shown.length !== around.length) return false;
    sources.forEach(function (piece, at) { if (piece !== around[at]) shown[at].replaceWith(document.importNode(pieces[at], true)); });
    around = sources;
    document.title = next.title;
    next.querySelectorAll("head script[src], head link[rel=stylesheet]").forEach(function (asked) {
      var name = asked.localName === "script" ? "src" : "href", address = asked.getAttribute(name);
      var there = list(document.head.querySelectorAll(asked.localName)).some(function (known) { return (known.getAttribute(name) || "").split("?")[0] === address; });
      if (there) return;
      var added = document.createElement(asked.localName);
      if (asked.rel) added.rel = asked.rel;
      added[name] = address;
      document.head.appendChild(added);
    });
    return true;
  }

  // A page that is no chapter is replaced whole.
  function replace(text) {
    var main = document.querySelector("main"), next = other(text).querySelector("main");
    if (!main || !next || !reframe(text)) return false;
    var y = window.scrollY, kept = choices(list(main.childNodes));
    main.replaceChildren.apply(main, list(document.importNode(next, true).childNodes));
    workbook.again();
    choose(list(main.childNodes), kept);
    window.scrollTo({ top: y, behavior: "instant" });
    return true;
  }

  // Sheets and pictures under the same names are loaded again.
  function restyle() {
    document.querySelectorAll("link[rel=stylesheet]").forEach(function (sheet) {
      if (sheet.href.indexOf(own) === 0) return;
      var fresh = sheet.cloneNode();
      fresh.href = sheet.getAttribute("href").split("?")[0] + "?" + edition;
      fresh.onload = function () { sheet.remove(); };
      sheet.after(fresh);
    });
    document.querySelectorAll("main img").forEach(function (image) {
      var from = image.getAttribute("src") || "";
      if (!/^[a-z]+:/i.test(from)) image.setAttribute("src", from.split("?")[0] + "?" + edition);
    });
  }

  function apply(patch) {
    if (scripts && patch.scripts !== scripts) return location.reload();
    if (patch.digest !== digest) {
      if (document.body.classList.contains("live-blank")) return location.reload();
      var parts = patch.parts, first = parts[0], last = parts[parts.length - 1], done = true;
      // The browser keeps a place of its own, and would do it twice.
      root.style.overflowAnchor = "none";
      if (parts.length < 3) done = typeof first !== "string" || replace(first);
      else done = (typeof first !== "string" || reframe(first + last)) && change(parts);
      if (!done) return location.reload();
      requestAnimationFrame(function () { root.style.overflowAnchor = ""; });
      digest = patch.digest;
    }
    if (patch.assets !== assets) restyle();
    assets = patch.assets;
    scripts = patch.scripts;
    mark();
    document.dispatchEvent(new CustomEvent("workbook:changed", { detail: edition }));
  }

  // While the page is shown as slides, its blocks are elsewhere.
  function away() { return root.classList.contains("presenting"); }

  function ask() {
    if (asking || away()) { again = true; return; }
    asking = true;
    again = false;
    var asked = own + "page?path=" + encodeURIComponent(path) + "&from=" + digest;
    fetch(asked).then(function (reply) {
      if (reply.ok) return reply.json().then(apply);
      say("gone", "This page is no longer in the book.");
    }).catch(function () { again = true; }).then(function () {
      asking = false;
      if (again && !lost && !away()) setTimeout(ask, 20);
    });
  }
  new MutationObserver(function () { if (again && !away()) ask(); }).observe(root, { attributes: true, attributeFilter: ["class"] });

  // --- What is told ---

  function element(name, kind, parent, text) {
    var added = document.createElement(name);
    if (kind) added.className = kind;
    if (text) added.textContent = text;
    if (parent) parent.appendChild(added);
    return added;
  }

  var bar = element("div", "live-bar"), panel = null, status = {};
  bar.setAttribute("role", "status");

  function counted(count, word) { return count + " " + word + (count === 1 ? "" : "s"); }

  // A short line in the corner; an empty one removes it. With `press`, it is a button.
  function say(which, text, press) {
    if (status[which] && status[which].textContent === text) return;
    if (status[which]) status[which].remove();
    delete status[which];
    if (!text) return;
    status[which] = element(press ? "button" : "span", "live-" + which, bar, text);
    if (press) {
      status[which].type = "button";
      status[which].addEventListener("click", press);
    }
  }

  function close() {
    if (!panel) return false;
    panel.remove();
    panel = null;
    return true;
  }

  // Mistakes as the terminal tells them, each with a link to its place in the editor.
  function show(title, found, count, kind) {
    close();
    panel = element("section", "live-panel live-panel-" + kind, document.body);
    panel.setAttribute("aria-label", title);
    var head = element("header", "", panel);
    element("h2", "", head, title);
    var button = element("button", "", head, "Close");
    button.type = "button";
    button.addEventListener("click", function () { dismissed = kind === "errors" ? JSON.stringify(found) : dismissed; close(); });
    found.forEach(function (one) {
      var item = element("article", "", panel), line = element("p", "live-place", item);
      element("span", "live-code", line, one.code);
      if (one.place && one.place.link) element("a", "", line, one.place.text).href = one.place.link;
      else if (one.place) element("span", "", line, one.place.text);
      element("pre", "", item, one.text.replace(/\n+$/, ""));
    });
    if (count > found.length) element("p", "live-more", panel, "and " + (count - found.length) + " more");
  }

  function mark() {
    var stale = news.stale || [];
    document.querySelectorAll(".live-stale").forEach(function (part) { part.classList.remove("live-stale"); });
    stale.forEach(function (id) {
      var figure = document.getElementById(id);
      if (figure) figure.classList.add("live-stale");
      document.querySelectorAll('.value[title*="' + CSS.escape(id) + '."]').forEach(function (value) { value.classList.add("live-stale"); });
    });
    say("stale", stale.length ? "computing " + counted(stale.length, "exhibit") : "");
  }

  function tell() {
    var errors = news.errors || [], warnings = news.warnings || [];
    var title = counted(news.error_count || 0, "mistake"), key = JSON.stringify(errors);
    say("errors", errors.length ? title : "", function () { if (!close()) show(title, errors, news.error_count, "errors"); });
    say("warnings", warnings.length ? counted(news.warning_count, "warning") : "", function () {
      if (!close()) show(counted(news.warning_count, "warning"), warnings, news.warning_count, "warnings");
    });
    if (errors.length && key !== dismissed) {
      show(title, errors, news.error_count, "errors");
      panel.setAttribute("role", "alert");
    } else if (!errors.length) {
      dismissed = "";
      if (panel && panel.classList.contains("live-panel-errors")) close();
    }
    mark();
  }

  document.body.appendChild(bar);
  document.addEventListener("DOMContentLoaded", function () {
    if (window.workbook && workbook.keys) workbook.keys.closes(function () {
      if (panel) dismissed = JSON.stringify(news.errors || []);
      return close();
    });
  });

  // --- The way to the server ---

  var line = new EventSource(own + "events");
  line.onopen = function () {
    lost = false;
    say("lost", "");
  };
  line.onerror = function () {
    lost = true;
    say("lost", "The preview has stopped; this page waits for it.");
    // A browser does not try again after some failures.
    if (line.readyState === EventSource.CLOSED) setTimeout(function () { location.reload(); }, 2000);
  };
  line.onmessage = function (event) {
    var told = JSON.parse(event.data), first = !announced;
    announced = true;
    news = told.news;
    say("gone", "");
    tell();
    // The page may be older than what is told first, too.
    if (first || told.edition !== edition) {
      edition = told.edition;
      ask();
    }
  };
  window.addEventListener("pagehide", function () { line.close(); });
  window.addEventListener("pageshow", function (event) { if (event.persisted) location.reload(); });
})();
