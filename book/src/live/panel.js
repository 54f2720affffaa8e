// What the boxes have in common: panels, and soft discs in them. Needs soft.js and player.js.
"use strict";
(() => {
  const { CUTOFF } = soft,
    { make, Sheet } = player;
  const wholeNumber = new Intl.NumberFormat("en-GB", { maximumFractionDigits: 0 });
  const whole = value => wholeNumber.format(value);
  const cutoffs = value => `${value.toFixed(2)} c`;
  const percent = share => `${share < 0 ? "−" : "+"}${Math.abs(100 * share).toFixed(2)} %`;

  // A panel: a heading, a sheet, a line of text below.
  function panel(parent, heading, label, extent) {
    const div = make(parent, "div", { className: "live-panel" });
    if (heading) make(div, "p", { className: "live-heading", textContent: heading });
    const sheet = new Sheet(div, label, extent);
    return { sheet, line: make(div, "p", { className: "live-line" }) };
  }

  // Adds a legend: the words of each mark. In all boxes blue is chosen and orange is in contact.
  function legend(parent, words) {
    const list = make(parent, "ul", { className: "live-legend" });
    for (const [mark, text] of Object.entries(words))
      make(list, "li", { className: `is-${mark}`, textContent: text });
  }

  function discs(sheet, box, style) {
    const { grey, orange } = sheet.colours;
    for (let i = 0; i < box.n; i++) {
      const touches = box.touching[i];
      sheet.disc(
        box.x[i],
        box.y[i],
        CUTOFF / 2,
        style?.(i) ?? { fill: touches ? orange : null, line: touches ? orange : grey, opacity: 0.8 },
      );
    }
    sheet.rectangle(0, 0, box.size, box.size, { line: grey, width: 2 });
  }

  // Where particle `i` is.
  const at = (box, i) => [box.x[i], box.y[i]];

  // The particle nearest to the middle, of those that are suitable if any is.
  function middle({ n, size, x, y }, suits = () => true) {
    const away = i => Math.hypot(x[i] - size / 2, y[i] - size / 2) + (suits(i) ? 0 : size);
    return Array.from({ length: n }, (_, i) => i).reduce((a, b) => (away(b) < away(a) ? b : a));
  }

  // The boxes, by the name that a page asks for: each fills an element.
  globalThis.boxes = {};
  globalThis.panels = { whole, cutoffs, percent, panel, legend, discs, at, middle };
})();
