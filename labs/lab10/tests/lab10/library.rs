//! Questions about the library's engine with the functions of tasks 10.1 to 10.4.

use common::soft::{CUTOFF, NoStatistics, Particle, Scene, Simulation};
use lab10::{Tasks, VARIANTS, filter};
use neighbour_list_core::kernels::ROOM;
use neighbour_list_core::{Bodies, NeighbourList, Workers};
use oracle::{Ask, Random, Runs, States, scenes};

/// Returns runs of the library's engine on all threads, for scenes of any size. An unsolved starter
/// stops at the `todo!` of task 10.4.
pub(crate) fn neighbour_list() -> Runs {
    filter(&[], Bodies::default().positions(), 1.0, &mut [[0; 2]; ROOM]);
    Runs::new("10.4", VARIANTS, "neighbour-list").set("share", 1.0)
}

pub(crate) fn verlet_steps(_: &mut Random, ask: &mut impl Ask) {
    let runs = neighbour_list();
    runs.resynchronised(ask, &scenes::official(), 200);
    runs.resynchronised(ask, &scenes::dense(), 20);
    runs.resynchronised_on_each(ask, scenes::edges(), 3);
    runs.resynchronised(ask, &scenes::close_pairs(), 20);
    runs.resynchronised_on_each(ask, scenes::fast().to_vec(), 20);
    runs.crowds(ask);
    runs.forces(ask);
}

pub(crate) fn verlet_statistics(_: &mut Random, ask: &mut impl Ask) {
    neighbour_list().statistics_of_each_step(ask, &scenes::dense(), 10);
    neighbour_list().set("skin", 1.0).statistics_of_each_step(ask, &scenes::official(), 40);
    let question = "a dense box, once with an undivided official step, and once with an official step that is divided \
                    into ten parts: dmin and navg of each run, at the beginning of the step";
    let found = || [1.0, 10.0].map(seen_in_a_step).concat();
    ask.judge(question, found, |found| match found {
        [dmin, navg, dmin_of_ten, navg_of_ten] if dmin == dmin_of_ten && navg == navg_of_ten => {
            Ok(())
        }
        _ => Err(format!("     found: {found:?}\n  expected: the same two numbers twice")),
    });
}

fn seen_in_a_step(divide: f64) -> Vec<f64> {
    neighbour_list().set("divide", divide).statistics().run(|engine| {
        engine.load(&scenes::dense());
        engine.step();
        let seen = engine.statistics().expect("the engine was built with statistics");
        vec![seen.dmin, seen.navg as f64]
    })
}

pub(crate) fn verlet_bytes(_: &mut Random, ask: &mut impl Ask) {
    neighbour_list().official_bytes(ask);
}

pub(crate) fn verlet_threads(_: &mut Random, ask: &mut impl Ask) {
    let scene = scenes::cloud(3000, 60.0, 3);
    neighbour_list().same_bits_on_threads(ask, &scene, 10, &[1, 2, 3, 4, 8]);
}

pub(crate) fn in_a_row(_: &mut Random, ask: &mut impl Ask) {
    let scene = Scene::official(2000, 2).expect("the scene is valid");
    neighbour_list();
    let found = || {
        let states = [&[7, 1, 12][..], &[1; 20]].map(|parts| state_after(&scene, parts));
        states.concat()
    };
    let question = "the official scene with 2,000 particles on two threads, 20 steps: (1) x y vx vy of each particle \
                    after 7, 1 and 12 steps in a row, (2) x y vx vy of each particle after 20 single steps";
    ask.judge(question, found, |found| {
        let mut rest = found;
        let in_a_row = States::split(&mut rest, scene.len(), 1)?.numbers();
        let one_by_one = States::split(&mut rest, scene.len(), 1)?.numbers();
        let odd = in_a_row.iter().zip(&one_by_one).position(|(a, b)| a.to_bits() != b.to_bits());
        odd.map_or(Ok(()), |k| {
            Err(format!("particle {} has different bits after the single steps", k / 4))
        })
    });
}

