//! Lab 12's graders.

use common::soft::{CUTOFF, DT, Particle, Scene};
use integrators::Watched;
use lab12::{CHI, Composition, LAMBDA, VARIANTS, XI, crossing, first_fall};
use oracle::reference::{Fineness, exact};
use oracle::{Grader, Random, apart, ask, right, scenes};
use watched::test;

#[path = "lab12/questions.rs"]
mod questions;

fn grader(task: &'static str, variant: &str) -> Grader {
    Grader::new(task, VARIANTS, variant)
}

/// A variant whose official steps are divided into so many parts.
fn divided(variant: &str, divide: f64) -> Grader {
    let task = match variant {
        "rk4" => "12.2",
        "rk4-located" => "12.4",
        _ => "12.1",
    };
    grader(task, variant).set("divide", divide)
}

fn farthest(a: &[Particle], b: &[Particle]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y)).fold(0.0, f64::max)
}

/// Two particles in a small box, `gap` cutoffs from each other, that approach at this relative
/// speed.
fn head_on(gap: f64, speed: f64) -> Scene {
    let at = |side: f64| Particle {
        x: 0.05 + 0.5 * side * gap * CUTOFF,
        y: 0.05,
        vx: -0.5 * side * speed,
        ..Particle::default()
    };
    Scene::new(0.1, vec![at(-1.0), at(1.0)]).expect("a scene")
}

/// How far a variant is from the exact motion after one official step in which two particles stay
/// in contact: no cutoff is crossed, so the order shows.
fn error_in_contact(variant: &str, divide: f64) -> f64 {
    let scene = head_on(0.8, 0.1);
    let exact = exact(&scene, DT, Fineness::FINE).expect("it is smooth");
    farthest(&divided(variant, divide).ends(&scene, 1), &exact)
}

#[test]
fn task_12_1_drifts_and_kicks_take_turns() {
    questions::steps(&mut Random::new(1), &mut right);
}

#[test]
fn task_12_1_euler_is_the_official_step() {
    let grader = grader("12.1", "euler");
    grader.resynchronised(&scenes::official(), 50);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
}

#[test]
fn task_12_1_velocity_verlet_kicks_by_halves() {
    let found = Composition::velocity_verlet();
    let expected = Composition { drifts: vec![0.0, 1.0, 0.0], kicks: vec![0.5, 0.5] };
    assert_eq!(found, expected, "half a kick, a drift, half a kick, as drifts and kicks by turns");
}

#[test]
fn task_12_1_pefrl_is_symmetric_and_whole() {
    let Composition { drifts, kicks } = Composition::pefrl();
    assert_eq!((drifts.len(), kicks.len()), (5, 4), "how many drifts and kicks");
    assert_eq!((drifts[0], drifts[1], kicks[1]), (XI, CHI, LAMBDA), "the numbers that are given");
    for (what, fractions) in [("drifts", &drifts), ("kicks", &kicks)] {
        let sum: f64 = fractions.iter().sum();
        assert!((sum - 1.0).abs() < 1e-14, "the {what} {fractions:?} add up to {sum}, not to 1");
        let backwards: Vec<f64> = fractions.iter().rev().copied().collect();
        assert_eq!(fractions, &backwards, "the {what}, and the same backwards");
    }
}

#[test]
fn task_12_1_orders_of_convergence() {
    for (composition, variant, order) in [
        (Composition::velocity_verlet(), "velocity-verlet", 2.0),
        (Composition::pefrl(), "pefrl", 4.0),
    ] {
        let found = (error_in_contact(variant, 4.0) / error_in_contact(variant, 8.0)).log2();
        let right = (order - 0.4..order + 0.8).contains(&found);
        assert!(right, "{variant}, {composition:?}: order {found:.2} and not {order}");
    }
}

#[test]
fn task_12_2_four_looks_at_a_ring() {
    questions::runge_kutta(&mut Random::new(2), &mut right);
}

#[test]
fn task_12_2_memory_does_not_grow() {
    apart(|| grader("12.2", "rk4").keeps_its_memory());
}

#[test]
fn task_12_2_order_of_convergence() {
    let found = (error_in_contact("rk4", 4.0) / error_in_contact("rk4", 8.0)).log2();
    assert!((3.6..4.8).contains(&found), "rk4: order {found:.2} and not 4");
}

