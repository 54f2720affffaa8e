//! Scenes of soft discs, runs of a lab's programs on them, and an observer that counts.

use common::Variant;
use common::soft::{CUTOFF, MIN_R, Particle, Scene, Simulation};

pub use self::count::Count;
pub use self::scenes::{anywhere as crowd, on_edges, spread};
use super::ask::memory;
use crate::{Answers, Random};

#[path = "../oracle/src/count.rs"]
mod count;
#[path = "../oracle/src/scenes.rs"]
mod scenes;

/// A lab's program, loaded again and again.
pub struct Engine(Box<dyn Simulation>);

impl Engine {
    /// The variant `name` on `threads` threads, with parameters turned.
    pub fn new(
        variants: &[Variant<dyn Simulation>],
        name: &str,
        threads: usize,
        parameters: &[(&str, f64)],
    ) -> Self {
        Self::built(variants, name, threads, parameters, false)
    }

    /// The same, collecting statistics.
    pub fn counting(
        variants: &[Variant<dyn Simulation>],
        name: &str,
        threads: usize,
        parameters: &[(&str, f64)],
    ) -> Self {
        Self::built(variants, name, threads, parameters, true)
    }

    fn built(
        variants: &[Variant<dyn Simulation>],
        name: &str,
        threads: usize,
        parameters: &[(&str, f64)],
        statistics: bool,
    ) -> Self {
        let variant = variants.iter().find(|v| v.name == name);
        let variant = variant.unwrap_or_else(|| panic!("the lab has no variant {name}"));
        let mut config = variant.config();
        (config.threads, config.statistics) = (threads, statistics);
        for (parameter, value) in parameters {
            variant.set(&mut config, parameter, *value).unwrap_or_else(|e| panic!("{e}"));
        }
        Self((variant.build)(&config).unwrap_or_else(|e| panic!("{name}: {e}")))
    }

    /// The states before the first and after each of `steps` steps, as the parent reads them.
    pub fn run(&mut self, scene: &Scene, steps: usize) -> Vec<f64> {
        self.0.load(scene);
        let mut values = vec![scene.size(), scene.len() as f64];
        values.extend(state(scene.particles()));
        for _ in 0..steps {
            self.0.step();
            values.extend(state(&self.read(scene.len())));
        }
        values
    }

    /// dmin, davg, navg and the pairs looked at, after each step.
    pub fn statistics(&mut self, scene: &Scene, steps: usize) -> Vec<[f64; 4]> {
        self.0.load(scene);
        let after = |_| {
            self.0.step();
            let seen = self.0.statistics().expect("statistics were asked for");
            [seen.dmin, seen.davg, seen.navg as f64, seen.pair_tests as f64]
        };
        (0..steps).map(after).collect()
    }

    /// Does what a long run of a dense scene holds grow?
    pub fn memory(&mut self, answers: &mut Answers) {
        let scene = scenes::dense();
        self.0.load(&scene);
        let size = (500, size_of_val(scene.particles()));
        memory("a dense scene", size, |steps| self.0.run(steps), &mut answers.told());
    }

    fn read(&self, n: usize) -> Vec<Particle> {
        let nan = f64::NAN;
        let unwritten = Particle { x: nan, y: nan, vx: nan, vy: nan, id: u32::MAX };
        let mut particles = vec![unwritten; n];
        self.0.read(0, &mut particles);
        particles
    }
}

/// x y vx vy of all; NaN where another particle stands at an index.
fn state(particles: &[Particle]) -> impl Iterator<Item = f64> {
    particles.iter().enumerate().flat_map(|(id, p)| {
        let own = p.id as usize == id;
        [p.x, p.y, p.vx, p.vy].map(|v| if own { v } else { f64::NAN })
    })
}

/// 60 pairs at 0.9995 cutoffs in every direction, alone, each over an edge of bins of one cutoff.
pub fn pairs_over_edges(random: &mut Random) -> Scene {
    let size = 40.55 * CUTOFF;
    let mut particles = Vec::new();
    for index in 0..81 {
        let middle = |at: usize| (4 * at + 3) as f64 * CUTOFF;
        let (x, y) = (middle(index % 9), middle(index / 9));
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let (dx, dy) = (0.499_75 * CUTOFF * cos, 0.499_75 * CUTOFF * sin);
        let at = |x, y| Particle { x, y, ..Particle::default() };
        particles.extend([at(x - dx, y - dy), at(x + dx, y + dy)]);
    }
    scene(size, particles)
}

/// Some 60 particles in a small box, two of them at one position and two nearly so.
pub fn heap(random: &mut Random) -> Scene {
    let (size, n) = (2.55 * CUTOFF, 40 + random.below(40));
    let mut particles = crowd(random, n, size, 1.0).particles().to_vec();
    (particles[1].x, particles[1].y) = (particles[0].x, particles[0].y);
    (particles[3].x, particles[3].y) = (particles[2].x, (particles[2].y + 0.4 * MIN_R).min(size));
    scene(size, particles)
}

fn scene(size: f64, particles: Vec<Particle>) -> Scene {
    Scene::new(size, particles).expect("all are in the box")
}
