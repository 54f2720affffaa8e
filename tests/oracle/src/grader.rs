//! The checks of one variant.

use common::soft::{DT, Particle, Scene, Simulation};
use common::{Config, Reproducibility, Variant};

use crate::ask::memory;
use crate::bits::difference;
use crate::compare::one_step;
use crate::single::Single;
use crate::{Model, right, scenes, within};

/// Every check ends within this time, or the test fails with the task's name.
const SECONDS: u64 = 120;

/// Checks one variant of a lab on behalf of one task. Every check panics in the domain's words.
#[derive(Clone)]
pub struct Grader {
    pub(crate) task: &'static str,
    variant: &'static Variant<dyn Simulation>,
    config: Config,
    /// The side of the bins that positions count from, for programs in single precision.
    bins: Option<fn(&Scene) -> f64>,
    seconds: u64,
}

impl Grader {
    /// A grader of `variant`, one of `variants`, for task `task`, such as `"2.5"`.
    ///
    /// # Panics
    /// There is no such variant.
    pub fn new(
        task: &'static str,
        variants: &'static [Variant<dyn Simulation>],
        variant: &str,
    ) -> Self {
        let Some(variant) = variants.iter().find(|v| v.name == variant) else {
            panic!("task {task}: the lab has no variant '{variant}'");
        };
        let config = variant.config();
        Self { task, variant, config, bins: None, seconds: SECONDS }
    }

