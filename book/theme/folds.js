// Opens the folds that a search or a link leads into. Hints stay folded.
"use strict";
(() => {
  const unfold = element => {
    for (let fold = element?.closest("details"); fold; fold = fold.parentElement.closest("details")) {
      if (fold.closest(".hint")) return;
      fold.open = true;
    }
  };
  const target = () => unfold(document.getElementById(location.hash.slice(1)));
  addEventListener("hashchange", target);
  target();
  // The search marks its words once its index has come.
  new MutationObserver(() =>
    document.querySelectorAll("main details:not([open]) mark").forEach(unfold),
  ).observe(document.querySelector("main"), { childList: true, subtree: true });
})();
