// An option in a command, such as --variant, is one word: a line does not end behind its hyphens.
"use strict";
(() => {
  const option = /(^|[\s([{|])(--?[a-z][\w-]*)/gi;
  for (const code of document.querySelectorAll("main code:not([class*=language-]), main code.language-sh")) {
    const texts = document.createTreeWalker(code, NodeFilter.SHOW_TEXT);
    const all = [];
    while (texts.nextNode()) all.push(texts.currentNode);
    for (const text of all) {
      for (const found of [...text.data.matchAll(option)].reverse()) {
        const word = text.splitText(found.index + found[1].length);
        word.splitText(found[2].length);
        const span = document.createElement("span");
        span.className = "option";
        word.replaceWith(span);
        span.append(word);
      }
    }
  }
})();
