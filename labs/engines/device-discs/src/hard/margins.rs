//! Margins that make sure that the device's filter loses no pair.

use std::ops::Range;

use bytemuck::bytes_of;
use common::hard::Disc;
use device::Real;
use solution7::Square;

/// The bounds of the device's filter, in units of the square's side.
///
/// In these units a coordinate is at most 1. Let M be the greatest velocity component, but at least
/// 1, and ε the greatest error of one rounding. By a generous estimate (chapter 9), the error of
/// the distance |d + t D| on the device is less than 64 ε M, and the error of d · D is less than 32
/// ε M. These bounds hold for any operations that the device contracts or reorders. The margins are
/// twice as large.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margins {
    /// Two discs can touch only if the device computes a distance below this bound.
    pub reach: f64,
    /// Two discs can approach each other only if the d · D that the device computes is at most this
    /// bound.
    pub receding: f64,
    /// A disc can hit a lower wall only if the device computes an end coordinate below this bound.
    pub least: f64,
    /// A disc can hit an upper wall only if the device computes an end coordinate above this bound.
    pub most: f64,
    /// Whether velocities are too large for these bounds, so that every pair is a candidate.
    pub everything: bool,
}

/// Greatest speed whose square is safely in the range of f32, in sides of the square per step.
const TOO_FAST: f64 = (1_u64 << 40) as f64;

impl Margins {
    /// Returns the bounds for these discs, on a device that computes with `R`.
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

    /// Returns the bounds as the kernels read them, for the rows `rows` of work with `n` discs.
    ///
    /// As u32: n, the first row, the end of the rows, and 1 if all pairs are candidates. Then as
    /// `R`: the square of `reach`, `receding`, `least` and `most`.
    pub fn bytes<R: Real>(&self, n: u32, rows: Range<u32>) -> Vec<u8> {
        let counts = [n, rows.start, rows.end, u32::from(self.everything)];
        // The square is enlarged slightly, because it will be rounded again.
        let reach_squared = self.reach * self.reach * (1.0 + 4.0 * R::ROUNDING);
        let bounds = [reach_squared, self.receding, self.least, self.most].map(R::of);
        [bytes_of(&counts), bytemuck::cast_slice(&bounds)].concat()
    }
}
