use common::Vec2;
use common::soft::{CUTOFF, DT, MASS, MIN_R, Observer, Particle, Scene, Simulation};
use lab1::{
    AllPairs, Tally, VARIANTS, advance, bounce, kinetic_energy, momentum, pair_acceleration,
    pair_potential, potential_energy,
};
use oracle::{Count, Grader, Random, acceleration_of_pair, fold, potential_of_pair, scenes};
use watched::test;

/// A distance vector of length `r` cutoffs, in a direction that is no axis.
fn apart(r: f64) -> Vec2 {
    r * CUTOFF * Vec2::new(0.6, 0.8)
}

fn grader(task: &'static str) -> Grader {
    Grader::new(task, VARIANTS, "all-pairs")
}

#[test]
fn task_1_1_table_of_forces() {
    let mut table = String::from("r / cutoff      ax              ay\n");
    for r in [0.0, 0.003, 0.01, 0.1, 0.5, 0.9, 0.9995, 1.0005, 2.0] {
        let line = match pair_acceleration(apart(r)) {
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
        assert_eq!(
            (back.x, back.y),
            (-a.x, -a.y),
            "{neighbour} is not pushed back as much as it pushes"
        );
    }
}

#[test]
fn task_1_1_bits_of_the_formula() {
    let mut random = Random::new(12);
    for _ in 0..100_000 {
        let d = CUTOFF * Vec2::new(random.between(-1.1, 1.1), random.between(-1.1, 1.1));
        let d = if random.bits().is_multiple_of(4) { 0.01 * d } else { d };
        let found = pair_acceleration(d).unwrap_or_default();
        let expected = acceleration_of_pair(d.x, d.y);
        let bits = |a: Vec2| (a.x.to_bits(), a.y.to_bits());
        let off = (found - expected).norm_squared().sqrt();
        let how = if off <= 1e-9 * expected.norm_squared().sqrt() {
            "in the last digits: write the formula just as it is printed"
        } else {
            "more than rounding can do"
        };
        assert!(
            bits(found) == bits(expected),
            "a neighbour at ({:?}, {:?}) causes ({:?}, {:?}), not ({:?}, {:?}): they differ by {off:.1e}, \
             {how}",
            d.x,
            d.y,
            found.x,
            found.y,
            expected.x,
            expected.y
        );
    }
}

#[test]
fn task_1_1_the_cutoff_itself_is_near_and_nothing_beyond() {
    let at = |x: f64| pair_acceleration(Vec2::new(x, 0.0));
    assert!(at(CUTOFF).is_some(), "at exactly the cutoff there is a force (of zero)");
    assert!(at(CUTOFF * 0.9999).is_some(), "just below the cutoff there is a force");
    assert!(at(CUTOFF * 1.0001).is_none(), "just beyond the cutoff there is none");
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
fn task_1_2_a_wall_reached_exactly_is_inside() {
    for (x, v, expected) in [
        (-1.0, -2.0, (1.0, 2.0)),
        (2.0, 2.0, (0.0, -2.0)),
        (3.0, 2.0, (1.0, 2.0)),
        (-2.0, -2.0, (0.0, -2.0)),
        (9.0, 2.0, (1.0, 2.0)),
        (11.0, 2.0, (1.0, 2.0)),
        (-12.0, -2.0, (0.0, -2.0)),
    ] {
        assert_eq!(
            bounce(x, v, 1.0),
            expected,
            "from x = {x} with v = {v} in a box of 1, which ends on a wall: there it is inside, \
             and is reflected no more"
        );
    }
}

#[test]
fn task_1_2_bounces_many_times() {
    let mut random = Random::new(13);
    for _ in 0..10_000 {
        let (x, v) = (random.between(-9.0, 9.0), random.between(-1.0, 1.0));
        let (found, expected) = (bounce(x, v, 1.0), fold(x, v, 1.0));
        assert!(
            (found.0 - expected.0).abs() < 1e-14 && found.1 == expected.1,
            "x = {x}, v = {v} in a box of 1: found {found:?}, expected {expected:?}"
        );
    }
}

#[test]
fn task_1_2_reflects_eight_times_and_then_folds() {
    let mut random = Random::new(14);
    let size = 0.0255;
    for _ in 0..10_000 {
        let x = random.between(-30.0 * size, 31.0 * size);
        let (found, expected) = (bounce(x, 1.0, size), fold(x, 1.0, size));
        assert_eq!(
            found, expected,
            "x = {x:?} in a box of {size}: eight reflections, and the fold if they were not enough, \
             give the place and the velocity to the last digit"
        );
    }
}

#[test]
fn task_1_2_a_bounce_ends_for_any_finite_speed() {
    let states = oracle::within("1.2", 10, || {
        let mut states = Vec::new();
        for x in [1e3, 1e9, 1e18, 1e300, f64::MAX] {
            for x in [x, -x] {
                states.push((x, bounce(x, x.signum(), 0.0255)));
            }
        }
        states
    });
    for (start, (x, v)) in states {
        assert!((0.0..=0.0255).contains(&x), "x = {start:e} ends at {x:e}, outside 0 to 0.0255");
        assert_eq!(v.abs(), 1.0, "the speed of the particle at x = {start:e} changed");
    }
}

#[test]
fn task_1_2_velocity_first_then_place() {
    let mut particle = Particle { x: 0.5, y: 0.5, vx: 1.0, vy: -2.0, id: 0 };
    advance(&mut particle, Vec2::new(400.0, 0.0), 1.0);
    assert_eq!(particle.vx, 1.0 + 400.0 * DT, "the velocity after a step with a = (400, 0)");
    assert_eq!(particle.x, 0.5 + particle.vx * DT, "the place follows with the new velocity");
    assert_eq!((particle.y, particle.vy), (0.5 - 2.0 * DT, -2.0), "along y nothing pushes");
}

#[test]
fn task_1_3_pairs_that_were_looked_at_are_counted() {
    let mut engine = AllPairs::<Count>::default();
    engine.load(&scenes::dense());
    for step in 1..=2 {
        engine.step();
        let n = scenes::dense().len() as u64;
        let counted = engine.statistics().map_or(0, |s| s.pair_tests);
        assert!(
            counted == n * n || counted == n * (n - 1),
            "step {step}: {n} particles look at {} pairs, or at {} with themselves; the observer \
             was told of {counted}",
            n * (n - 1),
            n * n
        );
    }
}

#[test]
fn task_1_3_positions_of_five_particles() {
    let at = |x: f64, y: f64| Particle { x: x * CUTOFF, y: y * CUTOFF, ..Particle::default() };
    let particles = vec![at(0.5, 0.5), at(1.2, 0.5), at(1.2, 1.3), at(2.95, 2.9), at(0.5, 2.9)];
    let scene = Scene::new(3.0 * CUTOFF, particles).expect("the scene is sound");
    let table = grader("1.3").run(move |_, engine| {
        let mut table = String::from("step  particle  x / cutoff  y / cutoff\n");
        engine.load(&scene);
        let mut state = vec![Particle::default(); scene.len()];
        for step in 1..=100 {
            engine.step();
            engine.read(0, &mut state);
            if [1, 10, 100].contains(&step) {
                for p in &state {
                    let (x, y) = (p.x / CUTOFF, p.y / CUTOFF);
                    table += &format!("{step:>4}  {:>8}  {x:>10.5}  {y:>10.5}\n", p.id);
                }
            }
        }
        table
    });
    insta::assert_snapshot!(table);
}

#[test]
fn task_1_3_steps_of_a_dense_box() {
    grader("1.3").resynchronised(&scenes::dense(), 20);
}

#[test]
fn task_1_3_steps_of_crowds() {
    grader("1.3").crowds();
}

#[test]
fn task_1_3_pairs_at_the_cutoff() {
    grader("1.3").resynchronised_on_each(scenes::edges(), 1);
}

#[test]
fn task_1_3_particles_at_one_place() {
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
fn task_1_3_the_official_run() {
    grader("1.3").resynchronised(&scenes::official(), 1000);
}

#[test]
fn task_1_3_the_official_bytes() {
    grader("1.3").official_bytes();
}

#[test]
fn task_1_4_pairs_counted_one_by_one() {
    let mut tally = Tally::default();
    for r in [0.5, 0.25, 1.0, 0.0, 0.0] {
        tally.seen((r * CUTOFF) * (r * CUTOFF));
    }
    let s = tally.statistics().expect("the tally counts");
    assert_eq!(s.navg, 3, "three of the five pairs are at a distance above zero");
    let pairs = "pairs at 0.5, 0.25, 1, 0 and 0 cutoffs";
    assert!(
        (s.dmin - 0.25).abs() < 1e-15,
        "{pairs}: dmin is {}, and the least distance above zero is 0.25",
        s.dmin
    );
    assert!(
        (s.davg - 1.75).abs() < 1e-15,
        "{pairs}: davg is {}, and the sum of distances 1.75",
        s.davg
    );
    let empty = Tally::default().statistics().expect("the tally counts");
    assert_eq!((empty.dmin, empty.davg, empty.navg), (1.0, 0.0, 0), "a step without pairs");
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
fn task_1_5_table_of_potentials() {
    let mut table = String::from("r / cutoff    potential\n");
    for r in [0.0, 0.003, 0.01, 0.1, 0.5, 0.9, 0.9995, 1.0005, 2.0] {
        table += &format!("{r:<10} {:>12.6e}\n", pair_potential(apart(r)));
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_1_5_the_potential_of_a_pair() {
    for k in 0..=1500 {
        let d = apart(f64::from(k) / 1000.0);
        let (found, expected) = (pair_potential(d), potential_of_pair(d.x, d.y));
        assert!(
            (found - expected).abs() <= 1e-12 * (1.0 + expected),
            "the potential of a pair at {} cutoffs is {found}, not {expected}{}",
            f64::from(k) / 1000.0,
            if k < 10 { ": this is below the least distance, on the parabola" } else { "" }
        );
    }
}

#[test]
fn task_1_5_the_potential_of_a_box() {
    // In the second box some particles lie at one place: they do not push each other, and hold
    // more energy than any other pair.
    for (name, scene) in
        [("a dense box", scenes::dense()), ("pairs, some at one place", scenes::close_pairs())]
    {
        let found = potential_energy(scene.particles());
        let mut expected = 0.0;
        for p in scene.particles() {
            for q in scene.particles().iter().filter(|q| q.id != p.id) {
                expected += potential_of_pair(q.x - p.x, q.y - p.y) / 2.0;
            }
        }
        assert!(
            (found - expected).abs() <= 1e-12 * expected,
            "{name}: the potential energy is {found}, and that of its pairs {expected}: each counts \
             once, none is a particle with itself"
        );
    }
}

#[test]
fn task_1_5_motion_of_two_particles() {
    let particles = [
        Particle { vx: 3.0, vy: 4.0, ..Particle::default() },
        Particle { vx: -1.0, vy: 2.0, ..Particle::default() },
    ];
    let energy = kinetic_energy(&particles);
    assert!(
        (energy - MASS * 15.0).abs() < 1e-15,
        "particles of mass {MASS} with velocities (3, 4) and (-1, 2): the energy of motion is \
         {energy}, not {}, the sum of m v² / 2",
        MASS * 15.0
    );
    let p = momentum(&particles);
    assert!(
        (p.x - 0.02).abs() < 1e-16 && (p.y - 0.06).abs() < 1e-16,
        "particles of mass {MASS} with velocities (3, 4) and (-1, 2): the momentum is ({}, {}), \
         not (0.02, 0.06), the sum of m v",
        p.x,
        p.y
    );
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
