use std::f64::consts::PI;

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation, Statistics};
use lab10::{Engine, Tasks, VARIANTS, best_skin, collect, expired, filter};
use neighbour_list_core::kernels::ROOM;
use neighbour_list_core::{AnyProcessor, Bodies, NeighbourList, Workers};
use oracle::{Grader, Random, apart, ask, right, scenes};
use watched::test;

#[path = "lab10/questions.rs"]
mod questions;

#[test]
fn task_10_1_velocities_first_then_positions() {
    questions::moves(&mut Random::new(1), &mut right);
}

#[test]
fn task_10_1_outside_is_beyond_either_wall() {
    questions::walls(&mut Random::new(2), &mut right);
}

#[test]
fn task_10_2_lists_exactly_the_pairs_within_reach() {
    questions::lists(&mut Random::new(3), &mut right);
}

#[test]
fn task_10_2_at_reach_is_within() {
    questions::reaches(&mut Random::new(4), &mut right);
}

#[test]
fn task_10_2_table_of_pairs() {
    // A dozen particles in a row, further and further apart.
    let mut bodies = Bodies::default();
    for id in 0..12 {
        let x = 0.3 + 0.05 * f64::from(id * id);
        bodies.push(Particle { x: x * CUTOFF, id, ..Particle::default() });
    }
    let mut table =
        format!("{:>8} {:>5}   {:<14}{:<22}{}\n", "particle", "x", "reach 1", "1.5", "2");
    for i in 0..12 {
        let listed = |reach: f64| {
            let mut list = [[77; 2]; 12 + 8];
            let len = collect(
                &mut list,
                0,
                bodies.positions(),
                i,
                i + 1..12,
                reach * CUTOFF,
                AnyProcessor,
            );
            list[..len].iter().map(|[_, j]| format!("{j} ")).collect::<String>()
        };
        let x = bodies.x[i] / CUTOFF;
        let [one, more, most] = [1.0, 1.5, 2.0].map(listed);
        let row = format!("{i:>8} {x:>5.2}   {one:<14}{more:<22}{most}");
        table += &format!("{}\n", row.trim_end());
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_10_3_both_of_a_pair_move() {
    for (moved, is) in [(0.0, false), (0.24, false), (0.26, true), (0.49, true), (3.0, true)] {
        let what = format!("two particles flew {moved} cutoffs towards each other, skin 0.5");
        assert_eq!(expired(moved * CUTOFF, 0.5 * CUTOFF), is, "{what}: has the list expired?");
    }
    questions::expiry(&mut Random::new(5), &mut right);
}

#[test]
fn task_10_3_no_other_skin_is_cheaper() {
    questions::skins(&mut Random::new(6), &mut right);
}

#[test]
fn task_10_3_table_of_skins() {
    let speeds = [0.01, 0.03, 0.05, 0.1, 0.3];
    let mut table = String::from("the cheapest skin, in cutoffs\n\n");
    table += "neighbours   cutoffs that a particle goes in a step\n";
    table += &format!("{:>10}", "");
    table += &speeds.map(|speed| format!("{speed:>8}")).concat();
    table += "\n";
    for neighbours in [0.1, 0.63, 2.0, 10.0, 60.0] {
        let density = neighbours / (PI * CUTOFF * CUTOFF);
        let skins = speeds.map(|speed| best_skin(density, speed * CUTOFF) / CUTOFF);
        table += &format!("{neighbours:>10}");
        table += &skins.map(|skin| format!("{skin:>8.2}")).concat();
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_10_4_pairs_within_the_distance() {
    questions::near(&mut Random::new(7), &mut right);
}

#[test]
fn task_10_5_the_outer_list_has_each_pair_once() {
    questions::outer_lists(&mut Random::new(8), &mut right);
}

#[test]
fn task_10_5_the_inner_list_has_the_near_ones_in_order() {
    questions::inner_lists(&mut Random::new(9), &mut right);
}

#[test]
fn task_10_5_rounding_hides_no_pair() {
    questions::margins(&mut Random::new(14), &mut right);
}

#[test]
fn task_10_5_skins_for_how_far_the_fastest_goes_in_a_step() {
    questions::chosen_skins(&mut Random::new(13), &mut right);
}

#[test]
fn task_10_6_accelerations_of_both_particles() {
    questions::accelerations(&mut Random::new(10), &mut right);
}

/// The student's engine. A step is asked first that needs no list.
fn serial() -> Grader {
    let mut engine = Engine::<NoStatistics>::new(0.0, true);
    engine.load(&scenes::official());
    engine.step();
    Grader::new("10.6", VARIANTS, "serial-list")
}

#[test]
fn task_10_6_a_step_makes_both_lists_older() {
    let mut engine = Engine::<NoStatistics>::new(1.0, true);
    // In the first step one of two at rest is pushed away.
    let at = |x: f64| Particle { x, y: 0.5, ..Particle::default() };
    let scene = Scene::new(1.0, vec![at(0.5), at(0.5 + 0.9 * CUTOFF), at(0.1)]).expect("a scene");
    engine.load(&scene);
    let mut gone = 0.0;
    for step in 1..=3 {
        engine.step();
        let moved = engine.bodies.fastest() * DT;
        gone += moved;
        let [outer, inner] = [&engine.outer, &engine.inner].map(|list| list.displacement);
        assert!(
            inner.is_finite(),
            "step {step}: there is no inner list after it. A new outer list comes first, and ends the inner one"
        );
        let off = (outer / gone - 1.0).abs();
        assert!(
            off < 1e-6,
            "step {step}: since the lists were built the fastest particle has gone {:.3e} c, after each move its \
             speed times dt; the outer list says {:.3e} c",
            gone / CUTOFF,
            outer / CUTOFF
        );
        assert!(outer > gone, "step {step}: a displacement grows by what rounding may add, too");
        assert!(
            inner >= moved * (1.0 - 1e-6),
            "in step {step} a particle went {:.3e} c, the inner list says {:.3e} c since it was built",
            moved / CUTOFF,
            inner / CUTOFF
        );
    }
}

#[test]
fn task_10_6_serial_list_follows_the_model() {
    for grader in [serial(), serial().set("inner", 0.0), serial().set("skin", 0.3)] {
        grader.resynchronised(&scenes::official(), 60);
        grader.resynchronised(&scenes::dense(), 20);
        grader.resynchronised_on_each(scenes::edges(), 3);
        grader.resynchronised(&scenes::close_pairs(), 20);
        grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
    }
    serial().crowds();
    serial().forces();
    serial().official_bytes();
}

#[test]
fn task_10_6_serial_list_statistics_and_memory() {
    serial().statistics_of_each_step(&scenes::dense(), 10);
    apart(|| serial().keeps_its_memory());
}

#[test]
fn task_10_6_two_meet_after_half_a_skin_each() {
    // They fly 0.05 c in a step, so the list expires after ten steps; then they are closer than c. At first
    // they are too far apart to be listed.
    let skin = 0.97;
    let at = |x: f64, vx: f64| Particle { x: x * CUTOFF, y: 0.05, vx, vy: 0.0, id: 0 };
    let scene = Scene::new(0.1, vec![at(3.0, 1.0), at(3.0 + 1.985, -1.0)]).expect("a scene");
    serial().set("skin", skin).resynchronised(&scene, 40);
    neighbour_list().set("skin", skin).resynchronised(&scene, 40);
}

#[test]
fn task_10_6_the_same_bits_as_the_library() {
    // With so thin a skin both sort in each step, so they add in the same order.
    let bits = |variant: &str, scene: &Scene| {
        let grader = Grader::new("10.6", VARIANTS, variant).set("skin", 1e-4);
        let seen = grader.ends(scene, 50);
        seen.iter().flat_map(|p| [p.x, p.y, p.vx, p.vy].map(f64::to_bits)).collect::<Vec<_>>()
    };
    for scene in
        [scenes::official(), scenes::dense(), scenes::crowd(3), scenes::cloud(2500, 40.0, 4)]
    {
        let n = scene.len();
        let [own, library] = ["serial-list", "neighbour-list"].map(|variant| bits(variant, &scene));
        let other = own.iter().zip(&library).filter(|(a, b)| a != b).count();
        assert_eq!(
            other, 0,
            "numbers of {n} particles that are not the library's after 50 steps: it lists the same pairs, in the \
             order of i, and adds them in that order"
        );
    }
}

#[test]
fn task_10_6_a_list_lasts() {
    let mut engine = Engine::<NoStatistics>::new(0.0, true);
    engine.load(&Scene::official(2000, 3).expect("a scene"));
    engine.run(200);
    let counted = |name: &str| {
        let counters = engine.counters();
        counters.into_iter().find(|(counter, _)| *counter == name).expect("it is counted").1
    };
    let (lasts, tests) =
        (counted("steps per rebuild"), counted("pair tests per particle and step"));
    assert!(
        lasts > 7.0,
        "a list of the official scene lasts for {lasts:.1} steps, nine are possible"
    );
    assert!(
        tests < 2.0,
        "{tests:.2} listed pairs a particle and step were looked at, 1.3 are enough"
    );
}

/// The library's engine on all threads, however small the scene. It calls the functions of 10.1 to 10.4;
/// the last one is asked first.
fn neighbour_list() -> Grader {
    let found = filter(&[], Bodies::default().positions(), 1.0, &mut [[0; 2]; ROOM]);
    assert_eq!(found, 0, "of no pairs none is near");
    Grader::new("10.4", VARIANTS, "neighbour-list").set("share", 1.0)
}

#[test]
fn task_10_4_verlet_follows_the_model() {
    let grader = neighbour_list();
    grader.resynchronised(&scenes::official(), 200);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
    grader.resynchronised(&scenes::close_pairs(), 20);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
    grader.crowds();
    grader.forces();
}

#[test]
fn task_10_4_verlet_statistics() {
    neighbour_list().statistics_of_each_step(&scenes::dense(), 10);
    neighbour_list().set("skin", 1.0).statistics_of_each_step(&scenes::official(), 40);
    // An official step is seen at its beginning, into however many it is divided.
    let seen = |divide: f64| {
        let grader = neighbour_list().set("divide", divide).statistics();
        grader.run(|_, engine| {
            engine.load(&scenes::dense());
            engine.step();
            let Statistics { dmin, navg, .. } = engine.statistics().expect("they were asked for");
            (dmin, navg)
        })
    };
    assert_eq!(seen(1.0), seen(10.0), "least distance and contacts");
}

#[test]
fn task_10_4_verlet_reproduces_the_official_output() {
    neighbour_list().official_bytes();
}

#[test]
fn task_10_4_verlet_is_the_same_on_any_number_of_threads() {
    let grader = neighbour_list();
    grader.same_bits_on_threads(&scenes::cloud(3000, 60.0, 3), 10, &[1, 2, 3, 4, 8]);
}

#[test]
fn task_10_4_steps_in_a_row_are_steps_one_by_one() {
    let scene = Scene::official(2000, 2).expect("a scene");
    let _ = neighbour_list();
    let [in_a_row, one_by_one] = [true, false].map(|in_a_row| {
        let mut engine = NeighbourList::<NoStatistics, Tasks>::new(Workers::new(2), 0.0, 1);
        engine.load(&scene);
        if in_a_row {
            [7, 1, 12].into_iter().for_each(|steps| engine.run(steps));
        } else {
            (0..20).for_each(|_| engine.step());
        }
        let mut seen = vec![Particle::default(); scene.len()];
        engine.read(0, &mut seen);
        seen
    });
    assert!(in_a_row == one_by_one, "20 steps in a row gave other bits than one by one");
}

#[test]
fn task_10_4_rows_longer_than_blocks() {
    // In a flat strip the row ahead of a particle ends several blocks behind its own.
    let mut random = Random::new(8);
    let at = |k: u32, random: &mut Random| Particle {
        x: (0.5 + 0.5 * f64::from(k % 3000)) * CUTOFF,
        y: (1.0 + 0.9 * f64::from(k / 3000) + random.between(-0.1, 0.1)) * CUTOFF,
        vx: random.between(-1.0, 1.0),
        vy: random.between(-1.0, 1.0),
        id: k,
    };
    let particles = (0..9000).map(|k| at(k, &mut random)).collect();
    let scene = Scene::new(15.01, particles).expect("a scene");
    let grader = neighbour_list().set("skin", 0.2);
    grader.resynchronised(&scene, 4);
    grader.same_bits_on_threads(&scene, 4, &[1, 2, 3]);
}

#[test]
fn task_10_4_outliers_of_the_list() {
    let mut random = Random::new(12);
    let side = 100.0 * CUTOFF;
    let at = |k: usize, random: &mut Random| {
        // Three of two thousand are too fast for a list that is made for the rest.
        let speed = [4.0, 6.0, 9.0].get(k / 600).filter(|_| k % 600 == 599).copied().unwrap_or(1.0);
        Particle {
            x: random.between(0.0, side),
            y: random.between(0.0, side),
            vx: speed * random.between(-1.0, 1.0),
            vy: if speed > 1.0 { speed } else { random.between(-1.0, 1.0) },
            id: k as u32,
        }
    };
    let particles = (0..2000).map(|k| at(k, &mut random)).collect();
    let scene = Scene::new(side, particles).expect("a scene");
    let grader = neighbour_list();
    grader.resynchronised(&scene, 60);
    grader.same_bits_on_threads(&scene, 60, &[1, 2, 3]);
}

#[test]
fn task_10_4_a_gas_that_heats_up_gets_new_lists() {
    // Pairs at rest push each other apart: soon all are faster than the list was made for.
    let at = |k: u32| Particle {
        x: (2.0 + 4.0 * f64::from(k / 2 % 50) + 0.9 * f64::from(k % 2)) * CUTOFF,
        y: (2.0 + 4.0 * f64::from(k / 100)) * CUTOFF,
        vx: 1e-3 * f64::from(k % 7),
        vy: 1e-3 * f64::from(k % 11),
        id: k,
    };
    let scene = Scene::new(2.1, (0..5000).map(at).collect()).expect("a scene");
    let grader = neighbour_list();
    let mut engine = NeighbourList::<NoStatistics, Tasks>::new(Workers::new(1), 0.0, 1);
    engine.load(&scene);
    engine.run(100);
    let counters = engine.counters();
    let counted = counters.iter().find(|(name, _)| *name == "share that outruns the list");
    let (_, outliers) = counted.expect("it is counted");
    assert!(*outliers < 0.3, "{outliers} of all are outliers");
    grader.resynchronised(&scene, 10);
}
