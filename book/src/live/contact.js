// Chapter 12: one contact, three times.
"use strict";
(() => {
  const { CUTOFF, DT } = soft;
  const { make, slider, Player, redraw } = player;
  const { cutoffs, percent, panel, legend, at } = panels;

  boxes.contact = element => {
    const size = 0.1,
      half = size / 2,
      most = 40;
    const ways = [
      { heading: "official step", advance: box => box.step(), dt: DT },
      {
        heading: "ten small steps for one",
        advance: box => {
          for (let k = 0; k < 10; k++) box.step();
        },
        dt: DT / 10,
      },
      { heading: "Runge-Kutta, official step", advance: box => soft.rungeKutta(box, DT), dt: DT },
    ];
    let speed = 5,
      aside = 0.2,
      runs;
    const again = () => {
      runs = ways.map(({ dt }) => {
        const scene = soft.empty(2, size),
          gap = 0.65 * CUTOFF;
        scene.x.set([half - gap, half + gap]);
        scene.y.set([half - (aside * CUTOFF) / 2, half + (aside * CUTOFF) / 2]);
        scene.vx.set([speed / 2, -speed / 2]);
        const box = new soft.Box(scene, new soft.AllPairs(), dt);
        return { box, start: box.energy(), trail: [[at(box, 0), at(box, 1)]] };
      });
    };
    again();
    let taken = 0;
    const row = make(element, "div", { className: "live-panels" }),
      wide = 1.6 * CUTOFF;
    const panels = ways.map(({ heading }) =>
      panel(row, heading, `Two discs that meet, ${heading}`, [
        half - wide,
        half + wide,
        half - wide,
        half + wide,
      ]),
    );
    legend(element, { contact: "in contact", dot: "an official step", first: "one disc", second: "the other" });
    const draw = () => {
      runs.forEach(({ box, start, trail }, k) => {
        const { sheet, line } = panels[k];
        sheet.begin();
        const { orange, grey, owners } = sheet.colours;
        [owners[1], owners[2]].forEach((colour, i) => {
          sheet.disc(...at(box, i), CUTOFF / 2, {
            fill: box.touching[i] ? orange : null,
            line: colour,
            opacity: 0.6,
          });
          sheet.path(
            trail.map(places => places[i]),
            { line: colour, width: 1.5 },
          );
          trail.forEach(places => sheet.dot(...places[i], 2.5, { fill: colour }));
        });
        sheet.rectangle(half - wide, half - wide, 2 * wide, 2 * wide, { line: grey, width: 2 });
        const change = box.energy() / start - 1;
        line.textContent = `energy ${percent(change)} after ${taken} steps`;
      });
    };
    const control = new Player(element, {
      step() {
        if (taken === most) return control.play(false);
        taken++;
        ways.forEach(({ advance }, k) => {
          const { box, trail } = runs[k];
          advance(box);
          trail.push([at(box, 0), at(box, 1)]);
        });
      },
      draw,
      again() {
        taken = 0;
        again();
      },
      rate: 4,
    });
    const anew = set => value => {
      set(value);
      taken = 0;
      again();
      draw();
    };
    slider(
      element,
      "relative speed",
      { min: 1, max: 24, step: 0.5, value: speed, text: value => value.toFixed(1) },
      anew(value => (speed = value)),
    );
    slider(
      element,
      "aimed aside by",
      { min: 0, max: 0.9, step: 0.05, value: aside, text: cutoffs },
      anew(value => (aside = value)),
    );
    redraw(element, draw);
    return control;
  };
})();
