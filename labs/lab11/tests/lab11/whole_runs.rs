//! Questions about whole runs of `planned`.

use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
use neighbour_list::{NeighbourList, Workers};
use oracle::{Ask, Random, Runs, scenes};

use super::{by_choice, variant};

/// Returns the particles of an engine.
fn particles(engine: &dyn Simulation, n: usize) -> Vec<Particle> {
    let mut particles = vec![Particle::default(); n];
    engine.read(0, &mut particles);
    particles
}

/// Returns x, y, vx, vy of each particle.
pub(crate) fn numbers(particles: &[Particle]) -> Vec<f64> {
    particles.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy]).collect()
}

/// Returns the particles that these numbers represent.
pub(crate) fn of_numbers(numbers: &[f64]) -> Vec<Particle> {
    let (all, _) = numbers.as_chunks();
    (0..).zip(all).map(|(id, &[x, y, vx, vy])| Particle { x, y, vx, vy, id }).collect()
}

/// Returns the concatenated states after each of `steps` steps.
pub(crate) fn states(runs: &Runs, scene: &Scene, steps: usize) -> Vec<f64> {
    let scene = scene.clone();
    runs.run(move |engine| {
        engine.load(&scene);
        let state = |_| {
            engine.step();
            numbers(&particles(engine, scene.len()))
        };
        (0..steps).flat_map(state).collect()
    })
}

/// Returns the state after `steps` single steps.
pub(crate) fn end(runs: &Runs, scene: &Scene, steps: usize) -> Vec<f64> {
    let scene = scene.clone();
    runs.run(move |engine| {
        engine.load(&scene);
        (0..steps).for_each(|_| engine.step());
        numbers(&particles(engine, scene.len()))
    })
}

/// Returns an engine's counter with this name after `steps` steps.
pub(crate) fn counted(runs: &Runs, name: &'static str, scene: &Scene, steps: usize) -> f64 {
    let scene = scene.clone();
    runs.run(move |engine| {
        engine.load(&scene);
        (0..steps).for_each(|_| engine.step());
        let counters = engine.counters();
        counters.iter().find(|(counter, _)| *counter == name).expect("the engine counts this").1
    })
}

/// Checks that a state agrees with the state of a neighbour list after `steps` steps. Each step is
/// divided into `divide` parts. The tolerance is a billionth of the box, or of 1 in a small box.
pub(crate) fn near_the_list(
    found: &[f64],
    scene: &Scene,
    steps: usize,
    divide: u32,
) -> Result<(), String> {
    let mut engine = NeighbourList::<NoStatistics>::new(Workers::default(), 0.0, divide);
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    let right = particles(&engine, scene.len());
    let found = of_numbers(found);
    if found.len() != right.len() {
        return Err("the run is not complete".into());
    }
    for (found, right) in found.iter().zip(&right) {
        let off = (found.x - right.x).hypot(found.y - right.y);
        if off.is_nan() || off > 1e-9 * scene.size().max(1.0) {
            return Err(format!(
                "particle {} is {off:e} away from its position in a run with a neighbour list, in which each step is \
                 divided into {divide} parts",
                right.id
            ));
        }
    }
    Ok(())
}

/// Returns a scene as dense as the official scene, in random order, with distances of at least
/// `least` cutoffs.
pub(crate) fn scattered(n: usize, least: f64, seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let size = (0.0005 * n as f64).sqrt();
    let mut particles: Vec<Particle> = Vec::new();
    while particles.len() < n {
        let [x, y] = [0; 2].map(|_| random.between(0.0, size));
        let [vx, vy] = [0; 2].map(|_| random.between(-1.0, 1.0));
        let p = Particle { x, y, vx, vy, id: particles.len() as u32 };
        if particles.iter().all(|q| q.to(&p).norm_squared() > (least * CUTOFF).powi(2)) {
            particles.push(p);
        }
    }
    Scene::new(size, particles).expect("the scene is valid")
}

pub(crate) fn windows(_: &mut Random, ask: &mut impl Ask) {
    for window in [1.0, 2.0, 5.0, 8.0, 16.0] {
        let planned = variant("11.5", "planned").set("window", window);
        planned.bits_of_all_pairs(ask, &scenes::official(), 200);
        planned.bits_of_all_pairs(ask, &scenes::dense(), 32);
        planned.bits_of_all_pairs(ask, &scenes::close_pairs(), 32);
        for scene in scenes::fast() {
            planned.bits_of_all_pairs(ask, &scene, 32);
        }
        planned.bits_of_all_pairs(ask, &scenes::crowd(1), 16);
    }
}

