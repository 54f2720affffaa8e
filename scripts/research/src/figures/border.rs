//! Two particles on two ranks, from the step in which ghosts are chosen to the last one that they are
//! good for.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, filled, outlined};
use super::rows::RANKS;

const PANEL: f64 = 240.0;
const TOP: f64 = 36.0;
const STRIP: f64 = 110.0;
const CUTOFF: f64 = 60.0;
/// How far each particle goes in the steps between.
const MOVED: f64 = 40.0;

/// How wide ghosts must be.
pub(super) fn width() -> Result<String> {
    let title = "Two particles on two ranks, W apart when ghosts are chosen, fly towards each other and are one cutoff apart in the last step that the ghosts are good for";
    let mut canvas = Canvas::new(title, 2.0 * PANEL + 30.0, TOP + 2.0 * STRIP + 44.0);
    let width = CUTOFF + 2.0 * MOVED;
    let panels = [
        ("ghosts are chosen", width, "W", "W = c + 2 (m − 1) f"),
        ("the last of m steps", CUTOFF, "c", "each has gone (m − 1) f"),
    ];
    for (panel, (name, apart, letter, under)) in panels.into_iter().enumerate() {
        let left = 10.0 + panel as f64 * (PANEL + 10.0);
        let (middle, border) = (left + PANEL / 2.0, TOP + STRIP);
        canvas.text((middle, TOP - 12.0), 17.0, INK, name);
        for (rank, top) in [(1, TOP), (0, border)] {
            let (colour, tint) = RANKS[rank];
            canvas.rectangle((left, top), PANEL, STRIP, outlined(GREY, 1.0).on(tint));
            let inside = if rank == 1 { TOP + 16.0 } else { border + STRIP - 8.0 };
            canvas.text((left + 30.0, inside + 2.0), 14.0, colour, &format!("rank {rank}"));
        }
        canvas.line((left, border), (left + PANEL, border), outlined(INK, 1.5));
        let [low, high] = [border + apart / 2.0, border - apart / 2.0];
        for (rank, y) in [(0, low), (1, high)] {
            let colour = RANKS[rank].0;
            canvas.circle((middle, y), 6.0, filled(colour));
            if panel == 0 {
                let towards = if rank == 0 { y - MOVED } else { y + MOVED };
                canvas.arrow((middle, y), (middle, towards), colour);
            }
        }
        let beside = middle + 34.0;
        canvas.line((beside, low), (beside, high), outlined(INK, 1.2));
        for y in [low, high] {
            canvas.line((beside - 6.0, y), (beside + 6.0, y), outlined(INK, 1.2));
        }
        canvas.text((beside + 14.0, border - 8.0), 16.0, INK, letter);
        canvas.text((middle, border + STRIP + 24.0), 15.0, INK, under);
    }
    Ok(canvas.svg())
}
