//! Collisions: which could happen in a step, which do, and what they do.

use std::cmp::Ordering;

use common::hard::Disc;

use crate::geometry::Square;

/// What a disc would collide with.
///
/// The order of the kinds, and within a kind of the numbers, is the order in which candidates of
/// the same time are taken: the derived order is just that one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Hit {
    /// Disc a with two walls at once.
    Corner(u32),
    /// Disc a with the left or the right wall.
    WallX(u32),
    /// Disc a with the lower or the upper wall.
    WallY(u32),
    /// Discs a < b with each other.
    Pair(u32, u32),
}

impl Hit {
    /// The disc, or the first of the two.
    #[inline]
    pub fn first(self) -> u32 {
        match self {
            Self::Corner(a) | Self::WallX(a) | Self::WallY(a) | Self::Pair(a, _) => a,
        }
    }

    /// The second disc of a pair.
    #[inline]
    pub fn second(self) -> Option<u32> {
        match self {
            Self::Pair(_, b) => Some(b),
            _ => None,
        }
    }
}

/// A collision that happens unless one of its discs collides earlier in the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// When, as a part λ of the step: 0 ≤ λ ≤ 1 for walls, 0 ≤ λ < 1 for pairs.
    pub time: f64,
    /// Which disc, and what it hits.
    pub hit: Hit,
}

/// The rules of a collision, as every engine asks for them.
///
/// A type that implements it has no values: it is a name for a set of functions, and the compiler
/// writes an engine for each.
pub trait Collisions: Sized + Send + Sync + 'static {
    /// The collision of disc number `a` with the walls in this step, if nothing stops it before.
    fn wall_hit(a: u32, disc: &Disc, square: Square) -> Option<Candidate>;

    /// The collision of discs number `a` < `b` of this radius in this step, if nothing stops them before.
    fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate>;

    /// Which of two candidates is taken first: a total order.
    fn order(a: &Candidate, b: &Candidate) -> Ordering;

    /// Appends to `taken`, in this order, the candidates that happen: those whose discs are all still `free`.
    /// They are not free any more afterwards. The candidates are left in any order.
    fn take_in_order(candidates: &mut [Candidate], free: &mut [bool], taken: &mut Vec<Candidate>);

    /// Moves a disc that hits walls at `time` from the start of the step to its end.
    fn bounce(disc: &mut Disc, time: f64, hit: Hit, square: Square);

    /// Moves two discs that touch at `time` from the start of the step to its end.
    fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square);
}

/// A disc that has collided at the end of the step, and the other one of a pair.
pub(crate) type Outcome = (Disc, Option<Disc>);

/// What a collision that was taken makes of its disc or its two, as they were at the start of the step.
pub(crate) fn outcome<C: Collisions>(
    candidate: &Candidate,
    discs: &[Disc],
    square: Square,
) -> Outcome {
    let mut first = discs[candidate.hit.first() as usize];
    let mut second = candidate.hit.second().map(|b| discs[b as usize]);
    match &mut second {
        Some(second) => C::collide(&mut first, second, candidate.time, square),
        None => C::bounce(&mut first, candidate.time, candidate.hit, square),
    }
    (first, second)
}

/// Writes the discs of a collision back.
pub(crate) fn write_back(hit: Hit, (first, second): Outcome, discs: &mut [Disc]) {
    discs[hit.first() as usize] = first;
    if let Some((b, second)) = hit.second().zip(second) {
        discs[b as usize] = second;
    }
}

/// Carries out the collisions that were taken, on discs as they were at the start of the step.
pub fn resolve<C: Collisions>(taken: &[Candidate], discs: &mut [Disc], square: Square) {
    for candidate in taken {
        write_back(candidate.hit, outcome::<C>(candidate, discs, square), discs);
    }
}
