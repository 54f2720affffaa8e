use std::f64::consts::PI;

use common::soft::{CUTOFF, DT, Particle, Scene, Simulation, Statistics};
use lab10::{
    AnyProcessor, Bodies, LISTED, Place, REBUILD, TESTED, VARIANTS, best_skin, collect, crossing,
    drift, vector, worn_out,
};
use oracle::reference::{Fineness, exact};
use oracle::{Grader, Random, scenes};

fn grader(task: &'static str, variant: &str) -> Grader {
    Grader::new(task, VARIANTS, variant)
}

/// A variant's engine.
fn engine(variant: &str, parameters: &[(&str, f64)], threads: usize) -> Box<dyn Simulation> {
    let variant = VARIANTS.iter().find(|v| v.name == variant).expect("the lab has it");
    let mut config = variant.config().with_threads(threads);
    for (parameter, value) in parameters {
        variant.set(&mut config, parameter, *value).expect("the variant has it");
    }
    (variant.build)(&config).expect("it builds")
}

/// The same scene with all pairs, one after another, by a variant.
fn run(variant: &str, parameters: &[(&str, f64)], scene: &Scene, steps: usize) -> Vec<Particle> {
    let mut engine = engine(variant, parameters, 1);
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    let mut out = vec![Particle::default(); scene.len()];
    engine.read(0, &mut out);
    out
}

fn farthest(a: &[Particle], b: &[Particle]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a.x - b.x).hypot(a.y - b.y)).fold(0.0, f64::max)
}

#[test]
fn task_10_1_the_velocity_first_then_the_place() {
    let mut random = Random::new(1);
    for n in [1, 7, 8, 64, 100] {
        let mut x: Vec<f64> = (0..n).map(|_| random.between(0.1, 0.9)).collect();
        let mut v: Vec<f64> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
        let a: Vec<f64> = (0..n).map(|_| random.between(-1e3, 1e3)).collect();
        let (old_x, old_v) = (x.clone(), v.clone());
        assert!(!drift(&mut x, &mut v, &a, DT, 1.0), "nobody left a box of 1");
        for i in 0..n {
            let expected_v = old_v[i] + a[i] * DT;
            assert_eq!(v[i], expected_v, "the velocity of particle {i} of {n}");
            assert_eq!(x[i], old_x[i] + expected_v * DT, "the place of particle {i} of {n}");
        }
    }
}

#[test]
fn task_10_1_says_when_somebody_leaves_through_either_wall() {
    for (x, v) in [(1e-5, -1.0), (1.0 - 1e-5, 1.0)] {
        for place in 0..20 {
            let mut xs = vec![0.5; 20];
            let mut vs = vec![0.0; 20];
            (xs[place], vs[place]) = (x, v);
            assert!(
                drift(&mut xs, &mut vs, &[0.0; 20], DT, 1.0),
                "particle {place} left at x = {x}"
            );
        }
    }
}

#[test]
fn task_10_2_lists_exactly_those_within_reach() {
    let scene = scenes::cloud(200, 6.0, 9);
    let bodies = Bodies::of(&scene);
    let reach = 1.7 * CUTOFF;
    for range in [50..150, 60..60, 60..61, 60..67, 60..68, 60..69, 60..80, 150..200, 194..200] {
        for i in 0..50 {
            let mut list = [[77; 2]; 109];
            let len = collect(&mut list, 1, &bodies, i, range.clone(), reach, AnyProcessor);
            let near = |&j: &usize| {
                let d = scene.particles()[i].to(&scene.particles()[j]);
                d.norm_squared() <= reach * reach
            };
            let pairs = range.clone().filter(near).map(|j| [i as u32, j as u32]);
            let expected: Vec<[u32; 2]> = [[77; 2]].into_iter().chain(pairs).collect();
            assert_eq!(
                list[..len],
                expected,
                "the pairs of particle {i} with all of {range:?}, behind one found before"
            );
        }
    }
}

