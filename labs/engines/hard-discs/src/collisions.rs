//! Collisions: candidates in a step, the choice among them, and their effect.

use std::cmp::Ordering;

use common::hard::Disc;

use crate::geometry::Square;

/// The walls or the discs of a collision.
///
/// Candidates at the same time are taken in the derived order: by kind, then by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Hit {
    /// Disc a hits two walls at once.
    Corner(u32),
    /// Disc a hits the left or the right wall.
    WallX(u32),
    /// Disc a hits the lower or the upper wall.
    WallY(u32),
    /// Discs a < b hit each other.
    Pair(u32, u32),
}

impl Hit {
    /// Returns the number of the disc, or of the first of two discs.
    #[inline]
    pub fn first(self) -> u32 {
        match self {
            Self::Corner(a) | Self::WallX(a) | Self::WallY(a) | Self::Pair(a, _) => a,
        }
    }

    /// Returns the number of the second disc of a pair, or `None` for a wall.
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
    /// The time of the collision as a part λ of the step: 0 ≤ λ ≤ 1 for walls, 0 ≤ λ < 1 for pairs.
    pub time: f64,
    /// The disc, and the walls or the disc that it hits.
    pub hit: Hit,
}

/// The rules of a collision, which every engine uses.
///
/// A type that implements the trait has no values. It is the name of a set of functions, and the
/// compiler makes an engine for each such type.
pub trait Collisions: Sized + Send + Sync + 'static {
    /// Returns the collision of disc number `a` with the walls in this step, if no earlier
    /// collision stops it.
    fn wall_hit(a: u32, disc: &Disc, square: Square) -> Option<Candidate>;

    /// Returns the collision of discs `a` < `b` of this radius in this step, if no earlier
    /// collision stops them.
    fn pair_hit(discs: &[Disc], a: u32, b: u32, radius: f64) -> Option<Candidate>;

    /// Compares two candidates in the order in which they are taken. The order is total.
    fn order(a: &Candidate, b: &Candidate) -> Ordering;

    /// Appends to `taken` the candidates that really happen, and marks their discs as not free.
    ///
    /// The candidates are taken in the order of [`order`](Self::order). A candidate really happens
    /// if all its discs are still `free`. The list `candidates` is left in any order.
    fn take_in_order(candidates: &mut [Candidate], free: &mut [bool], taken: &mut Vec<Candidate>);

    /// Moves a disc through the whole step. The disc hits the walls of `hit` at `time`.
    fn bounce(disc: &mut Disc, time: f64, hit: Hit, square: Square);

    /// Moves two discs through the whole step. The discs touch at `time`.
    fn collide(a: &mut Disc, b: &mut Disc, time: f64, square: Square);
}

/// The disc of a collision at the end of the step, and the other disc of a pair.
pub(crate) type Outcome = (Disc, Option<Disc>);

/// Returns the discs of a collision at the end of the step; `discs` are at its start.
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

/// Writes the discs of a collision back to `discs`.
pub(crate) fn write_back(hit: Hit, (first, second): Outcome, discs: &mut [Disc]) {
    discs[hit.first() as usize] = first;
    if let Some((b, second)) = hit.second().zip(second) {
        discs[b as usize] = second;
    }
}

/// Carries out the collisions in `taken`, on discs at the start of the step.
pub fn resolve<C: Collisions>(taken: &[Candidate], discs: &mut [Disc], square: Square) {
    for candidate in taken {
        write_back(candidate.hit, outcome::<C>(candidate, discs, square), discs);
    }
}