#[test]
fn task_12_2_table_of_errors() {
    let mut table =
        String::from("error, in cutoffs, of an official step in this number of parts\n");
    table += &format!("{:<15}{:>10}{:>10}{:>10}   order\n", "", 2, 4, 8);
    // Task 12.2 is asked first, and stands last.
    let mut rows = ["rk4", "euler", "velocity-verlet", "pefrl"].map(|variant| {
        let [two, four, eight] =
            [2.0, 4.0, 8.0].map(|divide| error_in_contact(variant, divide) / CUTOFF);
        let order = (four / eight).log2();
        format!("{variant:<15}{two:>10.0e}{four:>10.0e}{eight:>10.0e}{order:>8.1}\n")
    });
    rows.rotate_left(1);
    insta::assert_snapshot!(table + &rows.concat());
}

#[test]
fn task_12_3_the_moment_at_which_something_falls_through_zero() {
    questions::crossings(&mut Random::new(3), &mut right);
    questions::faint_crossings(&mut right);
}

#[test]
fn task_12_3_table_of_contacts() {
    let mut table =
        String::from("relative speed   contact, in steps   least distance, in cutoffs\n");
    for speed in [0.01, 0.1, 1.0, 2.83, 5.0, 10.0, 20.0] {
        // Two particles that meet head on, just in reach, and their exact motion.
        let scene = head_on(1.0 - 1e-9, speed);
        let pair = |t: f64| {
            let end = exact(&scene, t, Fineness::FINE).expect("it is smooth");
            (end[1].x - end[0].x, end[1].vx - end[0].vx)
        };
        let (early, late) = (0.1 * DT, 5.0 * DT);
        let parted = crossing(early, late, &mut |t| CUTOFF - pair(t).0);
        let turned = crossing(early, late, &mut |t| -pair(t).1);
        let (steps, least) = (parted / DT, pair(turned).0 / CUTOFF);
        table += &format!("{speed:>14} {steps:>19.2} {least:>28.3}\n");
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_12_4_what_falls_and_when() {
    questions::falls(&mut Random::new(4), &mut right);
}

/// A starter meets the todo of task 12.4 here, before that of any other task.
fn starts_with_the_fall() {
    let falling = Watched { value: 0.0, slope: -1.0 };
    assert_eq!(first_fall(falling, falling, 1.0, &mut |_| falling), Some(0.0), "it falls at once");
}

#[test]
fn task_12_4_keeps_fourth_order_across_the_cutoff() {
    starts_with_the_fall();
    // Two that come together from outside the cutoff, one of them past a wall: what is not
    // located costs the order.
    let at = |x: f64, y: f64, vx: f64, vy: f64| Particle { x, y, vx, vy, id: 0 };
    let particles = vec![at(0.05, 0.0003, 0.9, -0.4), at(0.0612, 0.0011, -1.1, 0.1)];
    let scene = Scene::new(0.1, particles).expect("a scene");
    let steps = 16;
    let exact = exact(&scene, f64::from(steps) * DT, Fineness::FINE).expect("it is smooth");
    let error =
        |variant, divide| farthest(&divided(variant, divide).ends(&scene, steps as usize), &exact);
    let order = (error("rk4-located", 1.0) / error("rk4-located", 8.0)).log2() / 3.0;
    assert!(order > 3.4, "order {order:.2}, less than four");
    let (plain, located) = (error("rk4", 8.0), error("rk4-located", 8.0));
    assert!(located < 0.05 * plain, "off by {located:e}, and rk4 unlocated by {plain:e}");
}

#[test]
fn task_12_4_located_steps_are_the_exact_motion() {
    starts_with_the_fall();
    let scene = Scene::official(300, 4).expect("a scene");
    let exact = exact(&scene, 100.0 * DT, Fineness::FINE).expect("it is smooth");
    let off = |divide| farthest(&divided("rk4-located", divide).ends(&scene, 100), &exact);
    let (coarse, fine) = (off(10.0), off(40.0));
    assert!(fine < 5e-9, "a particle is {fine:e} from where the exact motion has it");
    assert!(fine < 0.01 * coarse, "four times smaller steps: {fine:e} and not {coarse:e} off");
}

#[test]
fn task_12_4_located_steps_are_the_same_on_any_number_of_threads() {
    starts_with_the_fall();
    let scene = Scene::official(1000, 2).expect("a scene");
    grader("12.4", "rk4-located").same_bits_on_threads(&scene, 20, &[1, 2, 3, 4, 8]);
    grader("12.4", "rk4-located").same_bits_on_threads(&scenes::crowd(1), 3, &[1, 2, 4]);
}
