// Functions that live.rs calls on the book's scripts. They return runs as text, in the kit's
// formats.

// Formats a number as C's %g does: with six significant digits.
function general(value) {
  const text = value.toPrecision(6);
  return text.includes("e") || Math.abs(value) < 1e-4
    ? value.toExponential(5).replace(/\.?0*e([+-])(\d)$/, "e$10$2")
    : trimmed(text);
}
const trimmed = text => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);

// The official output of all pairs: every tenth step.
function officialOutput(n, seed, steps) {
  const box = new soft.Box(soft.official(n, seed), new soft.AllPairs());
  let text = `${n} ${general(box.size)}\n`;
  for (let step = 0; step < steps; step++) {
    box.step();
    if (step % 10 > 0) continue;
    for (let i = 0; i < n; i++) text += `${general(box.x[i])} ${general(box.y[i])}\n`;
    text += "\n";
  }
  return text;
}

// The pair tests of each step, then every number of every particle at the end, bit by bit.
function testsAndBits(search, n, seed, steps) {
  const box = new soft.Box(soft.official(n, seed), search);
  let text = "";
  for (let step = 0; step < steps; step++) {
    text += `${search.tests}\n`;
    box.step();
  }
  const bits = value => new BigUint64Array(new Float64Array([value]).buffer)[0].toString(16);
  for (let i = 0; i < n; i++) text += ["x", "y", "vx", "vy"].map(name => bits(box[name][i])).join(" ") + "\n";
  return text;
}

// The pair tests of each step.
const tests = (...run) =>
  testsAndBits(...run)
    .split("\n")
    .slice(0, run[3])
    .join("\n") + "\n";

// The positions of hard discs after each step, and finally their numbers of collisions.
function hardSteps(n, side, radius, seed, steps) {
  const scene = hard.random(n, side, radius, seed);
  const ten = value => (Object.is(value, -0) ? "-" : "") + value.toFixed(8);
  const numbers = ({ x, y, vx, vy }) => [x, y, vx, vy].map(value => ten(value).padStart(10)).join(" ");
  let text = "";
  for (let step = 1; step <= steps; step++) {
    hard.resolve(scene, hard.choose(hard.candidates(scene), n));
    scene.discs.forEach((disc, i) => (text += `${step} ${i} ${numbers(disc)}\n`));
  }
  scene.discs.forEach((disc, i) => (text += `${steps} ${i} ${numbers(disc)} ${disc.pairs} ${disc.walls}\n`));
  return text;
}

// Whether the collisions of some steps are the same if each disc is tested only with discs in nine
// cells.
function sameHits(n, side, radius, seed, steps) {
  const scene = hard.random(n, side, radius, seed, [0.5, 2]);
  for (let step = 0; step < steps; step++) {
    const { discs } = scene,
      component = name => discs.map(disc => disc[name]),
      fastest = Math.max(...[...component("vx"), ...component("vy")].map(Math.abs));
    const bins = new soft.Bins((2 * radius + 2 * Math.SQRT2 * fastest) / soft.CUTOFF);
    bins.prepare({ n, size: side, x: component("x"), y: component("y") });
    const all = hard.candidates(scene);
    if (bins.along < 3) return "too few cells to tell";
    if (JSON.stringify(hard.candidates(scene, i => bins.asked(i))) !== JSON.stringify(all)) return `step ${step} differs`;
    hard.resolve(scene, hard.choose(all, n));
  }
  return `${steps} steps, all the same`;
}

const ownersOfRows = (starts, rows) =>
  Array.from({ length: rows }, (_, row) => `${owners.owner(starts, row)} `).join("");

// The positions of the only disc of a run of two frames, at these fractions of the time between the
// frames.
function recordedPlaces(words, fastest, parts) {
  const frames = btoa(String.fromCharCode(...new Uint8Array(new Uint16Array(words).buffer)));
  const run = new recorded.Run({ n: 1, size: 1, fastest, between: 1, dt: 0.1, frames });
  const [now, next] = [run.frame(0), run.frame(1)];
  return parts.map(part => (part < 1 ? run.between(now, next, part) : next).x[0].toFixed(3)).join(" ");
}
