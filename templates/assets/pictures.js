// Pictures beside each other can also be flipped between, in one place and at the same pixels. Without this script they stand side by side.
(function () {
  "use strict";

  // The most screen pixels for each pixel of the picture, in whole numbers, that fit.
  function fit(box, picture) {
    var image = picture.querySelector("img");
    var most = Math.floor(box.clientWidth / Number(image.getAttribute("width")));
    box.style.setProperty("--flip-zoom", Math.max(1, Math.min(most, 3)));
  }

  // As many as stand in a row or two are buttons; more are a list.
  var MOST_BUTTONS = 5;

  function buttons(bar, names, index, choose) {
    names.forEach(function (name, at) {
      var label = document.createElement("label");
      var input = document.createElement("input");
      input.type = "radio";
      input.name = "flip-" + index;
      input.addEventListener("change", function () { choose(at - 1); });
      var text = document.createElement("span");
      text.innerHTML = name;
      label.append(input, text);
      bar.appendChild(label);
    });
    return function (at) { bar.querySelectorAll("input")[at + 1].checked = true; };
  }

  function list(bar, names, choose) {
    var select = document.createElement("select");
    select.setAttribute("aria-label", "View");
    names.forEach(function (name) {
      var option = document.createElement("option");
      option.innerHTML = name;
      option.textContent = option.textContent.trim();
      select.appendChild(option);
    });
    select.addEventListener("change", function () { choose(select.selectedIndex - 1); });
    bar.appendChild(select);
    return function (at) { select.selectedIndex = at + 1; };
  }

  var count = 0;

  function enhance(box) {
    var pictures = Array.prototype.slice.call(box.querySelectorAll(".picture"));
    if (pictures.length < 2 || (box.previousElementSibling && box.previousElementSibling.matches(".flip"))) return;
    var index = count++;
    var bar = document.createElement("fieldset");
    bar.className = "flip";
    var legend = document.createElement("legend");
    legend.textContent = "View";
    bar.appendChild(legend);
    var names = ["Side by side"].concat(pictures.map(function (picture) { return picture.querySelector(".title").innerHTML; }));

    function choose(at) {
      box.classList.toggle("flipping", at >= 0);
      pictures.forEach(function (picture, which) { picture.classList.toggle("shown", which === at); });
      if (at >= 0) fit(box, pictures[at]);
      mark(at);
    }

    var mark = pictures.length <= MOST_BUTTONS ? buttons(bar, names, index, choose) : list(bar, names, choose);
    pictures.forEach(function (picture, at) {
      picture.querySelector("img").addEventListener("click", function () {
        choose(box.classList.contains("flipping") ? (at + 1) % pictures.length : at);
      });
    });
    box.parentNode.insertBefore(bar, box);
    choose(-1);
  }

  document.addEventListener("DOMContentLoaded", function () {
    workbook.each(function () { document.querySelectorAll(".pictures").forEach(enhance); });
  });
})();
