// Chapter 1: the energy, and what the time step does to it.
"use strict";
(() => {
  const { DT } = soft;
  const { make, slider, Player, redraw } = player;
  const { whole, percent, panel, legend, discs } = panels;

  boxes.energy = element => {
    let box,
      start,
      curve,
      stretch = 1;
    const most = 600;
    const again = () => {
      box = new soft.Box(soft.official(100, 1), new soft.AllPairs(), stretch * DT);
      start = box.energy();
      curve = [0];
    };
    again();
    const row = make(element, "div", { className: "live-panels" });
    const left = panel(row, "", "A hundred particles in their box", [0, box.size, 0, box.size]);
    const right = panel(row, "", "Change of the energy against time", [0, 1, -0.5, 0.5]);
    legend(element, { contact: "in contact", alone: "alone", asked: "the energy" });
    const draw = () => {
      left.sheet.begin();
      discs(left.sheet, box);
      left.line.textContent = `step ${box.steps} of ${stretch} × 0.0005, time ${(box.steps * box.dt).toFixed(3)}`;
      const { sheet } = right,
        now = curve.at(-1),
        scale = Math.max(0.05, ...curve.map(Math.abs));
      sheet.begin();
      const { grey, ink, blue } = sheet.colours;
      sheet.path(
        [
          [0, 0],
          [1, 0],
        ],
        { line: grey },
      );
      sheet.path(
        curve.map((value, k) => [k / most, (0.42 * value) / scale]),
        { line: blue, width: 2 },
      );
      sheet.text(0.02, 0.46, `+${whole(100 * scale)} %`, ink, "left");
      sheet.text(0.02, -0.46, `−${whole(100 * scale)} %`, ink, "left");
      sheet.text(0.98, -0.05, "time", ink, "right");
      right.line.textContent = `energy ${percent(now)} of what it was at the start`;
    };
    const control = new Player(element, {
      step() {
        if (curve.length > most) return control.play(false);
        box.step();
        curve.push(box.energy() / start - 1);
      },
      draw,
      again,
    });
    slider(
      element,
      "time step, × 0.0005",
      { min: -2, max: 3, value: 0, text: power => String(2 ** power) },
      power => {
        stretch = 2 ** power;
        again();
        draw();
      },
    );
    redraw(element, draw);
    return control;
  };
})();
