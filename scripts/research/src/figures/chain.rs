//! Rounds of news along a chain of collisions across a cut.

use anyhow::Result;

use super::canvas::{Canvas, GREY, INK, ORANGE, PALE_ORANGE, Point, outlined};
use super::rows::RANKS;

const WIDTH: f64 = 520.0;
const PANEL: f64 = 158.0;
const TOP: f64 = 40.0;
const SIDE: f64 = 220.0;

/// Discs a to d, on either side of the cut, in shares of a panel.
const DISCS: [(&str, Point); 4] =
    [("a", (0.24, 0.12)), ("b", (0.76, 0.36)), ("c", (0.24, 0.62)), ("d", (0.76, 0.88))];

/// What has become of a candidate.
#[derive(Clone, Copy, PartialEq)]
enum Fate {
    Open,
    Taken,
    Dropped,
}

/// Candidates a–b, b–c and c–d in the order of time, after each of three rounds.
pub(super) fn rounds() -> Result<String> {
    use Fate::{Dropped, Open, Taken};
    let title = "A chain of collisions across the cut of two ranks: a with b is taken in the first round, so b with c is dropped in the second, so c with d is taken in the third";
    let mut canvas = Canvas::new(title, WIDTH, TOP + SIDE + 62.0);
    let panels = [
        ("round 1", [Taken, Open, Open], ["a–b is the first", "of both: taken"]),
        ("round 2", [Taken, Dropped, Open], ["news of b:", "b–c is dropped"]),
        ("round 3", [Taken, Dropped, Taken], ["news of c:", "c–d is taken"]),
    ];
    for (panel, (name, fates, said)) in panels.into_iter().enumerate() {
        let left = 11.0 + panel as f64 * (PANEL + 12.0);
        let at = |(x, y): Point| (left + x * PANEL, TOP + y * SIDE);
        canvas.text((left + PANEL / 2.0, TOP - 14.0), 17.0, INK, name);
        for (rank, (_, tint)) in RANKS.into_iter().take(2).enumerate() {
            let corner = at((0.5 * rank as f64, 0.0));
            canvas.rectangle(corner, PANEL / 2.0, SIDE, outlined(GREY, 1.0).on(tint));
        }
        for (at_pair, fate) in fates.into_iter().enumerate() {
            let (from, to) = (at(DISCS[at_pair].1), at(DISCS[at_pair + 1].1));
            let style = match fate {
                Open => outlined(INK, 1.5),
                Taken => outlined(ORANGE, 5.0),
                Dropped => outlined(GREY, 1.5).dashed(),
            };
            canvas.line(from, to, style);
        }
        for (number, (name, place)) in DISCS.into_iter().enumerate() {
            let hit = |pair: usize| fates.get(pair) == Some(&Taken);
            let is_hit = hit(number) || number > 0 && hit(number - 1);
            let fill = if is_hit { PALE_ORANGE } else { "#ffffff" };
            canvas.circle(at(place), 14.0, outlined(RANKS[number % 2].0, 1.5).on(fill));
            let (x, y) = at(place);
            canvas.text((x, y + 5.0), 15.0, INK, name);
        }
        canvas.line(at((0.5, 0.0)), at((0.5, 1.0)), outlined(INK, 2.0));
        for (line, text) in said.into_iter().enumerate() {
            let below = TOP + SIDE + 24.0 + 20.0 * line as f64;
            canvas.text((left + PANEL / 2.0, below), 15.0, INK, text);
        }
    }
    Ok(canvas.svg())
}
