//! Task 7.7: one step, the same for every variant.

use common::hard::{Disc, Scene, Simulation};

use crate::{Candidate, Choice, Find, Found, Hit, Square, Window, Workers, resolve, wall_hit};

/// An engine made of a way to find pairs and a way to choose among the candidates.
pub struct Engine<F> {
    square: Square,
    discs: Vec<Disc>,
    /// Whether disc i has not collided yet in this step.
    free: Vec<bool>,
    /// The wall collisions of this step that could happen, the earliest first.
    walls: Vec<Candidate>,
    taken: Vec<Candidate>,
    found: Found,
    finder: F,
    choice: Choice,
    workers: Workers,
    tally: Tally,
}

/// What an engine counts.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    candidates: u64,
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

    /// The collisions of the last step, in the order in which they were taken.
    pub fn taken(&self) -> &[Candidate] {
        &self.taken
    }

    /// Finds what happens in one window and marks it as taken.
    ///
    /// Three things, in this order: let the finder find the pairs of the window; add the wall
    /// collisions whose time lies in the window to the first list; let [`Choice::take`] choose.
    /// Walls are looked up in `self.walls`, which is sorted by time: those before `next_wall` have
    /// been dealt with. Returns where the next window goes on.
    ///
    /// Book: chapter 7, *A step*.
    fn collide_in(&mut self, window: Window, next_wall: usize) -> usize {
        todo!("task 7.7b: what happens in a window")
    }

    /// One step.
    ///
    /// 1. Ask the finder into how many windows it wants the step cut.
    /// 2. Every disc is free; nothing is taken.
    /// 3. Look for wall collisions ([`Self::find_walls`]).
    /// 4. Window by window, in order of time: [`Self::collide_in`].
    /// 5. Move the discs that are still free, by a whole step, and carry out what was taken
    ///    ([`Self::move_discs`]).
    ///
    /// All candidates are about the discs at the start of the step, so nobody moves before step 5.
    ///
    /// Book: chapter 7, *A step*.
    fn step_once(&mut self) {
        todo!("task 7.7: one step")
    }

    /// Fills `self.walls`, sorted by time if there are several windows to spread them over.
    fn find_walls(&mut self, windows: usize) {
        let square = self.square;
        self.walls.clear();
        self.workers.collect(&self.discs, &mut self.walls, |number, disc| {
            wall_hit(number as u32, disc, square)
        });
        if windows > 1 {
            self.walls.sort_unstable_by(|a, b| a.time.total_cmp(&b.time));
        }
    }

    /// Moves everybody to the end of the step.
    fn move_discs(&mut self) {
        let free = &self.free;
        self.workers.for_each(&mut self.discs, |number, disc| {
            if free[number] {
                disc.x += disc.vx;
                disc.y += disc.vy;
            }
        });
        resolve(&self.taken, &mut self.discs, self.square);
        let pairs = self.taken.iter().filter(|c| matches!(c.hit, Hit::Pair(..))).count() as u64;
        self.tally.pairs += pairs;
        self.tally.walls += self.taken.len() as u64 - pairs;
    }
}

impl<F: Find> Simulation for Engine<F> {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.discs = scene.discs().to_vec();
        self.free = vec![true; scene.len()];
        self.found = Found::default();
        self.tally = Tally::default();
        self.taken.clear();
    }

    fn step(&mut self) {
        self.step_once();
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        out.copy_from_slice(&self.discs[first..first + out.len()]);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("pair tests", self.found.pair_tests as f64),
            ("candidates", self.tally.candidates as f64),
            ("pair collisions", self.tally.pairs as f64),
            ("wall collisions", self.tally.walls as f64),
            ("windows", self.tally.windows as f64),
        ]
    }
}
