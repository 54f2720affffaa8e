//! A collision that could happen in this step.

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
