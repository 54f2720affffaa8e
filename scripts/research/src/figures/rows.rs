//! Rows of bins on ranks: what each has in its memory, and where the cuts are.

use anyhow::Result;
use common::soft::Particle;
use oracle::scenes;

use super::canvas::{
    BLUE, Canvas, GREY, INK, ORANGE, PALE_BLUE, PALE_ORANGE, Point, filled, outlined,
};

/// A colour and its tint for each rank.
pub(super) const RANKS: [(&str, &str); 4] =
    [(BLUE, PALE_BLUE), (ORANGE, PALE_ORANGE), ("#00795a", "#d3ebe2"), ("#7a5195", "#e6dced")];

/// The dozen particles of chapters 5 and 6 in six rows, and what each of three ranks has of them.
pub(super) fn rows() -> Result<String> {
    const PANEL: f64 = 108.0;
    const GAP: f64 = 10.0;
    const ROW: f64 = 44.0;
    const TOP: f64 = 34.0;
    let title = "Six rows of bins on three ranks: each has two rows, and a ghost row where a neighbour's row adjoins";
    let mut canvas = Canvas::new(title, 4.0 * PANEL + 7.0 * GAP, 6.0 * ROW + TOP + 40.0);
    let [particles, _] = scenes::dozen();
    for panel in 0..4_usize {
        let left = 3.0 * GAP + panel as f64 * (PANEL + GAP);
        let name = if panel == 0 { "the box".into() } else { format!("rank {}", panel - 1) };
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, &name);
        for row in 0..6_usize {
            let owner = row / 2;
            let (colour, tint) = RANKS[owner];
            let top = TOP + (5 - row) as f64 * ROW;
            if panel == 0 {
                let middle = (left - 1.4 * GAP, top + ROW / 2.0 + 5.0);
                canvas.text(middle, 15.0, INK, &row.to_string());
            }
            let is_own = panel == 0 || owner == panel - 1;
            let is_ghost = !is_own && row + 3 >= 2 * panel && row <= 2 * panel;
            let style = match (is_own, is_ghost) {
                (true, _) => outlined(GREY, 1.0).on(tint),
                (_, true) => outlined(colour, 1.5).dashed(),
                _ => outlined(GREY, 0.6).faint(0.4),
            };
            canvas.rectangle((left, top), PANEL, ROW, style);
            if is_own || is_ghost {
                for particle in particles.iter().filter(|p| p.y as usize == row) {
                    let place = (left + particle.x / 6.0 * PANEL, TOP + (6.0 - particle.y) * ROW);
                    disc(&mut canvas, place, colour, particle, is_ghost);
                }
            }
        }
    }
    let under = (2.0 * PANEL + 3.5 * GAP, TOP + 6.0 * ROW + 27.0);
    canvas.text(under, 15.0, INK, "filled: own particles; dashed and hollow: ghosts");
    Ok(canvas.svg())
}

/// A particle with its number, hollow if it is a ghost.
pub(super) fn disc(
    canvas: &mut Canvas,
    (x, y): Point,
    colour: &'static str,
    particle: &Particle,
    is_ghost: bool,
) {
    let (fill, ink) = if is_ghost { ("#ffffff", colour) } else { (colour, "#ffffff") };
    canvas.circle((x, y), 11.5, outlined(colour, 1.5).on(fill));
    canvas.text((x, y + 5.5), 13.0, ink, &particle.id.to_string());
}

/// The same ten rows on four ranks, cut by rows and cut by particles.
pub(super) fn recut() -> Result<String> {
    const COUNTS: [usize; 10] = [5, 4, 3, 2, 1, 0, 0, 0, 0, 1];
    const PANEL: f64 = 236.0;
    const ROW: f64 = 30.0;
    const TOP: f64 = 36.0;
    let title = "Ten rows with 5, 4, 3, 2, 1, 0, 0, 0, 0, 1 particles on four ranks: equal numbers of rows give 9, 6, 0, 1 particles, balanced blocks 5, 4, 3, 4";
    let mut canvas = Canvas::new(title, 2.0 * PANEL + 40.0, 10.0 * ROW + TOP + 14.0);
    let panels = [("equal numbers of rows", [0, 2, 5, 7, 10]), ("balanced", [0, 1, 2, 3, 10])];
    for (panel, (name, starts)) in panels.into_iter().enumerate() {
        let left = 10.0 + panel as f64 * (PANEL + 20.0);
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, name);
        for (rank, (colour, tint)) in RANKS.into_iter().enumerate() {
            let (start, end) = (starts[rank], starts[rank + 1]);
            let top = TOP + (10 - end) as f64 * ROW;
            let height = (end - start) as f64 * ROW;
            canvas.rectangle((left, top), PANEL, height, outlined(colour, 1.5).on(tint));
            let held: usize = COUNTS[start..end].iter().sum();
            for (row, count) in (start..end).zip(&COUNTS[start..end]) {
                let y = TOP + (9 - row) as f64 * ROW + ROW / 2.0;
                for k in 0..*count {
                    canvas.circle((left + 18.0 + 20.0 * k as f64, y), 7.0, filled(colour));
                }
            }
            let middle = (left + PANEL - 58.0, top + height / 2.0 + 5.0);
            canvas.text(middle, 15.0, INK, &format!("rank {rank} has {held}"));
        }
    }
    Ok(canvas.svg())
}
