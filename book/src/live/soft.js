// The soft discs of labs 1, 2, 10 and 11, computed as the labs compute them: tests/live compares
// places and counts with the kit's own, byte by byte.
"use strict";
(() => {
  const DENSITY = 0.0005, MASS = 0.01, CUTOFF = 0.01, MIN_R = CUTOFF / 100, DT = 0.0005;

  // MT19937.
  class Twister {
    constructor(seed) {
      this.state = new Uint32Array(624);
      this.state[0] = seed;
      for (let i = 1; i < 624; i++) {
        const before = this.state[i - 1] ^ (this.state[i - 1] >>> 30);
        this.state[i] = Math.imul(1812433253, before) + i;
      }
      this.next = 624;
    }

    word() {
      const s = this.state;
      if (this.next === 624) {
        for (let i = 0; i < 624; i++) {
          const y = (s[i] & 0x80000000) | (s[(i + 1) % 624] & 0x7fffffff);
          s[i] = s[(i + 397) % 624] ^ (y >>> 1) ^ (y & 1 ? 0x9908b0df : 0);
        }
        this.next = 0;
      }
      let y = s[this.next++];
      y ^= y >>> 11;
      y ^= (y << 7) & 0x9d2c5680;
      y ^= (y << 15) & 0xefc60000;
      return (y ^ (y >>> 18)) >>> 0;
    }

    // An integer below `range`, by Lemire's method.
    below(range) {
      const product = () => BigInt(this.word()) * BigInt(range);
      let p = product();
      if (BigInt.asUintN(32, p) < range) {
        const threshold = BigInt((2 ** 32 - range) % range);
        while (BigInt.asUintN(32, p) < threshold) p = product();
      }
      return Number(p >> 32n);
    }

    // A number in -1 .. 1, in single precision.
    speed() {
      const unit = Math.min(Math.fround(this.word()) / 2 ** 32, 1 - 2 ** -24);
      return Math.fround(unit * 2 - 1);
    }
  }

  // `n` particles at rest in the lower left corner of a box of side `size`.
  function empty(n, size) {
    const numbers = () => new Float64Array(n);
    return { n, size, x: numbers(), y: numbers(), vx: numbers(), vy: numbers() };
  }

  // The official scene of `n` particles.
  function official(n, seed) {
    const scene = empty(n, Math.sqrt(DENSITY * n)), twister = new Twister(seed);
    const columns = Math.ceil(Math.sqrt(n)), rows = Math.ceil(n / columns);
    const shuffle = Array.from({ length: n }, (_, i) => i);
    for (let i = 0; i < n; i++) {
      const pick = twister.below(n - i), place = shuffle[pick];
      shuffle[pick] = shuffle[n - i - 1];
      scene.x[i] = (scene.size * (1 + (place % columns))) / (1 + columns);
      scene.y[i] = (scene.size * (1 + Math.floor(place / columns))) / (1 + rows);
      scene.vx[i] = twister.speed();
      scene.vy[i] = twister.speed();
    }
    return scene;
  }

  // A search says for each particle which ones it asks, `asked(i)`, and counts in `tests` how many
  // pairs were looked at in the step. Before each step it is told where the particles are.

  // Lab 1: all of them.
  class AllPairs {
    prepare(box) {
      this.all ??= Array.from({ length: box.n }, (_, i) => i);
      this.tests = box.n * box.n;
    }
    asked() {
      return this.all;
    }
  }

  // Lab 2: those in nine bins with sides of at least `width` cutoffs.
  class Bins {
    constructor(width) {
      this.width = width;
    }
    prepare(box) {
      const fit = box.size / (this.width * CUTOFF * (1 + 1e-9));
      this.along = Math.max(1, Math.trunc(Math.min(fit, Math.sqrt(8 * box.n))));
      this.perLength = this.along / box.size;
      this.bins = Array.from({ length: this.along ** 2 }, () => []);
      for (let i = 0; i < box.n; i++) this.bins[this.row(box.y[i]) * this.along + this.row(box.x[i])].push(i);
      this.box = box;
      this.tests = 0;
      for (let i = 0; i < box.n; i++) this.tests += this.asked(i).length;
    }
    // Rows and columns are counted alike.
    row(x) {
      return Math.min(Math.trunc(x * this.perLength), this.along - 1);
    }
    near(k) {
      return [Math.max(0, k - 1), Math.min(k + 2, this.along)];
    }
    asked(i) {
      const [left, right] = this.near(this.row(this.box.x[i])), [low, high] = this.near(this.row(this.box.y[i]));
      const found = [];
      for (let row = low; row < high; row++) {
        for (let column = left; column < right; column++) found.push(...this.bins[row * this.along + column]);
      }
      return found;
    }
  }

  // Lab 10: those on a list that looks `skin` cutoffs beyond the cutoff, made anew when its budget
  // is spent. There is no short list; the kit makes one from a skin of about 0.7 cutoffs on.
  class List {
    constructor(skin) {
      this.skin = skin * CUTOFF;
      this.spent = Infinity;
    }
    prepare(box) {
      this.box = box;
      this.tests = 0;
      this.isNew = 4 * this.spent * this.spent > this.skin * this.skin;
      if (this.isNew) this.build();
      this.tests += this.pairs;
    }
    build() {
      const { n, size, x, y } = this.box;
      this.usual = Math.max(this.fastest(), 1e-9 * size);
      [this.spent, this.age] = [0, 0];
      this.reach = (CUTOFF + this.skin) * (1 + 1e-9) + 1e-15 * size;
      const cells = this.cells();
      this.lists = Array.from({ length: n }, () => []);
      this.pairs = 0;
      for (let row = 0; row < cells.rows; row++) {
        for (let column = 0; column < cells.columns; column++) {
          const own = cells.at(row, column);
          const ahead = [cells.at(row, column + 1), ...[-1, 0, 1].map(d => cells.at(row + 1, column + d))].flat();
          own.forEach((i, k) => {
            for (const j of own.slice(k + 1).concat(ahead)) {
              this.tests++;
              const dx = x[j] - x[i], dy = y[j] - y[i];
              if (dx * dx + dy * dy <= this.reach * this.reach) {
                this.lists[i].push(j);
                this.lists[j].push(i);
                this.pairs++;
              }
            }
          });
        }
      }
    }
    // Cells as wide as the list looks, over the part of the box where particles are.
    cells() {
      const { x, y, n } = this.box, side = this.reach * (1 + 1e-6), inverse = 1 / side;
      const [left, bottom] = [Math.min(...x), Math.min(...y)];
      const columns = Math.trunc((Math.max(...x) - left) / side) + 1;
      const rows = Math.trunc((Math.max(...y) - bottom) / side) + 1;
      const all = Array.from({ length: rows * columns }, () => []);
      for (let i = 0; i < n; i++) {
        const column = Math.min(Math.trunc((x[i] - left) * inverse), columns - 1);
        const row = Math.min(Math.trunc((y[i] - bottom) * inverse), rows - 1);
        all[row * columns + column].push(i);
      }
      const at = (row, column) => (row < rows && column >= 0 && column < columns ? all[row * columns + column] : []);
      return { rows, columns, at };
    }
    fastest() {
      const { n, vx, vy } = this.box;
      let most = 0;
      for (let i = 0; i < n; i++) most = Math.max(most, vx[i] * vx[i] + vy[i] * vy[i]);
      return Math.sqrt(most);
    }
    // After a step of length `dt`: its displacement is spent.
    moved(dt) {
      const over = Math.max(1, this.fastest() / this.usual);
      this.spent += over * (this.usual * dt) + Number.EPSILON * this.box.size;
      this.age++;
    }
    // A reader has moved a particle: the list is of no use any more.
    forget() {
      this.spent = Infinity;
    }
    asked(i) {
      return this.lists[i];
    }
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
      this.search = search;
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
          const dx = x[j] - x[i], dy = y[j] - y[i];
          if (dx * dx + dy * dy <= CUTOFF * CUTOFF && j !== i) near.push(j);
        }
        near.sort((a, b) => a - b);
        touching[i] = near.length > 0;
        [ax[i], ay[i]] = [0, 0];
        for (const j of near) {
          const dx = x[j] - x[i], dy = y[j] - y[i], coef = coefficient(dx * dx + dy * dy);
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
    const r2 = Math.max(square, MIN_R * MIN_R), r = Math.sqrt(r2);
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
    const ratio = CUTOFF / Math.max(r, MIN_R), above = ratio - 1 - Math.log(ratio);
    return r >= MIN_R ? above : above + (((ratio - 1) / (MIN_R * MIN_R)) * (MIN_R * MIN_R - r * r)) / 2;
  }

  // Lab 11: which particles meet no other and no wall in the next `steps` steps, flown straight on.
  // The rest are in groups. Two meet that come within the cutoff and a twentieth of it.
  function free({ n, size, x, y, vx, vy }, steps) {
    const isFree = new Array(n).fill(true), near = 1.05 * CUTOFF;
    const inside = x => x >= 0 && x <= size;
    for (let i = 0; i < n; i++) {
      if (!inside(x[i] + vx[i] * steps * DT) || !inside(y[i] + vy[i] * steps * DT)) isFree[i] = false;
      for (let j = i + 1; j < n; j++) {
        const dx = x[j] - x[i], dy = y[j] - y[i], wx = vx[j] - vx[i], wy = vy[j] - vy[i];
        const closest = -(dx * wx + dy * wy) / (wx * wx + wy * wy) || 0;
        const t = Math.min(Math.max(closest, 0), (steps - 1) * DT);
        if ((dx + t * wx) ** 2 + (dy + t * wy) ** 2 <= near * near) isFree[i] = isFree[j] = false;
      }
    }
    return isFree;
  }

  // A step of Runge and Kutta for a box without walls in reach, as in lab 12.
  function rungeKutta(box, h) {
    const { n, ax, ay } = box, start = ["x", "y", "vx", "vy"].map(name => box[name].slice());
    const sum = start.map(() => new Float64Array(n));
    for (const [weight, next] of [[1, 0.5], [2, 0.5], [2, 1], [1, 0]]) {
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

  globalThis.soft = { CUTOFF, DT, Twister, empty, official, AllPairs, Bins, List, Box, free, rungeKutta };
})();