    /// The same with `threads` threads.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.config.threads = threads;
        self
    }

    /// The same with a parameter of the variant turned.
    ///
    /// # Panics
    /// The variant has no such parameter.
    #[must_use]
    pub fn set(mut self, parameter: &str, value: f64) -> Self {
        self.variant.set(&mut self.config, parameter, value).unwrap_or_else(|e| panic!("{e}"));
        self
    }

    /// The same with statistics collected.
    #[must_use]
    pub fn statistics(mut self) -> Self {
        self.config.statistics = true;
        self
    }

    /// The same for a program in single precision whose positions are offsets in bins, of a side that
    /// depends on the scene. Only [`resynchronised`](Self::resynchronised) and
    /// [`resynchronised_on_each`](Self::resynchronised_on_each) know about precision.
    #[must_use]
    pub fn in_single(mut self, side_of_bins: fn(&Scene) -> f64) -> Self {
        self.bins = Some(side_of_bins);
        self
    }

    /// The same with another time limit for each check.
    #[must_use]
    pub fn seconds(mut self, seconds: u64) -> Self {
        self.seconds = seconds;
        self
    }

    /// What the variant promises.
    pub fn reproducibility(&self) -> Reproducibility {
        self.variant.reproducibility
    }

    /// Runs `check` on a fresh engine under the watchdog.
    pub fn run<T: Send + 'static>(
        &self,
        check: impl FnOnce(&Self, &mut dyn Simulation) -> T + Send + 'static,
    ) -> T {
        let grader = self.clone();
        within(self.task, self.seconds, move || {
            let mut engine = (grader.variant.build)(&grader.config)
                .unwrap_or_else(|e| panic!("{}: {e}", grader.name()));
            check(&grader, &mut *engine)
        })
    }

    /// Restarts the model from the program's own state before each of `steps` steps and compares
    /// where both go. No chaos, so it holds for any number of steps, any order of summation.
    pub fn resynchronised(&self, scene: &Scene, steps: usize) {
        let scene = scene.clone();
        self.run(move |grader, engine| grader.follow(engine, &scene, steps));
    }

    /// [`resynchronised`](Self::resynchronised) on many scenes through one engine: what it keeps
    /// from the scene before would show.
    pub fn resynchronised_on_each(&self, scenes: Vec<Scene>, steps: usize) {
        self.run(move |grader, engine| {
            for (number, scene) in scenes.iter().enumerate() {
                if let Err(words) = grader.follow_quietly(engine, scene, steps) {
                    panic!("{}, scene {number} of {}, {words}", grader.name(), scenes.len());
                }
            }
        });
    }

    /// 200 crowds of 200, two steps each, through one engine.
    pub fn crowds(&self) {
        self.resynchronised_on_each((1..=200).map(scenes::crowd).collect(), 2);
    }

    /// Forces on particles at rest in crowds: within 1e-12 of the sum of magnitudes; and all
    /// forces together within 1e-12 of theirs, since pairs keep the momentum.
    pub fn forces(&self) {
        self.run(|grader, engine| {
            for seed in 1..=10 {
                let scene = scenes::cloud(40 * seed as usize, 4.0, seed);
                grader.forces_at_rest(engine, &scene);
            }
        });
    }

    /// After every one of `steps` steps the bits are those of all pairs in ascending order.
    pub fn bits_of_all_pairs(&self, scene: &Scene, steps: usize) {
        let scene = scene.clone();
        self.run(move |grader, engine| {
            let mut model = Model::new(&scene);
            engine.load(&scene);
            for step in 1..=steps {
                engine.step();
                model.step();
                if let Some(words) = difference(&read(engine, scene.len()), &model.particles) {
                    panic!("{}, step {step}: not the bits of all pairs: {words}", grader.name());
                }
            }
        });
    }

    /// After `steps` steps in a row, without a read in between, the bits are those of all
    /// pairs: nothing outside makes threads that live for the whole run wait at a step's end.
    pub fn bits_after_a_run(&self, scene: &Scene, steps: u64) {
        let scene = scene.clone();
        self.run(move |grader, engine| {
            let mut model = Model::new(&scene);
            (0..steps).for_each(|_| model.step());
            engine.load(&scene);
            engine.run(steps);
            if let Some(words) = difference(&read(engine, scene.len()), &model.particles) {
                panic!("{}: {steps} steps in a row: {words}", grader.name());
            }
        });
    }

    /// The bits after `steps` steps are the same for each number of threads, and for a second
    /// run through the same engine.
    pub fn same_bits_on_threads(&self, scene: &Scene, steps: usize, threads: &[usize]) {
        let mut first: Option<Vec<Particle>> = None;
        for &count in threads {
            let scene = scene.clone();
            let [once, again] = self.clone().threads(count).run(move |_, engine| {
                [(), ()].map(|()| {
                    engine.load(&scene);
                    (0..steps).for_each(|_| engine.step());
                    read(engine, scene.len())
                })
            });
            let name = self.name();
            if let Some(words) = difference(&again, &once) {
                panic!("{name}, {count} threads: a second run gave other bits: {words}");
            }
            let first = first.get_or_insert(once);
            if let Some(words) = difference(&again, first) {
                panic!("{name}: {count} threads gave other bits than {}: {words}", threads[0]);
            }
        }
    }

    /// No particle is lost or doubled: after every step each id is there once, inside the box.
    pub fn keeps_everyone(&self, scene: &Scene, steps: usize) {
        let scene = scene.clone();
        self.run(move |grader, engine| {
            engine.load(&scene);
            for step in 1..=steps {
                engine.step();
                for (id, particle) in read(engine, scene.len()).iter().enumerate() {
                    let inside = |x: f64| (0.0..=scene.size()).contains(&x);
                    if particle.id as usize != id || !inside(particle.x) || !inside(particle.y) {
                        panic!(
                            "{}, step {step}: particle {id} is lost or outside the box",
                            grader.name()
                        );
                    }
                }
            }
        });
    }

    /// The particles after `steps` steps, one by one.
    pub fn ends(&self, scene: &Scene, steps: usize) -> Vec<Particle> {
        let scene = scene.clone();
        self.run(move |_, engine| {
            engine.load(&scene);
            (0..steps).for_each(|_| engine.step());
            read(engine, scene.len())
        })
    }

    /// What a long run holds does not grow with its steps. To be called [apart](crate::apart()): in a process of its own.
    pub fn keeps_its_memory(&self) {
        self.run(|grader, engine| {
            let scene = scenes::dense();
            engine.load(&scene);
            let size = (500, size_of_val(scene.particles()));
            memory(&grader.name(), size, |steps| engine.run(steps), &mut right);
        });
    }

    /// `task 2.5, variant sorted, 4 threads`: how messages begin.
    pub fn name(&self) -> String {
        let threads = match self.config.threads {
            1 => String::new(),
            threads => format!(", {threads} threads"),
        };
        format!("task {}, variant {}{threads}", self.task, self.variant.name)
    }

    fn follow(&self, engine: &mut dyn Simulation, scene: &Scene, steps: usize) {
        if let Err(words) = self.follow_quietly(engine, scene, steps) {
            panic!("{}, {words}", self.name());
        }
    }

    fn follow_quietly(
        &self,
        engine: &mut dyn Simulation,
        scene: &Scene,
        steps: usize,
    ) -> Result<(), String> {
        engine.load(scene);
        let mut before = scene.particles().to_vec();
        let single = self.bins.map(|side_of| Single { side: side_of(scene) });
        if let Some(single) = single {
            // The model starts where the program does: at the scene, rounded.
            let loaded = read(engine, scene.len());
            let odd = loaded.iter().zip(&before).find(|(l, given)| !single.is_rounded(l, given));
            if let Some((loaded, given)) = odd {
                return Err(format!("particle {}: {given:?} was loaded as {loaded:?}", given.id));
            }
            before = loaded;
        }
        for step in 1..=steps {
            engine.step();
            let after = read(engine, scene.len());
            one_step(scene.size(), &before, &after, single)
                .map_err(|mistake| format!("step {step}, {mistake}"))?;
            before = after;
        }
        Ok(())
    }

    fn forces_at_rest(&self, engine: &mut dyn Simulation, scene: &Scene) {
        engine.load(scene);
        engine.step();
        let mut model = Model::new(scene);
        model.step();
        let mut total = (0.0, 0.0, 0.0);
        for (id, particle) in read(engine, scene.len()).iter().enumerate() {
            let (ax, ay) = (particle.vx / DT, particle.vy / DT);
            let (a, scale) = (model.accelerations[id], model.magnitudes[id]);
            let off = (ax - a.x).hypot(ay - a.y);
            if off.is_nan() || off > 1e-12 * scale {
                panic!(
                    "{}: particle {id} is accelerated by ({ax:.6e}, {ay:.6e}), not ({:.6e}, {:.6e})",
                    self.name(),
                    a.x,
                    a.y
                );
            }
            total = (total.0 + ax, total.1 + ay, total.2 + scale);
        }
        if total.0.hypot(total.1) > 1e-12 * total.2 {
            panic!(
                "{}: the forces do not add up to zero: the two forces of a pair are not opposite",
                self.name()
            );
        }
    }
}

/// The state of an engine. What it does not write stays visibly wrong.
pub(crate) fn read(engine: &dyn Simulation, n: usize) -> Vec<Particle> {
    let unwritten = Particle { x: f64::NAN, y: f64::NAN, vx: f64::NAN, vy: f64::NAN, id: u32::MAX };
    let mut state = vec![unwritten; n];
    engine.read(0, &mut state);
    state
}
