//! The margins with which the device loses no pair.

use std::ops::Range;

use bytemuck::bytes_of;
use common::hard::Disc;
use device::Real;
use solution7::Square;

/// The bounds of the device's filter, in units of the square's side.
///
/// A coordinate is at most 1 in these units; let M be the greatest velocity component, or 1 if
/// that is more, and ε the greatest error of one rounding. Counted generously (chapter 9 does the
/// sum), the distance |d + t D| that the device finds is off by less than 64 ε M, whatever the
/// device contracts or in what order it adds, and d · D by less than 32 ε M. The margins are twice
/// that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margins {
    /// Two discs touch only if the device finds them nearer than this.
    pub reach: f64,
    /// Two discs approach only if the device finds d · D to be at most this.
    pub receding: f64,
    /// A disc hits a wall only if the device finds its end to be less than this …
    pub least: f64,
    /// … or more than this.
    pub most: f64,
    /// Velocities are so large that the bounds above mean nothing.
    pub everything: bool,
}

/// In sides of the square a step: the squares of greater speeds leave the range of f32.
const TOO_FAST: f64 = (1_u64 << 40) as f64;

impl Margins {
    /// The bounds for these discs, on a device that computes with `R`.
    pub fn of<R: Real>(discs: &[Disc], square: Square) -> Self {
        let components = discs.iter().map(|disc| disc.vx.abs().max(disc.vy.abs()));
        let fastest = components.fold(square.side, f64::max) / square.side;
        let margin = 128.0 * R::ROUNDING * fastest;
        let radius = square.radius / square.side;
        Self {
            reach: 2.0 * radius + margin,
            receding: margin / 2.0,
            least: radius + margin,
            most: 1.0 - radius - margin,
            everything: fastest >= TOO_FAST,
        }
    }

    /// As the kernels see it, for the rows `rows` of work with `n` discs: n, the first row, the one after the
    /// last, and 1 if everything may collide, as u32; then the square of `reach`, `receding`, `least` and `most`,
    /// as `R`.
    pub fn bytes<R: Real>(&self, n: u32, rows: Range<u32>) -> Vec<u8> {
        let counts = [n, rows.start, rows.end, u32::from(self.everything)];
        // A little more, since the square is rounded once more.
        let reach_squared = self.reach * self.reach * (1.0 + 4.0 * R::ROUNDING);
        let bounds = [reach_squared, self.receding, self.least, self.most].map(R::of);
        [bytes_of(&counts), bytemuck::cast_slice(&bounds)].concat()
    }
}