/// Returns a scene in which a reflected particle comes within reach of particle 1, which is at
/// rest. The reflected particle is far from the wall when the window begins, and reaches the wall
/// seven steps later. A crowd is elsewhere.
fn thrown_back() -> Scene {
    let wall = 60.0;
    let speed = 9.0_f64.hypot(7.0);
    let at = |cutoffs: f64, up: f64, vx: f64, vy: f64| {
        let share = cutoffs / speed;
        let [x, y] = [9.0 * share * CUTOFF, (wall + up * 7.0 * share) * CUTOFF];
        Particle { x, y, vx, vy, id: 0 }
    };
    let step = speed * common::soft::DT / CUTOFF;
    let mut particles = vec![at(7.5 * step, -1.0, -9.0, 7.0), at(1.2, 1.0, 0.0, 0.0)];
    let mut random = Random::new(6);
    for k in 0..2500 {
        let [x, y] = [k % 50, k / 50].map(|place| 1.0 + 2.2 * f64::from(place));
        if x > 8.0 || (y - wall).abs() > 8.0 {
            let [vx, vy] = [0; 2].map(|_| random.between(-1.0, 1.0));
            particles.push(Particle { x: x * CUTOFF, y: y * CUTOFF, vx, vy, id: 0 });
        }
    }
    Scene::new(1.1, particles).expect("the scene is valid")
}

pub(crate) fn back_from_a_wall(_: &mut Random, ask: &mut impl Ask) {
    let scene = thrown_back();
    let planned = variant("11.5", "planned").set("window", 16.0);
    let question = "a particle comes back from a wall in a window of 16 steps. A second particle rests in its way: vx \
                    of the second particle, which must not stay 0";
    let found = || vec![of_numbers(&end(&planned, &scene, 16))[1].vx];
    ask.judge(question, found, |found| match found {
        [vx] if *vx != 0.0 => Ok(()),
        _ => Err("the two particles have not met".into()),
    });
    planned.bits_of_all_pairs(ask, &scene, 32);
}

pub(crate) fn redone(_: &mut Random, ask: &mut impl Ask) {
    let scene = scattered(100, 0.3, 1);
    let planned = variant("11.5", "planned").set("window", 64.0);
    planned.bits_of_all_pairs(ask, &scene, 64);
    let question = "100 particles, windows of 64 steps: number of windows that are computed again, which must be more \
                    than 0";
    let found = || vec![counted(&planned, "windows redone", &scene, 64)];
    ask.judge(question, found, |found| match found {
        [redone] if *redone > 0.0 => Ok(()),
        _ => Err("no window is computed again, although the scene is too crowded for such windows"
            .into()),
    });
}

/// Checks that every step agrees with the model, on scenes of all kinds and on `crowds` crowds.
pub(crate) fn follows_the_model(ask: &mut impl Ask, planned: Runs, crowds: u64) {
    planned.resynchronised(ask, &scenes::official(), 100);
    planned.resynchronised(ask, &scenes::dense(), 20);
    planned.resynchronised_on_each(ask, scenes::edges(), 3);
    planned.resynchronised(ask, &scenes::close_pairs(), 20);
    planned.resynchronised_on_each(ask, scenes::fast().to_vec(), 20);
    planned.resynchronised_on_each(ask, (1..=crowds).map(scenes::crowd).collect(), 2);
    planned.forces(ask);
}

pub(crate) fn beside_the_list(ask: &mut impl Ask) {
    let scene = Scene::official(3000, 5).expect("the scene is valid");
    for window in [0.0, 6.0] {
        let planned = by_choice("11.6").set("window", window);
        let question = format!(
            "{}, windows of {window} steps (0: the planner's choice), 3,000 particles, seed 5: x y vx vy of each \
             particle after 200 steps",
            planned.name()
        );
        let found = || end(&planned, &scene, 200);
        ask.judge(&question, found, |found| near_the_list(found, &scene, 200, 1));
    }
}

pub(crate) fn steps_in_a_row(_: &mut Random, ask: &mut impl Ask) {
    let scene = Scene::official(2000, 2).expect("the scene is valid");
    let planned = variant("11.6", "planned");
    let in_windows = planned.clone().set("window", 6.0);
    for runs in [planned, in_windows, variant("11.6", "substep")] {
        let question = format!(
            "{}, 2,000 particles, seed 2: x y vx vy of each particle (1) after 1, 7, 1 and 11 steps in a row, (2) \
             after 1, 8, 9 and 20 single steps",
            runs.name()
        );
        let found = || {
            let one_by_one = [1, 8, 9, 20].map(|steps| end(&runs, &scene, steps));
            [in_a_row(&runs, &scene), one_by_one.concat()].concat()
        };
        ask.judge(&question, found, |found| {
            let (in_a_row, one_by_one) = found.split_at(found.len() / 2);
            if in_a_row == one_by_one {
                Ok(())
            } else {
                Err("the run with steps in a row and the run with single steps ended with different bits".into())
            }
        });
    }
}

/// Returns the concatenated states after runs of 1, 7, 1 and 11 steps.
fn in_a_row(runs: &Runs, scene: &Scene) -> Vec<f64> {
    let scene = scene.clone();
    runs.clone().threads(2).run(move |engine| {
        engine.load(&scene);
        let run = |steps| {
            engine.run(steps);
            numbers(&particles(engine, scene.len()))
        };
        [1, 7, 1, 11].map(run).concat()
    })
}
