//! The engine: what every variant keeps from step to step, and how it puts candidates in order.

use common::hard::{Disc, Scene};

use crate::{
    Candidate, Find, Found, Hit, Square, Workers, order, outcome, put_back, take_in_order, wall_hit,
};

/// So many collisions are carried out before their discs are put back: it bounds the memory for them.
const BATCH: usize = 1 << 16;

// ANCHOR: engine
/// An engine made of a way to find pairs and a way to choose among the candidates.
pub struct Engine<F> {
    pub(crate) square: Square,
    pub(crate) discs: Vec<Disc>,
    /// Whether disc i has not collided yet in this step.
    pub(crate) free: Vec<bool>,
    /// The wall collisions of this step that could happen, the earliest first.
    pub(crate) walls: Vec<Candidate>,
    pub(crate) taken: Vec<Candidate>,
    pub(crate) found: Found,
    pub(crate) finder: F,
    pub(crate) choice: Choice,
    pub(crate) workers: Workers,
    pub(crate) tally: Tally,
}
// ANCHOR_END: engine

/// What an engine counts.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pairs: u64,
    walls: u64,
    windows: u64,
}

impl<F: Find> Engine<F> {
    /// An engine that does its simple loops with `workers`.
    pub fn new(finder: F, choice: Choice, workers: Workers) -> Self {
        Self {
            square: Square { side: 1.0, radius: 0.5 },
            discs: Vec::new(),
            free: Vec::new(),
            walls: Vec::new(),
            taken: Vec::new(),
            found: Found::default(),
            finder,
            choice,
            workers,
            tally: Tally::default(),
        }
    }

    /// Starts over from `scene`.
    pub(crate) fn start(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.discs = scene.discs().to_vec();
        self.free = vec![true; scene.len()];
        self.found = Found::default();
        self.tally = Tally::default();
        self.taken.clear();
    }

    /// The collisions of the last step, in the order in which they were taken.
    pub fn taken(&self) -> &[Candidate] {
        &self.taken
    }

    /// Fills `self.walls`, sorted by time if there are several windows to spread them over.
    pub(crate) fn find_walls(&mut self, windows: usize) {
        let square = self.square;
        self.tally.windows += windows as u64;
        self.walls.clear();
        self.workers.collect(&self.discs, &mut self.walls, |number, disc| {
            wall_hit(number as u32, disc, square)
        });
        if windows > 1 {
            self.workers.sort(&mut self.walls, |a, b| a.time.total_cmp(&b.time));
        }
    }

    /// Moves all discs to the end of the step.
    pub(crate) fn move_discs(&mut self) {
        let free = &self.free;
        self.workers.for_each(&mut self.discs, |number, disc| {
            if free[number] {
                disc.x += disc.vx;
                disc.y += disc.vy;
            }
        });
        // No disc is in two collisions, so workers may do any of them at the same time.
        for taken in self.taken.chunks(BATCH) {
            let (discs, square) = (&self.discs, self.square);
            let outcomes = self.workers.map_pieces(taken, |_, piece| -> Vec<_> {
                piece.iter().map(|candidate| outcome(candidate, discs, square)).collect()
            });
            for (candidate, outcome) in taken.iter().zip(outcomes.into_iter().flatten()) {
                put_back(candidate.hit, outcome, &mut self.discs);
            }
        }
        let pairs = self.taken.iter().filter(|c| matches!(c.hit, Hit::Pair(..))).count() as u64;
        self.tally.pairs += pairs;
        self.tally.walls += self.taken.len() as u64 - pairs;
    }

    /// What was counted since the scene was loaded.
    pub(crate) fn counts(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("pair tests", self.found.pair_tests as f64),
            ("candidates", self.found.candidates as f64),
            ("pair collisions", self.tally.pairs as f64),
            ("wall collisions", self.tally.walls as f64),
            ("windows", self.tally.windows as f64),
        ]
    }
}

/// How the candidates of a window are put in order. All take the same ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Put all in one list and sort it, as the report does (with quicksort).
    Sort,
    /// The same, but all workers sort the list together. The sort in [`take_in_order`] finds nothing to do.
    SortTogether,
    /// Every worker sorts its own list. Then the library's merge sort finds sorted runs, and merges them (the
    /// report's future work).
    Merge,
}

impl Choice {
    /// Takes the candidates in `found` that happen. See [`take_in_order`].
    pub fn take(
        self,
        workers: &Workers,
        found: &mut Found,
        free: &mut [bool],
        taken: &mut Vec<Candidate>,
    ) {
        found.candidates += found.lists.iter().map(|list| list.len() as u64).sum::<u64>();
        if self == Self::Merge {
            workers.for_few(&mut found.lists, |_, list| list.sort_by(order));
        }
        let (first, rest) = found.lists.split_first_mut().expect("there is a list");
        rest.iter_mut().for_each(|list| first.append(list));
        match self {
            Self::Sort => {}
            Self::SortTogether => workers.sort(first, order),
            Self::Merge => first.sort_by(order),
        }
        take_in_order(first, free, taken);
    }
}
