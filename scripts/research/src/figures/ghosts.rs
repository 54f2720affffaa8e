//! A ghost that was not sent anew, in the step in which it goes stale.

use anyhow::Result;
use common::soft::Particle;
use oracle::scenes;

use super::canvas::{Canvas, GREY, INK, Point, outlined};
use super::rows::{RANKS, disc};

/// Columns and rows of the box that are shown.
const COLUMNS: [f64; 2] = [1.0, 4.0];
const ROWS: [f64; 2] = [1.0, 3.0];

const CELL: f64 = 51.0;
const TOP: f64 = 58.0;

/// Particle 2 of rank 0 and the ghost of particle 5 of rank 1, in the example of chapter 5.
pub(super) fn stale() -> Result<String> {
    let title = "Particle 5 moves within its row. With a fresh ghost particle 2 is pushed to the left, with the stale one to the right";
    let width = (COLUMNS[1] - COLUMNS[0]) * CELL;
    let height = (ROWS[1] - ROWS[0]) * CELL;
    let mut canvas = Canvas::new(title, 3.0 * width + 40.0, TOP + height + 62.0);
    let [before, after] = scenes::dozen();
    let panels = [
        ("before the step", "", &before[2], &before[5]),
        ("after it,", "ghost sent anew", &after[2], &after[5]),
        ("after it,", "ghost not sent", &after[2], &before[5]),
    ];
    for (panel, (first, second, own, ghost)) in panels.into_iter().enumerate() {
        let left = 10.0 + panel as f64 * (width + 10.0);
        let place = |p: &Particle| (left + (p.x - COLUMNS[0]) * CELL, TOP + (ROWS[1] - p.y) * CELL);
        canvas.text((left + width / 2.0, 22.0), 16.0, INK, first);
        canvas.text((left + width / 2.0, 43.0), 16.0, INK, second);
        for row in 0..2 {
            let (colour, tint) = RANKS[1 - row];
            let corner = (left, TOP + row as f64 * CELL);
            let ghosts = outlined(colour, 1.5).dashed();
            let style = if row == 0 { ghosts } else { outlined(GREY, 1.0).on(tint) };
            canvas.rectangle(corner, width, CELL, style);
        }
        canvas.circle(place(own), CELL, outlined(GREY, 1.2).dashed());
        if panel == 2 {
            canvas.circle(place(&after[5]), 11.5, outlined(GREY, 1.2).dashed());
        }
        push(&mut canvas, place(own), place(ghost));
        disc(&mut canvas, place(own), RANKS[0].0, own, false);
        disc(&mut canvas, place(ghost), RANKS[1].0, ghost, true);
    }
    let under = (1.5 * width + 20.0, TOP + height + 46.0);
    canvas.text(under, 15.0, INK, "rank 0's memory: row 1, and the ghosts of row 2 above it");
    Ok(canvas.svg())
}

/// The push on a particle at `own`, away from a ghost.
fn push(canvas: &mut Canvas, own: Point, ghost: Point) {
    let (dx, dy) = (own.0 - ghost.0, own.1 - ghost.1);
    let scale = 32.0 / dx.hypot(dy);
    canvas.arrow(own, (own.0 + dx * scale, own.1 + dy * scale), INK);
}
