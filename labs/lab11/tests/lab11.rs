//! Lab 11's graders.

use std::f64::consts::PI;

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation};
use lab11::{LONGEST, Tasks, VARIANTS, closest_squared, join, meets_wall, root, window_length};
use neighbour_list::{Bodies, NeighbourList, Workers};
use oracle::{Grader, Random, apart, ask, right, scenes, within};
use watched::test;
use windows::{Span, Strategy, plan};

#[path = "lab11/questions.rs"]
mod questions;

fn grader(task: &'static str, variant: &str) -> Grader {
    Grader::new(task, VARIANTS, variant)
}

/// The engine of a variant.
fn engine(variant: &str, parameters: &[(&str, f64)], threads: usize) -> Box<dyn Simulation> {
    let variant = VARIANTS.iter().find(|v| v.name == variant).expect("the lab has it");
    let mut config = variant.config().with_threads(threads);
    for (parameter, value) in parameters {
        variant.set(&mut config, parameter, *value).expect("the variant has it");
    }
    (variant.build)(&config).expect("it builds")
}

/// The particles after `steps` steps of a variant.
fn run(variant: &str, parameters: &[(&str, f64)], scene: &Scene, steps: usize) -> Vec<Particle> {
    particles(engine(variant, parameters, 1).as_mut(), scene, steps)
}

/// The particles after `steps` steps with a neighbour list, each divided into `divide`.
fn plain(divide: u32, scene: &Scene, steps: usize) -> Vec<Particle> {
    let mut engine = NeighbourList::<NoStatistics>::new(Workers::default(), 0.0, divide);
    particles(&mut engine, scene, steps)
}

/// The particles after `steps` steps of an engine.
fn particles(engine: &mut dyn Simulation, scene: &Scene, steps: usize) -> Vec<Particle> {
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    let mut out = vec![Particle::default(); scene.len()];
    engine.read(0, &mut out);
    out
}

fn farthest(a: &[Particle], b: &[Particle]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y)).fold(0.0, f64::max)
}

/// What a variant counted under this name, in a run of its own.
fn counted(name: &str, variant: &str, params: &[(&str, f64)], scene: &Scene, steps: usize) -> f64 {
    let mut engine = engine(variant, params, 1);
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    engine.counters().iter().find(|(counter, _)| *counter == name).expect("it is counted").1
}

#[test]
fn task_11_1_free_flight_adds_step_by_step() {
    questions::flights(&mut Random::new(1), &mut right);
}

#[test]
fn task_11_2_closest_approach() {
    questions::approaches(&mut Random::new(2), &mut right);
}

