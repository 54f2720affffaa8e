// The soft discs of labs 1, 11 and 12, computed as the labs compute them: tests/live compares places
// and counts with the kit's own, byte by byte. Needs random.js.
"use strict";
(() => {
  const DENSITY = 0.0005,
    MASS = 0.01,
    CUTOFF = 0.01,
    MIN_R = CUTOFF / 100,
    DT = 0.0005;

  // `n` particles at rest in the lower left corner of a box of side `size`.
  function empty(n, size) {
    const numbers = () => new Float64Array(n);
    return { n, size, x: numbers(), y: numbers(), vx: numbers(), vy: numbers() };
  }

  // The official scene of `n` particles.
  function official(n, seed) {
    const scene = empty(n, Math.sqrt(DENSITY * n)),
      twister = new Twister(seed);
    const columns = Math.ceil(Math.sqrt(n)),
      rows = Math.ceil(n / columns);
    const shuffle = Array.from({ length: n }, (_, i) => i);
    for (let i = 0; i < n; i++) {
      const pick = twister.below(n - i),
        place = shuffle[pick];
      shuffle[pick] = shuffle[n - i - 1];
      scene.x[i] = (scene.size * (1 + (place % columns))) / (1 + columns);
      scene.y[i] = (scene.size * (1 + Math.floor(place / columns))) / (1 + rows);
      scene.vx[i] = twister.speed();
      scene.vy[i] = twister.speed();
    }
    return scene;
  }

  // Particles in a box, and the search that finds their neighbours. What it shows is always the
  // beginning of a step: the forces on the particles where they are, and whom the search asks.
  class Box {
    constructor(scene, search, dt = DT) {
      Object.assign(this, scene, { search, dt, steps: 0, total: 0 });
      [this.ax, this.ay] = [new Float64Array(scene.n), new Float64Array(scene.n)];
      this.touching = new Uint8Array(scene.n);
      this.look();
    }

    look() {
      this.search.prepare(this);
      this.forces();
    }

    searchBy(search) {
      Object.assign(this, { search, steps: 0, total: 0 });
      this.look();
    }

    // A reader puts particle `i` elsewhere.
    put(i, x, y) {
      const inside = x => Math.min(Math.max(x, 0), this.size);
      [this.x[i], this.y[i]] = [inside(x), inside(y)];
      this.search.forget?.();
      this.look();
    }

    // The forces, summed by ascending number.
    forces() {
      const { n, x, y, ax, ay, search, touching } = this;
      for (let i = 0; i < n; i++) {
        const near = [];
        for (const j of search.asked(i)) {
          const dx = x[j] - x[i],
            dy = y[j] - y[i];
          if (dx * dx + dy * dy <= CUTOFF * CUTOFF && j !== i) near.push(j);
        }
        near.sort((a, b) => a - b);
        touching[i] = near.length > 0;
        [ax[i], ay[i]] = [0, 0];
        for (const j of near) {
          const dx = x[j] - x[i],
            dy = y[j] - y[i],
            coef = coefficient(dx * dx + dy * dy);
          ax[i] += coef * dx;
          ay[i] += coef * dy;
        }
      }
    }

    step() {
      const { n, x, y, vx, vy, ax, ay, search, size, dt } = this;
      for (let i = 0; i < n; i++) {
        vx[i] += ax[i] * dt;
        vy[i] += ay[i] * dt;
        [x[i], vx[i]] = bounce(x[i] + vx[i] * dt, vx[i], size);
        [y[i], vy[i]] = bounce(y[i] + vy[i] * dt, vy[i], size);
      }
      this.steps++;
      this.total += search.tests;
      search.moved?.(dt);
      this.look();
    }

    // Kinetic and potential energy.
    energy() {
      const { n, x, y, vx, vy } = this;
      let sum = 0;
      for (let i = 0; i < n; i++) {
        sum += (MASS * (vx[i] * vx[i] + vy[i] * vy[i])) / 2;
        for (let j = i + 1; j < n; j++) sum += potential(x[j] - x[i], y[j] - y[i]);
      }
      return sum;
    }
  }

  // What a squared distance within the cutoff makes of a distance vector: the acceleration.
  function coefficient(square) {
    const r2 = Math.max(square, MIN_R * MIN_R),
      r = Math.sqrt(r2);
    return (1 - CUTOFF / r) / r2 / MASS;
  }

  function bounce(x, v, size) {
    for (let k = 0; k < 8; k++) {
      if (x < 0) [x, v] = [-x, -v];
      else if (x > size) [x, v] = [2 * size - x, -v];
      else return [x, v];
    }
    if (x >= 0 && x <= size) return [x, v];
    const folded = ((x % (2 * size)) + 2 * size) % (2 * size);
    return folded <= size ? [folded, v] : [2 * size - folded, -v];
  }

  function potential(dx, dy) {
    const r = Math.sqrt(dx * dx + dy * dy);
    if (r > CUTOFF) return 0;
    const ratio = CUTOFF / Math.max(r, MIN_R),
      above = ratio - 1 - Math.log(ratio);
    return r >= MIN_R ? above : above + (((ratio - 1) / (MIN_R * MIN_R)) * (MIN_R * MIN_R - r * r)) / 2;
  }

  // Lab 11: which particles meet no other and no wall in the next `steps` steps, flown straight on.
  // The rest are in groups. Two meet that come within the cutoff and a twentieth of it.
  function free({ n, size, x, y, vx, vy }, steps) {
    const isFree = new Array(n).fill(true),
      near = 1.05 * CUTOFF;
    const inside = x => x >= 0 && x <= size;
    for (let i = 0; i < n; i++) {
      if (!inside(x[i] + vx[i] * steps * DT) || !inside(y[i] + vy[i] * steps * DT)) isFree[i] = false;
      for (let j = i + 1; j < n; j++) {
        const dx = x[j] - x[i],
          dy = y[j] - y[i],
          wx = vx[j] - vx[i],
          wy = vy[j] - vy[i];
        const closest = -(dx * wx + dy * wy) / (wx * wx + wy * wy) || 0;
        const t = Math.min(Math.max(closest, 0), (steps - 1) * DT);
        if ((dx + t * wx) ** 2 + (dy + t * wy) ** 2 <= near * near) isFree[i] = isFree[j] = false;
      }
    }
    return isFree;
  }

  // A step of Runge and Kutta for a box without walls in reach, as in lab 12.
  function rungeKutta(box, h) {
    const { n, ax, ay } = box,
      start = ["x", "y", "vx", "vy"].map(name => box[name].slice());
    const sum = start.map(() => new Float64Array(n));
    for (const [weight, next] of [
      [1, 0.5],
      [2, 0.5],
      [2, 1],
      [1, 0],
    ]) {
      box.look();
      const slopes = [box.vx.slice(), box.vy.slice(), ax, ay];
      ["x", "y", "vx", "vy"].forEach((name, k) => {
        for (let i = 0; i < n; i++) {
          sum[k][i] += weight * slopes[k][i];
          box[name][i] = start[k][i] + next * h * slopes[k][i];
        }
      });
    }
    ["x", "y", "vx", "vy"].forEach((name, k) => {
      for (let i = 0; i < n; i++) box[name][i] = start[k][i] + (h / 6) * sum[k][i];
    });
    box.steps++;
    box.look();
  }

  globalThis.soft = { CUTOFF, DT, empty, official, Box, free, rungeKutta };
})();
