//! Questions about forces between all pairs, summed by several threads.

use common::soft::{CUTOFF, Observer, Particle, Simulation, Statistics};
use lab3::Vanilla;
use oracle::scenes::anywhere;
use oracle::{Ask, Model, Random, integers};
use solution1::Tally;

use super::bins::states;

/// Asks for steps of any number of particles on some threads, and then of a few particles.
pub(crate) fn steps(random: &mut Random, ask: &mut impl Ask) {
    for threads in [1, 2, 3, 7] {
        let mut engine = Vanilla::<Tally>::new(threads);
        let sizes = [random.sizes(1025), vec![3, 1]].concat();
        for n in sizes.into_iter().filter(|&n| n > 0) {
            let crowd = random.magnitude(0.3, 10.0);
            let size = CUTOFF * (n as f64 / crowd).sqrt().max(1.0);
            let scene = anywhere(random, n, size, 1.0);
            engine.load(&scene);
            // The step's own sums replace these.
            engine.sum_forces();
            engine.step();
            let name = format!(
                "a step of {n} particles in a box of {:.2} cutoffs on {threads} threads",
                size / CUTOFF
            );
            let found = || {
                let mut found = vec![Particle::default(); n];
                engine.read(0, &mut found);
                states(&found)
            };
            ask.exact(&format!("{name}: id x y vx vy of each particle"), found, || {
                let mut model = Model::new(&scene);
                model.step();
                states(&model.particles)
            });
            let reported = Simulation::statistics(&engine).map_or(0, |s| s.pair_tests) as usize;
            let question = format!("{name}: number of pair tests reported to the observers");
            ask.exact(&question, || integers([reported]), || integers([n * n]));
        }
    }
}

/// An observer that counts the merged observers that have seen 150 pairs.
#[derive(Clone, Default)]
struct OfOne {
    tested: u64,
    merged: u64,
}

impl Observer for OfOne {
    fn tested(&mut self, pairs: u64) {
        self.tested += pairs;
    }
    fn seen(&mut self, _r2: f64) {}
    fn merge(&mut self, other: &Self) {
        self.merged += u64::from(other.tested == 150);
    }
    fn statistics(&self) -> Option<Statistics> {
        Some(Statistics { navg: self.merged, ..Statistics::default() })
    }
}

/// Asks whether every particle has its own observer.
pub(crate) fn observers(random: &mut Random, ask: &mut impl Ask) {
    let scene = anywhere(random, 150, 10.3 * CUTOFF, 1.0);
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&scene);
    engine.sum_forces();
    let of_one = Simulation::statistics(&engine).map_or(0, |seen| seen.navg) as usize;
    let question = "two threads and 150 particles, with 150 pair tests for each particle: number of observers that \
                    received the pair tests of exactly one particle. If one observer serves several particles, its \
                    sums depend on the order of the threads";
    ask.exact(question, || integers([of_one]), || integers([150]));
}
