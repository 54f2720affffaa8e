//! A pair across the cut between two owners: who computes it, and who writes which half.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, Point, filled, outlined};
use super::rows::RANKS;

const PANEL: f64 = 160.0;
const GAP: f64 = 15.0;
const TOP: f64 = 40.0;
/// Where the cut is.
const CUT: f64 = TOP + 112.0;
const BOTTOM: f64 = TOP + 224.0;
const CELL: (f64, f64) = (62.0, 30.0);

/// The pair, a race for the upper half, and the list that avoids it.
pub(super) fn cut() -> Result<String> {
    let title = "Particle i of thread 0 and j of thread 1 touch across the cut. If thread 0 writes into the sum of j, thread 1 may be writing there as well; so it writes into a list of its own, and thread 1 adds that later";
    let width = 3.0 * PANEL + 4.0 * GAP;
    let mut canvas = Canvas::new(title, width, BOTTOM + 62.0);
    let lefts = [0.0, 1.0, 2.0].map(|panel| GAP + panel * (PANEL + GAP));
    for (left, (name, under)) in lefts.into_iter().zip([
        ("the pair i, j", ["thread 0 owns i,", "thread 1 owns j, k"]),
        ("a race", ["both threads write", "into the sum of j"]),
        ("each its own", ["when all are done,", "thread 1 adds across"]),
    ]) {
        canvas.text((left + PANEL / 2.0, TOP - 14.0), 17.0, INK, name);
        for (thread, top) in [(1, TOP), (0, CUT)] {
            canvas.rectangle((left, top), PANEL, CUT - TOP, filled(RANKS[thread].1));
        }
        canvas.line((left, CUT), (left + PANEL, CUT), outlined(INK, 2.5).dashed());
        for (line, text) in under.into_iter().enumerate() {
            let y = BOTTOM + 24.0 + 20.0 * line as f64;
            canvas.text((left + PANEL / 2.0, y), 15.0, INK, text);
        }
    }
    pair(&mut canvas, lefts[0]);
    writes(&mut canvas, lefts[1], true);
    writes(&mut canvas, lefts[2], false);
    Ok(canvas.svg())
}

/// Where the three particles are, and which of them touch.
fn pair(canvas: &mut Canvas, left: f64) {
    let at = |(x, y): Point| (left + x, CUT - y);
    let [i, j, k] = [(62.0, -44.0), (84.0, 30.0), (122.0, 74.0)].map(at);
    canvas.line(i, j, outlined(INK, 2.0));
    canvas.line(j, k, outlined(GREY, 2.0));
    for (name, place, thread) in [("i", i, 0), ("j", j, 1), ("k", k, 1)] {
        canvas.circle(place, 13.0, outlined(RANKS[thread].0, 2.0).on("#ffffff"));
        canvas.text((place.0, place.1 + 5.0), 15.0, INK, name);
    }
    canvas.text((left + 44.0, TOP + 20.0), 15.0, RANKS[1].0, "thread 1");
    canvas.text((left + 44.0, BOTTOM - 12.0), 15.0, RANKS[0].0, "thread 0");
}

/// What both threads write, each for the pair that it looks at.
fn writes(canvas: &mut Canvas, left: f64, is_race: bool) {
    let (first, second) = (left + 12.0, left + PANEL - 12.0 - CELL.0);
    let middle = |x: f64| x + CELL.0 / 2.0;
    let (above, below) = (CUT - 12.0 - CELL.1, CUT + 12.0);
    let mut cell = |x: f64, y: f64, thread: usize, name: &str| {
        canvas.rectangle((x, y), CELL.0, CELL.1, outlined(RANKS[thread].0, 1.5).on("#ffffff"));
        canvas.text((middle(x), y + 20.0), 15.0, INK, name);
    };
    cell(first, above, 1, "j");
    cell(second, above, 1, "k");
    cell(second, below, 0, "i");
    if !is_race {
        cell(first, below, 0, "across");
    }
    let (sky, ground) = (TOP + 28.0, BOTTOM - 26.0);
    canvas.text((left + PANEL / 2.0, TOP + 20.0), 15.0, RANKS[1].0, "thread 1: j and k");
    canvas.text((left + PANEL / 2.0, BOTTOM - 10.0), 15.0, RANKS[0].0, "thread 0: i and j");
    canvas.arrow((middle(first), sky), (middle(first), above - 2.0), RANKS[1].0);
    canvas.arrow((middle(second), sky), (middle(second), above - 2.0), RANKS[1].0);
    canvas.arrow((middle(second), ground), (middle(second), below + CELL.1 + 2.0), RANKS[0].0);
    let end = if is_race { above } else { below } + CELL.1 + 2.0;
    canvas.arrow((middle(first), ground), (middle(first), end), RANKS[0].0);
    if is_race {
        canvas.rectangle((first, above), CELL.0, CELL.1, outlined(INK, 3.0));
    } else {
        canvas.arrow(
            (middle(first), below - 2.0),
            (middle(first), above + CELL.1 + 1.0),
            RANKS[1].0,
        );
    }
}
