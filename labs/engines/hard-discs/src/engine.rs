//! The engine: the data that every variant keeps from step to step.

use std::marker::PhantomData;

use common::hard::{Disc, Scene, Simulation};

use crate::choice::Choice;
use crate::collisions::{Candidate, Collisions, Hit, outcome, write_back};
use crate::find::{Find, Found};
use crate::geometry::Square;
use crate::threads::pieces::{collect, for_each, map_pieces};
use workers::Workers;

/// The order of search, decision and move in a step.
pub trait Step: Collisions {
    /// Finds all collisions of a step, chooses among them, and moves the discs to the end of the
    /// step.
    fn step<F: Find>(engine: &mut Engine<Self, F>);
}

/// Number of collisions that are computed before their discs are written back. The limit bounds the
/// memory for the results.
const BATCH: usize = 1 << 16;

// ANCHOR: engine
/// An engine made of the rules of a collision, a way to find pairs and a way to order candidates.
pub struct Engine<C, F> {
    rules: PhantomData<C>,
    /// The square, and the radius of all discs.
    pub square: Square,
    /// The discs, in the order of their numbers. They move at the end of a step.
    pub discs: Vec<Disc>,
    /// Whether each disc has not collided yet in this step.
    pub free: Vec<bool>,
    /// The candidates with walls in this step, the earliest first if there are several windows.
    pub walls: Vec<Candidate>,
    /// The collisions of this step that really happen, in the order in which they were taken.
    pub taken: Vec<Candidate>,
    /// The result of the search in a window.
    pub found: Found,
    /// The search for pairs.
    pub finder: F,
    /// The way to put candidates in order.
    pub choice: Choice,
    /// The threads.
    pub workers: Workers,
    tally: Tally,
}
// ANCHOR_END: engine

/// The engine's counters.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    pairs: u64,
    walls: u64,
    windows: u64,
}

impl<C: Collisions, F: Find> Engine<C, F> {
    /// Makes an engine that runs its simple loops on `workers`.
    pub fn new(finder: F, choice: Choice, workers: Workers) -> Self {
        Self {
            rules: PhantomData,
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

    /// Finds the candidates with walls, and sorts them by time if there are several windows.
    pub fn find_walls(&mut self, windows: usize) {
        let square = self.square;
        self.tally.windows += windows as u64;
        self.walls.clear();
        collect(&self.workers, &self.discs, &mut self.walls, |number, disc| {
            C::wall_hit(number as u32, disc, square)
        });
        if windows > 1 {
            self.workers.sort(&mut self.walls, |a, b| a.time.total_cmp(&b.time));
        }
    }

    /// Moves all discs to the end of the step. Free discs go straight, and the others follow the
    /// collisions in `taken`.
    pub fn move_discs(&mut self) {
        let free = &self.free;
        for_each(&self.workers, &mut self.discs, |number, disc| {
            if free[number] {
                disc.x += disc.vx;
                disc.y += disc.vy;
            }
        });
        // Every disc is in at most one collision, so workers may compute any collisions at the same
        // time.
        for taken in self.taken.chunks(BATCH) {
            let discs = &self.discs;
            let square = self.square;
            let outcomes = map_pieces(&self.workers, taken, |_, piece| -> Vec<_> {
                piece.iter().map(|candidate| outcome::<C>(candidate, discs, square)).collect()
            });
            for (candidate, outcome) in taken.iter().zip(outcomes.into_iter().flatten()) {
                write_back(candidate.hit, outcome, &mut self.discs);
            }
        }
        let pairs = self.taken.iter().filter(|c| matches!(c.hit, Hit::Pair(..))).count() as u64;
        self.tally.pairs += pairs;
        self.tally.walls += self.taken.len() as u64 - pairs;
    }
}

impl<C: Step, F: Find> Simulation for Engine<C, F> {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.discs = scene.discs().to_vec();
        self.free = vec![true; scene.len()];
        self.found = Found::default();
        self.tally = Tally::default();
        self.taken.clear();
    }

    fn step(&mut self) {
        C::step(self);
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        out.copy_from_slice(&self.discs[first..first + out.len()]);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("pair tests", self.found.pair_tests as f64),
            ("candidates", self.found.candidates as f64),
            ("pair collisions", self.tally.pairs as f64),
            ("wall collisions", self.tally.walls as f64),
            ("windows", self.tally.windows as f64),
        ]
    }
}
