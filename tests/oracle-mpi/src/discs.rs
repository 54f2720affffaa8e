//! Questions about whole runs of a variant with hard discs on ranks. The lab's engine takes the
//! steps, and a program that is known to be correct judges the root's results.

use common::hard::{RandomScene, Scene, Simulation};
use common::{Config, Variant};
use mpi::topology::SimpleCommunicator;
use oracle::hard::{difference, of_each_step, one_step, split};
use oracle::{Ask, Random, memory};

use crate::{Rank, on_each};

/// A program for hard discs.
type Discs = Variant<dyn Simulation>;

/// Questions about runs of one variant of a lab on several numbers of ranks, on behalf of one task.
#[derive(Clone)]
pub struct DiscsOnRanks {
    task: &'static str,
    variant: &'static Discs,
    config: Config,
    ranks: Vec<usize>,
    first: fn(&SimpleCommunicator),
}

impl DiscsOnRanks {
    /// Returns runs of `variant`, one of `variants`, on each of these numbers of ranks, for task
    /// `task`, such as `"8.7"`.
    ///
    /// # Panics
    /// If the variant does not exist.
    pub fn new(
        task: &'static str,
        variants: &'static [Discs],
        variant: &str,
        ranks: &[usize],
    ) -> Self {
        let Some(variant) = variants.iter().find(|v| v.name == variant) else {
            panic!("task {task}: the lab has no variant '{variant}'");
        };
        let config = variant.config();
        Self { task, variant, config, ranks: ranks.to_vec(), first: |_| {} }
    }

    /// Returns the same runs, in which every rank calls `first` before it builds an engine.
    #[must_use]
    pub fn first(mut self, first: fn(&SimpleCommunicator)) -> Self {
        self.first = first;
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

    /// Asks whether the state after each of `steps` steps of each scene equals that of `right` bit
    /// for bit. `right` is a program of an earlier lab. Each scene has a name.
    pub fn bits_of(
        &self,
        ask: &mut impl Ask,
        right: &'static Discs,
        scenes: &[(&str, Scene)],
        steps: usize,
    ) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            // All scenes use one engine, so that data left over from the previous scene is
            // detected.
            let mut engine = rank.call("building an engine", |world| Some(self.engine(world)));
            for (name, scene) in scenes {
                let found = rank.call("a run", |_| {
                    let engine = engine.as_mut().expect("a rank of a job has built it");
                    of_each_step(&mut **engine, scene, steps)
                });
                if rank.is_root() {
                    let question = format!(
                        "{}, {steps} steps of {} discs ({name}): x y vx vy, collisions with discs and with walls of \
                         each disc after each step, which must have the same bits as in {}",
                        self.name(rank),
                        scene.len(),
                        right.name
                    );
                    ask.judge(&question, || found, |found| same_bits(right, scene, found, steps));
                }
            }
        });
    }

    /// Asks for the variant's counters with these `names` after `steps` steps of a scene. `verdict`
    /// receives the root's counters, NaN for a counter that the variant does not have.
    pub fn counters(
        &self,
        ask: &mut impl Ask,
        (scene, steps): (&Scene, usize),
        names: &[&str],
        verdict: impl Fn(&[f64]) -> Result<(), String>,
    ) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            let found =
                rank.call("a run", |world| counted(&mut *self.engine(world), scene, steps, names));
            if rank.is_root() {
                let (n, names) = (scene.len(), names.join("; "));
                let name = self.name(rank);
                let question = format!("{name}, {steps} steps of {n} discs, counted: {names}");
                ask.judge(&question, || found, &verdict);
            }
        });
    }

    /// Asks whether, after `steps` steps, the totals of the counters over all ranks equal those of
    /// `right`. `right` is a program of an earlier lab.
    pub fn counters_of(
        &self,
        ask: &mut impl Ask,
        right: &'static Discs,
        (scene, steps): (&Scene, usize),
        names: &[&str],
    ) {
        self.counters(ask, (scene, steps), names, |found| {
            let right = counted(&mut *built(right, &right.config()), scene, steps, names);
            for ((name, found), right) in names.iter().zip(found).zip(right) {
                if *found != right {
                    return Err(format!("{name}: {found} were counted, but {right} is right"));
                }
            }
            Ok(())
        });
    }

    /// Asks whether the memory of a rank in a long run is independent of the number of steps.
    pub fn keeps_its_memory(&self, ask: &mut impl Ask) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            let scene = RandomScene::new(1000, 100.0, 1.0, 7).with_speeds(0.5, 3.0).draw();
            let scene = scene.expect("the scene is sound");
            let mut engine = rank.call("loading", |world| {
                let mut engine = self.engine(world);
                engine.load(&scene);
                Some(engine)
            });
            let mut step = || engine.iter_mut().for_each(|engine| engine.step());
            let name = format!("{}, rank {}", self.name(rank), rank.number);
            let size = (30, size_of_val(scene.discs()));
            memory(&name, size, |steps| (0..steps).for_each(|_| step()), ask);
        });
    }

    /// Calls the function that was set with `first`, and then builds an engine of the variant.
    ///
    /// # Panics
    /// If the engine cannot be built.
    pub fn engine(&self, world: &SimpleCommunicator) -> Box<dyn Simulation> {
        (self.first)(world);
        built(self.variant, &self.config)
    }

    /// Returns the beginning of questions: `task 8.7, variant master-workers, keep = 0, 3 ranks`.
    fn name(&self, rank: &Rank<'_>) -> String {
        let changed = self.variant.parameters.iter().filter_map(|parameter| {
            let value = self.config.parameter(parameter.name);
            (value != parameter.default).then(|| format!(", {} = {value}", parameter.name))
        });
        let changed: String = changed.collect();
        let ranks = if rank.ranks == 1 { "1 rank".into() } else { format!("{} ranks", rank.ranks) };
        format!("task {}, variant {}{changed}, {ranks}", self.task, self.variant.name)
    }
}

fn built(variant: &Discs, config: &Config) -> Box<dyn Simulation> {
    (variant.build)(config).unwrap_or_else(|e| panic!("{}: {e}", variant.name))
}

/// Returns an engine's counters with these names after some steps; NaN for a missing counter.
fn counted(engine: &mut dyn Simulation, scene: &Scene, steps: usize, names: &[&str]) -> Vec<f64> {
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    let counters = engine.counters();
    let count = |name: &&str| {
        let counter = counters.iter().find(|(it, _)| it == name);
        counter.map_or(f64::NAN, |(_, count)| *count)
    };
    names.iter().map(count).collect()
}

/// Compares the states after each step with the states of `right`.
fn same_bits(right: &Discs, scene: &Scene, found: &[f64], steps: usize) -> Result<(), String> {
    let mut engine = built(right, &right.config());
    let expected = of_each_step(&mut *engine, scene, steps);
    let expected = split(&expected, scene.len(), steps)?;
    let mut before = scene.discs().to_vec();
    for (step, (expected, found)) in
        (1..).zip(expected.iter().zip(split(found, scene.len(), steps)?))
    {
        if let Some(wrong) = difference(expected, &found) {
            // The expected event of a disc is more informative than a position.
            let wrong = one_step(&before, &found, scene).unwrap_or(wrong);
            return Err(format!("step {step}: {wrong}"));
        }
        before = found;
    }
    Ok(())
}
