// A page of slides: the arrow keys, Page Up, Page Down and the space bar lead from slide to slide, and N shows the
// notes. The address names the slide, so that it can be sent and reloaded: #slide-5, or #notes-5 with notes.
"use strict";
(() => {
  const slides = [...document.querySelectorAll("main > .slide")];
  if (slides.length === 0 || slides[0] !== document.querySelector("main").firstElementChild) return;
  const root = document.documentElement;
  const steps = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, End: Infinity };
  Object.assign(steps, { ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Home: -Infinity });

  const distance = slide => Math.abs(slide.getBoundingClientRect().top);
  const current = () => slides.reduce((best, slide, k) => (distance(slide) < distance(slides[best]) ? k : best), 0);
  const show = number => {
    slides[number].scrollIntoView({ behavior: "instant" });
    const name = root.classList.contains("with-notes") ? "notes" : "slide";
    history.replaceState(null, "", `#${name}-${number + 1}`);
  };

  document.body.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("dialog[open], input")) return;
    const step = steps[event.key];
    if (!step && event.key !== "n") return;
    const number = current();
    if (!step) root.classList.toggle("with-notes");
    event.preventDefault();
    // mdBook, which listens further out, would turn the page.
    event.stopPropagation();
    show(Math.min(Math.max(number + (step ?? 0), 0), slides.length - 1));
  });

  const [, name, number] = location.hash.match(/^#(slide|notes)-?(\d*)$/) ?? [];
  if (name === "notes") root.classList.add("with-notes");
  if (slides[number - 1]) show(number - 1);
})();
