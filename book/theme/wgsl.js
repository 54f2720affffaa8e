// The colours of WGSL, which mdBook's highlighter does not know: it takes such a block for C first.
"use strict";
(() => {
  hljs.registerLanguage("wgsl", ({ C_LINE_COMMENT_MODE, C_BLOCK_COMMENT_MODE }) => ({
    keywords: {
      keyword:
        "fn let var const override struct alias if else for while loop switch case default break continue " +
        "continuing return discard enable requires const_assert",
      literal: "true false",
      built_in: "bool i32 u32 f32 f16 vec2 vec3 vec4 array atomic ptr storage workgroup uniform function private",
    },
    contains: [
      C_LINE_COMMENT_MODE,
      C_BLOCK_COMMENT_MODE,
      { className: "meta", begin: /@\w+/ },
      { className: "number", begin: /\b(0x[\da-f]+|\d+(\.\d*)?(e[-+]?\d+)?)[iufh]?\b/i },
      { className: "title", begin: /(?<=\bfn\s+)\w+/ },
    ],
  }));
  for (const code of document.querySelectorAll("code.wgsl")) {
    code.classList.remove("c", "language-c");
    code.classList.add("language-wgsl");
    code.textContent = code.textContent;
    hljs.highlightBlock(code);
  }
})();
