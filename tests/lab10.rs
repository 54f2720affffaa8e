use std::f64::consts::PI;

use common::soft::{CUTOFF, DT, NoStatistics, Particle, Scene, Simulation, Statistics};
use lab10::kernels::{Pair, Places, ROOM};
use lab10::{
    AnyProcessor, Bodies, LISTED, REBUILD, TESTED, VARIANTS, Verlet, Workers, best_skin, collect,
    drift, filter, worn_out,
};
use oracle::{Grader, Random, scenes};
use watched::test;

/// The engine on all threads, however small the scene. It needs all five tasks; the last one is asked
/// first.
fn verlet() -> Grader {
    let found = filter(&[], Bodies::default().places(), 1.0, &mut [[0; 2]; ROOM]);
    assert_eq!(found, 0, "of no pairs none is near");
    Grader::new("10.5", VARIANTS, "verlet").set("share", 1.0)
}

#[test]
fn task_10_1_the_velocity_first_then_the_place() {
    let mut random = Random::new(1);
    for n in [1, 7, 8, 64, 100] {
        let mut x: Vec<f64> = (0..n).map(|_| random.between(0.1, 0.9)).collect();
        let mut v: Vec<f64> = (0..n).map(|_| random.between(-1.0, 1.0)).collect();
        let a: Vec<f64> = (0..n).map(|_| random.between(-1e3, 1e3)).collect();
        let (old_x, old_v) = (x.clone(), v.clone());
        assert!(!drift(&mut x, &mut v, &a, DT, 1.0), "none left a box of 1");
        for i in 0..n {
            let expected_v = old_v[i] + a[i] * DT;
            assert_eq!(v[i], expected_v, "the velocity of particle {i} of {n}");
            assert_eq!(x[i], old_x[i] + expected_v * DT, "the place of particle {i} of {n}");
        }
    }
}

