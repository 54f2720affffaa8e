// Pictures above the tables that are stepped through: lanes of threads or ranks between which particles fly, threads
// and the locks that they hold, bars of numbers. A picture is drawn from the recorded rows, so it shows nothing that
// the table does not have.
"use strict";
(() => {
  const make = (parent, name, properties = {}) => {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  };

  // A cell of particles, or of other numbers.
  const NUMBERS = /^[-\d |()]+( waits)?$/,
    OTHER = /\b(count|counts|displacements)\b/,
    PAIRS = /\d+[-+]\d+/;
  const ofParticles = (name, text) => NUMBERS.test(text) && !OTHER.test(name);

  // Fills a cell with numbers as tiles in the colours of `homes`. Tiles in parentheses are dashed, and tiles between
  // two bars stay together.
  function fill(cell, text, homes) {
    for (const part of text.split(/(?=\|)/)) {
      const span = make(cell, "span"),
        isGhost = part.includes("(");
      for (const word of part.match(/\d+[-+]\d+|\d+|\D+/g) ?? []) {
        if (!/\d/.test(word)) {
          span.append(word);
          continue;
        }
        const tile = make(span, "b", { className: isGhost ? "steps-ghost" : "", textContent: word });
        tile.style.setProperty("--home", `var(--steps-${(homes.get(word) ?? 0) % 4})`);
      }
    }
  }

  // Returns the lane in which a cell is drawn: the receiver's lane if the row is about sending.
  function receiver(name, column) {
    if (/to the rank before/.test(name)) return column - 1;
    if (/to the rank after/.test(name)) return column + 1;
    const told = name.match(/tells rank (\d+)/);
    return told ? Number(told[1]) : column;
  }

  // Each tile flies to its place from the nearest place that its number had in the moment before.
  function flying(element, change) {
    const tiles = () => [...element.querySelectorAll("b")];
    const place = tile => ({ number: tile.textContent, left: tile.offsetLeft, top: tile.offsetTop });
    const before = tiles().map(place);
    change();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    for (const tile of tiles()) {
      const to = place(tile);
      const far = from => Math.hypot(from.left - to.left, from.top - to.top);
      const [from] = before.filter(({ number }) => number === to.number).sort((a, b) => far(a) - far(b));
      if (!from || far(from) < 1) continue;
      const start = `translate(${from.left - to.left}px, ${from.top - to.top}px)`;
      tile.animate([{ transform: start }, { transform: "none" }], { duration: 600, easing: "ease-in-out" });
    }
  }

  // A lane for each column. Its first line shows the particles that it holds: the latest row whose name matches
  // `holds`. Its second line shows the row of the moment.
  function lanes(element, { names, rows, homes, holds }) {
    const made = names.map(name => {
      const lane = make(element, "div", { className: "lane" });
      make(lane, "strong", { textContent: name });
      return { lane, held: make(lane, "p"), now: make(lane, "p") };
    });
    const put = (line, name, text) => {
      if (text === "-" || text === "") return;
      if (ofParticles(name, text)) fill(line, text.replace(" waits", ""), homes);
      else if (PAIRS.test(text)) fill(line, text.match(/\d+[-+]\d+|[a-z]{3,}/g).join(" "), homes);
      else line.append(text);
    };
    return at =>
      flying(element, () => {
        const [name, ...cells] = rows[at];
        const held = rows.slice(0, at + 1).findLast(([name]) => holds.test(name));
        made.forEach(({ lane, held: line, now }, column) => {
          line.replaceChildren();
          now.replaceChildren();
          if (held) put(line, held[0], held[column + 1]);
          lane.classList.toggle("is-waiting", /waits/.test(cells[column]));
        });
        if (held === rows[at]) return;
        cells.forEach((text, column) => {
          const lane = made[receiver(name, column)];
          if (lane) put(lane.now, name, text);
        });
      });
  }

  // Threads on the left, locks on the right. A line is a lock that is held, a dashed line one that is asked for.
  function locks(element, { names, rows }) {
    const HIGH = 56;
    const columns = kind => names.flatMap((name, k) => (name.startsWith(kind) ? [{ name, cell: k + 1 }] : []));
    const [threads, guards] = [columns("thread"), columns("lock")];
    const high = HIGH * Math.max(threads.length, guards.length);
    const middle = k => HIGH * (Number(k) + 0.5);
    const line = (thread, lock, kind) =>
      `<line class="${kind}" x1="96" y1="${middle(thread)}" x2="224" y2="${middle(lock)}"></line>`;
    return at => {
      let drawn = "";
      threads.forEach(({ name, cell }, k) => {
        const text = rows[at][cell];
        for (const [lock] of (text.match(/has [\d and]+/)?.[0] ?? "").matchAll(/\d+/g)) drawn += line(k, lock, "held");
        const wanted = text.match(/(asks|waits) for (\d+)/);
        if (wanted) drawn += line(k, wanted[2], wanted[1]);
        drawn += `<rect x="8" y="${middle(k) - 16}" width="88" height="32" rx="16"></rect>
          <text x="52" y="${middle(k) + 5}">${name}</text>`;
      });
      guards.forEach(({ name, cell }, k) => {
        const inside = /^bin/.test(rows[at][cell]) ? `, ${rows[at][cell]}` : "";
        drawn += `<rect x="224" y="${middle(k) - 16}" width="128" height="32"></rect>
          <text x="288" y="${middle(k) + 5}">${name}${inside}</text>`;
      });
      element.innerHTML = `<svg viewBox="0 0 360 ${high}">${drawn}</svg>`;
    };
  }

  // The numbers of each column as bars, all on one scale.
  function bars(element, { names, rows }) {
    const numbers = text => (text.match(/\d+/g) ?? []).map(Number);
    const most = Math.max(...rows.flatMap(([, ...cells]) => cells.flatMap(numbers)));
    const widest = Math.max(...rows.flatMap(([, ...cells]) => cells.map(cell => numbers(cell).length)));
    const made = names.map((name, column) => {
      const lane = make(element, "div", { className: "lane" });
      make(lane, "strong", { textContent: name });
      const row = make(lane, "div", { className: "bars" });
      row.style.setProperty("--home", `var(--steps-${column % 4})`);
      return Array.from({ length: widest }, () => make(row, "i"));
    });
    return at =>
      made.forEach((bars, column) => {
        const shown = numbers(rows[at][column + 1]);
        bars.forEach((bar, k) => {
          bar.dataset.number = shown[k] ?? "";
          bar.style.height = `${(100 * (shown[k] ?? 0)) / most}%`;
        });
      });
  }

  globalThis.pictures = { make, fill, ofParticles, NUMBERS, OTHER, kinds: { lanes, locks, bars } };
})();
