// A drawing is a link to its file. Here a click shows it larger, in the page; the next one, or Escape, closes it.
"use strict";
(() => {
  const main = document.querySelector("main");
  const make = (parent, name, properties) => {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  };
  const sheet = make(main, "dialog", { className: "zoom", ariaLabel: "The drawing, enlarged" });
  make(sheet, "button", { type: "button", textContent: "Close" });
  const image = make(sheet, "img", { alt: "" });
  sheet.addEventListener("click", () => sheet.close());
  // mdBook takes the key, and a dialog would not hear of it.
  sheet.addEventListener("keydown", event => event.key === "Escape" && sheet.close());
  main.addEventListener("click", event => {
    const link = event.target.closest("a:has(> img, > picture)");
    // With these keys a browser opens a tab or a window.
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    const { alt } = link.querySelector("img");
    Object.assign(image, { src: link.href, alt });
    sheet.showModal();
  });
})();
