//! Questions about the steps of the engine, task 10.6.

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation};
use lab10::{Engine, VARIANTS};
use oracle::scenes::spread;
use oracle::{Ask, Random, Runs, States, drawn, scenes};

use super::forces::no_forces;
use super::library::neighbour_list;
use super::scenes::particles;

/// Returns runs of the student's engine.
fn serial() -> Runs {
    no_forces();
    Runs::new("10.6", VARIANTS, "serial-list")
}

/// Asks about two particles at rest, one of which is pushed away in the first step, so that
/// displacements begin to grow.
pub(crate) fn ages(_: &mut Random, ask: &mut impl Ask) {
    no_forces();
    let at = |x: f64| Particle { x, y: 0.5, ..Particle::default() };
    let three = vec![at(0.5), at(0.5 + 0.9 * CUTOFF), at(0.1)];
    let mut engine = Engine::<NoStatistics>::new(1.0, true);
    engine.load(&Scene::new(1.0, three).expect("all particles are in the box"));
    let mut found = Vec::new();
    for _ in 0..3 {
        engine.step();
        let moved = engine.bodies.fastest() * DT;
        found.extend([moved, engine.outer.displacement, engine.inner.displacement]);
    }
    let question = "two touching particles at rest and a third particle, skin 1 cutoff. After each of three steps, in \
                    units of length: (1) the distance that the fastest particle went in the step, (2) the \
                    displacement of the outer list, (3) the displacement of the inner list";
    ask.judge(question, || found, are_older);
}

/// Checks that displacements grow by the distance that the fastest particle moves in each step, up
/// to rounding.
fn are_older(found: &[f64]) -> Result<(), String> {
    let mut gone = 0.0;
    for (step, &[moved, outer, inner]) in found.as_chunks::<3>().0.iter().enumerate() {
        let step = step + 1;
        gone += moved;
        if !inner.is_finite() {
            return Err(format!(
                "step {step}: there is no inner list after this step. Build the outer list before the inner one, \
                 because a new outer list makes the inner list invalid"
            ));
        }
        if (outer / gone - 1.0).abs() > 1e-6 {
            return Err(format!(
                "step {step}: since the lists were built, the fastest particle has gone {:.3e} cutoffs (in each step, \
                 its speed after the move times dt), but the displacement of the outer list is {:.3e} cutoffs",
                gone / CUTOFF,
                outer / CUTOFF
            ));
        }
        if outer <= gone {
            return Err(format!(
                "step {step}: the displacement is too small. In each step, add also the distance by which rounding \
                 may move a particle"
            ));
        }
        if inner < moved * (1.0 - 1e-6) {
            return Err(format!(
                "step {step}: a particle went {:.3e} cutoffs, but the displacement of the inner list is only {:.3e} \
                 cutoffs",
                moved / CUTOFF,
                inner / CUTOFF
            ));
        }
    }
    Ok(())
}

pub(crate) fn steps(_: &mut Random, ask: &mut impl Ask) {
    for runs in [serial(), serial().set("inner", 0.0), serial().set("skin", 0.3)] {
        runs.resynchronised(ask, &scenes::official(), 60);
        runs.resynchronised(ask, &scenes::dense(), 20);
        runs.resynchronised_on_each(ask, scenes::edges(), 3);
        runs.resynchronised(ask, &scenes::close_pairs(), 20);
        runs.resynchronised_on_each(ask, scenes::fast().to_vec(), 20);
    }
    serial().crowds(ask);
    serial().forces(ask);
}

/// Asks about crowds, a box with few neighbours, pairs across edges of cells, and a pile of
/// particles.
pub(crate) fn drawn_boxes(random: &mut Random, ask: &mut impl Ask) {
    for runs in [serial(), serial().set("inner", 0.0)] {
        let n = 200 + random.below(200);
        let size = random.between(0.12, 0.17);
        let all = [
            spread(random, n, size, 1.0),
            spread(random, n, 1.0, 3.0),
            drawn::pairs_over_edges(random),
            drawn::heap(random),
        ];
        for scene in all {
            runs.resynchronised(ask, &scene, 15 + random.below(30));
        }
    }
}

pub(crate) fn official_bytes(_: &mut Random, ask: &mut impl Ask) {
    serial().official_bytes(ask);
}

pub(crate) fn statistics(_: &mut Random, ask: &mut impl Ask) {
    serial().statistics_of_each_step(ask, &scenes::dense(), 10);
}

pub(crate) fn memory(_: &mut Random, ask: &mut impl Ask) {
    serial().keeps_its_memory(ask);
}

