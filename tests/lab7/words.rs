//! Discs and candidates as words and as numbers, and numbers to draw scenes from.

use common::Vec2;
use common::hard::Disc;
use hard_discs::{Candidate, Hit};
use oracle::{Near, Random};

/// Numbers of discs where eight bits, sixteen bits and a sign end.
const NUMBERS: [u32; 10] =
    [0, 1, 255, 256, 65_535, 65_536, 0x7fff_ffff, 0x8000_0000, 0xffff_fffd, 0xffff_fffe];

/// The number of a disc, often one at which bits end.
pub(crate) fn number(random: &mut Random) -> u32 {
    [NUMBERS[random.below(NUMBERS.len())], random.bits() as u32 >> 1][random.below(2)]
}

/// A unit of length, from small to large. A power of two makes products of whole numbers without
/// rounding: there a tie is a tie.
pub(crate) fn unit(random: &mut Random, is_power: bool) -> f64 {
    let unit = random.magnitude(1e-12, 1e12);
    if is_power { unit.log2().round().exp2() } else { unit }
}

/// A power of ten near `number` in plain scenes, which are asked first, and else the number itself.
pub(crate) fn short(is_plain: bool, number: f64) -> f64 {
    let power = 10_f64.powf(number.abs().log10().round()).copysign(number);
    if is_plain { power } else { number }
}

/// A vector turned by quarters and mirrored: the three lowest bits of `how` say in which way.
pub(crate) fn turned(d: Vec2, how: usize) -> Vec2 {
    let d = if how & 1 == 0 { d } else { Vec2::new(d.y, d.x) };
    Vec2::new(if how & 2 == 0 { d.x } else { -d.x }, if how & 4 == 0 { d.y } else { -d.y })
}

/// Where a disc is, and how fast.
pub(crate) fn words(disc: &Disc) -> String {
    format!("({:?}, {:?}) with velocity ({:?}, {:?})", disc.x, disc.y, disc.vx, disc.vy)
}

/// What happens, and when.
pub(crate) fn event(candidate: &Candidate) -> String {
    let what = match candidate.hit {
        Hit::Corner(a) => format!("disc {a} hits a corner"),
        Hit::WallX(a) => format!("disc {a} hits the left or right wall"),
        Hit::WallY(a) => format!("disc {a} hits the lower or upper wall"),
        Hit::Pair(a, b) => format!("discs {a} and {b} touch"),
    };
    format!("{what} at λ = {:?}", candidate.time)
}

/// How [`values`] describes candidates.
pub(crate) const EACH: &str = "λ, what (0 a corner, 1 the left or right wall, 2 the lower or upper one, 3 a pair), \
                               and the discs (-1 for none) of each";

/// Candidates as numbers. Either zero will do.
pub(crate) fn values(candidates: &[Candidate]) -> Vec<f64> {
    let value = |c: &Candidate| {
        let [kind, first, second] = hit(c.hit);
        [c.time + 0.0, kind, first, second]
    };
    candidates.iter().flat_map(value).collect()
}

/// What is hit, and the discs, −1 for none.
pub(crate) fn hit(hit: Hit) -> [f64; 3] {
    let kind = match hit {
        Hit::Corner(_) => 0.0,
        Hit::WallX(_) => 1.0,
        Hit::WallY(_) => 2.0,
        Hit::Pair(..) => 3.0,
    };
    [kind, f64::from(hit.first()), hit.second().map_or(-1.0, f64::from)]
}

/// Numbers that must be exactly right.
pub(crate) fn exact(numbers: impl IntoIterator<Item = f64>) -> impl Iterator<Item = Near> {
    numbers.into_iter().map(|right| Near { right, scale: 0.0 })
}
