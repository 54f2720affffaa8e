// A run that was recorded: frames of discs instead of steps that are computed. Needs soft.js.
"use strict";
(() => {
  // Frames are 16-bit numbers: for one disc after the other x and y, from 0 to WHOLE across the box, and
  // the velocity, half of WHOLE for none and WHOLE for the greatest component of the run.
  const WHOLE = 65534;

  class Run {
    constructor({ n, size, fastest, between, dt, frames }) {
      const bytes = Uint8Array.from(atob(frames), letter => letter.charCodeAt(0));
      Object.assign(this, { n, size, fastest, time: between * dt });
      this.numbers = new Uint16Array(bytes.buffer);
      this.last = this.numbers.length / (4 * n) - 1;
    }

    // The discs of a frame, as a box has them.
    frame(k) {
      const discs = soft.empty(this.n, this.size);
      for (let i = 0; i < this.n; i++) {
        const [x, y, vx, vy] = this.numbers.subarray(4 * (k * this.n + i));
        [discs.x[i], discs.y[i]] = [x, y].map(word => (word / WHOLE) * this.size);
        [discs.vx[i], discs.vy[i]] = [vx, vy].map(word => ((2 * word) / WHOLE - 1) * this.fastest);
      }
      return discs;
    }

    // The discs at a part, 0 to 1, of the way from `now`, a frame, to `next`, the one after it. Each flies with
    // its old velocity as far as where its new one must have begun: so it turns where it was hit.
    between(now, next, part) {
      if (part === 0) return now;
      const discs = soft.empty(this.n, this.size);
      const inside = x => Math.min(Math.max(x, 0), this.size);
      for (let i = 0; i < this.n; i++) {
        const [wx, wy] = [now.vx[i] - next.vx[i], now.vy[i] - next.vy[i]],
          missed = axis => next[axis][i] - now[axis][i] - next[`v${axis}`][i] * this.time,
          along = (missed("x") * wx + missed("y") * wy) / ((wx * wx + wy * wy) * this.time) || 0,
          turn = Math.min(Math.max(along, 0), 0.99);
        const flies = part < turn ? now : next;
        for (const axis of ["x", "y"]) {
          const v = `v${axis}`,
            at = turn => inside(now[axis][i] + now[v][i] * this.time * turn),
            from = at(turn);
          discs[v][i] = flies[v][i];
          discs[axis][i] =
            part < turn ? at(part) : from + ((next[axis][i] - from) * (part - turn)) / (1 - turn);
        }
      }
      return discs;
    }
  }

  globalThis.recorded = { Run };
})();
