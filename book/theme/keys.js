// Whatever has the focus has the arrow keys: they turn the page only where nothing has it. A block that is to be
// scrolled can have it.
"use strict";
(() => {
  const { body } = document;
  body.addEventListener("keydown", event => {
    // mdBook listens further out.
    if (event.target !== body && /^Arrow(Left|Right)$/.test(event.key)) event.stopPropagation();
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
