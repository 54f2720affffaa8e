// What plays: a sheet to draw on, buttons, sliders. The book's boxes and the pages of
// `cargo lab movie` share it.
"use strict";
(() => {
  const make = (parent, name, properties = {}) => {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  };

  // Colours with enough contrast on the page's own background, whichever theme it has.
  function colours(element) {
    const [red, green, blue] = getComputedStyle(element)
      .color.match(/[\d.]+/g)
      .map(Number);
    const dark = red + green + blue > 3 * 128;
    return {
      ink: `rgb(${red},${green},${blue})`,
      grey: dark ? "#9aa3ad" : "#717982",
      faint: dark ? "#59616a" : "#c3c9cf",
      blue: dark ? "#6fc3f5" : "#0072b2",
      orange: dark ? "#ffab5c" : "#c75000",
      tint: dark ? "#1d4a66" : "#d6e9f5",
      owners: dark
        ? ["#6fc3f5", "#4fd6a8", "#f0a3dc", "#e6d566"]
        : ["#0072b2", "#00805c", "#a0478a", "#7a6a00"],
    };
  }

  // A drawing in units of the model: a part of the plane, `left ..= right` and `bottom ..= top`.
  class Sheet {
    constructor(parent, label, [left, right, bottom, top]) {
      this.canvas = make(parent, "canvas");
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", label);
      this.canvas.style.aspectRatio = (right - left) / (top - bottom);
      Object.assign(this, { left, right, bottom, top, pen: this.canvas.getContext("2d") });
    }

    // Cleared, and as fine as the screen.
    begin() {
      const { canvas, pen } = this,
        fine = Math.min(devicePixelRatio || 1, 2);
      const width = Math.round(canvas.clientWidth * fine),
        height = Math.round(canvas.clientHeight * fine);
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      this.colours = colours(canvas);
      this.fine = fine;
      this.scale = width / (this.right - this.left);
      pen.setTransform(1, 0, 0, 1, 0, 0);
      pen.clearRect(0, 0, width, height);
    }
    x(x) {
      return (x - this.left) * this.scale;
    }
    // y grows upwards in the model.
    y(y) {
      return (this.top - y) * this.scale;
    }
    paint({ fill, line, width = 1, dashed = false, opacity = 1 }) {
      const { pen, fine } = this;
      pen.globalAlpha = opacity;
      if (fill) {
        pen.fillStyle = fill;
        pen.fill();
      }
      if (line) {
        pen.strokeStyle = line;
        pen.lineWidth = width * fine;
        pen.setLineDash(dashed ? [4 * fine, 3 * fine] : []);
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }
    disc(x, y, radius, style) {
      this.pen.beginPath();
      this.pen.arc(this.x(x), this.y(y), radius * this.scale, 0, 7);
      this.paint(style);
    }
    // A dot of `pixels`, however large the box.
    dot(x, y, pixels, style) {
      this.disc(x, y, (pixels * this.fine) / this.scale, style);
    }
    path(points, style) {
      this.pen.beginPath();
      for (const [x, y] of points) this.pen.lineTo(this.x(x), this.y(y));
      this.paint(style);
    }
    rectangle(left, bottom, width, height, style) {
      this.pen.beginPath();
      this.pen.rect(this.x(left), this.y(bottom + height), width * this.scale, height * this.scale);
      this.paint(style);
    }
    // A square of side `size` cut into bins, `along` each way.
    grid(along, size) {
      const style = { line: this.colours.faint };
      for (let k = 1; k < along; k++) {
        const cut = (k * size) / along;
        for (const ends of [
          [
            [cut, 0],
            [cut, size],
          ],
          [
            [0, cut],
            [size, cut],
          ],
        ])
          this.path(ends, style);
      }
    }
    text(x, y, text, colour, align = "center") {
      const { pen, fine } = this;
      pen.font = `${13 * fine}px sans-serif`;
      Object.assign(pen, { fillStyle: colour, textAlign: align, textBaseline: "middle" });
      pen.fillText(text, this.x(x), this.y(y));
    }
    // Where a pointer is in the model.
    place(event) {
      const { left, top, width } = this.canvas.getBoundingClientRect();
      const unit = (this.right - this.left) / width;
      return [this.left + (event.clientX - left) * unit, this.top - (event.clientY - top) * unit];
    }
  }

  // Choosing and dragging, by pointer and by keyboard. `discs` says how many there are and where,
  // `choose(i)` and `drag(i, x, y)` what comes of it.
  function handle(sheet, { count, at, choose, drag, chosen, stride }) {
    const { canvas } = sheet;
    canvas.tabIndex = 0;
    let held = null;
    canvas.addEventListener("pointerdown", event => {
      const [x, y] = sheet.place(event),
        away = i => Math.hypot(at(i)[0] - x, at(i)[1] - y);
      let near = 0;
      for (let i = 1; i < count(); i++) if (away(i) < away(near)) near = i;
      const finger = (24 * (sheet.right - sheet.left)) / canvas.clientWidth;
      if (away(near) > Math.max(stride, finger)) return;
      choose(near);
      held = near;
      canvas.setPointerCapture(event.pointerId);
    });
    let begun = null;
    canvas.addEventListener("pointermove", event => {
      if (held === null) return;
      begun ??= [event.clientX, event.clientY];
      if (Math.hypot(event.clientX - begun[0], event.clientY - begun[1]) > 3)
        drag(held, ...sheet.place(event));
    });
    for (const name of ["pointerup", "pointercancel"])
      canvas.addEventListener(name, () => (held = begun = null));
    // A finger on a disc moves the disc, elsewhere the page.
    canvas.addEventListener("touchmove", event => held !== null && event.preventDefault(), {
      passive: false,
    });
    canvas.addEventListener("keydown", event => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }[event.key];
      if (!way) return;
      event.preventDefault();
      const [i, n] = [chosen(), count()];
      if (event.shiftKey) drag(i, at(i)[0] + way[0] * stride, at(i)[1] + way[1] * stride);
      else choose((i + way[0] + way[1] + n) % n);
    });
  }

  function slider(parent, label, { min, max, step = 1, value, text = String }, change) {
    const row = make(parent, "label", { className: "live-slider" });
    make(row, "span", { textContent: label });
    const input = make(row, "input", { type: "range", min, max, step, value });
    const shown = make(row, "output", { textContent: text(value) });
    input.addEventListener("input", () => {
      shown.textContent = text(+input.value);
      change(+input.value);
    });
    return { row, show: value => ([input.value, shown.textContent] = [value, text(+value)]) };
  }

  // Something to switch on and off.
  function toggle(parent, label, on, change) {
    const row = make(parent, "label", { className: "live-choice" });
    const input = make(row, "input", { type: "checkbox", checked: on });
    make(row, "span", { textContent: label });
    input.addEventListener("change", () => change(input.checked));
  }

  // One of several: `options` are names and their words.
  function choice(parent, label, options, value, change) {
    const row = make(parent, "label", { className: "live-slider" });
    make(row, "span", { textContent: label });
    const select = make(row, "select");
    for (const [name, words] of Object.entries(options))
      make(select, "option", { value: name, textContent: words, selected: name === value });
    select.addEventListener("change", () => change(select.value));
    return { row };
  }

  // Buttons, and the clock: `rate` steps a second; `draw(part)` is asked where between two steps the
  // clock is, 0 to 1. A reader who wants little motion gets a still every second, in as many steps.
  class Player {
    constructor(parent, { step, draw, again, back, rate = 30 }) {
      Object.assign(this, { step, draw, back, rate, part: 0, playing: false });
      this.row = make(parent, "div", { className: "live-buttons" });
      this.button = make(this.row, "button", { type: "button", textContent: "Play" });
      this.button.onclick = () => this.play(!this.playing);
      make(this.row, "button", { type: "button", textContent: "Step" }).onclick = () => this.once();
      if (back)
        make(this.row, "button", { type: "button", textContent: "Back" }).onclick = () => this.once(back);
      if (again) {
        make(this.row, "button", { type: "button", textContent: "From the start" }).onclick = () => {
          this.part = 0;
          again();
          draw(0);
        };
      }
      const still = matchMedia("(prefers-reduced-motion: reduce)");
      this.still = () => still.matches;
    }
    // One step, or one back.
    once(step = this.step) {
      this.play(false);
      this.part = 0;
      step();
      this.draw(0);
    }
    play(on) {
      if (on === this.playing) return;
      this.playing = on;
      this.button.textContent = on ? "Pause" : "Play";
      let last = performance.now();
      const frame = now => {
        if (!this.playing) return;
        requestAnimationFrame(frame);
        if (this.still() && now - last < 1000) return;
        // After a pause of the page it does not make up for lost time.
        this.part += Math.min((now - last) / 1000, this.still() ? 1 : 0.1) * this.rate;
        last = now;
        for (; this.part >= 1 && this.playing; this.part--) this.step();
        if (this.still()) this.part = 0;
        this.draw(this.playing ? this.part : 0);
      };
      if (on) requestAnimationFrame(frame);
    }
  }

  // Draws whenever the size or the theme changes.
  function redraw(element, draw) {
    // Not at once: what is drawn may change the size.
    new ResizeObserver(() => requestAnimationFrame(draw)).observe(element);
    new MutationObserver(draw).observe(document.documentElement, {
      attributes: true,
      attributeFilter: ["class"],
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw());
  }

  globalThis.player = { make, Sheet, handle, slider, toggle, choice, Player, redraw };
})();
