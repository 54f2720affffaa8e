//! A survey of a scene: the averages and bounds that a plan needs.

use std::f64::consts::SQRT_2;

use common::hard::Disc;
use workers::Workers;

use crate::geometry::Square;
use crate::threads::pieces::map_pieces;

/// Averages and bounds of a scene's discs, from which a step can be planned.
///
/// Lengths are in the scene's unit, and velocities in lengths per step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Survey {
    /// Number of discs.
    pub n: usize,
    /// Means of |vx| and of |vy|.
    pub speed: (f64, f64),
    /// The greatest |vx| or |vy|.
    pub fastest: f64,
    /// The least and the greatest x of a centre inside the square, at the start or the end of the
    /// step.
    pub x: (f64, f64),
    /// The least and the greatest y of such a centre.
    pub y: (f64, f64),
    /// Number of discs that a disc would meet in the step if all discs were free to the end.
    ///
    /// A disc that has met another disc is no longer free, so the later windows of a step have
    /// fewer discs.
    pub meetings: f64,
}

impl Survey {
    /// Surveys the discs with one thread.
    pub fn of(discs: &[Disc], square: Square) -> Self {
        Self::by(&Workers::One, discs, square)
    }

    /// Surveys the discs with `workers`.
    ///
    /// The means are summed over pieces that are the same for any number of workers.
    pub fn by(workers: &Workers, discs: &[Disc], square: Square) -> Self {
        let pieces = map_pieces(workers, discs, |_, piece| Self::sums(piece, square));
        let mut all = pieces.into_iter().reduce(Self::and).unwrap_or_default();
        all.speed.0 /= discs.len() as f64;
        all.speed.1 /= discs.len() as f64;
        let reach = 2.0 * square.radius;
        let area = (all.x.1 - all.x.0).max(reach) * (all.y.1 - all.y.0).max(reach);
        // On average, two velocities with random directions differ by √2 times their magnitude.
        let relative = SQRT_2 * all.speed.0.hypot(all.speed.1);
        all.meetings = discs.len() as f64 / area * 2.0 * reach * relative;
        all
    }

    /// Returns a survey with the sums of |vx| and |vy| instead of their means.
    fn sums(discs: &[Disc], square: Square) -> Self {
        let nowhere = (f64::INFINITY, f64::NEG_INFINITY);
        let mut survey = Self { n: discs.len(), x: nowhere, y: nowhere, ..Self::default() };
        for disc in discs {
            survey.x = widened(survey.x, disc.x, (disc.x + disc.vx).clamp(0.0, square.side));
            survey.y = widened(survey.y, disc.y, (disc.y + disc.vy).clamp(0.0, square.side));
            survey.speed.0 += disc.vx.abs();
            survey.speed.1 += disc.vy.abs();
            survey.fastest = survey.fastest.max(disc.vx.abs()).max(disc.vy.abs());
        }
        survey
    }

    /// Combines the sums and bounds of two pieces.
    fn and(self, other: Self) -> Self {
        Self {
            n: self.n + other.n,
            speed: (self.speed.0 + other.speed.0, self.speed.1 + other.speed.1),
            fastest: self.fastest.max(other.fastest),
            x: widened(self.x, other.x.0, other.x.1),
            y: widened(self.y, other.y.0, other.y.1),
            meetings: 0.0,
        }
    }
}

/// Returns a range that is extended to `a` and `b`.
fn widened((low, high): (f64, f64), a: f64, b: f64) -> (f64, f64) {
    (low.min(a).min(b), high.max(a).max(b))
}
