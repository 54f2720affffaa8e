//! The engine: the device filters all pairs, and the host computes the remaining pairs.

use std::time::{Duration, Instant};

use common::hard::{Disc, Scene, Simulation};
use device::{Real, Stopwatch};
use solution7::{Candidate, Square, resolve};

use super::choose::Choice;
use super::finder::Finder;
use super::kernels::HardKernels;
use super::margins::Margins;

/// Hard discs, filtered on the device with the kernels `K` in precision `R`.
///
/// The host computes every result in f64 with the functions of lab 7. So the output equals that of
/// lab 7's sequential program byte for byte.
pub struct HardDiscs<K, R> {
    finder: Finder<K, R>,
    choice: Choice<K>,
    square: Square,
    discs: Vec<Disc>,
    free: Vec<bool>,
    found: Vec<[u32; 2]>,
    candidates: Vec<Candidate>,
    taken: Vec<Candidate>,
    tally: Tally,
}

/// The engine's counters.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    steps: u64,
    found: u64,
    candidates: u64,
    taken: u64,
    /// Time for finding candidates, including the copies to the device and back.
    finding: Duration,
    /// Time for computing the times of collisions.
    checking: Duration,
    choosing: Duration,
    moving: Duration,
}

impl<K: HardKernels, R: Real> HardDiscs<K, R> {
    /// Makes an engine from a way to find candidates and a way to choose among them.
    pub fn new(finder: Finder<K, R>, choice: Choice<K>) -> Self {
        Self {
            finder,
            choice,
            square: Square { side: 1.0, radius: 0.5 },
            discs: Vec::new(),
            free: Vec::new(),
            found: Vec::new(),
            candidates: Vec::new(),
            taken: Vec::new(),
            tally: Tally::default(),
        }
    }

    /// Returns the candidate collisions of the last step, in no particular order.
    pub fn candidates(&self) -> &[Candidate] {
        &self.candidates
    }

    /// Returns the collisions of the last step, in no particular order.
    pub fn taken(&self) -> &[Candidate] {
        &self.taken
    }

    fn move_discs(&mut self) {
        for (disc, _) in self.discs.iter_mut().zip(&self.free).filter(|(_, free)| **free) {
            disc.x += disc.vx;
            disc.y += disc.vy;
        }
        resolve(&self.taken, &mut self.discs, self.square);
    }

    fn stopwatches(&self) -> impl Iterator<Item = &Stopwatch> {
        let chooser = match &self.choice {
            Choice::Host => None,
            Choice::Device(chooser) => chooser.stopwatch(),
        };
        self.finder.stopwatch().into_iter().chain(chooser)
    }
}

impl<K: HardKernels, R: Real> Simulation for HardDiscs<K, R> {
    fn load(&mut self, scene: &Scene) {
        self.square = Square::of(scene);
        self.discs = scene.discs().to_vec();
        self.free = vec![true; scene.len()];
        self.tally = Tally::default();
        self.taken.clear();
        self.stopwatches().for_each(Stopwatch::reset);
    }

    /// # Panics
    /// The device has too little memory for these discs or candidates, or its rounds of choosing
    /// collisions do not end.
    fn step(&mut self) {
        let start = Instant::now();
        let margins = Margins::of::<R>(&self.discs, self.square);
        self.finder
            .find(&self.discs, margins, self.square, &mut self.found)
            .unwrap_or_else(|error| panic!("{error}"));
        let found = Instant::now();
        K::confirm(&self.discs, self.square, &self.found, &mut self.candidates);
        let checked = Instant::now();
        self.free.fill(true);
        self.taken.clear();
        self.choice
            .take(&mut self.candidates, &mut self.free, &mut self.taken)
            .unwrap_or_else(|error| panic!("{error}"));
        let chosen = Instant::now();
        self.move_discs();
        self.tally.moving += chosen.elapsed();
        self.tally.choosing += chosen - checked;
        self.tally.checking += checked - found;
        self.tally.finding += found - start;
        self.tally.steps += 1;
        self.tally.found += self.found.len() as u64;
        self.tally.candidates += self.candidates.len() as u64;
        self.tally.taken += self.taken.len() as u64;
    }

    fn read(&self, first: usize, out: &mut [Disc]) {
        out.copy_from_slice(&self.discs[first..first + out.len()]);
    }

    fn counters(&self) -> Vec<(&'static str, f64)> {
        let n = self.discs.len() as f64;
        let tally = self.tally;
        let mut counters = vec![
            ("pair tests", tally.steps as f64 * n * (n - 1.0) / 2.0),
            ("passed on by the device", tally.found as f64),
            ("candidates", tally.candidates as f64),
            ("collisions", tally.taken as f64),
            ("finding on the device [s]", tally.finding.as_secs_f64()),
            ("checking on the host [s]", tally.checking.as_secs_f64()),
            ("choosing [s]", tally.choosing.as_secs_f64()),
            ("moving on the host [s]", tally.moving.as_secs_f64()),
        ];
        let kernels: Vec<_> = self.stopwatches().flat_map(Stopwatch::seconds).collect();
        if !kernels.is_empty() {
            let kernel: f64 = kernels.iter().map(|(_, seconds)| seconds).sum();
            let mut waiting = tally.finding.as_secs_f64();
            if matches!(self.choice, Choice::Device(_)) {
                waiting += tally.choosing.as_secs_f64();
            }
            counters.push(("kernel time [s]", kernel));
            counters.push(("transfer time [s]", (waiting - kernel).max(0.0)));
            counters.extend(kernels);
        }
        counters
    }
}
