//! Questions about whole runs of a variant on ranks. The lab's engine takes the steps, and the
//! model judges the root's results.

use common::Variant;
use common::soft::{Averages, Scene, Simulation, Statistics};
use mpi::topology::SimpleCommunicator;
use oracle::{Ask, Near, Random, States, scenes, statistics_of_run};

use crate::{Rank, on_each};

mod counted;
mod repeated;

/// Questions about runs of one variant of a lab on several numbers of ranks, on behalf of one task.
#[derive(Clone)]
pub struct RunsOnRanks {
    task: &'static str,
    variant: &'static Variant<dyn Simulation>,
    ranks: Vec<usize>,
    threads: usize,
    parameters: Vec<(&'static str, f64)>,
    statistics: bool,
    first: fn(&SimpleCommunicator),
}

impl RunsOnRanks {
    /// Returns runs of `variant`, one of `variants`, on each of these numbers of ranks, for task
    /// `task`, such as `"5.8"`.
    ///
    /// # Panics
    /// If the variant does not exist.
    pub fn new(
        task: &'static str,
        variants: &'static [Variant<dyn Simulation>],
        variant: &str,
        ranks: &[usize],
    ) -> Self {
        let Some(variant) = variants.iter().find(|v| v.name == variant) else {
            panic!("task {task}: the lab has no variant '{variant}'");
        };
        let ranks = ranks.to_vec();
        let parameters = Vec::new();
        Self { task, variant, ranks, threads: 1, parameters, statistics: false, first: |_| {} }
    }

    /// Returns the same runs, with a call to `first` on every rank before each run.
    #[must_use]
    pub fn first(mut self, first: fn(&SimpleCommunicator)) -> Self {
        self.first = first;
        self
    }

    /// Returns the same runs with `threads` threads on each rank.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// Returns the same runs with a parameter of the variant changed.
    #[must_use]
    pub fn set(mut self, parameter: &'static str, value: f64) -> Self {
        self.parameters.push((parameter, value));
        self
    }

    /// Asks whether the bits after each of `steps` steps of each scene equal those of all pairs.
    /// The pairs are in ascending order.
    pub fn bits_of_all_pairs(&self, ask: &mut impl Ask, all: &[Scene], steps: usize) {
        self.judged(
            ask,
            all,
            steps,
            "x y vx vy of each particle after each step, which must have the same bits as in all-pairs",
            |scene, states| states.bits_of_all_pairs(scene),
        );
    }

    /// Asks whether every one of `steps` steps of each scene agrees with the model up to rounding.
    /// The model starts from the program's own state before the step.
    pub fn resynchronised(&self, ask: &mut impl Ask, all: &[Scene], steps: usize) {
        self.judged(
            ask,
            all,
            steps,
            "x y vx vy of each particle after each step, compared with the model",
            |scene, states| states.follow_the_model(scene),
        );
    }

    /// Asks whether the official run, n = 1000 and seed 1, has the same bits as all pairs in its
    /// first 200 steps. The output is then the reference program's, because bits that agree for so
    /// long determine all digits of the output.
    pub fn official(&self, ask: &mut impl Ask) {
        self.bits_of_all_pairs(ask, &[scenes::official()], 200);
    }

    /// Asks whether the bits in the counter scene of `n` particles are the same as with all pairs.
    /// Each rank makes its own share of the scene.
    ///
    /// # Panics
    /// If the scene does not exist.
    pub fn bits_in_a_counter_scene(&self, ask: &mut impl Ask, n: u64, steps: usize) {
        let scene = Scene::counter(n, 1).expect("the scene is sound");
        let count = scene.len();
        self.answered(
            ask,
            &format!(
                "counter scene, {count} particles, {steps} steps: x y vx vy of each particle after \
                 each step, which must have the same bits as in all-pairs"
            ),
            |engine| {
                engine.load_counter(n, 1).expect("the scene is sound");
                States::of_loaded(engine, count, steps).numbers()
            },
            |_, found| States::split(&mut &found[..], count, steps)?.bits_of_all_pairs(&scene),
        );
    }

