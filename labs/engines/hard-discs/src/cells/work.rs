//! How much work a step makes.

use crate::geometry::Square;
use crate::pairs::LANES;
use crate::survey::Survey;

/// Height of a row, in heights of a mean box. Lower rows mean more entries, higher ones more
/// pairs to look at.
pub(super) const HEIGHT: f64 = 2.0;

/// Width of a column, in widths of a mean box.
pub(super) const WIDTH: f64 = 0.5;

/// Mean width and height of a box, if the step is cut into `windows` windows.
pub(super) fn mean_box(survey: &Survey, square: Square, windows: usize) -> (f64, f64) {
    let windows = windows as f64;
    let least = 2.0 * square.radius;
    (survey.speed.0 / windows + least, survey.speed.1 / windows + least)
}

/// Work that a step is expected to make, all its windows together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// Entries.
    pub entries: f64,
    /// Pairs to look at.
    pub pairs: f64,
    /// Of these, pairs that are asked when they touch.
    pub asked: f64,
}

/// The work of a step that is cut into `windows` windows.
///
/// Boxes shrink with the number of windows: a mean one is `speed / windows + 2 r` wide. A disc
/// is in 1 + height / row height rows. Two entries of a row meet if their boxes overlap along x. Of such pairs
/// a share of about 4 r / width pass each other within 2 r, at any time, and then all are asked that were looked
/// at together with them. All that for each window, and only of discs that are free when it begins
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

/// Windows, counted by the share of discs that are free when they begin, and by the share of pairs.
///
/// A disc collides once in a step. If it would meet m discs, the share f of the free ones falls by
/// f' = −m f², so f(t) = 1 / (1 + m t). In the first window all are free; over the later ones f
/// and f² are integrated.
fn still_free(meetings: f64, windows: usize) -> (f64, f64) {
    let windows = windows as f64;
    let later = 1.0 - 1.0 / windows;
    let free = if meetings > 0.0 { (meetings * later).ln_1p() / meetings } else { later };
    (1.0 + windows * free, 1.0 + windows * later / (1.0 + meetings * later))
}
