// The boxes in the pages: each <figure class="live" data-box="…"> has a picture, which stays where
// there are no scripts and in print, and a caption. The box takes the picture's place on the screen.
"use strict";
(() => {
  const { CUTOFF, DT } = soft;
  const { make, Sheet, handle, slider, Player, redraw } = player;
  const whole = new Intl.NumberFormat("en-GB", { maximumFractionDigits: 0 });
  const places = digits => value => value.toFixed(digits);
  const cutoffs = value => `${value.toFixed(2)} c`;

  // A panel: a heading, a sheet, a line of text below.
  function panel(parent, heading, label, extent) {
    const div = make(parent, "div", { className: "live-panel" });
    if (heading) make(div, "p", { className: "live-heading", textContent: heading });
    const sheet = new Sheet(div, label, extent);
    return { sheet, line: make(div, "p", { className: "live-line" }) };
  }

  function discs(sheet, box, style) {
    const { grey, orange } = sheet.colours;
    for (let i = 0; i < box.n; i++) {
      const touches = box.touching[i];
      sheet.disc(box.x[i], box.y[i], CUTOFF / 2, style?.(i) ?? { fill: touches ? orange : null, line: touches ? orange : grey, opacity: 0.8 });
    }
    sheet.rectangle(0, 0, box.size, box.size, { line: grey, width: 2 });
  }

  // Which particles one of them asks, drawn by the kind of search.
  const asks = {
    all: (sheet, box, one) => spokes(sheet, box, one, 0.5),
    bins(sheet, box, one) {
      const { search } = box, { along } = search, side = box.size / along;
      const [left, right] = search.near(search.row(box.x[one])), [low, high] = search.near(search.row(box.y[one]));
      sheet.rectangle(left * side, low * side, (right - left) * side, (high - low) * side, { fill: sheet.colours.tint });
      for (let k = 1; k < along; k++) {
        sheet.path([[k * side, 0], [k * side, box.size]], { line: sheet.colours.faint });
        sheet.path([[0, k * side], [box.size, k * side]], { line: sheet.colours.faint });
      }
      spokes(sheet, box, one, 1.5);
    },
    list(sheet, box, one) {
      const { lists, reach } = box.search;
      lists.forEach((list, i) => {
        for (const j of list) if (j > i) sheet.path([at(box, i), at(box, j)], { line: sheet.colours.faint });
      });
      sheet.disc(...at(box, one), reach, { line: sheet.colours.blue, dashed: true });
      spokes(sheet, box, one, 1.5);
    },
  };
  const at = (box, i) => [box.x[i], box.y[i]];
  function spokes(sheet, box, one, width) {
    for (const j of box.search.asked(one)) sheet.path([at(box, one), at(box, j)], { line: sheet.colours.blue, width });
  }

  const searches = {
    all: { heading: "all pairs", make: () => new soft.AllPairs() },
    bins: { heading: "bins", make: sliders => new soft.Bins(sliders.width ?? 1) },
    list: { heading: "a list", make: sliders => new soft.List(sliders.skin ?? 0.5) },
  };
  const knobs = {
    n: ["particles", { min: 50, max: 1000, step: 50 }],
    width: ["least side of a bin", { min: 1, max: 3, step: 0.25, text: cutoffs }],
    skin: ["skin", { min: 0.1, max: 2, step: 0.1, text: cutoffs }],
  };

  // One search or several side by side, on the same particles.
  function searching(figure, names, sliders) {
    let boxes, one = 0;
    const fresh = name => new soft.Box(soft.official(sliders.n, 1), searches[name].make(sliders));
    const again = () => {
      boxes = names.map(fresh);
      // The one nearest to the middle.
      const { size, n } = boxes[0], away = i => Math.hypot(boxes[0].x[i] - size / 2, boxes[0].y[i] - size / 2);
      one = Array.from({ length: n }, (_, i) => i).reduce((a, b) => (away(b) < away(a) ? b : a));
      panels?.forEach(({ sheet }) => Object.assign(sheet, { right: size, top: size }));
    };
    let panels = null;
    again();
    const { size } = boxes[0], row = make(figure, "div", { className: "live-panels" });
    panels = names.map(name => {
      const heading = searches[name].heading;
      return panel(row, names.length > 1 ? heading : "", `Particles in a box, ${heading}; arrow keys choose one, with Shift they move it`, [0, size, 0, size]);
    });
    const draw = () => {
      names.forEach((name, k) => {
        const box = boxes[k], { sheet, line } = panels[k], asked = box.search.asked(one).filter(j => j !== one).length;
        sheet.begin();
        asks[name](sheet, box, one);
        discs(sheet, box);
        sheet.dot(...at(box, one), 4, { fill: sheet.colours.blue });
        line.textContent = `asks ${whole.format(asked)}; ${whole.format(box.search.tests)} pair tests in this step` + words[name](box);
      });
    };
    const words = {
      all: () => "",
      bins: box => (names.length > 1 ? "" : `, all pairs ${whole.format(box.n ** 2)}; bins of ${cutoffs(box.size / box.search.along / CUTOFF)}`),
      list(box) {
        const { isNew, spent, skin } = box.search;
        const parts = [isNew ? ", with those for a new list" : ""];
        if (box.steps) parts.push(`, ${whole.format(box.total / box.steps)} on average`);
        if (names.length === 1) parts.push(`; ${whole.format((200 * spent) / skin)} % of the list's budget spent`);
        return parts.join("");
      },
    };
    const control = new Player(figure, {
      step: () => boxes.forEach(box => box.step()),
      draw,
      again,
    });
    for (const [name, [label, range]] of Object.entries(knobs)) {
      if (!(name in sliders)) continue;
      slider(figure, label, { ...range, value: sliders[name] }, value => {
        sliders[name] = value;
        if (name === "n") again();
        else names.forEach((search, k) => search === (name === "skin" ? "list" : "bins") && boxes[k].searchBy(searches[search].make(sliders)));
        draw();
      });
    }
    panels.forEach(({ sheet }) =>
      handle(sheet, {
        count: () => boxes[0].n,
        at: i => at(boxes[0], i),
        chosen: () => one,
        stride: CUTOFF / 2,
        choose(i) {
          one = i;
          draw();
        },
        drag(i, x, y) {
          boxes.forEach(box => box.put(i, x, y));
          draw();
        },
      })
    );
    redraw(figure, draw);
    return control;
  }

  // Chapter 1: the energy, and what the time step does to it.
  function energy(figure) {
    let box, start, curve, stretch = 1;
    const most = 600;
    const again = () => {
      box = new soft.Box(soft.official(100, 1), new soft.AllPairs(), stretch * DT);
      start = box.energy();
      curve = [0];
    };
    again();
    const row = make(figure, "div", { className: "live-panels" });
    const left = panel(row, "", "A hundred particles in their box", [0, box.size, 0, box.size]);
    const right = panel(row, "", "Change of the energy against time", [0, 1, -0.5, 0.5]);
    const draw = () => {
      left.sheet.begin();
      discs(left.sheet, box);
      left.line.textContent = `step ${box.steps} of ${stretch} × 0.0005, time ${(box.steps * box.dt).toFixed(3)}`;
      const { sheet } = right, now = curve.at(-1), scale = Math.max(0.05, ...curve.map(Math.abs));
      sheet.begin();
      const { grey, ink, blue } = sheet.colours;
      sheet.path([[0, 0], [1, 0]], { line: grey });
      sheet.path(curve.map((value, k) => [k / most, (0.42 * value) / scale]), { line: blue, width: 2 });
      sheet.text(0.02, 0.46, `+${whole.format(100 * scale)} %`, ink, "left");
      sheet.text(0.02, -0.46, `−${whole.format(100 * scale)} %`, ink, "left");
      sheet.text(0.98, -0.05, "time", ink, "right");
      right.line.textContent = `energy ${now < 0 ? "−" : "+"}${Math.abs(100 * now).toFixed(2)} % of what it was at the start`;
    };
    const control = new Player(figure, {
      step() {
        if (curve.length > most) return control.play(false);
        box.step();
        curve.push(box.energy() / start - 1);
      },
      draw,
      again,
    });
    slider(figure, "time step, × 0.0005", { min: -2, max: 3, value: 0, text: power => String(2 ** power) }, power => {
      stretch = 2 ** power;
      again();
      draw();
    });
    redraw(figure, draw);
    return control;
  }

  // Chapter 11: which particles fly freely through a window.
  function windows(figure) {
    let box, free, opened, steps = 8, n = 300;
    const open = () => ([free, opened] = [soft.free(box, steps), { step: box.steps, x: box.x.slice(), y: box.y.slice(), vx: box.vx.slice(), vy: box.vy.slice() }]);
    const again = () => {
      box = new soft.Box(soft.official(n, 1), new soft.Bins(1));
      open();
    };
    again();
    const { sheet, line } = panel(make(figure, "div", { className: "live-panels" }), "", "Particles in a box; some fly freely, some are in groups", [0, box.size, 0, box.size]);
    const draw = () => {
      sheet.begin();
      const { grey, orange, blue } = sheet.colours, time = steps * DT;
      for (let i = 0; i < n; i++) {
        const end = [opened.x[i] + opened.vx[i] * time, opened.y[i] + opened.vy[i] * time];
        sheet.path([[opened.x[i], opened.y[i]], end], { line: free[i] ? blue : orange, width: 1.5 });
      }
      discs(sheet, box, i => (free[i] ? { line: grey } : { fill: orange, line: orange, opacity: 0.75 }));
      const alone = free.filter(isFree => isFree).length, touched = (alone + (n - alone) * steps) / steps / n;
      line.textContent = `step ${box.steps - opened.step} of ${steps} of the window; ${whole.format((100 * alone) / n)} % fly freely; ${touched.toFixed(2)} particles touched per particle and step`;
    };
    const control = new Player(figure, {
      step() {
        box.step();
        if (box.steps - opened.step >= steps) open();
      },
      draw,
      again,
      rate: 8,
    });
    slider(figure, "steps in a window", { min: 1, max: 32, value: steps }, value => {
      steps = value;
      open();
      draw();
    });
    redraw(figure, draw);
    return control;
  }

  // Chapter 12: one contact, three times.
  function contact(figure) {
    const size = 0.1, half = size / 2, most = 40;
    const ways = [
      { heading: "official step", advance: box => box.step(), dt: DT },
      { heading: "ten small steps for one", advance: box => { for (let k = 0; k < 10; k++) box.step(); }, dt: DT / 10 },
      { heading: "Runge-Kutta, official step", advance: box => soft.rungeKutta(box, DT), dt: DT },
    ];
    let speed = 5, aside = 0.2, runs;
    const again = () => {
      runs = ways.map(({ dt }) => {
        const scene = soft.empty(2, size), gap = 0.65 * CUTOFF;
        scene.x.set([half - gap, half + gap]);
        scene.y.set([half - (aside * CUTOFF) / 2, half + (aside * CUTOFF) / 2]);
        scene.vx.set([speed / 2, -speed / 2]);
        const box = new soft.Box(scene, new soft.AllPairs(), dt);
        return { box, start: box.energy(), trail: [[at(box, 0), at(box, 1)]] };
      });
    };
    again();
    let taken = 0;
    const row = make(figure, "div", { className: "live-panels" }), wide = 1.6 * CUTOFF;
    const panels = ways.map(({ heading }) => panel(row, heading, `Two discs that meet, ${heading}`, [half - wide, half + wide, half - wide, half + wide]));
    const draw = () => {
      runs.forEach(({ box, start, trail }, k) => {
        const { sheet, line } = panels[k];
        sheet.begin();
        const { blue, orange, grey } = sheet.colours;
        [blue, orange].forEach((colour, i) => {
          sheet.disc(...at(box, i), CUTOFF / 2, { fill: box.touching[i] ? colour : null, line: colour, opacity: 0.6 });
          sheet.path(trail.map(places => places[i]), { line: colour, width: 1.5 });
          trail.forEach(places => sheet.dot(...places[i], 2.5, { fill: colour }));
        });
        sheet.rectangle(half - wide, half - wide, 2 * wide, 2 * wide, { line: grey, width: 2 });
        const change = box.energy() / start - 1;
        line.textContent = `energy ${change < 0 ? "−" : "+"}${Math.abs(100 * change).toFixed(2)} % after ${taken} steps`;
      });
    };
    const control = new Player(figure, {
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
    slider(figure, "relative speed", { min: 1, max: 24, step: 0.5, value: speed, text: places(1) }, anew(value => (speed = value)));
    slider(figure, "aimed aside by", { min: 0, max: 0.9, step: 0.05, value: aside, text: cutoffs }, anew(value => (aside = value)));
    redraw(figure, draw);
    return control;
  }

  // Chapter 7: a step of hard discs in four pictures.
  function collisions(figure) {
    let scene, found, taken, stage, one = 0, n = 9, seed = 19;
    // The scene of the picture.
    const side = 20, radius = 1, speeds = [2, 7];
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
    const row = make(figure, "div", { className: "live-panels" });
    const { sheet, line } = panel(row, "", "Hard discs in a square; arrow keys choose one, with Shift they move it", [0, side, 0, side]);
    const list = make(make(row, "div", { className: "live-panel" }), "ol", { className: "live-list" });
    const stages = ["the start, with straight paths", "candidates, in order of their time", "the greedy choice", "the rest of the step"];
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
        for (const disc of scene.discs) sheet.path([where(disc, 0), where(disc, 1)], { line: grey, dashed: true });
        if (stage > 0) {
          found.forEach((hit, k) => {
            if (stage === 2 && !taken.has(hit)) return;
            const [p, q] = [where(scene.discs[hit.a], hit.time), where(scene.discs[hit.b], hit.time)];
            for (const place of [p, q]) sheet.disc(...place, radius, { line: stage === 2 ? orange : blue, width: mine(hit) ? 2.5 : 1 });
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
        const item = make(list, "li", { textContent: `λ = ${hit.time.toFixed(3)}, ${what}${stage > 0 ? fate : ""}` });
        if (mine(hit)) item.className = "live-mine";
      });
    };
    const control = new Player(figure, {
      step() {
        if (stage === 3) return begin();
        if (++stage === 3) hard.resolve(scene, [...taken]);
      },
      draw,
      again,
      rate: 1,
    });
    slider(figure, "discs", { min: 2, max: 20, value: n }, value => {
      n = value;
      again();
      draw();
    });
    slider(figure, "scene", { min: 1, max: 40, value: seed }, value => {
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
    redraw(figure, draw);
    return control;
  }

  const builders = {
    idea: figure => searching(figure, ["all", "bins", "list"], { n: 200, width: 1, skin: 1 }),
    bins: figure => searching(figure, ["bins"], { n: 300, width: 1 }),
    list: figure => searching(figure, ["list"], { n: 300, skin: 1 }),
    energy,
    windows,
    contact,
    collisions,
  };

  for (const figure of document.querySelectorAll("figure.live:not(.is-live)")) {
    const box = document.createElement("div");
    box.className = "live-box";
    figure.insertBefore(box, figure.querySelector("figcaption"));
    figure.classList.add("is-live");
    builders[figure.dataset.box](box);
  }
})();