#[test]
fn task_11_2_table_of_closest_approaches() {
    let cases = [
        ("at rest to each other", (3.0, 4.0), (0.0, 0.0)),
        ("head on", (3.0, 0.0), (-1.0, 0.0)),
        ("past each other", (3.0, 1.0), (-1.0, 0.0)),
        ("too slow to meet", (3.0, 1.0), (-0.25, 0.0)),
        ("apart", (3.0, 1.0), (1.0, 0.0)),
        ("side by side", (0.0, 1.2), (0.5, 0.0)),
        ("at one position", (0.0, 0.0), (1.0, 1.0)),
    ];
    let spans = [0.0, 1.0, 2.0, 4.0, 8.0];
    let mut table = format!("{:<24}least distance within a time of\n{:<21}", "", "");
    table += &spans.map(|span| format!("{span:>8}")).concat();
    table += "\n";
    for (name, d, w) in cases {
        table += &format!("{name:<21}");
        let least = |span| closest_squared(d.0, d.1, w.0, w.1, span).sqrt();
        table += &spans.map(|span| format!("{:>8.3}", least(span))).concat();
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_11_3_roots_of_chains_and_trees() {
    questions::roots(&mut Random::new(3), &mut right);
    apart(|| questions::long_chain(&mut right));
}

#[test]
fn task_11_3_two_groups_become_one() {
    questions::joins(&mut Random::new(30), &mut right);
    within("11.3", 30, || questions::many_joins(&mut right));
}

#[test]
fn task_11_3_pairs_join_their_groups() {
    let pairs: [[u32; 2]; 7] = [[4, 7], [2, 9], [7, 9], [1, 5], [9, 4], [3, 8], [8, 5]];
    let mut parent: Vec<u32> = (0..11).collect();
    let mut table = format!("{:<6}the root of each particle\n{:<6}", "pair", "");
    table += &(0..11).map(|k| format!("{k:>3}")).collect::<String>();
    for [a, b] in pairs {
        // Task 11.3 is asked first.
        let before = [a, b].map(|k| root(&mut parent, k));
        join(&mut parent, a, b);
        assert_eq!(root(&mut parent, a), root(&mut parent, b), "{a} and {b}, once of {before:?}");
        table += &format!("\n{:<6}", format!("{a}, {b}"));
        table += &(0..11).map(|k| format!("{:>3}", root(&mut parent, k))).collect::<String>();
    }
    assert!((0..11).all(|k| parent[k as usize] <= k), "a parent is greater: {parent:?}");
    insta::assert_snapshot!(table);
}

#[test]
fn task_11_4_two_may_be_off_their_paths() {
    questions::margins(&mut Random::new(4), &mut right);
}

#[test]
fn task_11_5_a_wall_within_the_window() {
    questions::walls(&mut Random::new(5), &mut right);
}

#[test]
fn task_11_5_windows_have_the_bits_of_all_pairs() {
    // Windows need the tasks before, too; this one is asked first.
    let span = Span { steps: 8, dt: DT, size: 1.0 };
    assert!(!meets_wall(&span, 0.5, 0.5, 1.0, 1.0), "a wall is far from the middle of the box");
    for window in [1.0, 2.0, 5.0, 8.0, 16.0] {
        let grader = grader("11.5", "planned").set("window", window);
        grader.bits_of_all_pairs(&scenes::official(), 200);
        grader.bits_of_all_pairs(&scenes::dense(), 32);
        grader.bits_of_all_pairs(&scenes::close_pairs(), 32);
        for scene in scenes::fast() {
            grader.bits_of_all_pairs(&scene, 32);
        }
        grader.bits_of_all_pairs(&scenes::crowd(1), 16);
    }
}

#[test]
fn task_11_5_one_comes_back_from_a_wall() {
    // It is far from the wall when the window begins, is thrown back seven steps later, and only so
    // comes into reach of the one that waits there.
    let span = Span { steps: 16, dt: DT, size: 1.0 };
    assert!(!meets_wall(&span, 0.5, 0.5, 1.0, 1.0), "a wall is far from the middle of the box");
    let (step, wall) = (9.0_f64.hypot(7.0) * DT / CUTOFF, 60.0);
    let along = |length: f64, up: f64| {
        let share = length / 9.0_f64.hypot(7.0);
        ((9.0 * share) * CUTOFF, (wall + up * 7.0 * share) * CUTOFF)
    };
    let (from, waiting) = (along(7.5 * step, -1.0), along(1.2, 1.0));
    let mut random = Random::new(6);
    let mut particles = vec![
        Particle { x: from.0, y: from.1, vx: -9.0, vy: 7.0, id: 0 },
        Particle { x: waiting.0, y: waiting.1, vx: 0.0, vy: 0.0, id: 0 },
    ];
    for k in 0..2500 {
        let (x, y) = (1.0 + 2.2 * f64::from(k % 50), 1.0 + 2.2 * f64::from(k / 50));
        if x > 8.0 || (y - wall).abs() > 8.0 {
            let (vx, vy) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            particles.push(Particle { x: x * CUTOFF, y: y * CUTOFF, vx, vy, id: 0 });
        }
    }
    let scene = Scene::new(1.1, particles).expect("a scene");
    let met = run("planned", &[("window", 16.0)], &scene, 16);
    assert_ne!(met[1].vx, 0.0, "the two were to meet");
    grader("11.5", "planned").set("window", 16.0).bits_of_all_pairs(&scene, 32);
}

#[test]
fn task_11_5_a_window_past_repair_is_redone() {
    let span = Span { steps: 64, dt: DT, size: 1.0 };
    assert!(!meets_wall(&span, 0.5, 0.5, 1.0, 1.0), "a wall is far from the middle of the box");
    let (scene, window) = (scattered(100, 0.3, 1), [("window", 64.0)]);
    grader("11.5", "planned").set("window", 64.0).bits_of_all_pairs(&scene, 64);
    let redone = counted("windows redone", "planned", &window, &scene, 64);
    assert!(redone > 0.0, "the scene was to be too crowded for such windows");
}

#[test]
fn task_11_6_window_lengths() {
    questions::lengths(&mut Random::new(6), &mut right);
}

#[test]
fn task_11_6_planned_statistics() {
    grader("11.6", "planned").statistics_of_each_step(&scenes::dense(), 10);
    grader("11.6", "planned").set("window", 4.0).statistics_of_each_step(&scenes::official(), 10);
}

#[test]
fn task_11_6_table_of_plans() {
    assert_eq!(window_length(2000.0, 0.0), LONGEST, "no particle moves");
    let mut table = format!("{:>10}   {:>22}   {}\n", "neighbours", "planned", "substep");
    let official = Scene::official(2000, 1).expect("a scene");
    for neighbours in [0.01_f64, 0.03, 0.06, 0.1, 0.2, 0.6, 1.2, 5.0] {
        // The official scene, spread or pressed together.
        let stretch = (0.63 / neighbours).sqrt();
        let mut bodies = Bodies::of(&official);
        bodies.x.iter_mut().chain(&mut bodies.y).for_each(|x| *x *= stretch);
        let planned = |divide| {
            let plan = plan::<Tasks>(&bodies, 0, divide);
            format!("{:?}", plan.strategy)
        };
        table += &format!("{neighbours:>10}   {:>22}   {}\n", planned(1), planned(10));
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_11_6_a_crystal_is_not_empty() {
    // Three cutoffs apart: none has another in its cell, and yet soon they meet.
    let mut crystal = Bodies::default();
    for id in 0..2500 {
        let (x, y) = (f64::from(id % 50), f64::from(id / 50));
        let (x, y) = (3.0 * CUTOFF * (1.0 + x), 3.0 * CUTOFF * (1.0 + y));
        crystal.push(Particle { x, y, vx: 1.0, vy: 0.0, id });
    }
    let found = plan::<Tasks>(&crystal, 0, 1).neighbours;
    let expected = PI / 9.0;
    assert!(
        (found - expected).abs() < 0.05 * expected,
        "one particle to nine square cutoffs is {expected:.3} in a cutoff disc, not {found:.3}"
    );
}

/// The planner's own choice, which is a list for most of these scenes, and windows.
fn planned_both_ways() -> [Grader; 2] {
    let planned = on_all_threads("planned");
    [planned.clone(), planned.set("window", 6.0)]
}

/// A grader of a variant that leaves no thread out, however small the scene.
fn on_all_threads(variant: &str) -> Grader {
    grader("11.6", variant).set("share", 1.0)
}

#[test]
fn task_11_6_planned_follows_the_model() {
    for grader in planned_both_ways() {
        grader.resynchronised(&scenes::official(), 100);
        grader.resynchronised(&scenes::dense(), 20);
        grader.resynchronised_on_each(scenes::edges(), 3);
        grader.resynchronised(&scenes::close_pairs(), 20);
        grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
        grader.crowds();
        grader.forces();
    }
}

#[test]
fn task_11_6_memory_does_not_grow() {
    let [by_choice, in_windows] = planned_both_ways();
    apart(|| {
        by_choice.keeps_its_memory();
        in_windows.keeps_its_memory();
    });
}

#[test]
fn task_11_6_planned_reproduces_the_official_output() {
    planned_both_ways().iter().for_each(Grader::official_bytes);
}

#[test]
fn task_11_6_planned_equals_the_plain_engine() {
    let scene = Scene::official(3000, 5).expect("a scene");
    for window in [0.0, 6.0] {
        let planned = run("planned", &[("window", window)], &scene, 200);
        let off = farthest(&planned, &plain(1, &scene, 200));
        assert!(
            off <= 1e-9,
            "windows of {window} steps (0: the planner's choice): after 200 steps a particle is \
             {off:e} from where the plain engine has it"
        );
    }
}

#[test]
fn task_11_6_planned_is_the_same_on_any_number_of_threads() {
    let [by_choice, in_windows] = planned_both_ways();
    by_choice.same_bits_on_threads(&scenes::cloud(1000, 30.0, 3), 20, &[1, 2, 3, 4, 8]);
    let scene = Scene::official(2000, 2).expect("a scene");
    in_windows.same_bits_on_threads(&scene, 20, &[1, 2, 3, 4, 8]);
}

#[test]
fn task_11_6_threads_that_pay() {
    let said = |n, threads: usize| {
        let mut engine = engine("planned", &[], threads);
        engine.load(&Scene::official(n, 1).expect("a scene"));
        engine.plan().expect("it plans").lines().next().expect("a line").to_owned()
    };
    assert_eq!(said(3999, 8), "threads: 1 of 8", "two would have fewer than 2000 particles each");
    assert_eq!(said(4000, 8), "threads: 2 of 8");
    assert_eq!(said(10_000, 3), "threads: 3 of 3");
}

#[test]
fn task_11_6_steps_in_a_row_are_steps_one_by_one() {
    let scene = Scene::official(2000, 2).expect("a scene");
    let ways: [(_, &[_]); 3] =
        [("planned", &[]), ("planned", &[("window", 6.0)]), ("substep", &[])];
    for (name, parameters) in ways {
        let mut engine = engine(name, parameters, 2);
        engine.load(&scene);
        let mut seen = vec![Particle::default(); scene.len()];
        for (steps, so_far) in [(1, 1), (7, 8), (1, 9), (11, 20)] {
            engine.run(steps);
            engine.read(0, &mut seen);
            let same = seen == run(name, parameters, &scene, so_far);
            assert!(
                same,
                "{name} {parameters:?}: {steps} steps in a row, up to step {so_far}, gave other bits than one by one"
            );
        }
    }
}

#[test]
fn task_11_6_a_long_run_on_a_list_counts_every_step() {
    let touched = "particles touched per particle and step";
    let found = counted(touched, "planned", &[], &scenes::official(), 600);
    assert_eq!(found, 1.0, "on a list all particles moves at each step: {touched}");
}

#[test]
fn task_11_6_substeps_are_small_steps() {
    let scene = scenes::official();
    let substeps = run("substep", &[("substeps", 10.0)], &scene, 100);
    let small_steps = plain(10, &scene, 100);
    let off = farthest(&substeps, &small_steps);
    assert!(off <= 1e-9, "after 100 steps a particle is {off:e} from where small steps have it");
}

/// As dense as the official scene and in no order, but no two closer than `least` cutoffs.
fn scattered(n: usize, least: f64, seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let size = (0.0005 * n as f64).sqrt();
    let mut particles: Vec<Particle> = Vec::new();
    while particles.len() < n {
        let (x, y) = (random.between(0.0, size), random.between(0.0, size));
        let (vx, vy) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let p = Particle { x, y, vx, vy, id: particles.len() as u32 };
        if particles.iter().all(|q| q.to(&p).norm_squared() > (least * CUTOFF).powi(2)) {
            particles.push(p);
        }
    }
    Scene::new(size, particles).expect("a scene")
}

#[test]
fn task_11_6_substeps_mend_what_pushes_bend() {
    // Particles that overlap push each other far, out of any margin.
    let scene = scattered(1200, 0.6, 3);
    let again = counted("share computed again", "substep", &[], &scene, 60);
    assert!(again > 0.0, "the scene was to bend paths");
    let substeps = run("substep", &[], &scene, 60);
    for steps in [1.0, 9.0] {
        let others = run("substep", &[("window", steps)], &scene, 60);
        for (a, b) in substeps.iter().zip(&others) {
            assert_eq!(a, b, "particle {}, after 60 steps and in windows of {steps}", a.id);
        }
    }
    let off = farthest(&substeps, &plain(10, &scene, 60));
    assert!(off <= 1e-9, "after 60 steps a particle is {off:e} from where small steps have it");
}

#[test]
fn task_11_6_few_fast_particles_are_left_to_a_list() {
    let mut bodies = Bodies::of(&Scene::official(2000, 1).expect("a scene"));
    bodies.x.iter_mut().chain(&mut bodies.y).for_each(|x| *x *= 4.0);
    let strategy = |bodies: &Bodies| plan::<Tasks>(bodies, 0, 1).strategy;
    assert!(matches!(strategy(&bodies), Strategy::Windows { .. }), "the box is nearly empty");
    bodies.vx[7] = 1000.0;
    assert_eq!(strategy(&bodies), Strategy::List, "one crosses the box within a window");
}

#[test]
fn task_11_6_substeps_are_the_same_on_any_number_of_threads() {
    let scene = Scene::official(10_000, 2).expect("a scene");
    let grader = on_all_threads("substep");
    grader.same_bits_on_threads(&scene, 20, &[1, 2, 3, 8]);
    grader.same_bits_on_threads(&scattered(3000, 0.6, 7), 20, &[1, 2, 3, 8]);
}

#[test]
fn task_11_6_substeps_follow_small_steps_from_anywhere() {
    // From where small steps for all particles are after each official step, one step of both.
    let mut cases = scenes::edges();
    cases.extend([scenes::official(), scenes::close_pairs()]);
    cases.extend(scenes::fast());
    for (number, scene) in cases.into_iter().enumerate() {
        let mut scene = scene;
        for step in 1..=3 {
            let substeps = run("substep", &[], &scene, 1);
            let small_steps = plain(10, &scene, 1);
            let off = farthest(&substeps, &small_steps);
            assert!(
                off <= 1e-9 * scene.size().max(1.0),
                "scene {number}, step {step}: a particle is {off:e} from where small steps have it"
            );
            scene = Scene::new(scene.size(), small_steps).expect("a scene");
        }
    }
}
