// The book has two themes that are tested for contrast, and "auto". The others of mdBook are not offered.
"use strict";
(() => {
  for (const name of ["rust", "coal", "ayu"]) {
    document.getElementById(`mdbook-theme-${name}`).parentElement.remove();
    // A reader who chose one of them earlier gets the offered theme of the same kind.
    if (!document.documentElement.classList.contains(name)) continue;
    document.getElementById(`mdbook-theme-${name === "rust" ? "light" : "navy"}`).click();
  }
})();
