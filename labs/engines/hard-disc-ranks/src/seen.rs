//! The discs that a rank has in a step.

use common::hard::Disc;

use crate::strips::Reach;
use crate::wire::DiscWire;

/// The discs that this rank has in a step: its own discs and ghosts, in ascending order of numbers.
#[derive(Default)]
pub struct Seen {
    /// The numbers of the discs.
    pub numbers: Vec<u32>,
    /// The discs.
    pub discs: Vec<Disc>,
    /// Whether the disc is in the strip of this rank.
    pub owns: Vec<bool>,
    /// The ranks that have the disc.
    pub reach: Vec<Reach>,
}

impl Seen {
    /// Replaces all by the `own` discs merged with `ghosts`, which both are in the order of numbers.
    pub fn fill(
        &mut self,
        own: &[DiscWire],
        ghosts: &[DiscWire],
        reached: impl Fn(&DiscWire) -> Reach,
    ) {
        let Self { numbers, discs, owns, reach } = self;
        numbers.clear();
        discs.clear();
        owns.clear();
        reach.clear();
        let mut push = |disc: &DiscWire, is_own: bool| {
            numbers.push(disc.number as u32);
            discs.push(disc.into());
            owns.push(is_own);
            reach.push(reached(disc));
        };
        let mut ghosts = ghosts.iter().peekable();
        for disc in own {
            while let Some(ghost) = ghosts.next_if(|ghost| ghost.number < disc.number) {
                push(ghost, false);
            }
            push(disc, true);
        }
        ghosts.for_each(|ghost| push(ghost, false));
        debug_assert!(
            numbers.is_sorted_by(|a, b| a < b),
            "a disc is here as an own one and as a ghost: two ranks own it"
        );
    }
}
