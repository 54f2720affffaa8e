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
  let at = 0;
  const show = number => {
    at = Math.min(Math.max(number, 0), slides.length - 1);
    slides[at].scrollIntoView({ behavior: "instant" });
    const name = root.classList.contains("with-notes") ? "notes" : "slide";
    history.replaceState(null, "", `#${name}-${at + 1}`);
  };
  // A reader can scroll, too.
  addEventListener("scrollend", () => {
    at = slides.reduce((best, slide, k) => (distance(slide) < distance(slides[best]) ? k : best), 0);
  });
  // In a window of a different size each slide is elsewhere. A phone, where slides are not screens, changes its height
  // whenever it hides its address.
  addEventListener("resize", () => at > 0 && innerWidth > 600 && show(at));

  document.body.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("dialog[open], input")) return;
    const step = steps[event.key];
    if (!step && event.key !== "n") return;
    if (!step) root.classList.toggle("with-notes");
    event.preventDefault();
    // mdBook, which listens further out, would turn the page.
    event.stopPropagation();
    show(at + (step ?? 0));
  });

  const [, name, number] = location.hash.match(/^#(slide|notes)-?(\d*)$/) ?? [];
  if (name === "notes") root.classList.add("with-notes");
  if (slides[number - 1]) show(number - 1);
})();
