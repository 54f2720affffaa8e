// Chapter 7: a step of hard discs in four pictures. Needs hard.js.
"use strict";
(() => {
  const { make, handle, slider, Player, redraw } = player;
  const { panel, legend } = panels;

  boxes.collisions = element => {
    let scene,
      found,
      taken,
      stage,
      one = 0,
      n = 9,
      seed = 19;
    // The scene of the picture.
    const side = 20,
      radius = 1,
      speeds = [2, 7];
    const begin = () => {
      found = hard.candidates(scene);
      taken = new Set(hard.choose(found, n));
      stage = 0;
    };
    const again = () => {
      scene = hard.random(n, side, radius, seed, speeds);
      one = 0;
      begin();
    };
    again();
    const row = make(element, "div", { className: "live-panels" });
    const { sheet, line } = panel(
      row,
      "",
      "Hard discs in a square; arrow keys choose one, with Shift they move it",
      [0, side, 0, side],
    );
    const list = make(make(row, "div", { className: "live-panel" }), "ol", { className: "live-list", tabIndex: 0 });
    list.setAttribute("aria-label", "The candidates");
    legend(element, {
      chosen: "the chosen disc",
      path: "a straight path",
      candidate: "two discs where they would meet",
      hit: "a collision that happens",
    });
    const stages = [
      "the start, with straight paths",
      "candidates, in order of their time",
      "the greedy choice",
      "the rest of the step",
    ];
    const where = (disc, time) => [disc.x + time * disc.vx, disc.y + time * disc.vy];
    const draw = () => {
      sheet.begin();
      const { ink, grey, blue, orange, faint } = sheet.colours;
      const mine = hit => hit.a === one || hit.b === one;
      if (stage === 3) {
        for (const { path } of scene.discs) {
          sheet.disc(...path[0], radius, { line: faint, dashed: true });
          sheet.path(path, { line: path.length > 2 ? orange : grey, width: 2 });
        }
      } else {
        for (const disc of scene.discs)
          sheet.path([where(disc, 0), where(disc, 1)], { line: grey, dashed: true });
        if (stage > 0) {
          found.forEach((hit, k) => {
            if (stage === 2 && !taken.has(hit)) return;
            const [p, q] = [where(scene.discs[hit.a], hit.time), where(scene.discs[hit.b], hit.time)];
            for (const place of [p, q])
              sheet.disc(...place, radius, { line: stage === 2 ? orange : ink, width: mine(hit) ? 2.5 : 1 });
            sheet.text((p[0] + q[0]) / 2, (p[1] + q[1]) / 2, k + 1, ink);
          });
        }
      }
      scene.discs.forEach((disc, i) => {
        sheet.disc(disc.x, disc.y, radius, { fill: i === one ? blue : grey, opacity: 0.45 });
        sheet.text(disc.x, disc.y, i, ink);
      });
      sheet.rectangle(0, 0, side, side, { line: grey, width: 2 });
      line.textContent = `${stages[stage]}; ${found.length} candidates, ${taken.size} of them happen`;
      list.replaceChildren();
      found.forEach(hit => {
        const what = hit.kind === hard.PAIR ? `discs ${hit.a} and ${hit.b}` : `disc ${hit.a} and a wall`;
        const fate = stage < 2 ? "" : taken.has(hit) ? ": happens" : ": no, a disc has collided";
        const item = make(list, "li", {
          textContent: `λ = ${hit.time.toFixed(3)}, ${what}${stage > 0 ? fate : ""}`,
        });
        item.classList.toggle("live-mine", mine(hit));
        item.classList.toggle("live-taken", stage > 1 && taken.has(hit));
      });
    };
    const control = new Player(element, {
      step() {
        if (stage === 3) return begin();
        if (++stage === 3) hard.resolve(scene, [...taken]);
      },
      draw,
      again,
      rate: 1,
    });
    slider(element, "discs", { min: 2, max: 20, value: n }, value => {
      n = value;
      again();
      draw();
    });
    slider(element, "scene", { min: 1, max: 40, value: seed }, value => {
      seed = value;
      again();
      draw();
    });
    handle(sheet, {
      count: () => n,
      at: i => [scene.discs[i].x, scene.discs[i].y],
      chosen: () => one,
      stride: radius,
      choose(i) {
        one = i;
        draw();
      },
      drag(i, x, y) {
        const inside = x => Math.min(Math.max(x, radius), side - radius);
        Object.assign(scene.discs[i], { x: inside(x), y: inside(y) });
        begin();
        draw();
      },
    });
    redraw(element, draw);
    return control;
  };
})();
