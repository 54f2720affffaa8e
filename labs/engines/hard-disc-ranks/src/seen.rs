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
    /// Whether each disc is in the strip of this rank.
    pub owns: Vec<bool>,
    /// The ranks that have each disc.
    pub reach: Vec<Reach>,
}

impl Seen {
    /// Replaces all discs by `own` and `ghosts`, merged. Both lists are in the order of numbers.
    pub fn fill(
        &mut self,
        own: &[DiscWire],
        ghosts: &[DiscWire],
        reached: impl Fn(&DiscWire) -> Reach,
    ) {
        self.numbers.clear();
        self.discs.clear();
        self.owns.clear();
        self.reach.clear();
        let mut ghosts = ghosts.iter().peekable();
        for disc in own {
            while let Some(ghost) = ghosts.next_if(|ghost| ghost.number < disc.number) {
                self.push(ghost, false, reached(ghost));
            }
            self.push(disc, true, reached(disc));
        }
        ghosts.for_each(|ghost| self.push(ghost, false, reached(ghost)));
        debug_assert!(
            self.numbers.is_sorted_by(|a, b| a < b),
            "a disc is here as an own one and as a ghost: two ranks own it"
        );
    }

    fn push(&mut self, disc: &DiscWire, is_own: bool, reach: Reach) {
        self.numbers.push(disc.number as u32);
        self.discs.push(disc.into());
        self.owns.push(is_own);
        self.reach.push(reach);
    }
}
