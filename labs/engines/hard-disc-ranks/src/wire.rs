//! Discs and candidates in messages.

use common::hard::Disc;
use hard_discs::{Candidate, Hit};
use mpi::traits::Equivalence;

/// A disc with its number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Equivalence)]
#[repr(C)]
pub struct DiscWire {
    /// Centre along x.
    pub x: f64,
    /// Centre along y.
    pub y: f64,
    /// Velocity along x: the displacement in one step.
    pub vx: f64,
    /// Velocity along y.
    pub vy: f64,
    /// Collisions with other discs since the start.
    pub pair_collisions: u32,
    /// Collisions with walls since the start.
    pub wall_collisions: u32,
    /// The disc's number in the scene.
    pub number: u64,
}

impl DiscWire {
    /// Converts disc number `number`.
    pub fn new(number: usize, disc: &Disc) -> Self {
        let Disc { x, y, vx, vy, pair_collisions, wall_collisions } = *disc;
        Self { x, y, vx, vy, pair_collisions, wall_collisions, number: number as u64 }
    }

    /// Returns the disc's number in the scene, as an index into the list of all discs.
    pub fn index(&self) -> usize {
        self.number as usize
    }
}

impl From<&DiscWire> for Disc {
    fn from(wire: &DiscWire) -> Self {
        let DiscWire { x, y, vx, vy, pair_collisions, wall_collisions, .. } = *wire;
        Self { x, y, vx, vy, pair_collisions, wall_collisions }
    }
}

/// A candidate, and whether it has been taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Equivalence)]
#[repr(C)]
pub struct CandidateWire {
    /// The time of the collision as a part λ of the step.
    pub time: f64,
    /// The kind of the collision: 0 a corner, 1 an x wall, 2 a y wall, 3 a pair.
    kind: u32,
    /// The first disc.
    first: u32,
    /// The second disc of a pair.
    second: u32,
    /// 1 if the candidate has been taken, otherwise 0.
    taken: u32,
}

impl CandidateWire {
    /// Converts a candidate that has been taken.
    pub fn taken(candidate: &Candidate) -> Self {
        Self { taken: 1, ..candidate.into() }
    }

    /// Whether the candidate has been taken.
    pub fn is_taken(&self) -> bool {
        self.taken != 0
    }
}

impl From<&Candidate> for CandidateWire {
    fn from(candidate: &Candidate) -> Self {
        let (kind, first, second) = match candidate.hit {
            Hit::Corner(a) => (0, a, 0),
            Hit::WallX(a) => (1, a, 0),
            Hit::WallY(a) => (2, a, 0),
            Hit::Pair(a, b) => (3, a, b),
        };
        Self { time: candidate.time, kind, first, second, taken: 0 }
    }
}

impl From<&CandidateWire> for Candidate {
    fn from(wire: &CandidateWire) -> Self {
        let hit = match wire.kind {
            0 => Hit::Corner(wire.first),
            1 => Hit::WallX(wire.first),
            2 => Hit::WallY(wire.first),
            _ => Hit::Pair(wire.first, wire.second),
        };
        Self { time: wire.time, hit }
    }
}

#[cfg(test)]
mod tests {
    use hard_discs::{Candidate, Hit};

    use super::CandidateWire;

    #[test]
    fn a_candidate_survives_its_message() {
        for hit in [Hit::Corner(3), Hit::WallX(0), Hit::WallY(7), Hit::Pair(4, 2_147_483_646)] {
            let candidate = Candidate { time: 0.1 + 0.2, hit };
            let wire = CandidateWire::from(&candidate);
            assert_eq!(Candidate::from(&wire), candidate, "a candidate after its way in a message");
            assert!(!wire.is_taken(), "{hit:?} is only a candidate, and arrives as taken");
            assert!(CandidateWire::taken(&candidate).is_taken(), "{hit:?} is taken");
        }
    }
}
