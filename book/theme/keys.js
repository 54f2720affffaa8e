// Whatever has the focus has the arrow keys: they turn the page only where nothing has it. A block that is to be
// scrolled can have it.
"use strict";
(() => {
  const { body } = document;
  body.addEventListener("keydown", event => {
    // mdBook listens further out.
    if (event.target !== body && /^Arrow(Left|Right)$/.test(event.key)) event.stopPropagation();
  });
  // mdBook's switch of the table of contents is a label, which no key reaches.
  const contents = document.getElementById("mdbook-sidebar-toggle");
  Object.assign(contents, { role: "button", tabIndex: 0 });
  contents.addEventListener("keydown", event => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    contents.click();
  });
  // The first stops lead past the table of contents.
  const skip = (element, id, textContent) => {
    if (!element) return;
    Object.assign(element, { id, tabIndex: -1 });
    const link = Object.assign(document.createElement("a"), { href: `#${id}`, className: "skip", textContent });
    body.insertBefore(link, document.getElementById("mdbook-help-container"));
  };
  skip(document.querySelector("main"), "text", "Skip to the text");
  skip(document.querySelector(".live-box"), "box", "Skip to the figure that plays");
  // mdBook's switches that fold the table of contents have no name and no key.
  for (const fold of document.querySelectorAll(".chapter-fold-toggle")) {
    const chapter = fold.parentElement.querySelector("a").textContent;
    const isOpen = () => fold.closest("li").classList.contains("expanded");
    const say = () => fold.setAttribute("aria-expanded", isOpen());
    Object.assign(fold, { role: "button", tabIndex: 0, ariaLabel: `Pages of ${chapter}` });
    say();
    fold.addEventListener("click", say);
    fold.addEventListener("keydown", event => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      fold.click();
    });
  }
  const blocks = document.querySelectorAll("main :is(pre > code, .table-wrapper, .formula)");
  const mark = () => {
    for (const block of blocks)
      if (block.scrollWidth > block.clientWidth + 1) block.tabIndex = 0;
      else block.removeAttribute("tabindex");
  };
  mark();
  addEventListener("load", mark);
  addEventListener("resize", mark);
  // What a fold hides has no width before.
  addEventListener("toggle", mark, true);
})();
