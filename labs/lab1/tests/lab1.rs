//! Lab 1's graders.

use common::Vec2;
use common::soft::{CUTOFF, DT, MIN_R, Observer, Particle, Scene};
use lab1::{
    Tally, VARIANTS, advance, bounce, kinetic_energy, momentum, pair_acceleration, pair_potential,
    potential_energy,
};
use oracle::scenes::anywhere;
use oracle::{
    Count, Grader, Model, Random, acceleration_of_pair, apart, ask, fold, potential_of_pair, right,
    scenes, within,
};
use watched::test;

#[path = "lab1/questions.rs"]
mod questions;

/// A distance vector of length `r` cutoffs, in a direction that is no axis.
fn distance(r: f64) -> Vec2 {
    r * CUTOFF * Vec2::new(0.6, 0.8)
}

fn grader(task: &'static str) -> Grader {
    Grader::new(task, VARIANTS, "all-pairs")
}

#[test]
fn task_1_1_table_of_forces() {
    let mut table = String::from("r / cutoff      ax              ay\n");
    for r in [0.0, 0.003, 0.01, 0.1, 0.5, 0.9, 0.9995, 1.0005, 2.0] {
        let line = match pair_acceleration(distance(r)) {
            Some(a) => format!("{r:<10} {:>15.6e} {:>15.6e}", a.x, a.y),
            None => format!("{r:<10} {:>15} {:>15}", "none", "none"),
        };
        table += &(line + "\n");
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_1_1_the_neighbour_pushes_away_along_the_line_between() {
    let mut random = Random::new(11);
    for _ in 0..10_000 {
        let d = Vec2::new(random.between(-0.8, 0.8), random.between(-0.8, 0.8));
        let d = CUTOFF * d;
        let Some(a) = pair_acceleration(d) else { continue };
        let neighbour = format!("a neighbour at ({}, {})", d.x, d.y);
        assert!(a.dot(d) <= 0.0, "{neighbour} attracts: it causes ({}, {})", a.x, a.y);
        assert!(
            a.cross(d).abs() <= 1e-12 * a.dot(d).abs(),
            "{neighbour} causes ({}, {}), which does not point straight away from it",
            a.x,
            a.y
        );
        let back = pair_acceleration(-d).expect("the way back is as long");
        assert_eq!((back.x, back.y), (-a.x, -a.y), "{neighbour} does not feel the opposite force");
    }
}

#[test]
fn task_1_1_bits_of_the_formula() {
    questions::forces(&mut Random::new(12), &mut right);
}

#[test]
fn task_1_2_bounces_once() {
    for (x, v, expected) in [
        (0.3, 2.0, (0.3, 2.0)),
        (0.0, -2.0, (0.0, -2.0)),
        (1.0, 2.0, (1.0, 2.0)),
        (-0.25, -2.0, (0.25, 2.0)),
        (1.25, 2.0, (0.75, -2.0)),
    ] {
        assert_eq!(bounce(x, v, 1.0), expected, "from x = {x} with v = {v} in a box of 1");
    }
}

#[test]
fn task_1_2_any_coordinate_in_any_box() {
    within("1.2", 10, || questions::bounces(&mut Random::new(13), &mut right));
}

#[test]
fn task_1_2_velocity_first_then_position() {
    let mut particle = Particle { x: 0.5, y: 0.5, vx: 1.0, vy: -2.0, id: 0 };
    advance(&mut particle, Vec2::new(400.0, 0.0), 1.0);
    assert_eq!(particle.vx, 1.0 + 400.0 * DT, "the velocity after a step with a = (400, 0)");
    assert_eq!(particle.x, 0.5 + particle.vx * DT, "the position follows with the new velocity");
    assert_eq!((particle.y, particle.vy), (0.5 - 2.0 * DT, -2.0), "along y no force acts");
}

#[test]
fn task_1_3_a_step_of_any_number_of_particles() {
    questions::steps(&mut Random::new(14), &mut right);
}

#[test]
fn task_1_3_steps_of_a_dense_box() {
    grader("1.3").resynchronised(&scenes::dense(), 20);
}

#[test]
fn task_1_3_pairs_at_the_cutoff() {
    grader("1.3").resynchronised_on_each(scenes::edges(), 1);
}

#[test]
fn task_1_3_particles_at_one_position() {
    grader("1.3").resynchronised(&scenes::close_pairs(), 5);
}

#[test]
fn task_1_3_fast_particles() {
    for scene in scenes::fast() {
        grader("1.3").resynchronised(&scene, 20);
    }
}

#[test]
fn task_1_3_forces_of_crowds_add_up() {
    grader("1.3").forces();
}

#[test]
fn task_1_3_bits_of_dense_boxes() {
    grader("1.3").bits_of_all_pairs(&scenes::dense(), 20);
    grader("1.3").bits_of_all_pairs(&scenes::crowd(3), 5);
}

#[test]
fn task_1_3_memory_does_not_grow() {
    apart(|| grader("1.3").keeps_its_memory());
}

#[test]
fn task_1_3_the_official_run() {
    grader("1.3").resynchronised(&scenes::official(), 1000);
}

#[test]
fn task_1_3_the_official_bytes() {
    grader("1.3").official_bytes();
}

#[test]
fn task_1_4_any_number_of_pairs() {
    let empty = Tally::default().statistics().expect("the tally counts");
    assert_eq!((empty.dmin, empty.davg, empty.navg), (1.0, 0.0, 0), "a step without pairs");
    questions::tallies(&mut Random::new(15), &mut right);
}

#[test]
fn task_1_4_statistics_of_dense_boxes() {
    Tally::default().seen(CUTOFF * CUTOFF);
    grader("1.4").statistics_of_each_step(&scenes::dense(), 20);
    grader("1.4").statistics_of_each_step(&scenes::close_pairs(), 3);
}

#[test]
fn task_1_4_statistics_of_the_official_run() {
    Tally::default().seen(CUTOFF * CUTOFF);
    grader("1.4").long_statistics();
}

#[test]
fn task_1_5_the_potential_of_a_pair() {
    questions::potentials(&mut Random::new(16), &mut right);
}

#[test]
fn task_1_5_energies_of_any_number_of_particles() {
    questions::energies(&mut Random::new(17), &mut right);
}

#[test]
fn task_1_5_a_collision_gives_the_energy_back() {
    let at = |x: f64, vx: f64| Particle { x, y: 0.5, vx, ..Particle::default() };
    let scene = Scene::new(1.0, vec![at(0.45, 0.5), at(0.55, -0.5)]).expect("the scene is sound");
    let energy = |state: &[Particle]| kinetic_energy(state) + potential_energy(state);
    let start = energy(scene.particles());
    let end = Grader::new("1.5", VARIANTS, "energy").run(move |_, engine| {
        engine.load(&scene);
        let mut state = scene.particles().to_vec();
        for _ in 0..400 {
            engine.step();
        }
        engine.read(0, &mut state);
        assert!((momentum(&state).x).abs() < 1e-14, "two particles cannot gain momentum");
        energy(&state)
    });
    let change = end / start - 1.0;
    assert!(change.abs() < 0.05, "the energy changed by {:.1} %", 100.0 * change);
    let highest = pair_potential(Vec2::new(MIN_R, 0.0));
    assert!(highest > 90.0, "the potential at the least distance is {highest}: too low");
}
