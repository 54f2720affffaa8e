//! A prefix sum in rounds, as lab 9's workgroups compute it.

use anyhow::Result;

use super::canvas::{BLUE, Canvas, GREY, INK, PALE_BLUE, PALE_ORANGE, outlined};

const WIDTH: f64 = 520.0;
const LEFT: f64 = 96.0;
const CELL: f64 = 52.0;
const ROW: f64 = 84.0;
const TOP: f64 = 34.0;

/// How many particles each of eight bins holds.
const COUNTS: [u32; 8] = [3, 1, 0, 2, 4, 0, 1, 2];

/// In rounds each number adds the one that is 1, 2, 4 places before it.
pub(super) fn rounds() -> Result<String> {
    let title = "A prefix sum of eight numbers in three rounds: each adds the number that is one place before it, then two, then four; a barrier stands between the rounds";
    let mut canvas = Canvas::new(title, WIDTH, TOP + 3.0 * ROW + 84.0);
    let mut sums = COUNTS;
    let y = |round: usize| TOP + round as f64 * ROW;
    row(&mut canvas, y(0), "counts", sums);
    for (round, reach) in [1, 2, 4].into_iter().enumerate() {
        let before = sums;
        let (from, to) = (y(round) + 36.0, y(round + 1));
        let middle = (from + to) / 2.0;
        for at in 0..sums.len() {
            let x = |place: usize| LEFT + (place as f64 + 0.5) * CELL;
            canvas.line((x(at), from), (x(at), to), outlined(GREY, 1.0));
            if at >= reach {
                sums[at] += before[at - reach];
                canvas.line((x(at - reach), from), (x(at) - 3.0, to - 1.0), outlined(BLUE, 1.5));
            }
        }
        let barrier = outlined(INK, 2.0).dashed();
        canvas.line((LEFT, middle), (LEFT + 8.0 * CELL, middle), barrier);
        canvas.text((LEFT / 2.0, middle + 5.0), 14.0, INK, "barrier");
        row(&mut canvas, to, &format!("reach {reach}"), sums);
    }
    let under = (WIDTH / 2.0, y(3) + 62.0);
    canvas.text(under, 15.0, INK, "where bin k ends; without its own count, where it begins");
    Ok(canvas.svg())
}

fn row(canvas: &mut Canvas, top: f64, name: &str, numbers: [u32; 8]) {
    canvas.text((LEFT / 2.0, top + 23.0), 15.0, INK, name);
    for (at, number) in numbers.into_iter().enumerate() {
        let left = LEFT + at as f64 * CELL + 4.0;
        let is_final = number == COUNTS[..=at].iter().sum::<u32>();
        let fill = if is_final { PALE_ORANGE } else { PALE_BLUE };
        canvas.rectangle((left, top), CELL - 8.0, 36.0, outlined(GREY, 1.0).on(fill));
        canvas.text((left + CELL / 2.0 - 4.0, top + 24.0), 17.0, INK, &number.to_string());
    }
}
