//! Discs and candidates as words and as numbers, and random numbers for scenes.

use common::Vec2;
use common::hard::Disc;
use hard_discs::{Candidate, Hit};
use oracle::{Near, Random};

/// Disc numbers at the limits of 8 bits, 16 bits and a signed integer.
const NUMBERS: [u32; 10] =
    [0, 1, 255, 256, 65_535, 65_536, 0x7fff_ffff, 0x8000_0000, 0xffff_fffd, 0xffff_fffe];

/// Draws the number of a disc, often at a limit of a bit range.
pub(crate) fn number(random: &mut Random) -> u32 {
    [NUMBERS[random.below(NUMBERS.len())], random.bits() as u32 >> 1][random.below(2)]
}

/// Draws a unit of length, small or large. A power of two makes products of integers exact, so that
/// equal times are exactly equal.
pub(crate) fn unit(random: &mut Random, is_power: bool) -> f64 {
    let unit = random.magnitude(1e-12, 1e12);
    if is_power { unit.log2().round().exp2() } else { unit }
}

/// Returns a power of ten near `number` in plain scenes, which are asked first; otherwise `number`
/// itself.
pub(crate) fn short(is_plain: bool, number: f64) -> f64 {
    let power = 10_f64.powf(number.abs().log10().round()).copysign(number);
    if is_plain { power } else { number }
}

/// Returns a vector rotated by quarter turns and mirrored. The three lowest bits of `how` select
/// the way.
pub(crate) fn turned(d: Vec2, how: usize) -> Vec2 {
    let d = if how & 1 == 0 { d } else { Vec2::new(d.y, d.x) };
    Vec2::new(if how & 2 == 0 { d.x } else { -d.x }, if how & 4 == 0 { d.y } else { -d.y })
}

/// Describes the position and velocity of a disc.
pub(crate) fn words(disc: &Disc) -> String {
    format!("({:?}, {:?}) with velocity ({:?}, {:?})", disc.x, disc.y, disc.vx, disc.vy)
}

/// Describes the event of a candidate and its time.
pub(crate) fn event(candidate: &Candidate) -> String {
    let what = match candidate.hit {
        Hit::Corner(a) => format!("disc {a} hits a corner"),
        Hit::WallX(a) => format!("disc {a} hits the left or right wall"),
        Hit::WallY(a) => format!("disc {a} hits the lower or upper wall"),
        Hit::Pair(a, b) => format!("discs {a} and {b} touch"),
    };
    format!("{what} at λ = {:?}", candidate.time)
}

/// Description of the numbers of a candidate in [`values`].
pub(crate) const EACH: &str = "λ, kind (0 a corner, 1 the left or right wall, 2 the lower or upper wall, 3 a pair), \
                               and both discs (-1 for none) of each candidate";

/// Returns candidates as numbers. Negative zero becomes zero.
pub(crate) fn values(candidates: &[Candidate]) -> Vec<f64> {
    let value = |c: &Candidate| {
        let [kind, first, second] = hit(c.hit);
        [c.time + 0.0, kind, first, second]
    };
    candidates.iter().flat_map(value).collect()
}

/// Returns the kind of obstacle and the discs, −1 for a missing disc.
pub(crate) fn hit(hit: Hit) -> [f64; 3] {
    let kind = match hit {
        Hit::Corner(_) => 0.0,
        Hit::WallX(_) => 1.0,
        Hit::WallY(_) => 2.0,
        Hit::Pair(..) => 3.0,
    };
    [kind, f64::from(hit.first()), hit.second().map_or(-1.0, f64::from)]
}

/// Marks numbers that must be exact.
pub(crate) fn exact(numbers: impl IntoIterator<Item = f64>) -> impl Iterator<Item = Near> {
    numbers.into_iter().map(|right| Near { right, scale: 0.0 })
}
