//! Lists of several ranks and one buffer of the root: counts and displacements.

use anyhow::Result;

use super::canvas::{Canvas, INK, Point, outlined};
use super::rows::RANKS;

const CELL: f64 = 35.0;
const WIDTH: f64 = 500.0;
const GAP: f64 = 26.0;

/// What the ranks of chapter 5's example have copied, and what its root has for each of them.
const COPIES: [&[u32]; 3] = [&[1, 2], &[4, 5, 6, 7], &[9]];
const LISTS: [&[u32]; 3] = [&[3, 4, 5, 11], &[1, 2, 3, 8, 9], &[6, 7, 8]];

/// Gather brings one number from each rank, Gatherv as many items as these numbers say.
pub(super) fn gather() -> Result<String> {
    let title = "Gather brings a count from each rank to the root. Gatherv then brings 2, 4 and 1 items into one buffer of the root, at displacements 0, 2 and 6";
    let mut canvas = Canvas::new(title, WIDTH, 476.0);
    canvas.text((WIDTH / 2.0, 24.0), 18.0, INK, "Gather: a number from each rank");
    let counts = COPIES.map(|list| vec![list.len() as u32]);
    let counts = [&counts[0][..], &counts[1], &counts[2]];
    let buffer = to_root(&mut canvas, 60.0, counts);
    let below = (WIDTH / 2.0, buffer[0].1 + CELL + 20.0);
    canvas.text(below, 15.0, INK, "counts, on the root");
    canvas.text((WIDTH / 2.0, 250.0), 18.0, INK, "Gatherv: the items of each rank");
    let buffer = to_root(&mut canvas, 286.0, COPIES);
    let mut displacement = 0;
    for (list, (x, y)) in COPIES.iter().zip(buffer) {
        canvas.text((x + 6.0, y + CELL + 18.0), 15.0, INK, &displacement.to_string());
        displacement += list.len();
    }
    canvas.text(
        (WIDTH / 2.0, buffer[0].1 + CELL + 40.0),
        15.0,
        INK,
        "displacements in the root's buffer",
    );
    Ok(canvas.svg())
}

/// Scatter brings each rank a number, Scatterv as many items as this number says.
pub(super) fn scatter() -> Result<String> {
    let title = "Scatter brings each rank its count. Scatterv then brings parts of 4, 5 and 3 items, at displacements 0, 4 and 9 of the root's buffer, to ranks 0, 1 and 2";
    let mut canvas = Canvas::new(title, WIDTH, 452.0);
    canvas.text((WIDTH / 2.0, 24.0), 18.0, INK, "Scatter: a number to each rank");
    let counts = LISTS.map(|list| vec![list.len() as u32]);
    let counts = [&counts[0][..], &counts[1], &counts[2]];
    let buffer = from_root(&mut canvas, 66.0, counts);
    canvas.text((WIDTH / 2.0, buffer[1].1 - 10.0), 15.0, INK, "counts, on the root");
    canvas.text((WIDTH / 2.0, 234.0), 18.0, INK, "Scatterv: the items for each rank");
    let buffer = from_root(&mut canvas, 296.0, LISTS);
    let mut displacement = 0;
    for (list, (x, y)) in LISTS.iter().zip(buffer) {
        canvas.text((x + 7.0, y - 8.0), 15.0, INK, &displacement.to_string());
        displacement += list.len();
    }
    canvas.text((WIDTH / 2.0, 264.0), 15.0, INK, "displacements in the root's buffer");
    Ok(canvas.svg())
}

/// Lists of the ranks above, from `top` on, one buffer below; where its parts begin.
fn to_root(canvas: &mut Canvas, top: f64, lists: [&[u32]; 3]) -> [Point; 3] {
    let (ranks, buffer) = (places(top, GAP, lists), places(top + 98.0, 0.0, lists));
    for (rank, list) in lists.into_iter().enumerate() {
        let half = list.len() as f64 * CELL / 2.0;
        canvas.text((ranks[rank].0 + half, top - 8.0), 15.0, INK, &format!("rank {rank}"));
        cells(canvas, ranks[rank], rank, list);
        cells(canvas, buffer[rank], rank, list);
        arrow(canvas, rank, (ranks[rank].0 + half, top), (buffer[rank].0 + half, top + 98.0));
    }
    buffer
}

/// One buffer above, from `top` on, lists of the ranks below; where the parts of the buffer begin.
fn from_root(canvas: &mut Canvas, top: f64, lists: [&[u32]; 3]) -> [Point; 3] {
    let (buffer, ranks) = (places(top, 0.0, lists), places(top + 86.0, GAP, lists));
    for (rank, list) in lists.into_iter().enumerate() {
        let half = list.len() as f64 * CELL / 2.0;
        cells(canvas, buffer[rank], rank, list);
        cells(canvas, ranks[rank], rank, list);
        arrow(canvas, rank, (buffer[rank].0 + half, top), (ranks[rank].0 + half, top + 86.0));
        let name = (ranks[rank].0 + half, ranks[rank].1 + CELL + 18.0);
        canvas.text(name, 15.0, INK, &format!("rank {rank}"));
    }
    buffer
}

/// Where lists begin that stand side by side in the middle of the sheet. Lists of one item have
/// room for the names of their ranks.
fn places(top: f64, gap: f64, lists: [&[u32]; 3]) -> [Point; 3] {
    let gap = if gap > 0.0 && lists.iter().all(|list| list.len() == 1) { 90.0 } else { gap };
    let items: usize = lists.iter().map(|list| list.len()).sum();
    let mut x = (WIDTH - items as f64 * CELL - 2.0 * gap) / 2.0;
    lists.map(|list| {
        let place = (x, top);
        x += list.len() as f64 * CELL + gap;
        place
    })
}

fn cells(canvas: &mut Canvas, (x, y): Point, rank: usize, list: &[u32]) {
    let (colour, tint) = RANKS[rank];
    for (k, item) in list.iter().enumerate() {
        let left = x + k as f64 * CELL;
        canvas.rectangle((left, y), CELL, CELL, outlined(colour, 1.5).on(tint));
        canvas.text((left + CELL / 2.0, y + 23.0), 16.0, INK, &item.to_string());
    }
}

/// From below the cells at `from` to above those at `to`.
fn arrow(canvas: &mut Canvas, rank: usize, from: Point, to: Point) {
    canvas.arrow((from.0, from.1 + CELL + 4.0), (to.0, to.1 - 4.0), RANKS[rank].0);
}
