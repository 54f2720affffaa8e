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
