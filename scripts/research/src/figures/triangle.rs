//! The triangle of all pairs, dealt to two threads by rows.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, outlined};
use super::rows::RANKS;

const DISCS: usize = 12;
const CELL: f64 = 19.0;
const PANEL: f64 = DISCS as f64 * CELL;
const TOP: f64 = 36.0;

/// Who looks at the pairs of disc a with all later ones, for each a.
type Owners = [usize; DISCS];

/// Each of two threads has half of the rows.
fn in_halves() -> Owners {
    std::array::from_fn(|a| a / (DISCS / 2))
}

/// A thread that is done takes the next row: each pair takes as long as any other.
fn from_a_queue() -> Owners {
    let mut busy_until = [0, 0];
    std::array::from_fn(|a| {
        let thread = usize::from(busy_until[1] < busy_until[0]);
        busy_until[thread] += DISCS - 1 - a;
        thread
    })
}

/// The same pairs by a static and by a dynamic schedule.
pub(super) fn schedules() -> Result<String> {
    let title = "The pairs of twelve discs on two threads: with half of the rows each, one has 51 pairs and the other 15; from a queue of rows they have nearly the same";
    let mut canvas = Canvas::new(title, 2.0 * PANEL + 60.0, TOP + PANEL + 62.0);
    let panels =
        [("static: half of the rows", in_halves()), ("dynamic: the next row", from_a_queue())];
    for (panel, (name, owners)) in panels.into_iter().enumerate() {
        let left = 20.0 + panel as f64 * (PANEL + 20.0);
        canvas.text((left + PANEL / 2.0, TOP - 12.0), 17.0, INK, name);
        let mut pairs = [0, 0];
        for (a, thread) in owners.into_iter().enumerate() {
            let (colour, tint) = RANKS[thread];
            pairs[thread] += DISCS - 1 - a;
            for b in a + 1..DISCS {
                let corner = (left + b as f64 * CELL, TOP + a as f64 * CELL);
                canvas.rectangle(corner, CELL, CELL, outlined(colour, 1.0).on(tint));
            }
        }
        canvas.line((left, TOP), (left + PANEL, TOP + PANEL), outlined(GREY, 1.0).dashed());
        for (thread, pairs) in pairs.into_iter().enumerate() {
            let place = (left + PANEL / 2.0, TOP + PANEL + 24.0 + 22.0 * thread as f64);
            canvas.text(place, 15.0, RANKS[thread].0, &format!("thread {thread}: {pairs} pairs"));
        }
    }
    Ok(canvas.svg())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_title_counts_the_pairs() {
        let pairs = |owners: Owners, thread| -> usize {
            (0..DISCS).filter(|&a| owners[a] == thread).map(|a| DISCS - 1 - a).sum()
        };
        assert_eq!([0, 1].map(|thread| pairs(in_halves(), thread)), [51, 15]);
        let [first, second] = [0, 1].map(|thread| pairs(from_a_queue(), thread));
        assert!(first.abs_diff(second) <= 2, "{first} and {second}");
    }
}
