// The introduction, chapters 2 and 10: which particles one of them asks, and how many questions that
// makes in a step.
"use strict";
(() => {
  const { CUTOFF } = soft;
  const { make, handle, slider, Player, redraw } = player;
  const { whole, cutoffs, panel, legend, discs, at, middle } = panels;

  // Which particles one of them asks, drawn by the kind of search.
  const { spokes } = layers;
  const asks = {
    all: (sheet, box, search, one) => spokes(sheet, box, search, one, 0.5),
    bins(...drawing) {
      layers.bins(...drawing);
      spokes(...drawing);
    },
    list(...drawing) {
      layers.list(...drawing);
      spokes(...drawing);
    },
  };

  const marks = {
    all: {},
    bins: { bins: "bins that it looks into" },
    list: { listed: "pairs of the list", reach: "how far the list looks" },
  };

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

  // The official scene starts on a lattice, on which no particle is near another. A hundred steps later it is
  // typical.
  function typical(n) {
    const box = new soft.Box(soft.official(n, 1), new soft.Bins(1));
    while (box.steps < 100) box.step();
    return box;
  }

  // A box of these particles that has taken some steps, so that it knows averages.
  function beginning({ n, size, x, y, vx, vy }, search) {
    const scene = { n, size, x: x.slice(), y: y.slice(), vx: vx.slice(), vy: vy.slice() };
    const box = new soft.Box(scene, search);
    while (box.steps < 25) box.step();
    return box;
  }

  // One search or several side by side, on the same particles.
  function searching(element, names, sliders) {
    let boxes,
      one = 0;
    const again = () => {
      const scene = typical(sliders.n);
      boxes = names.map(name => beginning(scene, searches[name].make(sliders)));
      one = middle(boxes[0], i => boxes.every(({ search }) => search.asked(i).length > 1));
      const { size } = boxes[0];
      panels?.forEach(({ sheet }) => Object.assign(sheet, { right: size, top: size }));
    };
    let panels = null;
    again();
    const { size } = boxes[0],
      row = make(element, "div", { className: "live-panels" });
    panels = names.map(name => {
      const heading = searches[name].heading;
      return panel(
        row,
        names.length > 1 ? heading : "",
        `Particles in a box, ${heading}; arrow keys choose one, with Shift they move it`,
        [0, size, 0, size],
      );
    });
    const marked = names.map(name => marks[name]);
    legend(element, {
      chosen: "the chosen particle",
      asked: "particles that it asks",
      contact: "in contact",
      ...Object.assign({}, ...marked),
    });
    const draw = () => {
      names.forEach((name, k) => {
        const box = boxes[k],
          { sheet, line } = panels[k],
          asked = box.search.asked(one).filter(j => j !== one).length;
        sheet.begin();
        asks[name](sheet, box, box.search, one);
        discs(sheet, box);
        sheet.dot(...at(box, one), 4, { fill: sheet.colours.blue });
        const average = box.steps ? `, ${whole(box.total / box.steps)} on average` : "";
        line.textContent =
          `asks ${whole(asked)}; ${whole(box.search.tests)} pair tests in this step${average}` + words[name](box);
      });
    };
    const words = {
      all: () => "",
      bins: box =>
        names.length > 1
          ? ""
          : `, all pairs ${whole(box.n ** 2)}; bins of ${cutoffs(box.size / box.search.along / CUTOFF)}`,
      list(box) {
        const { isNew, spent, skin } = box.search;
        if (isNew) return "; a new list";
        return names.length > 1 ? "" : `; ${whole((200 * spent) / skin)} % of the list's budget spent`;
      },
    };
    const control = new Player(element, {
      step: () => boxes.forEach(box => box.step()),
      draw,
      again,
    });
    for (const [name, [label, range]] of Object.entries(knobs)) {
      if (!(name in sliders)) continue;
      slider(element, label, { ...range, value: sliders[name] }, value => {
        sliders[name] = value;
        if (name === "n") again();
        else
          names.forEach(
            (search, k) =>
              search === (name === "skin" ? "list" : "bins") &&
              boxes[k].searchBy(searches[search].make(sliders)),
          );
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
      }),
    );
    redraw(element, draw);
    return control;
  }

  boxes.idea = element => searching(element, ["all", "bins", "list"], { n: 200, width: 1, skin: 1 });
  boxes.bins = element => searching(element, ["bins"], { n: 300, width: 1 });
  boxes.list = element => searching(element, ["list"], { n: 300, skin: 1 });
})();
