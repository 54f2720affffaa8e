//! The check of one step at a time.

use common::Variant;
use common::hard::{Disc, Scene, Simulation};

use super::one_step;
use crate::within;

/// Checks one variant of a lab of hard discs, and says in the domain's words what is wrong.
pub struct Grader {
    task: &'static str,
    variant: &'static Variant<dyn Simulation>,
    threads: usize,
}

impl Grader {
    /// Grades the variant called `name` on behalf of `task`.
    ///
    /// # Panics
    /// There is no such variant.
    pub fn new(
        task: &'static str,
        variants: &'static [Variant<dyn Simulation>],
        name: &str,
    ) -> Self {
        let variant = variants.iter().find(|v| v.name == name);
        let variant = variant.unwrap_or_else(|| panic!("task {task}: no variant '{name}'"));
        Self { task, variant, threads: 1 }
    }

    /// The same with `threads` threads.
    #[must_use]
    pub fn with_threads(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// Runs `steps` steps; before each, the model starts from where the variant is, and after it
    /// both must be at the same position, up to rounding.
    ///
    /// # Panics
    /// They are not. The message names the step, the disc and its collision.
    pub fn resynchronised(&self, name: &str, scene: &Scene, steps: usize) {
        let Self { task, variant, threads } = *self;
        let (name, scene) = (name.to_owned(), scene.clone());
        within(task, 120, move || {
            let config = variant.config().with_threads(threads);
            let mut simulation = (variant.build)(&config).expect("the variant can be built");
            simulation.load(&scene);
            let mut discs = scene.discs().to_vec();
            for t in 1..=steps {
                let before = discs.clone();
                simulation.step();
                simulation.read(0, &mut discs);
                if let Some(wrong) = one_step(&before, &discs, &scene) {
                    panic!(
                        "task {task}, variant {}, scene {name}, step {t}: {wrong}",
                        variant.name
                    );
                }
            }
        });
    }

    /// The discs after `steps` steps.
    pub fn run(&self, scene: &Scene, steps: usize) -> Vec<Disc> {
        let Self { task, variant, threads } = *self;
        let scene = scene.clone();
        within(task, 120, move || {
            let config = variant.config().with_threads(threads);
            let mut simulation = (variant.build)(&config).expect("the variant can be built");
            simulation.load(&scene);
            for _ in 0..steps {
                simulation.step();
            }
            let mut discs = scene.discs().to_vec();
            simulation.read(0, &mut discs);
            discs
        })
    }
}
