// Steps through a table of what threads or ranks do and have, row by row. A <figure class="steps">
// has the table as text, as a test of the kit recorded it, which stays where there are no scripts and
// in print: a line of names, then a line for each moment. Particles that stood in a column first have
// its colour ever after; those in parentheses are ghosts. With `data-picture` a picture moves above the
// table. Needs pictures.js.
"use strict";
(() => {
  const { make, fill, ofParticles, NUMBERS, OTHER } = pictures;

  // The columns' names and where they begin; then rows, the name of each before its cells.
  function read(text) {
    const [head, ...lines] = text.replace(/\s+$/, "").split("\n");
    const starts = [...head.matchAll(/\S+( \S+)*/g)].map(name => name.index);
    const cut = line =>
      [0, ...starts].map((start, k) => line.slice(start, starts[k] ?? line.length).trimEnd());
    return { names: cut(head), rows: lines.map(cut) };
  }

  // The column in which each particle stands first, not as a ghost.
  function firstPlaces(rows) {
    const homes = new Map();
    for (const [name, ...cells] of rows)
      if (!OTHER.test(name))
        cells.forEach((cell, column) => {
          const own = cell.replace(/\(.*?\)/g, "");
          for (const [number] of own.matchAll(NUMBERS.test(cell) ? /\d+/g : /\d+[-+]\d+/g))
            if (!homes.has(number)) homes.set(number, column);
        });
    return homes;
  }

  // Adds the picture that a figure asks for, and returns the function that draws it at a moment.
  function picture(box, { picture, holds = "^$" }, table) {
    if (!picture) return undefined;
    const element = make(box, "div", { className: `steps-picture is-${picture}`, ariaHidden: "true" });
    element.style.setProperty("--columns", table.names.length);
    const draw = pictures.kinds[picture](element, { ...table, holds: new RegExp(holds) });
    return at => {
      draw(at);
      // It grows but does not shrink, so the buttons stay where they are.
      element.style.minHeight = `${element.offsetHeight}px`;
    };
  }

  function build(figure) {
    const { names, rows } = read(figure.querySelector("pre code").textContent),
      homes = firstPlaces(rows);
    const box = document.createElement("div");
    box.className = "steps-box";
    figure.insertBefore(box, figure.querySelector("figcaption"));
    figure.classList.add("is-steps");
    const draw = picture(box, figure.dataset, { names: names.slice(1), rows, homes });
    const frame = make(box, "div", { className: "steps-frame", tabIndex: 0 });
    frame.setAttribute("role", "region");
    frame.setAttribute("aria-label", "The moments so far; arrow keys go on and back");
    const table = make(frame, "table");
    table.style.setProperty("--columns", names.length - 1);
    const head = make(make(table, "thead"), "tr");
    make(head, "td");
    for (const name of names.slice(1)) make(head, "th", { scope: "col", textContent: name });
    const body = make(table, "tbody");
    const lines = rows.map(([name, ...cells], row) => {
      const line = make(body, "tr");
      make(line, "th", { scope: "row", textContent: name });
      cells.forEach((text, column) => {
        const cell = make(line, "td");
        if (text !== rows[row - 1]?.[column + 1]) cell.className = "is-new";
        if (/waits/.test(text)) cell.classList.add("is-waiting");
        if (ofParticles(name, text)) fill(cell, text, homes);
        else cell.textContent = text;
      });
      return line;
    });

    const buttons = make(box, "div", { className: "live-buttons" });
    const button = (text, go) => {
      const made = make(buttons, "button", { type: "button", textContent: text });
      made.onclick = go;
      return made;
    };
    const back = button("Back", () => go(at - 1)),
      next = button("Next", () => go(at + 1));
    button("From the start", () => go(0));
    const moment = make(buttons, "input", { type: "range", name: "moment", min: 1, max: rows.length });
    moment.setAttribute("aria-label", "Moment");
    moment.addEventListener("input", () => show(moment.value - 1));
    const said = make(buttons, "output", { className: "steps-said" });
    let at = 0;
    // Buttons and keys move the slider, because the address contains its value.
    function go(row) {
      moment.value = row + 1;
      moment.dispatchEvent(new Event("input", { bubbles: true }));
    }
    function show(row) {
      at = row;
      moment.value = at + 1;
      draw?.(at);
      lines.forEach((line, k) => {
        line.classList.toggle("is-now", k === at);
        line.classList.toggle("is-to-come", k > at);
      });
      said.textContent = `${at + 1} of ${rows.length}: ${rows[at][0].trim()}`;
      // A button that has the focus keeps it.
      back.setAttribute("aria-disabled", at === 0);
      next.setAttribute("aria-disabled", at === rows.length - 1);
      const now = lines[at];
      frame.scrollTop = now.offsetTop + now.offsetHeight - frame.clientHeight + 4;
    }
    box.addEventListener("keydown", event => {
      const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: rows.length }[event.key];
      if (to === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      go(to);
    });
    // It opens where there is something to see.
    const hasNumbers = text => NUMBERS.test(text) && /\d/.test(text);
    show(Math.max(0, rows.findIndex(([name, ...cells]) => !OTHER.test(name) && cells.some(hasNumbers))));
  }

  document.querySelectorAll("figure.steps:not(.is-steps)").forEach(build);
})();