/// Returns the state after these numbers of steps, one run after the other.
fn state_after(scene: &Scene, parts: &[u64]) -> Vec<f64> {
    let mut engine = NeighbourList::<NoStatistics, Tasks>::new(Workers::if_possible(2), 0.0, 1);
    engine.load(scene);
    for &steps in parts {
        engine.run(steps);
    }
    let mut seen = vec![Particle::default(); scene.len()];
    engine.read(0, &mut seen);
    States::of(&seen).numbers()
}

/// Asks about a flat strip, in which the row above a particle ends several blocks after the
/// particle's block.
pub(crate) fn long_rows(random: &mut Random, ask: &mut impl Ask) {
    let particles = (0..9000).map(|k| Particle {
        x: (0.5 + 0.5 * f64::from(k % 3000)) * CUTOFF,
        y: (1.0 + 0.9 * f64::from(k / 3000) + random.between(-0.1, 0.1)) * CUTOFF,
        vx: random.between(-1.0, 1.0),
        vy: random.between(-1.0, 1.0),
        id: k,
    });
    let scene = Scene::new(15.01, particles.collect()).expect("the scene is valid");
    let runs = neighbour_list().set("skin", 0.2);
    runs.resynchronised(ask, &scene, 4);
    runs.same_bits_on_threads(ask, &scene, 4, &[1, 2, 3]);
}

/// Asks about two thousand particles, three of which are too fast for a list that suits the others.
pub(crate) fn outliers(random: &mut Random, ask: &mut impl Ask) {
    let side = 100.0 * CUTOFF;
    let particles = (0..2000).map(|k| {
        let speed = match k {
            599 => 4.0,
            1199 => 6.0,
            1799 => 9.0,
            _ => 1.0,
        };
        Particle {
            x: random.between(0.0, side),
            y: random.between(0.0, side),
            vx: speed * random.between(-1.0, 1.0),
            vy: if speed > 1.0 { speed } else { random.between(-1.0, 1.0) },
            id: k,
        }
    });
    let scene = Scene::new(side, particles.collect()).expect("the scene is valid");
    neighbour_list().resynchronised(ask, &scene, 60);
    neighbour_list().same_bits_on_threads(ask, &scene, 60, &[1, 2, 3]);
}

/// Asks about pairs at rest that push each other apart. Soon all particles are faster than the list
/// expects.
pub(crate) fn heating_up(_: &mut Random, ask: &mut impl Ask) {
    let at = |k: u32| Particle {
        x: (2.0 + 4.0 * f64::from(k / 2 % 50) + 0.9 * f64::from(k % 2)) * CUTOFF,
        y: (2.0 + 4.0 * f64::from(k / 100)) * CUTOFF,
        vx: 1e-3 * f64::from(k % 7),
        vy: 1e-3 * f64::from(k % 11),
        id: k,
    };
    let scene = Scene::new(2.1, (0..5000).map(at).collect()).expect("the scene is valid");
    let runs = neighbour_list();
    let question = "5,000 particles at rest in pairs that push each other apart, 100 steps: share of the particles \
                    that are too fast for the list. It must be less than 0.3";
    ask.judge(
        question,
        || vec![share_of_outliers(&scene)],
        |found| match found {
            [share] if *share < 0.3 => Ok(()),
            _ => Err(format!("     found: {found:.3?}")),
        },
    );
    runs.resynchronised(ask, &scene, 10);
}

fn share_of_outliers(scene: &Scene) -> f64 {
    let mut engine = NeighbourList::<NoStatistics, Tasks>::new(Workers::if_possible(1), 0.0, 1);
    engine.load(scene);
    engine.run(100);
    let counters = engine.counters();
    let counted = counters.iter().find(|(name, _)| *name == "share that outruns the list");
    counted.expect("the engine counts this").1
}