#[test]
fn task_10_2_at_reach_is_within() {
    let reach = 1.7 * CUTOFF;
    let mut bodies = Bodies::default();
    let shares = [0.0, 1.0 + 1e-9, 1.0, 1.0 - 1e-9, -1.0, 1.0 + 1e-15];
    for (k, share) in (0..).zip(shares) {
        bodies.push(Particle { x: reach * share, id: k, ..Particle::default() });
    }
    let mut list = [[77; 2]; 16];
    let len = collect(&mut list, 0, &bodies, 0, 1..6, reach, AnyProcessor);
    let found: Vec<u32> = list[..len].iter().map(|pair| pair[1]).collect();
    assert_eq!(found, [2, 3, 4], "of particles at these multiples of the reach: {shares:?}");
}

#[test]
fn task_10_3_both_of_a_pair_move() {
    let skin = 0.5 * CUTOFF;
    for (moved, worn) in [(0.0, false), (0.24, false), (0.26, true), (0.49, true), (3.0, true)] {
        let way = moved * CUTOFF;
        assert_eq!(
            worn_out(way * way, skin),
            worn,
            "two particles flew {moved} cutoffs towards each other under a skin of 0.5"
        );
    }
    assert!(worn_out(f64::INFINITY, 0.0), "before the first list there is none to use");
}

#[test]
fn task_10_3_verlet_follows_the_model() {
    let grader = grader("10.3", "verlet");
    grader.resynchronised(&scenes::official(), 200);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
    grader.resynchronised(&scenes::close_pairs(), 20);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
    grader.crowds();
    grader.forces();
}

