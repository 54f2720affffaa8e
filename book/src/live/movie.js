// A recorded run: what `cargo lab movie` writes, with layers to switch on. Needs soft.js, searches.js, kinds.js,
// recorded.js, owners.js, panel.js and layers.js; the run stands in the page as JSON, its name is `movie`.
"use strict";
(() => {
  const { make, handle, slider, toggle, choice, Player, redraw } = player;
  const { whole, cutoffs, percent, panel, at, middle } = panels;

  boxes.movie = element => {
    const movie = JSON.parse(document.getElementById("movie").textContent),
      isHard = movie.kind === "hard",
      model = kinds[movie.kind](movie),
      run = new recorded.Run(movie),
      { n, last } = run;
    const on = new Set(["speed", "touching", ...movie.layers]);
    const set = { method: movie.method, workers: movie.workers, cut: movie.cut, width: 1, skin: 1, window: 8 };
    let frame, one, now, next;

    // What a layer needs to know of a frame is worked out when it is asked for, once.
    let known = {};
    const once = (name, work) => (known[name] ??= work());
    const searched = {
      all: () => new soft.AllPairs(),
      bins: () => new soft.Bins(model.width * set.width),
      list: () => list,
    };
    const search = name =>
      once(name, () => {
        const made = searched[name]();
        made.prepare(now);
        return made;
      });
    const touching = () => once("touching", () => model.touching(now, search("bins")));
    const free = () => once("free", () => model.free(now, set.window, search("bins")));
    const parts = () =>
      once("parts", () => {
        const bins = search("bins"),
          rows = set.cut === "number" ? n : model.rows(bins, set.workers),
          height = run.size / rows;
        const row = y => Math.min(Math.max(Math.trunc(y / height), 0), rows - 1);
        return { height, ...owners.parts(set, rows, now.y, row, i => model.reach(now, bins, i)) };
      });

    // A list lasts for several steps: it ages from frame to frame, and is made anew for another frame.
    let list = new soft.List(set.skin);
    const show = (to, isNext = false) => {
      if (isNext && list.spent < Infinity) {
        list.box = now;
        list.moved(run.time);
      } else list.forget();
      frame = to;
      now = isNext ? next : run.frame(frame);
      next = run.frame(Math.min(frame + 1, last));
      known = {};
    };
    show(0);
    one = middle(now);

    const row = make(element, "div", { className: "live-panels" });
    const what = isHard ? "disc" : "particle";
    const { sheet, line } = panel(
      row,
      "",
      `The ${what}s in their box; arrow keys choose one`,
      [0, run.size, 0, run.size],
    );
    const more = make(line.parentNode, "p", { className: "live-line" });

    // Each layer: its words, what it draws below the discs or above them, and what it says.
    const drawn = {
      speed: { words: "speed: lighter is faster" },
      touching: { words: model.touch },
      bins: {
        words: model.cells,
        draw: discs => layers.bins(sheet, discs, search("bins"), one),
        say: () => `${search("bins").along} × ${search("bins").along} ${isHard ? "cells" : "bins"}`,
      },
      asked: {
        words: `pairs looked at: whom the chosen ${what} asks`,
        draw: discs => layers.spokes(sheet, discs, search(set.method), one, set.method === "all" ? 0.5 : 1.5),
        say: () =>
          `${model.methods[set.method]}: ${whole(model.pairs(search(set.method).tests, n))} pairs looked at, ` +
          `${whole(search(set.method).asked(one).filter(j => j !== one).length)} of them by ${what} ${one}`,
      },
      list: {
        words: "list: pairs within the cutoff and a skin",
        draw: discs => layers.list(sheet, discs, search("list"), one),
        say: () =>
          `a list of ${whole(search("list").pairs)} pairs` +
          (search("list").isNew
            ? ", new"
            : `, ${whole((200 * list.spent) / list.skin)} % of its budget spent`),
      },
      owners: {
        words: "owners: by colour",
        draw() {
          const { starts, height } = parts();
          if (set.cut === "number") return;
          for (const start of starts.slice(1, -1))
            sheet.path([[0, start * height], [run.size, start * height]], { line: sheet.colours.ink, width: 2 });
        },
        say() {
          const counts = new Array(set.workers).fill(0);
          for (const k of parts().home) counts[k]++;
          return `owners have ${counts.join(", ")}`;
        },
      },
      ghosts: {
        words: "ghosts: dashed where another owner has a copy",
        say: () => `${whole(parts().copies.reduce((sum, copies) => sum + copies.length, 0))} ghosts`,
      },
      windows: {
        words: model.paths,
        drawLast: () => layers.flights(sheet, now, free(), model.time(set.window)),
        say: () => `${whole((100 * free().filter(isFree => isFree).length) / n)} % fly freely`,
      },
    };
    if (isHard) delete drawn.list;

    const draw = (part = 0) => {
      const discs = run.between(now, next, part);
      sheet.begin();
      const { blue, grey, orange, ink, owners } = sheet.colours,
        shown = Object.keys(drawn).filter(name => on.has(name));
      shown.forEach(name => drawn[name].draw?.(discs));
      const touched = new Set(on.has("touching") ? touching().flat() : []);
      for (let i = 0; i < n; i++) {
        const speed = Math.hypot(discs.vx[i], discs.vy[i]) / run.fastest;
        const fill = on.has("owners")
          ? owners[parts().home[i] % owners.length]
          : on.has("windows")
            ? !free()[i] && orange
            : on.has("speed")
              ? layers.viridis(speed)
              : touched.has(i) && orange;
        sheet.disc(...at(discs, i), movie.radius, {
          fill,
          line: touched.has(i) ? orange : grey,
          width: touched.has(i) ? 2.5 : 1,
          opacity: 0.85,
        });
        if (on.has("ghosts") && parts().copies[i].length > 0)
          sheet.disc(...at(discs, i), 1.6 * movie.radius, { line: ink, width: 1.5, dashed: true });
      }
      if (on.has("touching"))
        for (const [i, j] of touching()) sheet.path([at(discs, i), at(discs, j)], { line: orange, width: 2.5 });
      shown.forEach(name => drawn[name].drawLast?.());
      sheet.disc(...at(discs, one), 1.3 * movie.radius, { line: blue, width: 3 });
      sheet.rectangle(0, 0, run.size, run.size, { line: grey, width: 2 });
      const step = movie.first + frame * movie.between;
      line.textContent =
        `step ${whole(step)}, time ${+(step * movie.dt).toPrecision(6)}; ` +
        `energy ${movie.energy[frame].toPrecision(5)}, ${percent(movie.energy[frame] / movie.energy[0] - 1)}; ` +
        model.said(isHard ? touching().length : movie.touching[frame]);
      more.textContent = shown.flatMap(name => drawn[name].say?.() ?? []).join("; ");
      position?.show(frame);
    };

    let position = null;
    const control = new Player(element, {
      step: () => (frame < last ? show(frame + 1, true) : show(0)),
      back: () => show(frame > 0 ? frame - 1 : last),
      draw,
      again: () => show(0),
      rate: isHard ? 2 : 15,
    });
    const still = () => draw(control.part);
    position = slider(element, "frame", { min: 0, max: last, value: 0 }, value => {
      control.play(false);
      control.part = 0;
      show(value);
      draw();
    });
    slider(
      element,
      "speed",
      { min: 1, max: 60, value: control.rate, text: rate => `${rate} a second` },
      rate => (control.rate = rate),
    );

    const group = make(element, "fieldset", { className: "live-layers" });
    make(group, "legend", { textContent: "Layers" });
    for (const [name, { words }] of Object.entries(drawn))
      toggle(group, words, on.has(name), isOn => {
        on[isOn ? "add" : "delete"](name);
        settle();
        still();
      });

    // A setting is there while a layer is on that it is about.
    const change = name => value => {
      set[name] = value;
      if (name === "skin") list = new soft.List(value);
      known = {};
      still();
    };
    const range = (name, words, limits) => slider(element, words, { ...limits, value: set[name] }, change(name));
    const cuts = { even: "equal rows", equal: "equal numbers", number: "no place: by number" };
    const settings = [
      {
        layers: ["asked"],
        ...choice(element, "pairs looked at by", model.methods, set.method, change("method")),
      },
      { layers: ["owners", "ghosts"], ...range("workers", "owners", { min: 1, max: 16 }) },
      { layers: ["owners", "ghosts"], ...choice(element, "cut into", cuts, set.cut, change("cut")) },
    ];
    if (!isHard)
      settings.push(
        {
          layers: ["bins", "asked", "ghosts"],
          ...range("width", "least side of a bin", { min: 1, max: 3, step: 0.25, text: cutoffs }),
        },
        { layers: ["list", "asked"], ...range("skin", "skin", { min: 0.1, max: 2, step: 0.1, text: cutoffs }) },
        { layers: ["windows"], ...range("window", "steps in a window", { min: 1, max: 32 }) },
      );
    const settle = () =>
      settings.forEach(({ row, layers }) => (row.hidden = !layers.some(layer => on.has(layer))));
    settle();

    handle(sheet, {
      count: () => n,
      at: i => at(now, i),
      chosen: () => one,
      stride: movie.radius,
      choose(i) {
        one = i;
        still();
      },
      drag() {},
    });
    make(element, "p", {
      textContent:
        "The space bar plays and pauses, arrow keys go a frame on or back; in the drawing they choose " +
        `a ${what}. Layers are worked out here, from the recorded places, as the labs do it.`,
    });
    // Wherever no control has the keys.
    document.addEventListener("keydown", event => {
      if (event.target !== document.body || event.altKey || event.ctrlKey || event.metaKey) return;
      const does = {
        " ": () => control.play(!control.playing),
        ArrowRight: () => control.once(),
        ArrowLeft: () => control.once(control.back),
      }[event.key];
      if (!does) return;
      event.preventDefault();
      does();
    });
    redraw(element, still);
    return control;
  };
})();