#[test]
fn task_10_1_says_when_a_particle_leaves_through_either_wall() {
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
fn task_10_2_lists_exactly_the_pairs_within_reach() {
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
            let len = collect(&mut list, 0, &bodies, i, i + 1..12, reach * CUTOFF, AnyProcessor);
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
    let skin = 0.5 * CUTOFF;
    for (moved, worn) in [(0.0, false), (0.24, false), (0.26, true), (0.49, true), (3.0, true)] {
        let flown = moved * CUTOFF;
        assert_eq!(
            worn_out(flown * flown, skin),
            worn,
            "two particles flew {moved} cutoffs towards each other under a skin of 0.5"
        );
    }
    assert!(worn_out(f64::INFINITY, 0.0), "before the first list there is none to use");
}

#[test]
fn task_10_4_fast_and_sparse_means_thick() {
    let skin = |density: f64, speed: f64| best_skin(density * 2000.0, speed * CUTOFF) / CUTOFF;
    assert!(skin(1.0, 0.1) > skin(1.0, 0.01), "fast particles need a thicker skin");
    assert!(skin(0.1, 0.05) > skin(50.0, 0.05), "a crowd needs a thinner one");
    for (density, speed) in [(0.0, 0.1), (1.0, 0.0), (100.0, 9.0), (1.0, 0.07)] {
        let found = skin(density, speed);
        assert!((0.0499..=3.0001).contains(&found), "{found} is none of the skins to try");
    }
    assert!(
        (skin(1.0, 0.0) - 0.05).abs() < 1e-9,
        "particles at rest need no more than the thinnest"
    );
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
fn task_10_4_table_of_skins() {
    let speeds = [0.01, 0.03, 0.05, 0.1, 0.3];
    let mut table = String::from("the cheapest skin, in cutoffs\n\n");
    table += "neighbours   a particle goes so many cutoffs in a step\n";
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
fn task_10_5_pairs_within_the_distance() {
    let mut random = Random::new(5);
    let scene = scenes::cloud(100, 5.0, 2);
    let all = Bodies::of(&scene);
    let first = 20;
    let places = Places { x: &all.x[first..], y: &all.y[first..], first };
    for len in [0, 1, 7, 100, ROOM] {
        let mut pick = || first as u32 + random.between(0.0, 80.0) as u32;
        let pairs: Vec<Pair> = (0..len).map(|_| [pick(), pick()]).collect();
        let mut near = [[77; 2]; ROOM];
        let found = filter(&pairs, places, CUTOFF * CUTOFF, &mut near);
        let is_near = |[i, j]: &Pair| {
            let d = scene.particles()[*i as usize].to(&scene.particles()[*j as usize]);
            d.norm_squared() <= CUTOFF * CUTOFF
        };
        let expected: Vec<Pair> = pairs.iter().copied().filter(is_near).collect();
        assert_eq!(near[..found], expected, "{len} pairs of particles from number {first} on");
    }
}

#[test]
fn task_10_5_at_the_distance_is_near() {
    let mut row = Bodies::default();
    for (id, x) in (0..).zip([0.0, 3.0, 4.0, 8.0]) {
        row.push(Particle { x, id, ..Particle::default() });
    }
    let mut near = [[77; 2]; ROOM];
    let found = filter(&[[0, 1], [0, 2], [1, 3], [2, 3]], row.places(), 16.0, &mut near);
    assert_eq!(near[..found], [[0, 1], [0, 2], [2, 3]], "of pairs 3, 4, 5 and 4 apart");
}

#[test]
fn task_10_5_verlet_follows_the_model() {
    let grader = verlet();
    grader.resynchronised(&scenes::official(), 200);
    grader.resynchronised(&scenes::dense(), 20);
    grader.resynchronised_on_each(scenes::edges(), 3);
    grader.resynchronised(&scenes::close_pairs(), 20);
    grader.resynchronised_on_each(scenes::fast().to_vec(), 20);
    grader.crowds();
    grader.forces();
}

#[test]
fn task_10_5_verlet_statistics() {
    verlet().statistics_of_each_step(&scenes::dense(), 10);
    verlet().set("skin", 1.0).statistics_of_each_step(&scenes::official(), 40);
    // An official step is seen at its beginning, into however many it is divided.
    let seen = |divide: f64| {
        let grader = verlet().set("divide", divide).statistics();
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
fn task_10_5_verlet_reproduces_the_official_output() {
    verlet().official_bytes();
}

#[test]
fn task_10_5_verlet_is_the_same_on_any_number_of_threads() {
    let grader = verlet();
    grader.same_bits_on_threads(&scenes::cloud(3000, 60.0, 3), 10, &[1, 2, 3, 4, 8]);
}

#[test]
fn task_10_5_steps_in_a_row_are_steps_one_by_one() {
    let scene = Scene::official(2000, 2).expect("a scene");
    let _ = verlet();
    let [in_a_row, one_by_one] = [true, false].map(|in_a_row| {
        let mut engine = Verlet::<NoStatistics>::new(Workers::new(2), 0.0, 1);
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
fn task_10_5_rows_longer_than_blocks() {
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
    let grader = verlet().set("skin", 0.2);
    grader.resynchronised(&scene, 4);
    grader.same_bits_on_threads(&scene, 4, &[1, 2, 3]);
}

#[test]
fn task_10_5_outliers_of_the_list() {
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
    let grader = verlet();
    grader.resynchronised(&scene, 60);
    grader.same_bits_on_threads(&scene, 60, &[1, 2, 3]);
}

#[test]
fn task_10_5_a_gas_that_heats_up_gets_new_lists() {
    // Pairs at rest push each other apart: soon all are faster than the list was made for.
    let at = |k: u32| Particle {
        x: (2.0 + 4.0 * f64::from(k / 2 % 50) + 0.9 * f64::from(k % 2)) * CUTOFF,
        y: (2.0 + 4.0 * f64::from(k / 100)) * CUTOFF,
        vx: 1e-3 * f64::from(k % 7),
        vy: 1e-3 * f64::from(k % 11),
        id: k,
    };
    let scene = Scene::new(2.1, (0..5000).map(at).collect()).expect("a scene");
    let grader = verlet();
    let mut engine = Verlet::<NoStatistics>::new(Workers::new(1), 0.0, 1);
    engine.load(&scene);
    engine.run(100);
    let counters = engine.counters();
    let counted = counters.iter().find(|(name, _)| *name == "share that outruns the list");
    let (_, outliers) = counted.expect("it is counted");
    assert!(*outliers < 0.3, "{outliers} of all are outliers");
    grader.resynchronised(&scene, 10);
}

#[test]
fn task_10_5_two_meet_across_a_worn_skin() {
    // With a skin of 1 c a list lasts until a particle has flown c/2. These two start 2.05 c apart,
    // unlisted, and touch after both have flown 0.525 c.
    let at = |x: f64, vx: f64| Particle { x, y: 0.05, vx, vy: 0.0, id: 0 };
    let scene = Scene::new(0.1, vec![at(0.03, 1.0), at(0.0505, -1.0)]).expect("a scene");
    verlet().set("skin", 1.0).resynchronised(&scene, 40);
}
