//! Questions about whole runs of one variant: the lab's engine takes the steps, and the model
//! judges them.

mod long;
mod states;
mod threads;

use common::soft::{DT, Particle, Scene, Simulation};
use common::{Config, Reproducibility, Variant};

pub use self::long::statistics_of_run;
pub use self::states::States;
use self::states::read;
use crate::bits::difference;
use crate::compare::one_step;
use crate::single::Single;
use crate::{Ask, Model, memory, scenes, within};

/// Time limit of a run, in seconds. The message of a failure names the task.
const SECONDS: u64 = 120;

/// Number of steps of a short run that is asked for before a longer run. A program that duplicates
/// particles fails in the short run, before the memory is full.
const FIRST: usize = 8;

/// Questions about runs of one variant of a lab, for one task. Verdicts use the terms of the field.
#[derive(Clone)]
pub struct Runs {
    task: &'static str,
    variant: &'static Variant<dyn Simulation>,
    config: Config,
    /// Parameters that differ from the variant's defaults, as questions name them.
    changed: String,
    /// Side of the bins to which positions are relative, for programs in single precision.
    bins: Option<fn(&Scene) -> f64>,
    seconds: u64,
}

impl Runs {
    /// Returns runs of `variant`, one of `variants`, for task `task`, such as `"2.5"`.
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
        let config = variant.config();
        Self { task, variant, config, changed: String::new(), bins: None, seconds: SECONDS }
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
        self.changed += &format!(", {parameter} {value}");
        self
    }

    /// Returns the same runs with statistics collected.
    #[must_use]
    pub fn statistics(mut self) -> Self {
        self.config.statistics = true;
        self
    }

    /// Returns the same runs for a program in single precision whose positions are offsets in bins.
    /// The side of the bins depends on the scene. Only [`resynchronised`](Self::resynchronised) and
    /// [`resynchronised_on_each`](Self::resynchronised_on_each) consider precision.
    #[must_use]
    pub fn in_single(mut self, side_of_bins: fn(&Scene) -> f64) -> Self {
        self.bins = Some(side_of_bins);
        self
    }

    /// Returns the same runs with a different time limit for each run, in seconds.
    #[must_use]
    pub fn seconds(mut self, seconds: u64) -> Self {
        self.seconds = seconds;
        self
    }

    /// Returns the reproducibility that the variant promises.
    pub fn reproducibility(&self) -> Reproducibility {
        self.variant.reproducibility
    }

    /// Returns the beginning of questions: `task 2.5, variant sorted, bin-size 2, 4 threads`.
    pub fn name(&self) -> String {
        let threads = match self.config.threads {
            1 => String::new(),
            threads => format!(", {threads} threads"),
        };
        format!("task {}, variant {}{}{threads}", self.task, self.variant.name, self.changed)
    }

    /// Runs `work` on a fresh engine under the watchdog.
    pub fn run<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut dyn Simulation) -> T + Send + 'static,
    ) -> T {
        let runs = self.clone();
        within(self.task, self.seconds, move || {
            let mut engine = (runs.variant.build)(&runs.config)
                .unwrap_or_else(|e| panic!("{}: {e}", runs.name()));
            work(&mut *engine)
        })
    }

    /// Asks whether every one of `steps` steps agrees with the model up to rounding. The model
    /// restarts from the program's own state before each step, so chaos and the order of summation
    /// do not affect the comparison.
    pub fn resynchronised(&self, ask: &mut impl Ask, scene: &Scene, steps: usize) {
        self.resynchronised_on_each(ask, vec![scene.clone()], steps);
    }

    /// Asks [`resynchronised`](Self::resynchronised) on many scenes with one engine. So data left
    /// over from the previous scene is detected.
    pub fn resynchronised_on_each(&self, ask: &mut impl Ask, all: Vec<Scene>, steps: usize) {
        if steps > FIRST {
            self.steps_of_each(ask, all.clone(), FIRST);
        }
        self.steps_of_each(ask, all, steps);
    }

    fn steps_of_each(&self, ask: &mut impl Ask, all: Vec<Scene>, steps: usize) {
        let count = all.len();
        let question = match &all[..] {
            [scene] => format!(
                "{}: x y vx vy of each particle after each step",
                self.question(scene, steps)
            ),
            _ => format!(
                "{}, {count} scenes, one after another in one engine: x y vx vy of each particle after each of \
                 {steps} steps",
                self.name()
            ),
        };
        let (loaded, recorded) = (usize::from(self.bins.is_some()), all.clone());
        let found = move |engine: &mut dyn Simulation| {
            let run = |scene: &Scene| States::of_run(engine, scene, steps, loaded).numbers();
            recorded.iter().flat_map(run).collect::<Vec<f64>>()
        };
        let verdict = |found: &[f64]| {
            let mut rest = found;
            for (number, scene) in all.iter().enumerate() {
                let states = States::split(&mut rest, scene.len(), loaded + steps)?;
                self.follow(scene, states).map_err(|words| match count {
                    1 => words,
                    _ => format!("scene {number} of {count}, {words}"),
                })?;
            }
            Ok(())
        };
        ask.judge(&question, || self.run(found), verdict);
    }

    /// Asks for two steps of each of 200 crowds of 200 particles, with one engine.
    pub fn crowds(&self, ask: &mut impl Ask) {
        self.resynchronised_on_each(ask, (1..=200).map(scenes::crowd).collect(), 2);
    }

    /// Asks for the forces on crowded particles at rest.
    ///
    /// The error of each force may be 10⁻¹² times the sum of the magnitudes of its pair forces. The
    /// total force may be 10⁻¹² times all these sums together, because pairs conserve momentum.
    pub fn forces(&self, ask: &mut impl Ask) {
        for seed in 1..=10 {
            let scene = scenes::cloud(40 * seed as usize, 4.0, seed);
            let (question, of_run) = (self.question(&scene, 1), scene.clone());
            let found =
                move |engine: &mut dyn Simulation| States::of_run(engine, &of_run, 1, 0).numbers();
            ask.judge(
                &format!("{question}, with all particles at rest at the beginning: x y vx vy of each particle"),
                || self.run(found),
                |found| {
                    let mut rest = found;
                    let states = States::split(&mut rest, scene.len(), 1)?;
                    forces_of_pairs(&scene, &states.state(0))
                },
            );
        }
    }

    /// Asks whether the state after each of `steps` steps is bit-identical to the state computed
    /// from all pairs in ascending order.
    pub fn bits_of_all_pairs(&self, ask: &mut impl Ask, scene: &Scene, steps: usize) {
        let of_run = scene.clone();
        let found =
            move |engine: &mut dyn Simulation| States::of_run(engine, &of_run, steps, 0).numbers();
        let question = format!(
            "{}: x y vx vy of each particle after each step. The bits must be the same as in all-pairs",
            self.question(scene, steps)
        );
        ask.judge(
            &question,
            || self.run(found),
            |found| {
                let mut rest = found;
                let states = States::split(&mut rest, scene.len(), steps)?;
                states.bits_of_all_pairs(scene)
            },
        );
    }

    /// Asks whether the state after `steps` steps is bit-identical to that of all pairs.
    ///
    /// No state is read between two steps. So nothing outside the program makes its threads wait,
    /// and threads that live for the whole run must wait for each other themselves.
    pub fn bits_after_a_run(&self, ask: &mut impl Ask, scene: &Scene, steps: u64) {
        let of_run = scene.clone();
        let found = move |engine: &mut dyn Simulation| {
            engine.load(&of_run);
            engine.run(steps);
            States::of(&read(engine, of_run.len())).numbers()
        };
        let question = format!(
            "{}, {steps} steps in a row: x y vx vy of each particle. The bits must be the same as in all-pairs",
            self.name()
        );
        ask.judge(
            &question,
            || self.run(found),
            |found| {
                let mut model = Model::new(scene);
                (0..steps).for_each(|_| model.step());
                let mut rest = found;
                let end = States::split(&mut rest, scene.len(), 1)?.state(0);
                difference(&end, &model.particles).map_or(Ok(()), Err)
            },
        );
    }

    /// Asks whether the state after `steps` steps is bit-identical for each number of threads.
    ///
    /// A second run with the same engine must also reach the same bits.
    pub fn same_bits_on_threads(
        &self,
        ask: &mut impl Ask,
        scene: &Scene,
        steps: usize,
        threads: &[usize],
    ) {
        let runs_on = |count: usize| {
            let of_run = scene.clone();
            self.clone().threads(count).run(move |engine| {
                let once = States::of_end(engine, &of_run, steps).numbers();
                [once, States::of_end(engine, &of_run, steps).numbers()].concat()
            })
        };
        let found = || threads.iter().flat_map(|&count| runs_on(count)).collect();
        let question = format!(
            "{}, {steps} steps, two runs on each of {threads:?} threads: x y vx vy of each particle at the end of \
             each run",
            self.clone().threads(1).name()
        );
        ask.judge(&question, found, |found| {
            let mut rest = found;
            let mut first = None;
            for count in threads {
                let states = States::split(&mut rest, scene.len(), 2)?;
                let (once, again) = (states.state(0), states.state(1));
                if let Some(words) = difference(&again, &once) {
                    return Err(format!("{count} threads: the second run ended with different bits: {words}"));
                }
                if let Some(words) = difference(&again, first.get_or_insert(once)) {
                    let than = threads[0];
                    return Err(format!("the runs on {count} and on {than} threads ended with different bits: {words}"));
                }
            }
            Ok(())
        });
    }

    /// Asks whether particles are lost or doubled: after every step each id must occur once, inside
    /// the box.
    pub fn keeps_everyone(&self, ask: &mut impl Ask, scene: &Scene, steps: usize) {
        let of_run = scene.clone();
        let found =
            move |engine: &mut dyn Simulation| States::of_run(engine, &of_run, steps, 0).numbers();
        let question = format!(
            "{}: x y vx vy of each particle after each step. Each particle must be inside the box",
            self.question(scene, steps)
        );
        ask.judge(
            &question,
            || self.run(found),
            |found| {
                let mut rest = found;
                States::split(&mut rest, scene.len(), steps)?.everyone_inside(scene.size())
            },
        );
    }

    /// Asks whether the memory of a long run is independent of its number of steps.
    pub fn keeps_its_memory(&self, ask: &mut impl Ask) {
        ask.apart(|ask| {
            let scene = scenes::dense();
            let mut engine = (self.variant.build)(&self.config)
                .unwrap_or_else(|e| panic!("{}: {e}", self.name()));
            engine.load(&scene);
            let size = (500, size_of_val(scene.particles()));
            memory(&self.name(), size, |steps| engine.run(steps), ask);
        });
    }

    fn question(&self, scene: &Scene, steps: usize) -> String {
        format!("{}, {} particles, {steps} steps", self.name(), scene.len())
    }

    /// Checks that every step agrees with the model. For a program in single precision, the states
    /// begin with the loaded state.
    fn follow(&self, scene: &Scene, states: States) -> Result<(), String> {
        let single = self.bins.map(|side_of| Single { side: side_of(scene) });
        let mut before = scene.particles().to_vec();
        let mut first = 0;
        if let Some(single) = single {
            // The model starts where the program starts: at the rounded scene.
            let loaded = states.state(0);
            let odd = loaded.iter().zip(&before).find(|(l, given)| !single.is_rounded(l, given));
            if let Some((loaded, given)) = odd {
                return Err(format!(
                    "particle {}: the scene has {given:?}, but the engine loaded {loaded:?}",
                    given.id
                ));
            }
            (before, first) = (loaded, 1);
        }
        for step in first..states.count() {
            let after = states.state(step);
            one_step(scene.size(), &before, &after, single)
                .map_err(|mistake| format!("step {}, {mistake}", step + 1 - first))?;
            before = after;
        }
        Ok(())
    }
}

/// Checks that particles that began at rest were accelerated as in the model, and conserve
/// momentum.
fn forces_of_pairs(scene: &Scene, after: &[Particle]) -> Result<(), String> {
    let mut model = Model::new(scene);
    model.step();
    let (mut x, mut y, mut magnitudes) = (0.0, 0.0, 0.0);
    for (id, particle) in after.iter().enumerate() {
        let (ax, ay) = (particle.vx / DT, particle.vy / DT);
        let (a, scale) = (model.accelerations[id], model.magnitudes[id]);
        let off = (ax - a.x).hypot(ay - a.y);
        if off.is_nan() || off > 1e-12 * scale {
            return Err(format!(
                "particle {id} is accelerated by ({ax:.6e}, {ay:.6e}), not ({:.6e}, {:.6e})",
                a.x, a.y
            ));
        }
        x += ax;
        y += ay;
        magnitudes += scale;
    }
    if x.hypot(y) > 1e-12 * magnitudes {
        return Err(
            "the forces do not add up to zero: the two forces of a pair are not opposite".into()
        );
    }
    Ok(())
}
