// Pictures beside each other can also be flipped between, in one place and at the same pixels. Without this script they stand side by side.
(function () {
  "use strict";

  // The most screen pixels for each pixel of the picture, in whole numbers, that fit.
  function fit(box, picture) {
    var image = picture.querySelector("img");
    var most = Math.floor(box.clientWidth / Number(image.getAttribute("width")));
    box.style.setProperty("--flip-zoom", Math.max(1, Math.min(most, 3)));
  }

  function enhance(box, index) {
    var pictures = Array.prototype.slice.call(box.querySelectorAll(".picture"));
    if (pictures.length < 2) return;
    var bar = document.createElement("fieldset");
    bar.className = "flip";
    var legend = document.createElement("legend");
    legend.textContent = "View";
    bar.appendChild(legend);

    function choose(at) {
      box.classList.toggle("flipping", at >= 0);
      pictures.forEach(function (picture, which) { picture.classList.toggle("shown", which === at); });
      if (at >= 0) fit(box, pictures[at]);
      bar.querySelectorAll("input")[at + 1].checked = true;
    }

    function option(words, at) {
      var label = document.createElement("label");
      var input = document.createElement("input");
      input.type = "radio";
      input.name = "flip-" + index;
      input.addEventListener("change", function () { choose(at); });
      label.appendChild(input);
      var text = document.createElement("span");
      if (typeof words === "string") text.textContent = words;
      else text.innerHTML = words.innerHTML;
      label.appendChild(text);
      bar.appendChild(label);
    }

    option("Side by side", -1);
    pictures.forEach(function (picture, at) {
      option(picture.querySelector(".title"), at);
      picture.querySelector("img").addEventListener("click", function () {
        if (box.classList.contains("flipping")) choose((at + 1) % pictures.length);
        else choose(at);
      });
    });
    box.parentNode.insertBefore(bar, box);
    choose(-1);
  }

  document.addEventListener("DOMContentLoaded", function () {
    document.querySelectorAll(".pictures").forEach(enhance);
  });
})();