#[test]
fn task_10_3_verlet_statistics() {
    grader("10.3", "verlet").statistics_of_each_step(&scenes::dense(), 10);
    grader("10.3", "verlet").set("skin", 1.0).statistics_of_each_step(&scenes::official(), 40);
    // An official step is seen at its beginning, into however many it is divided.
    let seen = |divide: f64| {
        let grader = grader("10.3", "verlet").set("divide", divide).statistics();
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
fn task_10_3_verlet_reproduces_the_official_output() {
    grader("10.3", "verlet").official_bytes();
}

#[test]
fn task_10_3_verlet_is_the_same_on_any_number_of_threads() {
    let grader = grader("10.3", "verlet");
    grader.same_bits_on_threads(&scenes::cloud(3000, 60.0, 3), 10, &[1, 2, 3, 4, 8]);
}

#[test]
fn task_10_3_steps_in_a_row_are_steps_one_by_one() {
    let scene = Scene::official(2000, 2).expect("a scene");
    let mut engine = engine("verlet", &[], 2);
    engine.load(&scene);
    engine.run(8);
    engine.step();
    engine.run(11);
    let mut seen = vec![Particle::default(); scene.len()];
    engine.read(0, &mut seen);
    assert!(seen == run("verlet", &[], &scene, 20), "20 steps gave other bits than one by one");
}

#[test]
fn task_10_3_rows_longer_than_blocks() {
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
    let grader = grader("10.3", "verlet").set("skin", 0.2);
    grader.resynchronised(&scene, 4);
    grader.same_bits_on_threads(&scene, 4, &[1, 2, 3]);
}

#[test]
fn task_10_3_who_outruns_the_list_looks_around() {
    let mut random = Random::new(12);
    let side = 100.0 * CUTOFF;
    let at = |k: usize, random: &mut Random| {
        // Three of two thousand are too fast for a list that is made for the others.
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
    let grader = grader("10.3", "verlet");
    grader.resynchronised(&scene, 60);
    grader.same_bits_on_threads(&scene, 60, &[1, 2, 3]);
}

/// What a variant counted under this name, in a run of its own.
fn counted(name: &str, variant: &str, scene: &Scene, steps: usize) -> f64 {
    let variant = VARIANTS.iter().find(|v| v.name == variant).expect("the lab has it");
    let mut engine = (variant.build)(&variant.config()).expect("it builds");
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    engine.counters().iter().find(|(counter, _)| *counter == name).expect("it is counted").1
}

#[test]
fn task_10_3_a_gas_that_heats_up_gets_new_lists() {
    // Pairs at rest push each other apart: soon all are faster than the list was made for.
    let at = |k: u32| Particle {
        x: (2.0 + 4.0 * f64::from(k / 2 % 50) + 0.9 * f64::from(k % 2)) * CUTOFF,
        y: (2.0 + 4.0 * f64::from(k / 100)) * CUTOFF,
        vx: 1e-3 * f64::from(k % 7),
        vy: 1e-3 * f64::from(k % 11),
        id: k,
    };
    let scene = Scene::new(2.1, (0..5000).map(at).collect()).expect("a scene");
    let runners = counted("share that outruns the list", "verlet", &scene, 100);
    assert!(runners < 0.3, "{runners} of all look around for themselves");
    grader("10.3", "verlet").resynchronised(&scene, 10);
}

#[test]
fn task_10_3_two_meet_across_a_worn_skin() {
    // With a skin of 1 c a list lasts until somebody has flown c/2. These two start 2.05 c apart,
    // unlisted, and touch after both have flown 0.525 c.
    let at = |x: f64, vx: f64| Particle { x, y: 0.05, vx, vy: 0.0, id: 0 };
    let scene = Scene::new(0.1, vec![at(0.03, 1.0), at(0.0505, -1.0)]).expect("a scene");
    grader("10.3", "verlet").set("skin", 1.0).resynchronised(&scene, 40);
}

#[test]
fn task_10_4_fast_and_sparse_means_thick() {
    let skin = |density: f64, speed: f64| best_skin(density * 2000.0, speed * CUTOFF) / CUTOFF;
    assert!(skin(1.0, 0.1) > skin(1.0, 0.01), "the fast need a thicker skin");
    assert!(skin(0.1, 0.05) > skin(50.0, 0.05), "a crowd needs a thinner one");
    for (density, speed) in [(0.0, 0.1), (1.0, 0.0), (100.0, 9.0), (1.0, 0.07)] {
        let found = skin(density, speed);
        assert!((0.0499..=3.0001).contains(&found), "{found} is none of the skins to try");
    }
    assert!((skin(1.0, 0.0) - 0.05).abs() < 1e-9, "those at rest need no more than the thinnest");
}

#[test]
fn task_10_4_no_other_skin_is_cheaper() {
    let cost = |skin: f64, density: f64, speed: f64| {
        let (reach, rebuilds) = (CUTOFF + skin, (2.0 * speed / skin).min(1.0));
        let (listed, tested) = (0.5 * PI * reach * reach, 0.5 * 9.0 * reach * reach);
        rebuilds * (REBUILD + TESTED * tested * density) + LISTED * listed * density
    };
    for (density, speed) in [(0.2, 0.1), (0.2, 0.02), (1.5, 0.07), (20.0, 0.05), (1e-3, 0.3)] {
        let (density, speed) = (density / (CUTOFF * CUTOFF), speed * CUTOFF);
        let found = best_skin(density, speed);
        for skin in (1..=60).map(|k| f64::from(k) * 0.05 * CUTOFF) {
            assert!(
                cost(found, density, speed) <= cost(skin, density, speed) * (1.0 + 1e-12),
                "a skin of {} cutoffs is cheaper than {}, with {} particles per square cutoff",
                skin / CUTOFF,
                found / CUTOFF,
                density * CUTOFF * CUTOFF,
            );
        }
    }
}

#[test]
fn task_10_10_orders_of_convergence() {
    // Two that stay in contact: no cutoff is crossed, so the order shows.
    let at = |x: f64, vx: f64| Particle { x, y: 0.05, vx, vy: 0.0, id: 0 };
    let scene = Scene::new(0.1, vec![at(0.048, 0.05), at(0.056, -0.05)]).expect("a scene");
    for (variant, order) in [("velocity-verlet", 2.0), ("pefrl", 4.0), ("rk4", 4.0)] {
        let best = run("pefrl", &[("divide", 512.0)], &scene, 1);
        let error = |divide| farthest(&run(variant, &[("divide", divide)], &scene, 1), &best);
        let found = (error(4.0) / error(8.0)).log2();
        assert!(found > order - 0.6, "{variant}: order {found:.2}, less than {order}");
    }
}

#[test]
fn task_10_11_a_distance_across_cells() {
    let side = 0.01_f32;
    for column in [1, 70_000, 100_000_000_u32] {
        let from = Place { column, row: 5, x: 0.009, y: 0.002 };
        let to = Place { column: column + 1, row: 4, x: 0.001, y: 0.008 };
        let (dx, dy) = vector(&from, &to, side);
        assert!((dx - 0.002).abs() < 2e-9, "dx = {dx} from column {column} to the next");
        assert!((dy + 0.004).abs() < 2e-9, "dy = {dy} from row 5 to row 4");
        let (back_x, back_y) = vector(&to, &from, side);
        assert_eq!((back_x, back_y), (-dx, -dy), "the way back from column {column}");
    }
}

#[test]
fn task_10_11_the_error_does_not_depend_on_the_box() {
    let mut random = Random::new(4);
    let lattice: Vec<Particle> = (0..64_u32)
        .map(|id| {
            let at = |k: u32| (1.0 + 0.9 * f64::from(k)) * CUTOFF;
            let (vx, vy) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            Particle { x: at(id % 8), y: at(id / 8), vx, vy, id }
        })
        .collect();
    let error = |size: f64, offset: f64| {
        let at = |p: &Particle| Particle { x: p.x + offset, y: p.y + offset, ..*p };
        let scene = Scene::new(size, lattice.iter().map(at).collect()).expect("a scene");
        farthest(&run("mixed", &[], &scene, 3), &run("verlet", &[], &scene, 3))
    };
    for (size, offset) in [(0.1, 0.0), (10.0, 9.0), (1e4, 9e3)] {
        let off = error(size, offset);
        assert!(off < 1e-4 * CUTOFF, "in a box of {size}, {offset} from its walls: off by {off:e}");
    }
}

#[test]
fn task_10_12_the_moment_at_which_something_falls_through_zero() {
    // Name, where to look, what is watched, and when it falls.
    type Watched = (&'static str, f64, f64, fn(f64) -> f64, f64);
    let watched: [Watched; 6] = [
        ("a wall ahead", 0.0, 5e-4, |t| 2e-4 - t, 2e-4),
        ("two that fly towards each other", 0.0, 5e-4, |t| (0.0103 - t).powi(2) - 1e-4, 3e-4),
        ("two that graze", 0.0, 1.0, |t| (t - 1.0).powi(2) - 1e-8, 1.0 - 1e-4),
        ("one that falls late", 0.0, 1.0, |t| 0.5 - t.powi(9), 0.5_f64.powf(1.0 / 9.0)),
        ("one that falls early", 0.0, 1.0, |t| (-40.0 * t).exp() - 0.5, 2.0_f64.ln() / 40.0),
        ("one that falls at the end of a later stretch", 3.0, 4.0, |t| 3.999_999 - t, 3.999_999),
    ];
    for (what, low, high, value, moment) in watched {
        let mut looks = 0;
        let found = crossing(low, high, &mut |t| {
            looks += 1;
            assert!((low..=high).contains(&t), "{what}: looked at {t}, outside the step");
            value(t)
        });
        let late = (found - moment) / (high - low);
        assert!(late.abs() < 2e-12, "{what}: found {found}, it is {moment}");
        assert!(value(found) <= 0.0, "{what}: found {found}, too early by a little: it is not yet");
        assert!(looks <= 30, "{what}: {looks} looks; halving would do with 42, chords with fewer");
    }
}

#[test]
fn task_10_12_keeps_fourth_order_across_the_cutoff() {
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
fn task_10_12_located_steps_are_the_exact_motion() {
    let scene = Scene::official(300, 4).expect("a scene");
    let exact = exact(&scene, 100.0 * DT, Fineness::FINE).expect("it is smooth");
    let off = |divide| farthest(&run("rk4-located", &[("divide", divide)], &scene, 100), &exact);
    let (coarse, fine) = (off(10.0), off(40.0));
    assert!(fine < 5e-9, "somebody is {fine:e} from where the exact motion has it");
    assert!(fine < 0.01 * coarse, "four times smaller steps: {fine:e} and not {coarse:e} off");
}

#[test]
fn task_10_12_located_steps_are_the_same_on_any_number_of_threads() {
    let scene = Scene::official(1000, 2).expect("a scene");
    grader("10.12", "rk4-located").same_bits_on_threads(&scene, 20, &[1, 2, 3, 4, 8]);
    grader("10.12", "rk4-located").same_bits_on_threads(&scenes::crowd(1), 3, &[1, 2, 4]);
}
