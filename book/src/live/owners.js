// Who owns which discs: rows across the box, cut into a block of adjacent ones for each worker, as labs 3 to 6
// and 8 cut them. Block k is the rows from `starts[k]` up to, not including, `starts[k + 1]`.
"use strict";
(() => {
  // As equal as can be: lab 5.
  const even = (rows, workers) =>
    Array.from({ length: workers + 1 }, (_, k) => Math.floor((k * rows) / workers));

  // With nearly equal numbers of discs, of which a row has `counts[row]`: lab 6.
  function balanced(counts, workers) {
    const all = counts.reduce((sum, count) => sum + count, 0),
      starts = [0];
    let row = 0,
      before = 0;
    for (let k = 1; k < workers; k++) {
      while (before < Math.floor((k * all) / workers)) before += counts[row++];
      starts.push(row);
    }
    return [...starts, counts.length];
  }

  // The worker whose block has a row: the last of those that begin there or before.
  const owner = (starts, row) => starts.findLastIndex((start, k) => start <= row && k < starts.length - 1);

  // The workers that have ghosts of a disc in the rows of `home`, because something of it, or of what it asks,
  // lies in the rows from `low` to `high`.
  function copies(starts, home, low, high) {
    const found = [];
    for (let k = owner(starts, low); k <= owner(starts, high); k++)
      if (k !== home && starts[k] < starts[k + 1]) found.push(k);
    return found;
  }

  // Whose each disc is, and which workers have copies of it. The cut is into equal rows ("even"), rows of equal
  // numbers ("equal") or, without a place, discs by number ("number"). `row` is the row of a place y; `reach(i)` says
  // from which place to which disc i asks.
  function parts({ workers, cut }, rows, y, row, reach) {
    const counts = new Array(rows).fill(0);
    for (const place of y) counts[row(place)]++;
    const starts = cut === "equal" ? balanced(counts, workers) : even(rows, workers);
    const home = Array.from(y, (place, i) => owner(starts, cut === "number" ? i : row(place)));
    const all = home.map((k, i) => (cut === "number" ? [] : copies(starts, k, ...reach(i).map(row))));
    return { starts, home, copies: all };
  }

  globalThis.owners = { even, balanced, owner, copies, parts };
})();
