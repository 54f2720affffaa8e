// What soft discs and hard discs do not share when a run is shown: who touches whom in a frame, whose path is
// straight, how wide bins must be, and the words for it. Needs soft.js, hard.js and panel.js.
"use strict";
(() => {
  const { CUTOFF, DT } = soft;
  const { whole } = panels;

  const soften = () => ({
    width: 1,
    pairs: tests => tests,
    touching(now, bins) {
      const found = [];
      for (let i = 0; i < now.n; i++)
        for (const j of bins.asked(i))
          if (j > i && Math.hypot(now.x[j] - now.x[i], now.y[j] - now.y[i]) <= CUTOFF) found.push([i, j]);
      return found;
    },
    free: (now, window) => soft.free(now, window),
    time: window => window * DT,
    // What a disc asks lies in the rows of bins beside its own.
    reach: (now, bins, i) => [-1, 1].map(by => (bins.row(now.y[i]) + by + 0.5) * (now.size / bins.along)),
    rows: bins => bins.along,
    touch: "pairs that touch: within the cutoff c",
    said: pairs => `${whole(pairs)} pairs touch`,
    methods: { all: "all pairs", bins: "bins", list: "a list" },
    paths: "windows: straight paths of the next steps, orange where two or a wall are met",
    cells: "bins, and the nine that the chosen particle asks",
  });

  const harden = ({ radius, fastest }) => {
    // Two discs further apart than this do not meet in a step.
    const side = 2 * radius + 2 * Math.SQRT2 * fastest;
    const hits = (now, bins) => {
      const discs = Array.from(now.x, (x, i) => ({ x, y: now.y[i], vx: now.vx[i], vy: now.vy[i] }));
      const scene = { side: now.size, radius, discs };
      return hard.choose(hard.candidates(scene, i => bins.asked(i)), now.n);
    };
    return {
      width: side / CUTOFF,
      // A disc does not ask itself, and of two discs one asks.
      pairs: (tests, n) => (tests - n) / 2,
      touching: (now, bins) =>
        hits(now, bins)
          .filter(hit => hit.kind === hard.PAIR)
          .map(({ a, b }) => [a, b]),
      free(now, _, bins) {
        const free = new Array(now.n).fill(true);
        for (const { a, b } of hits(now, bins)) free[a] = free[b] = false;
        return free;
      },
      time: () => 1,
      // A disc is known wherever it comes to in the step.
      reach(now, _, i) {
        const ends = [now.y[i], now.y[i] + now.vy[i]];
        return [Math.min(...ends) - radius, Math.max(...ends) + radius];
      },
      rows: (_, workers) => 512 * workers,
      touch: "pairs that collide in the next step",
      said: pairs => `${whole(pairs)} pairs collide in the next step`,
      methods: { all: "all pairs", bins: "cells" },
      paths: "straight paths of the next step, orange where a disc or a wall is met",
      cells: "cells as wide as two discs come nearer in a step, and the nine that the chosen disc asks",
    };
  };

  globalThis.kinds = { soft: soften, hard: harden };
})();
