use std::f64::consts::PI;

use common::soft::{CUTOFF, DT, Particle, Scene, Simulation, Statistics};
use lab10::{
    AnyProcessor, Bodies, LISTED, LONGEST, REBUILD, Span, TESTED, VARIANTS, Way, best_skin,
    closest_squared, collect, drift, fly, plan, too_far_off, window_length, worn_out,
};
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
fn task_10_9_planned_statistics() {
    grader("10.9", "planned").statistics_of_each_step(&scenes::dense(), 10);
    grader("10.9", "planned").set("window", 4.0).statistics_of_each_step(&scenes::official(), 10);
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
fn task_10_5_a_wall_within_the_window() {
    let span = Span { steps: 8, dt: DT, size: 1.0 };
    let way = span.whole();
    for (x, v, meets) in [
        (0.5, 1.0, false),
        (0.9 * way, -1.0, true),
        (1.1 * way, -1.0, false),
        (1.0 - 0.9 * way, 1.0, true),
        (1.0 - 1.1 * way, 1.0, false),
        (0.9 * way, 1.0, false),
        (0.5, f64::NAN, true),
    ] {
        assert_eq!(span.meets_wall(x, 0.5, v, 0.0), meets, "x = {x} with vx = {v}, 8 steps");
        assert_eq!(span.meets_wall(0.5, x, 0.0, v), meets, "y = {x} with vy = {v}, 8 steps");
    }
}

#[test]
fn task_10_6_closest_approach() {
    for (d, w, span, expected) in [
        ((3.0, 4.0), (0.0, 0.0), 1.0, 25.0),
        ((3.0, 1.0), (-1.0, 0.0), 10.0, 1.0),
        ((3.0, 1.0), (-1.0, 0.0), 2.0, 2.0),
        ((3.0, 1.0), (1.0, 0.0), 10.0, 10.0),
        ((0.0, 0.0), (0.0, 0.0), 1.0, 0.0),
        ((0.0, 0.0), (5.0, 5.0), 0.0, 0.0),
    ] {
        let found = closest_squared(d.0, d.1, w.0, w.1, span);
        assert!((found - expected).abs() < 1e-12, "{d:?} apart, {w:?} within {span}: {found}");
    }
}

#[test]
fn task_10_6_windows_have_the_bits_of_all_pairs() {
    // What a window cannot do without.
    let missed = closest_squared(-1.0, 2.0, 1.0, 0.0, 4.0);
    assert!(missed > CUTOFF * CUTOFF, "two that pass each other at a distance of 2 never touch");
    for window in [1.0, 2.0, 5.0, 8.0, 16.0] {
        let grader = grader("10.6", "planned").set("window", window);
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
fn task_10_7_free_flight_adds_step_by_step() {
    let mut random = Random::new(3);
    let start: Vec<f64> = (0..100).map(|_| random.between(0.0, 20.0)).collect();
    let v: Vec<f64> = (0..100).map(|_| random.between(-1.0, 1.0)).collect();
    for steps in [0, 1, 7, 12] {
        let mut x = start.clone();
        fly(&mut x, &v, steps, DT);
        for i in 0..100 {
            let expected = (0..steps).fold(start[i], |x, _| x + v[i] * DT);
            assert_eq!(x[i], expected, "particle {i} after {steps} steps, bit by bit");
        }
    }
}

#[test]
fn task_10_8_two_may_be_off_their_paths() {
    for (bent, broken) in [(0.0, false), (0.49, false), (0.51, true), (1.5, true)] {
        assert_eq!(too_far_off(bent, 1.0), broken, "{bent} of the margin off its path");
    }
}

#[test]
fn task_10_9_window_lengths() {
    let a_step = 2.0 * CUTOFF * 2f64.sqrt() * 0.77 * DT * 2000.0;
    assert_eq!(window_length(2000.0, 0.77), (0.14 / a_step) as u32, "the official scene");
    assert_eq!(window_length(2000.0, 0.0), LONGEST, "nobody moves");
    assert_eq!(window_length(0.0, 1.0), LONGEST, "nobody is there");
    assert_eq!(window_length(2000.0, 900.0), 1, "all are very fast");
}

#[test]
fn task_10_9_a_crystal_is_not_empty() {
    // Three cutoffs apart: none has another in its cell, and yet soon they meet.
    let mut crystal = Bodies::default();
    for id in 0..2500 {
        let (x, y) = (f64::from(id % 50), f64::from(id / 50));
        let (x, y) = (3.0 * CUTOFF * (1.0 + x), 3.0 * CUTOFF * (1.0 + y));
        crystal.push(Particle { x, y, vx: 1.0, vy: 0.0, id });
    }
    let found = plan(&crystal, 152.0 * CUTOFF, 0, 1).neighbours;
    let expected = PI / 9.0;
    assert!(
        (found - expected).abs() < 0.05 * expected,
        "one particle to nine square cutoffs is {expected:.3} in a cutoff disc, not {found:.3}"
    );
}

/// The planner's own choice, which is a list for most of these scenes, and windows.
fn planned_both_ways() -> [Grader; 2] {
    [grader("10.9", "planned"), grader("10.9", "planned").set("window", 6.0)]
}

#[test]
fn task_10_9_planned_follows_the_model() {
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
fn task_10_9_planned_reproduces_the_official_output() {
    planned_both_ways().iter().for_each(Grader::official_bytes);
}

#[test]
fn task_10_9_planned_equals_the_plain_engine() {
    let scene = Scene::official(3000, 5).expect("a scene");
    for window in [0.0, 6.0] {
        let planned = run("planned", &[("window", window)], &scene, 200);
        let off = farthest(&planned, &run("verlet", &[], &scene, 200));
        assert!(
            off <= 1e-9,
            "windows of {window} steps (0: the planner's choice): after 200 steps somebody is \
             {off:e} from where the plain engine has it"
        );
    }
}

#[test]
fn task_10_9_planned_is_the_same_on_any_number_of_threads() {
    let [by_choice, in_windows] = planned_both_ways();
    by_choice.same_bits_on_threads(&scenes::cloud(1000, 30.0, 3), 20, &[1, 2, 3, 4, 8]);
    let scene = Scene::official(2000, 2).expect("a scene");
    in_windows.same_bits_on_threads(&scene, 20, &[1, 2, 3, 4, 8]);
}

#[test]
fn task_10_9_steps_in_a_row_are_steps_one_by_one() {
    let scene = Scene::official(2000, 2).expect("a scene");
    let ways: [(_, &[_]); 4] =
        [("planned", &[]), ("planned", &[("window", 6.0)]), ("substep", &[]), ("verlet", &[])];
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
fn task_10_9_a_long_run_on_a_list_counts_every_step() {
    let touched = "particles touched per particle and step";
    let found = counted(touched, "planned", &scenes::official(), 600);
    assert_eq!(found, 1.0, "on a list everybody moves at each step: {touched}");
}

#[test]
fn task_10_9_substeps_are_small_steps() {
    let scene = scenes::official();
    let substeps = run("substep", &[("substeps", 10.0)], &scene, 100);
    let small_steps = run("verlet", &[("divide", 10.0)], &scene, 100);
    let off = farthest(&substeps, &small_steps);
    assert!(off <= 1e-9, "after 100 steps somebody is {off:e} from where small steps have it");
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

/// What a variant counted under this name, in a run of its own.
fn counted(name: &str, variant: &str, scene: &Scene, steps: usize) -> f64 {
    let variant = VARIANTS.iter().find(|v| v.name == variant).expect("the lab has it");
    let mut engine = (variant.build)(&variant.config()).expect("it builds");
    engine.load(scene);
    (0..steps).for_each(|_| engine.step());
    engine.counters().iter().find(|(counter, _)| *counter == name).expect("it is counted").1
}

#[test]
fn task_10_9_substeps_on_a_list_have_the_bits_of_windows() {
    // Those that overlap push each other far: what was watched is not enough, and the step is redone.
    let pushed = scattered(1200, 0.6, 3);
    // Of few particles a list is made for the fastest: here it would be too long, and windows step in.
    let mut some_fast = scattered(900, 0.8, 4).particles().to_vec();
    some_fast.iter_mut().step_by(300).for_each(|p| (p.vx, p.vy) = (25.0, -25.0));
    let size = (0.0005_f64 * 900.0).sqrt();
    let some_fast = Scene::new(size, some_fast).expect("a scene");
    let official = Scene::official(5000, 5).expect("a scene");
    // Three of five thousand outrun a list that is made for the others.
    let mut outrun = official.particles().to_vec();
    outrun.iter_mut().skip(1).step_by(2000).for_each(|p| (p.vx, p.vy) = (9.0, -7.0));
    let outrun = Scene::new(official.size(), outrun).expect("a scene");
    let scenes = [
        ("official", official),
        ("pushed", pushed.clone()),
        ("fast", some_fast),
        ("outrun", outrun),
    ];
    for (name, scene) in scenes {
        let way = plan(&Bodies::of(&scene), scene.size(), 0, 10).way;
        assert!(matches!(way, Way::Contacts { .. }), "{name}: {way:?} is not on a list");
        let on_a_list = run("substep", &[], &scene, 60);
        let in_windows = run("substep", &[("window", 1.0)], &scene, 60);
        for (a, b) in on_a_list.iter().zip(&in_windows) {
            assert_eq!(a, b, "{name}: particle {}, on a list and in windows, after 60 steps", a.id);
        }
    }
    for name in ["windows redone", "share computed again"] {
        assert!(counted(name, "substep", &pushed, 60) > 0.0, "{name}: the scene was to show it");
    }
}

#[test]
fn task_10_9_a_runner_comes_back_from_a_wall() {
    // It is far from the wall when the list is made, is thrown back seven steps later, and only so
    // comes into reach of the one that waits there. The others make it a runner.
    let (way, wall) = (9.0_f64.hypot(7.0) * DT / CUTOFF, 60.0);
    let along = |length: f64, up: f64| {
        let share = length / 9.0_f64.hypot(7.0);
        ((9.0 * share) * CUTOFF, (wall + up * 7.0 * share) * CUTOFF)
    };
    let (from, waiting) = (along(7.5 * way, -1.0), along(1.2, 1.0));
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
    let on_a_list = run("substep", &[], &scene, 9);
    let in_windows = run("substep", &[("window", 1.0)], &scene, 9);
    assert_ne!(on_a_list[1].vx, 0.0, "the two were to meet");
    assert_eq!(on_a_list[..2], in_windows[..2], "on a list and in windows, after 9 steps");
}

#[test]
fn task_10_9_substeps_are_the_same_on_any_number_of_threads() {
    let scene = Scene::official(10_000, 2).expect("a scene");
    grader("10.9", "substep").same_bits_on_threads(&scene, 20, &[1, 2, 3, 8]);
    grader("10.9", "substep").same_bits_on_threads(&scattered(3000, 0.6, 7), 20, &[1, 2, 3, 8]);
}

#[test]
fn task_10_9_substeps_follow_small_steps_from_anywhere() {
    // From where small steps for everybody are after each official step, one step of both.
    let mut cases = scenes::edges();
    cases.extend([scenes::official(), scenes::close_pairs()]);
    cases.extend(scenes::fast());
    for (number, scene) in cases.into_iter().enumerate() {
        let mut scene = scene;
        for step in 1..=3 {
            let substeps = run("substep", &[], &scene, 1);
            let small_steps = run("verlet", &[("divide", 10.0)], &scene, 1);
            let off = farthest(&substeps, &small_steps);
            assert!(
                off <= 1e-9 * scene.size().max(1.0),
                "scene {number}, step {step}: somebody is {off:e} from where small steps have it"
            );
            scene = Scene::new(scene.size(), small_steps).expect("a scene");
        }
    }
}
