// Writes the state of a figure into the page's address, so that a link leads to it: #box=list&skin=1.5, or
// #steps=2&moment=5 for the second stepper of a page. Needs the figures, so it is the last script.
"use strict";
(() => {
  // Each figure with something to set: the name in the address, and the controls by their names.
  const figures = [...document.querySelectorAll("figure.is-live")].map(figure => describe("box", figure.dataset.box, figure));
  document.querySelectorAll("figure.is-steps").forEach((figure, k) => figures.push(describe("steps", `${k + 1}`, figure)));

  function describe(kind, name, figure) {
    const controls = new Map();
    for (const control of figure.querySelectorAll("input, select"))
      controls.set(control.name || slug(control.closest("label").querySelector("span").textContent), control);
    const begun = new Map([...controls].map(([name, control]) => [name, value(control)]));
    figure.addEventListener("input", () => {
      const state = new URLSearchParams({ [kind]: name });
      for (const [name, control] of controls)
        if (value(control) !== begun.get(name)) state.set(name, value(control));
      history.replaceState(history.state, "", `#${state}`);
    });
    return { kind, name, figure, controls };
  }

  function slug(label) {
    return label.toLowerCase().replace(/[^a-z\d]+/g, "-").replace(/^-|-$/g, "");
  }
  function value(control) {
    return control.type === "checkbox" ? (control.checked ? "on" : "off") : control.value;
  }

  // Gives each figure the state that the address contains.
  function restore() {
    const state = new URLSearchParams(location.hash.slice(1));
    for (const { kind, name, figure, controls } of figures) {
      if (state.get(kind) !== name) continue;
      for (let fold = figure.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
      for (const [name, control] of controls) {
        if (!state.has(name)) continue;
        if (control.type === "checkbox") control.checked = state.get(name) === "on";
        else control.value = state.get(name);
        // They do not bubble: the address is not written again.
        control.dispatchEvent(new Event("input"));
        control.dispatchEvent(new Event("change"));
      }
      figure.scrollIntoView();
    }
  }
  restore();
  addEventListener("hashchange", restore);
})();
