//! What a worker does in time, as a lane. Not to scale.

use super::canvas::{Canvas, GREY, INK, outlined};
use super::rows::RANKS;

pub(super) const WIDTH: f64 = 520.0;
/// Height of a lane.
pub(super) const BAR: f64 = 34.0;
const LEFT: f64 = 76.0;

/// What a worker does from one moment to another, in tenths of the lane.
pub(super) type Span = (f64, f64, &'static str);

/// Where a moment is, in pixels.
pub(super) fn x(tenths: f64) -> f64 {
    LEFT + tenths * (WIDTH - LEFT - 10.0) / 10.0
}

pub(super) fn heading(canvas: &mut Canvas, y: f64, text: &str) {
    canvas.text((WIDTH / 2.0, y), 17.0, INK, text);
}

/// The lane of a worker, such as thread 1, from `top` on. It only waits where its colour is missing.
pub(super) fn lane(canvas: &mut Canvas, (worker, number): (&str, usize), top: f64, spans: &[Span]) {
    let (colour, tint) = RANKS[number];
    canvas.text((LEFT / 2.0 - 1.0, top + 22.0), 15.0, INK, &format!("{worker} {number}"));
    for &(from, to, text) in spans {
        let idle = text.contains("wait") || ["ghosts", "lengths", "movers"].contains(&text);
        let style =
            if idle { outlined(GREY, 1.5).dashed() } else { outlined(colour, 1.5).on(tint) };
        canvas.rectangle((x(from), top), x(to) - x(from), BAR, style);
        canvas.text((x((from + to) / 2.0), top + 22.0), 14.0, INK, text);
    }
}