    /// Asks whether absmin, absavg and neighbours per particle of `steps` steps of a scene are the
    /// model's.
    pub fn averages(&self, ask: &mut impl Ask, scene: &Scene, steps: usize) {
        let counting = Self { statistics: true, ..self.clone() };
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            let found = rank.call("a run", |world| {
                counting.begin(world);
                counting.averages_of(scene, steps)
            });
            if rank.is_root() {
                let question = format!(
                    "{}, {} particles, {steps} steps: absmin, absavg, neighbours per particle",
                    self.name(rank),
                    scene.len()
                );
                ask.near(
                    &question,
                    || found,
                    || {
                        let right = Averages::of(scene.len(), &statistics_of_run(scene, steps));
                        let right = right.expect("the run has steps");
                        let numbers = [right.absmin, right.absavg, right.neighbours];
                        numbers.map(|right| Near { right, scale: right.max(1.0) }).to_vec()
                    },
                );
            }
        });
    }

    /// Builds an engine of the variant.
    ///
    /// # Panics
    /// If the engine cannot be built.
    pub fn engine(&self) -> Box<dyn Simulation> {
        let mut config = self.variant.config();
        config.threads = self.threads;
        config.statistics = self.statistics;
        for (parameter, value) in &self.parameters {
            self.variant.set(&mut config, parameter, *value).unwrap_or_else(|e| panic!("{e}"));
        }
        (self.variant.build)(&config).unwrap_or_else(|e| panic!("{}: {e}", self.variant.name))
    }

    /// Returns the beginning of questions: `task 5.8, variant through-root, 3 ranks`.
    fn name(&self, rank: &Rank<'_>) -> String {
        let threads = match self.threads {
            1 => String::new(),
            threads => format!(", {threads} threads each"),
        };
        let ranks = if rank.ranks == 1 { "1 rank".into() } else { format!("{} ranks", rank.ranks) };
        format!("task {}, variant {}, {ranks}{threads}", self.task, self.variant.name)
    }

    fn judged(
        &self,
        ask: &mut impl Ask,
        all: &[Scene],
        steps: usize,
        what: &str,
        judge: impl Fn(&Scene, &States) -> Result<(), String>,
    ) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            // All scenes use one engine, so that data left over from the previous scene is
            // detected.
            let mut engine = rank.call("building an engine", |world| {
                self.begin(world);
                Some(self.engine())
            });
            for (number, scene) in all.iter().enumerate() {
                let found = rank.call("a run", |_: &SimpleCommunicator| {
                    let engine = engine.as_mut().expect("a rank of a job has built it");
                    States::of_run(&mut **engine, scene, steps, 0).numbers()
                });
                if rank.is_root() {
                    let count = scene.len();
                    let name = self.name(rank);
                    let question =
                        format!("{name}, scene {number}, {count} particles, {steps} steps: {what}");
                    ask.judge(
                        &question,
                        || found,
                        |found| judge(scene, &States::split(&mut &found[..], count, steps)?),
                    );
                }
            }
        });
    }

    /// Makes all ranks execute `run`, each with its own engine. The root answers with the result.
    /// `verdict` receives the number of ranks and this answer.
    fn answered(
        &self,
        ask: &mut impl Ask,
        question: &str,
        run: impl Fn(&mut dyn Simulation) -> Vec<f64>,
        verdict: impl Fn(usize, &[f64]) -> Result<(), String>,
    ) {
        on_each(ask, self.task, &self.ranks, &Random::new(0), |rank, _, ask| {
            let found = rank.call("a run", |world| {
                self.begin(world);
                run(&mut *self.engine())
            });
            if rank.is_root() {
                let question = format!("{}, {question}", self.name(rank));
                ask.judge(&question, || found, |found| verdict(rank.ranks, found));
            }
        });
    }

    fn begin(&self, world: &SimpleCommunicator) {
        (self.first)(world);
    }

    fn averages_of(&self, scene: &Scene, steps: usize) -> Vec<f64> {
        let mut engine = self.engine();
        engine.load(scene);
        let all: Vec<Statistics> = (0..steps)
            .map(|_| {
                engine.step();
                engine.statistics().unwrap_or_default()
            })
            .collect();
        let averages = Averages::of(scene.len(), &all);
        averages.map_or(vec![], |a| vec![a.absmin, a.absavg, a.neighbours])
    }
}
