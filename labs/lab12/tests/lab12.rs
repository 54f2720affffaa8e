//! Lab 12's graders.

use common::Vec2;
use common::soft::{CUTOFF, DT, Particle, Scene};
use integrators::{State, Watched};
use lab12::{CHI, Composition, LAMBDA, Motion, VARIANTS, XI, crossing, first_fall, slopes};
use oracle::reference::{Fineness, exact};
use oracle::{Grader, scenes};
use watched::test;

fn grader(task: &'static str, variant: &str) -> Grader {
    Grader::new(task, VARIANTS, variant)
}

/// A scene after some official steps of a variant.
fn run(variant: &str, parameters: &[(&str, f64)], scene: &Scene, steps: usize) -> Vec<Particle> {
    let variant = VARIANTS.iter().find(|v| v.name == variant).expect("the lab has it");
    let mut config = variant.config().with_threads(1);
    for (parameter, value) in parameters {
        variant.set(&mut config, parameter, *value).expect("the variant has it");
    }
    let mut engine = (variant.build)(&config).expect("it builds");
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    let mut out = vec![Particle::default(); scene.len()];
    engine.read(0, &mut out);
    out
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
    farthest(&run(variant, &[("divide", divide)], &scene, 1), &exact)
}

/// Writes down the drifts and kicks that are asked of it; a drift for no time is none.
#[derive(Default)]
struct Record(Vec<(&'static str, f64)>);

impl Motion for Record {
    fn drift(&mut self, dt: f64) {
        if dt != 0.0 {
            self.0.push(("drift", dt));
        }
    }

    fn kick(&mut self, dt: f64) {
        self.0.push(("kick", dt));
    }
}

#[test]
fn task_12_1_drifts_and_kicks_take_turns() {
    let composition = Composition { drifts: vec![0.25, 0.5, 0.25], kicks: vec![0.75, 0.25] };
    let mut record = Record::default();
    composition.step(&mut record, 2.0);
    let expected = [("drift", 0.5), ("kick", 1.5), ("drift", 1.0), ("kick", 0.5), ("drift", 0.5)];
    assert_eq!(record.0, expected, "what a step of length 2 asks for, {composition:?}");
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
fn task_12_2_four_looks_at_a_pendulum() {
    // x' = v, v' = -x: the fourth-order Taylor polynomial comes out to the last digits.
    let start = State { at: vec![Vec2::new(1.0, 0.0)], v: vec![Vec2::new(0.0, 2.0)] };
    let (h, mut looks) = (0.5, Vec::new());
    let sum = slopes(&start, h, &mut |at, a| {
        looks.push((at[0].x, at[0].y));
        a[0] = -at[0];
    });
    let expected = [(1.0, 0.0), (1.0, 0.5), (0.9375, 0.5), (0.875, 0.9375)];
    assert_eq!(looks, expected, "where the pendulum was asked for its acceleration");
    let (c, s) = (1.0 - h * h / 2.0 + h.powi(4) / 24.0, h - h.powi(3) / 6.0);
    for (what, found, expected) in [
        ("x", 1.0 + h / 6.0 * sum.at[0].x, c),
        ("y", h / 6.0 * sum.at[0].y, 2.0 * s),
        ("vx", h / 6.0 * sum.v[0].x, -s),
        ("vy", 2.0 + h / 6.0 * sum.v[0].y, 2.0 * c),
    ] {
        assert!((found - expected).abs() < 1e-14, "{what} after a step: {found}, not {expected}");
    }
}

#[test]
fn task_12_2_each_particle_has_its_own_slopes() {
    let at: Vec<Vec2> = (0..5).map(|i| Vec2::new(f64::from(i), 1.0)).collect();
    let v: Vec<Vec2> = (0..5).map(|i| Vec2::new(0.5, -f64::from(i))).collect();
    // A constant acceleration, another for each particle.
    let sum = slopes(&State { at, v: v.clone() }, 0.5, &mut |_, a| {
        a.iter_mut().enumerate().for_each(|(i, a)| *a = Vec2::new(i as f64, 8.0));
    });
    for (i, &v) in v.iter().enumerate() {
        let a = Vec2::new(i as f64, 8.0);
        assert_eq!(sum.v[i], 6.0 * a, "particle {i}: six accelerations");
        assert_eq!(sum.at[i], 6.0 * (v + 0.25 * a), "particle {i}: six velocities of half-way");
    }
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
    // Name, where to look, what is watched, and when it falls.
    type Fall = (&'static str, f64, f64, fn(f64) -> f64, f64);
    let watched: [Fall; 6] = [
        ("a wall ahead", 0.0, 5e-4, |t| 2e-4 - t, 2e-4),
        ("two that fly towards each other", 0.0, 5e-4, |t| (0.0103 - t).powi(2) - 1e-4, 3e-4),
        ("two that graze", 0.0, 1.0, |t| (t - 1.0).powi(2) - 1e-8, 1.0 - 1e-4),
        ("one that falls late", 0.0, 1.0, |t| 0.5 - t.powi(9), 0.5_f64.powf(1.0 / 9.0)),
        ("one that falls early", 0.0, 1.0, |t| (-40.0 * t).exp() - 0.5, 2.0_f64.ln() / 40.0),
        ("one that falls at the end of a later stretch", 3.0, 4.0, |t| 3.999_999 - t, 3.999_999),
    ];
    for (what, low, high, value, moment) in watched {
        let what = format!("crossing({low}, {high}), {what}");
        let mut looks = Vec::new();
        let found = crossing(low, high, &mut |t| {
            looks.push(t);
            assert!((low..=high).contains(&t), "{what}: looked at {t}, outside the step");
            value(t)
        });
        let last = &looks[looks.len().saturating_sub(3)..];
        let late = (found - moment) / (high - low);
        assert!(
            late.abs() < 2e-12,
            "{what}: found {found}, it is {moment}; the last looks were at {last:?}: both ends \
             must close in"
        );
        assert!(value(found) <= 0.0, "{what}: found {found}, too early by a little: it is not yet");
        let looks = looks.len();
        assert!(
            looks <= 30,
            "{what}: {looks} looks, the last at {last:?}; halving would do with 42, chords with \
             fewer if they stay a little away from both ends"
        );
    }
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
    // What is watched, what becomes of it within a time of 1, and when it falls.
    type Fall = (&'static str, fn(f64) -> (f64, f64), Option<f64>);
    let falls: [Fall; 16] = [
        ("falls", |t| (0.3 - t, -1.0), Some(0.3)),
        ("falls, not far enough", |t| (2.0 - t, -1.0), None),
        ("rises", |t| (0.1 + t, 1.0), None),
        (
            "dips below zero and comes back",
            |t| ((t - 0.5).powi(2) - 0.01, 2.0 * t - 1.0),
            Some(0.4),
        ),
        ("comes near zero and goes away", |t| ((t - 0.5).powi(2) + 0.01, 2.0 * t - 1.0), None),
        (
            "rises and then falls",
            |t| (0.2 + t - 2.0 * t * t, 1.0 - 4.0 * t),
            Some(0.653_112_887_414_927_5),
        ),
        ("is at a wall and leaves", |t| (t, 1.0), None),
        ("is at a wall, leaves and comes back", |t| (t * (0.4 - t), 0.4 - 2.0 * t), Some(0.4)),
        ("has been seen a little too late and leaves", |t| (t - 1e-18, 1.0), None),
        ("has been seen a little too late and goes on", |t| (-1e-18 - t, -1.0), Some(0.0)),
        (
            "has been seen too late and rises all the way, still below zero",
            |t| (t - 2.0, 1.0),
            None,
        ),
        ("has been seen too late and rises to zero", |t| (t - 1.0, 1.0), None),
        ("starts level and falls", |t| (0.25 - t * t, -2.0 * t), Some(0.5)),
        ("is level at zero and falls", |t| (-t * t, -2.0 * t), Some(0.0)),
        (
            "falls and ends level, below zero",
            |t| ((t - 1.0).powi(2) - 0.25, 2.0 * t - 2.0),
            Some(0.5),
        ),
        ("never gets above zero", |t| (-0.01 - (t - 0.3).powi(2), 0.6 - 2.0 * t), Some(0.3)),
    ];
    for (what, curve, expected) in falls {
        let mut watch = |t: f64| {
            assert!((0.0..=1.0).contains(&t), "what {what} is looked at at {t}, outside the step");
            let (value, slope) = curve(t);
            Watched { value, slope }
        };
        let found = first_fall(watch(0.0), watch(1.0), 1.0, &mut watch);
        let right = match (found, expected) {
            (Some(found), Some(expected)) => (found - expected).abs() < 1e-11,
            (found, expected) => found == expected,
        };
        assert!(right, "first_fall says that what {what} falls at {found:?}, it is {expected:?}");
    }
}

#[test]
fn task_12_4_what_only_falls_is_not_searched_for_a_bottom() {
    let mut looks = 0;
    let watch = |t: f64| Watched { value: 2.0 - t, slope: -1.0 };
    let found = first_fall(watch(0.0), watch(1.0), 1.0, &mut |t| {
        looks += 1;
        watch(t)
    });
    assert_eq!(found, None, "what falls from 2 to 1");
    assert_eq!(looks, 0, "looks at what its ends tell already");
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
    let error = |variant, divide| {
        farthest(&run(variant, &[("divide", divide)], &scene, steps as usize), &exact)
    };
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
    let off = |divide| farthest(&run("rk4-located", &[("divide", divide)], &scene, 100), &exact);
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