/// Asks about two particles that fly 0.05 cutoffs in a step, so that the list expires after ten
/// steps. At first they are too far apart to be listed; when the list expires they are closer than
/// a cutoff.
pub(crate) fn two_meet(_: &mut Random, ask: &mut impl Ask) {
    let at = |x: f64, vx: f64| Particle { x: x * CUTOFF, y: 0.05, vx, ..Particle::default() };
    let scene =
        Scene::new(0.1, vec![at(3.0, 1.0), at(3.0 + 1.985, -1.0)]).expect("the scene is valid");
    serial().set("skin", 0.97).resynchronised(ask, &scene, 40);
    neighbour_list().set("skin", 0.97).resynchronised(ask, &scene, 40);
}

/// Asks for the bits of the library's engine. With a very thin skin both engines sort in each step,
/// so they add in the same order.
pub(crate) fn library_bits(_: &mut Random, ask: &mut impl Ask) {
    for scene in
        [scenes::official(), scenes::dense(), scenes::crowd(3), scenes::cloud(2500, 40.0, 4)]
    {
        let own = serial().set("skin", 1e-4);
        let question = format!(
            "{}, {}, 50 steps: x y vx vy of each particle at the end, which must have the same bits as in \
             `neighbour-list`. That variant lists the same pairs in the order of i, and adds the forces in this order",
            own.name(),
            particles(scene.len())
        );
        ask.exact(
            &question,
            || end(&own, &scene),
            || end(&Runs::new("10.6", VARIANTS, "neighbour-list").set("skin", 1e-4), &scene),
        );
    }
}

fn end(runs: &Runs, scene: &Scene) -> Vec<f64> {
    let scene = scene.clone();
    runs.run(move |engine| States::of_end(engine, &scene, 50).numbers())
}

/// Asks how long lists last with the cheapest skin.
pub(crate) fn a_list_lasts(_: &mut Random, ask: &mut impl Ask) {
    no_forces();
    let mut engine = Engine::<NoStatistics>::new(0.0, true);
    engine.load(&Scene::official(2000, 3).expect("the scene is valid"));
    engine.run(200);
    let question = "the official scene with 2,000 particles, 200 steps: (1) number of steps that a list lasts, (2) \
                    number of pair tests for each particle in a step";
    let found = || {
        ["steps per rebuild", "pair tests per particle and step"]
            .map(|name| counted(&engine, name))
            .to_vec()
    };
    ask.judge(question, found, |found| match found {
        [lasts, tests] if *lasts > 7.0 && *tests < 2.0 => Ok(()),
        _ => Err(format!(
            "     found: {found:.2?}\n  expected: (1) more than 7 steps (9 are possible), (2) less than 2 pair tests"
        )),
    });
}

/// Asks for the steps in which lists are rebuilt. With a given skin, the speeds determine the steps
/// in which the list expires.
pub(crate) fn rebuilds(random: &mut Random, ask: &mut impl Ask) {
    no_forces();
    for skin in [0.3, random.between(0.5, 2.0), 2.5] {
        let n = 500 + random.below(1000);
        let mut engine = Engine::<NoStatistics>::new(skin, true);
        engine.load(&spread(random, n, (0.0005 * n as f64).sqrt(), 1.0));
        let mut found = Vec::new();
        for _ in 0..100 {
            engine.step();
            found.push(engine.bodies.fastest() * DT);
        }
        found.push(100.0 / counted(&engine, "steps per rebuild"));
        let question = format!(
            "{n} particles in a box like the official box, skin {skin:.4} cutoffs: (1) for each of 100 steps, the \
             distance that the fastest particle moves in the step, (2) the number of outer lists built"
        );
        ask.judge(&question, || found, |found| are_rebuilt(skin * CUTOFF, found));
    }
}

fn are_rebuilt(skin: f64, found: &[f64]) -> Result<(), String> {
    let Some((lists, distances)) = found.split_last() else {
        return Err("the answer is empty".into());
    };
    let mut right = 0.0;
    let mut gone = f64::INFINITY;
    for distance in distances {
        if 2.0 * gone > skin {
            right += 1.0;
            gone = 0.0;
        }
        gone += distance;
    }
    if (lists - right).abs() < 1e-6 {
        return Ok(());
    }
    Err(format!(
        "{lists:.1} lists were built, but {right} were needed: the first list, and one list after each list that \
         expired"
    ))
}

fn counted(engine: &Engine<NoStatistics>, name: &str) -> f64 {
    let counters = engine.counters();
    counters.into_iter().find(|(counter, _)| *counter == name).expect("the engine counts this").1
}
