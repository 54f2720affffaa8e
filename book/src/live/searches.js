// Which particles one of them asks: three searches, of labs 1, 2 and 10. Needs soft.js.
"use strict";
(() => {
  const { CUTOFF } = soft;

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
      const [left, right] = this.near(this.row(this.box.x[i])),
        [low, high] = this.near(this.row(this.box.y[i]));
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
      this.spent = 0;
      this.reach = (CUTOFF + this.skin) * (1 + 1e-9) + 1e-15 * size;
      const cells = this.cells();
      this.lists = Array.from({ length: n }, () => []);
      this.pairs = 0;
      for (let row = 0; row < cells.rows; row++) {
        for (let column = 0; column < cells.columns; column++) {
          const own = cells.at(row, column);
          const ahead = [
            cells.at(row, column + 1),
            ...[-1, 0, 1].map(d => cells.at(row + 1, column + d)),
          ].flat();
          own.forEach((i, k) => {
            for (const j of own.slice(k + 1).concat(ahead)) {
              this.tests++;
              const dx = x[j] - x[i],
                dy = y[j] - y[i];
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
      const { x, y, n } = this.box,
        side = this.reach * (1 + 1e-6),
        inverse = 1 / side;
      const [left, bottom] = [Math.min(...x), Math.min(...y)];
      const columns = Math.trunc((Math.max(...x) - left) / side) + 1;
      const rows = Math.trunc((Math.max(...y) - bottom) / side) + 1;
      const all = Array.from({ length: rows * columns }, () => []);
      for (let i = 0; i < n; i++) {
        const column = Math.min(Math.trunc((x[i] - left) * inverse), columns - 1);
        const row = Math.min(Math.trunc((y[i] - bottom) * inverse), rows - 1);
        all[row * columns + column].push(i);
      }
      const at = (row, column) =>
        row < rows && column >= 0 && column < columns ? all[row * columns + column] : [];
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
    }
    // A reader has moved a particle: the list is of no use any more.
    forget() {
      this.spent = Infinity;
    }
    asked(i) {
      return this.lists[i];
    }
  }

  Object.assign(soft, { AllPairs, Bins, List });
})();
