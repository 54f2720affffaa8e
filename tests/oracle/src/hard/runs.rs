//! Questions about whole runs of one variant with hard discs: the lab's engine takes the steps, and
//! the model judges them.

use common::hard::{RandomScene, Scene, Simulation};
use common::{Config, Variant};

use super::states::{follow, of_each_step, of_end, split};
use super::{difference, scenes};
use crate::{Ask, memory, within};

/// Time limit of a run, in seconds. The message of a failure names the task.
const SECONDS: u64 = 120;

/// Description of the numbers in a state.
const STATE: &str =
    "x y vx vy and the numbers of collisions with discs and with walls for each disc";

/// Questions about runs of one variant of a lab, for one task. Verdicts use the terms of the field.
#[derive(Clone)]
pub struct Runs {
    task: &'static str,
    variant: &'static Variant<dyn Simulation>,
    config: Config,
}

impl Runs {
    /// Returns runs of `variant`, one of `variants`, for task `task`, such as `"7.7"`.
    ///
    /// # Panics
    /// If the variant does not exist.
    pub fn new(
        task: &'static str,
        variants: &'static [Variant<dyn Simulation>],
        variant: &str,
    ) -> Self {
        let Some(variant) = variants.iter().find(|v| v.name == variant) else {
            panic!("task {task}: the lab has no variant '{variant}'");
        };
        Self { task, variant, config: variant.config() }
    }

    /// Returns the same runs with `threads` threads.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.config.threads = threads;
        self
    }

    /// Returns the same runs with a parameter of the variant changed.
    ///
    /// # Panics
    /// If the variant does not have this parameter.
    #[must_use]
    pub fn set(mut self, parameter: &str, value: f64) -> Self {
        self.variant.set(&mut self.config, parameter, value).unwrap_or_else(|e| panic!("{e}"));
        self
    }

    /// Returns the beginning of questions: `task 7.7, variant sequential, 2 threads`.
    pub fn name(&self) -> String {
        format!("task {}, {}", self.task, self.program())
    }

    /// Runs `work` on a fresh engine under the watchdog.
    ///
    /// # Panics
    /// If the variant cannot be built, or `work` panics or takes too long.
    pub fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut dyn Simulation) -> T + Send + 'static,
    ) -> T {
        let runs = self.clone();
        within(self.task, SECONDS, move || {
            let mut engine = (runs.variant.build)(&runs.config)
                .unwrap_or_else(|e| panic!("{}: {e}", runs.name()));
            work(&mut *engine)
        })
    }

    /// Asks whether every one of `steps` steps agrees with the model up to rounding. The model
    /// restarts from the program's own state before each step. `name` describes the scene.
    pub fn resynchronised(&self, ask: &mut impl Ask, name: &str, scene: &Scene, steps: usize) {
        let question = format!("{}: {STATE} after each step", self.question(name, scene, steps));
        let of_run = scene.clone();
        let found = move |engine: &mut dyn Simulation| of_each_step(engine, &of_run, steps);
        ask.judge(&question, || self.run(found), |found| follow(scene, found, steps));
    }

    /// Asks whether the bits after `steps` steps equal the bits of `right`, a program that is known
    /// to be correct. `right` must not contain any of the lab's tasks.
    pub fn bits_of(
        &self,
        ask: &mut impl Ask,
        right: &Self,
        name: &str,
        scene: &Scene,
        steps: usize,
    ) {
        let of = right.program();
        let question = format!(
            "{}: {STATE} at the end. The bits must be the same as in {of}",
            self.question(name, scene, steps)
        );
        ask.judge(
            &question,
            || self.end(scene, steps),
            |found| {
                let found = split(found, scene.len(), 1)?;
                let right = split(&right.end(scene, steps), scene.len(), 1)?;
                difference(&right[0], &found[0]).map_or(Ok(()), Err)
            },
        );
    }

    /// Asks whether the bits after `steps` steps are the same for each of `programs`, programs of
    /// the same lab.
    pub fn same_bits(
        &self,
        ask: &mut impl Ask,
        programs: &[Self],
        (name, scene): (&str, &Scene),
        steps: usize,
    ) {
        let others: Vec<String> = programs.iter().map(Self::program).collect();
        let question = format!(
            "{}: {STATE} at the end. The bits must be the same in {}",
            self.question(name, scene, steps),
            others.join("; ")
        );
        let found = || [self].into_iter().chain(programs).flat_map(|runs| runs.end(scene, steps));
        ask.judge(
            &question,
            || found().collect(),
            |found| {
                let ends = split(found, scene.len(), 1 + programs.len())?;
                for (other, end) in others.iter().zip(&ends[1..]) {
                    if let Some(words) = difference(&ends[0], end) {
                        return Err(format!("{other} ends with different bits: {words}"));
                    }
                }
                Ok(())
            },
        );
    }

    /// Asks whether the memory of a long run is independent of its number of steps.
    pub fn keeps_its_memory(&self, ask: &mut impl Ask) {
        ask.apart(|ask| {
            let scene = RandomScene::new(100, 32.0, 1.0, 7).with_speeds(0.5, 3.0).draw();
            let scene = scene.expect("the scene is valid");
            let mut engine = (self.variant.build)(&self.config)
                .unwrap_or_else(|e| panic!("{}: {e}", self.name()));
            engine.load(&scene);
            let size = (500, size_of_val(scene.discs()));
            memory(&self.name(), size, |steps| (0..steps).for_each(|_| engine.step()), ask);
        });
    }

    /// Asks for three steps of each of forty scenes, from sparse to crowded, small and wide.
    pub fn follows_unseen_scenes(&self, ask: &mut impl Ask) {
        for seed in 0..40 {
            let (name, scene) = (format!("unseen {seed}"), scenes::unseen(seed));
            self.resynchronised(ask, &name, &scene, 3);
        }
    }

    /// Returns the state after `steps` steps.
    fn end(&self, scene: &Scene, steps: usize) -> Vec<f64> {
        let scene = scene.clone();
        self.run(move |engine| of_end(engine, &scene, steps))
    }

    /// Describes the program: `variant sequential, 2 threads`.
    fn program(&self) -> String {
        match self.config.threads {
            1 => format!("variant {}", self.variant.name),
            threads => format!("variant {}, {threads} threads", self.variant.name),
        }
    }

    fn question(&self, name: &str, scene: &Scene, steps: usize) -> String {
        format!("{}, scene '{name}' of {} discs, {steps} steps", self.name(), scene.len())
    }
}
