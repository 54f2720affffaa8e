// Puts the boxes into the page: each <figure class="live" data-box="…"> has a picture, which stays
// where there are no scripts and in print, and a caption. The box takes the picture's place on the
// screen.
"use strict";
(() => {
  for (const figure of document.querySelectorAll("figure.live:not(.is-live)")) {
    const box = document.createElement("div");
    box.className = "live-box";
    // A click anywhere in the box gives it the focus, so that the arrow keys turn no page.
    box.tabIndex = -1;
    figure.insertBefore(box, figure.querySelector("figcaption"));
    figure.classList.add("is-live");
    boxes[figure.dataset.box](box);
  }
})();
