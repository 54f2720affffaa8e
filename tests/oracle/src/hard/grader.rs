//! The check of one step at a time.

use common::Variant;
use common::hard::{Disc, Scene, Simulation};

use super::model::{Event, What, step};
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

/// How far two correct programs may be apart after one step from the same state.
fn limit(before: &[Disc], scene: &Scene) -> f64 {
    let fastest = before.iter().map(|d| d.vx.abs().max(d.vy.abs())).fold(0.0, f64::max);
    1e-14 * scene.side() * (1.0 + fastest / scene.radius())
}

/// What is wrong with `found`, the discs after a step of `scene` from `before`; nothing if nothing is.
pub fn one_step(before: &[Disc], found: &[Disc], scene: &Scene) -> Option<String> {
    let (expected, events) = step(before, scene.side(), scene.radius());
    let limit = limit(before, scene);
    let wrong = |(e, f): (&Disc, &Disc)| {
        let near = |a: f64, b: f64| (a - b).abs() <= limit;
        !(near(e.x, f.x) && near(e.y, f.y) && near(e.vx, f.vx) && near(e.vy, f.vy))
            || (e.pair_collisions, e.wall_collisions) != (f.pair_collisions, f.wall_collisions)
    };
    // Of several wrong discs the one with the earliest collision tells most.
    let i = (0..expected.len())
        .filter(|&i| wrong((&expected[i], &found[i])))
        .min_by(|&i, &j| time_of(&events, i).total_cmp(&time_of(&events, j)))?;
    let (e, f) = (&expected[i], &found[i]);
    Some(format!(
        "disc {i} {}. It must end at {}, but ends at {}",
        happening(&events, i),
        describe(e),
        describe(f)
    ))
}

fn time_of(events: &[Event], i: usize) -> f64 {
    events.iter().find(|e| e.involves(i)).map_or(2.0, |e| e.time)
}

fn happening(events: &[Event], i: usize) -> String {
    let Some(event) = events.iter().find(|e| e.involves(i)) else {
        return "collides with nothing and flies straight".into();
    };
    let time = event.time;
    match event.what {
        What::Corner => format!("hits a corner at λ = {time:?}"),
        What::WallX => format!("hits the left or right wall at λ = {time:?}"),
        What::WallY => format!("hits the lower or upper wall at λ = {time:?}"),
        What::Disc(j) => {
            let other = if event.disc == i { j } else { event.disc };
            format!("collides with disc {other} at λ = {time:?}")
        }
    }
}

fn describe(d: &Disc) -> String {
    format!(
        "({:?}, {:?}) with velocity ({:?}, {:?}), {} pair and {} wall collisions",
        d.x, d.y, d.vx, d.vy, d.pair_collisions, d.wall_collisions
    )
}

/// The first disc that is not the same to the bit in two runs; nothing if all are.
pub fn difference(expected: &[Disc], found: &[Disc]) -> Option<String> {
    let bits =
        |d: &Disc| ([d.x, d.y, d.vx, d.vy].map(f64::to_bits), d.pair_collisions, d.wall_collisions);
    let i = expected.iter().zip(found).position(|(e, f)| bits(e) != bits(f))?;
    Some(format!("disc {i} is at {}, not at {}", describe(&found[i]), describe(&expected[i])))
}
