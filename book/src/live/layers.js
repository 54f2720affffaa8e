// What may be drawn around discs: bins, which ones a disc asks, lists, straight paths; and a colour for speeds.
// Needs player.js.
"use strict";
(() => {
  // Points of the colour map viridis, which grows lighter evenly and reads in grey as well.
  const VIRIDIS = [
    [72, 40, 120],
    [62, 74, 137],
    [49, 104, 142],
    [38, 130, 142],
    [31, 158, 137],
    [53, 183, 121],
    [110, 206, 88],
    [181, 222, 43],
    [253, 231, 37],
  ];
  const viridis = share => {
    const place = Math.min(share, 1) * (VIRIDIS.length - 1),
      low = Math.min(Math.floor(place), VIRIDIS.length - 2);
    const mixed = VIRIDIS[low].map((c, i) => Math.round(c + (place - low) * (VIRIDIS[low + 1][i] - c)));
    return `rgb(${mixed.join(",")})`;
  };

  const at = (box, i) => [box.x[i], box.y[i]];

  // Lines from disc `one` to those that it asks.
  function spokes(sheet, box, search, one, width = 1.5) {
    for (const j of search.asked(one))
      sheet.path([at(box, one), at(box, j)], { line: sheet.colours.blue, width });
  }

  // The bins, and those around disc `one`.
  function bins(sheet, box, search, one) {
    const { along } = search,
      side = box.size / along;
    const [left, right] = search.near(search.row(box.x[one])),
      [low, high] = search.near(search.row(box.y[one]));
    sheet.rectangle(left * side, low * side, (right - left) * side, (high - low) * side, {
      fill: sheet.colours.tint,
    });
    sheet.grid(along, box.size);
  }

  // The pairs of a list, and how far it looks around disc `one`.
  function list(sheet, box, search, one) {
    search.lists.forEach((list, i) => {
      for (const j of list) if (j > i) sheet.path([at(box, i), at(box, j)], { line: sheet.colours.faint });
    });
    sheet.disc(...at(box, one), search.reach, { line: sheet.colours.blue, dashed: true });
  }

  // Straight paths through some time: of discs that fly freely, and of the others.
  function flights(sheet, box, free, time) {
    const { blue, orange } = sheet.colours;
    for (let i = 0; i < box.n; i++) {
      const end = [box.x[i] + box.vx[i] * time, box.y[i] + box.vy[i] * time];
      sheet.path([at(box, i), end], { line: free[i] ? blue : orange, width: 1.5 });
    }
  }

  globalThis.layers = { viridis, spokes, bins, list, flights };
})();
