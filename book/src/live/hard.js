// The hard discs of lab 7, computed as lab 7 computes them: tests/live compares its places with the
// kit's own, byte by byte. Needs random.js.
"use strict";
(() => {
  // A random scene: `n` discs of radius `radius` in a square of side `side`, none of them still; the
  // speeds along x and y are the assignment's unless given.
  function random(n, side, radius, seed, [least, greatest] = [side / (8 * radius), side / 4]) {
    const twister = new Twister(seed);
    const unit = () => {
      const high = twister.word() >>> 5,
        low = twister.word() >>> 6;
      return (high * 67108864 + low) / 9007199254740992;
    };
    const within = side - 2 * radius;
    const place = () => Math.min(Math.max((side - within) / 2 + within * unit(), radius), side - radius);
    const component = () => {
      const s = 2 * unit() - 1,
        speed = least + (greatest - least) * Math.abs(s);
      return s < 0 || Object.is(s, -0) ? -speed : speed;
    };
    const discs = [];
    for (let i = 0; i < n; i++) {
      const [x, y] = [place(), place()];
      discs.push({ x, y, vx: component(), vy: component(), pairs: 0, walls: 0 });
    }
    return { side, radius, discs };
  }

  const CORNER = 0,
    WALL_X = 1,
    WALL_Y = 2,
    PAIR = 3;

  // When along one axis a disc hits a wall in this step, or none.
  function along(x, v, { side, radius }) {
    const clamp = time => Math.min(Math.max(time, 0), 1);
    if (x + v < radius) return clamp((radius - x) / v);
    if (x + v > side - radius) return clamp((side - radius - x) / v);
    return null;
  }

  function wallHit(scene, a) {
    const { x, y, vx, vy } = scene.discs[a],
      tx = along(x, vx, scene),
      ty = along(y, vy, scene);
    if (tx === null && ty === null) return null;
    if (tx !== null && tx === ty) return { time: tx, kind: CORNER, a, b: a };
    if (tx === null || (ty !== null && ty < tx)) return { time: ty, kind: WALL_Y, a, b: a };
    return { time: tx, kind: WALL_X, a, b: a };
  }

  function pairHit({ discs, radius }, a, b) {
    const [one, two] = [discs[a], discs[b]];
    const dx = two.x - one.x,
      dy = two.y - one.y,
      wx = two.vx - one.vx,
      wy = two.vy - one.vy;
    const s = dx * wx + dy * wy;
    if (s >= 0) return null;
    const distance = dx * dx + dy * dy,
      reach = 4 * radius * radius;
    if (distance <= reach && distance !== 0) return { time: 0, kind: PAIR, a, b };
    const cross = dx * wy - dy * wx,
      delta = reach * (wx * wx + wy * wy) - cross * cross;
    if (delta <= 0) return null;
    const time = (distance - reach) / (Math.sqrt(delta) - s);
    return time < 1 ? { time, kind: PAIR, a, b } : null;
  }

  // The earliest first; at the same time walls before pairs, then by number.
  const order = (p, q) => p.time - q.time || p.kind - q.kind || p.a - q.a || p.b - q.b;

  // All collisions that could happen in this step, in order. `asked(a)` are the discs that can meet disc
  // a, and perhaps more.
  function candidates(scene, asked) {
    const found = [],
      all = scene.discs.map((_, i) => i);
    for (const a of all) {
      found.push(wallHit(scene, a));
      for (const b of asked?.(a) ?? all) if (b > a) found.push(pairHit(scene, a, b));
    }
    return found.filter(hit => hit).sort(order);
  }

  // Those that happen: each whose discs are still free. `candidates` are in order.
  function choose(candidates, n) {
    const free = new Array(n).fill(true);
    return candidates.filter(({ a, b }) => {
      const taken = free[a] && free[b];
      if (taken) free[a] = free[b] = false;
      return taken;
    });
  }

  function travel(disc, time) {
    disc.x += time * disc.vx;
    disc.y += time * disc.vy;
  }

  // A disc that ends beyond a wall waits there, back along its path.
  function stop(disc, { side, radius }) {
    const back = (x, v) => {
      const beyond = x - Math.min(Math.max(x, radius), side - radius),
        time = beyond / v;
      return beyond !== 0 && time > 0 && time <= 2 ? time : 0;
    };
    travel(disc, -Math.max(back(disc.x, disc.vx), back(disc.y, disc.vy)));
  }

  // Carries out what was taken; discs in no collision fly on. Each disc's `path` is where it was.
  function resolve(scene, taken) {
    const free = new Set(scene.discs);
    for (const disc of scene.discs) disc.path = [[disc.x, disc.y]];
    for (const { time, kind, a, b } of taken) {
      const [one, two] = [scene.discs[a], scene.discs[b]];
      const hit = kind === PAIR ? [one, two] : [one];
      for (const disc of hit) {
        free.delete(disc);
        travel(disc, time);
        disc.path.push([disc.x, disc.y]);
      }
      if (kind === PAIR) {
        exchange(one, two);
      } else {
        if (kind !== WALL_Y) one.vx = -one.vx;
        if (kind !== WALL_X) one.vy = -one.vy;
      }
      for (const disc of hit) {
        travel(disc, 1 - time);
        stop(disc, scene);
        disc[kind === PAIR ? "pairs" : "walls"]++;
      }
    }
    free.forEach(disc => travel(disc, 1));
    scene.discs.forEach(disc => disc.path.push([disc.x, disc.y]));
  }

  function exchange(one, two) {
    const nx = two.x - one.x,
      ny = two.y - one.y,
      length = nx * nx + ny * ny;
    if (length <= 0) return;
    const share = ((two.vx - one.vx) * nx + (two.vy - one.vy) * ny) / length;
    const [px, py] = [share * nx, share * ny];
    one.vx += px;
    one.vy += py;
    two.vx -= px;
    two.vy -= py;
  }

  globalThis.hard = { PAIR, random, candidates, choose, resolve };
})();
