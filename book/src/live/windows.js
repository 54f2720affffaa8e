// Chapter 11: which particles fly freely through a window.
"use strict";
(() => {
  const { DT } = soft;
  const { make, slider, Player, redraw } = player;
  const { whole, panel, legend, discs } = panels;

  boxes.windows = element => {
    let box,
      free,
      opened,
      steps = 8,
      n = 300;
    const open = () =>
      ([free, opened] = [
        soft.free(box, steps),
        { n, step: box.steps, x: box.x.slice(), y: box.y.slice(), vx: box.vx.slice(), vy: box.vy.slice() },
      ]);
    const again = () => {
      box = new soft.Box(soft.official(n, 1), new soft.Bins(1));
      open();
    };
    again();
    const { sheet, line } = panel(
      make(element, "div", { className: "live-panels" }),
      "",
      "Particles in a box; some fly freely, some are in groups",
      [0, box.size, 0, box.size],
    );
    legend(element, {
      asked: "a free path through the window",
      meets: "a path that meets another or a wall",
      contact: "in a group, computed step by step",
      alone: "free, computed once",
    });
    const draw = () => {
      sheet.begin();
      const { grey, orange } = sheet.colours;
      layers.flights(sheet, opened, free, steps * DT);
      discs(sheet, box, i => (free[i] ? { line: grey } : { fill: orange, line: orange, opacity: 0.75 }));
      const alone = free.filter(isFree => isFree).length,
        touched = (alone + (n - alone) * steps) / steps / n;
      line.textContent = `step ${box.steps - opened.step} of ${steps} of the window; ${whole((100 * alone) / n)} % fly freely; ${touched.toFixed(2)} particles touched per particle and step`;
    };
    const control = new Player(element, {
      step() {
        box.step();
        if (box.steps - opened.step >= steps) open();
      },
      draw,
      again,
      rate: 8,
    });
    slider(element, "steps in a window", { min: 1, max: 32, value: steps }, value => {
      steps = value;
      open();
      draw();
    });
    redraw(element, draw);
    return control;
  };
})();
