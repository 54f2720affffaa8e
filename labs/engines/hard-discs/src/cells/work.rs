//! Estimates the work of a step.

use crate::geometry::Square;
use crate::pairs::LANES;
use crate::survey::Survey;

/// Height of a row, in heights of a mean box.
///
/// Lower rows mean more entries; higher rows mean more pairs to test.
pub(super) const HEIGHT: f64 = 2.0;

/// Width of a column, in widths of a mean box.
pub(super) const WIDTH: f64 = 0.5;

/// Returns the mean width and height of a box, if the step is divided into `windows` windows.
pub(super) fn mean_box(survey: &Survey, square: Square, windows: usize) -> (f64, f64) {
    let windows = windows as f64;
    let least = 2.0 * square.radius;
    (survey.speed.0 / windows + least, survey.speed.1 / windows + least)
}

/// The expected work of a step, summed over its windows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// Number of entries.
    pub entries: f64,
    /// Number of pairs whose boxes are compared.
    pub pairs: f64,
    /// Number of these pairs whose collision time is computed.
    pub asked: f64,
}

/// Returns the expected work of a step that is divided into `windows` windows.
///
/// Boxes shrink as the number of windows grows: a mean box is `speed / windows + 2 r` wide. A disc
/// is in 1 + height / row height rows. Two entries of a row meet if their boxes overlap along x. A
/// share of about 4 r / width of such pairs pass each other within 2 r at some time. For each of
/// them, the collision times of all pairs that are tested together with it are computed. All this
/// happens in each window, but only for discs that are free when the window begins
/// ([`still_free`]).
pub fn expected_work(survey: &Survey, square: Square, windows: usize) -> Work {
    let (width, height) = mean_box(survey, square, windows);
    let wide = (survey.x.1 - survey.x.0).max(width);
    let high = (survey.y.1 - survey.y.0).max(height);
    let (free, both_free) = still_free(survey.meetings, windows);

    let entries = survey.n as f64 * (1.0 + 1.0 / HEIGHT);
    let rows = (high / (HEIGHT * height)).max(1.0);
    let in_row = entries / rows;
    let pairs = rows * in_row * in_row * (width * (1.0 + WIDTH / 2.0) / wide).min(1.0);
    let asked = (LANES as f64 * 4.0 * square.radius / width).min(1.0);
    let pairs = both_free * pairs;
    Work { entries: free * entries, pairs, asked: asked * pairs }
}

/// Returns the shares of discs and of pairs that are free when a window begins, summed over windows.
///
/// A disc collides at most once in a step. If it would meet m discs, the share f of free discs
/// falls with the slope −m f², so f(t) = 1 / (1 + m t). In the first window all discs are free;
/// over the later windows f and f² are integrated.
fn still_free(meetings: f64, windows: usize) -> (f64, f64) {
    let windows = windows as f64;
    let later = 1.0 - 1.0 / windows;
    let free = if meetings > 0.0 { (meetings * later).ln_1p() / meetings } else { later };
    (1.0 + windows * free, 1.0 + windows * later / (1.0 + meetings * later))
}
