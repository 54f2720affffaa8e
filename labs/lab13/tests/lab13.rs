//! Lab 13's graders.

use std::f64::consts::PI;
use std::process::ExitCode;

use common::soft::{CUTOFF, Particle, Scene};
use common_mpi::as_rank;
use lab13::{
    ACROSS, GHOST, MOVED, RENEWAL, STEP, WAIT, best_depth, best_steps, choose, confirm, deep_width,
    exchange_places, ghost_width, load, must_renew, pairs_across, partners, right_steps,
    weigh_rows,
};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use neighbour_list::LISTED;
use neighbour_list::kernels::{Pair, Positions};
use oracle::mpiexec::{self, Ended, OnRanks};
use oracle::{Columns, Model, Random, scenes, spaced};
use strips::{Outlook, Scenery, Strips};
use watched::test;

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab13"), option_env!("CARGO_BIN_EXE_solution13")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

/// Whole steps need tasks 13.1 to 13.6; the program meets the last one first.
fn on_ranks(ranks: usize) -> OnRanks {
    OnRanks::new("13.6", PROGRAM, "strips", ranks)
}

/// Has each rank of a job do `check`, on each of these numbers of ranks.
fn on_each(task: &str, counts: &[usize], check: impl FnOnce(&SimpleCommunicator)) -> Ended {
    mpiexec::on_each(task, counts, || {
        as_rank(|world| {
            check(world);
            ExitCode::SUCCESS
        });
    })
}

fn strips(edges: &[f64]) -> Strips {
    Strips { edges: edges.to_vec() }
}

#[test]
fn task_13_1_two_meet_across_the_border() {
    // Ghosts are chosen, then the two fly towards each other as fast as any.
    for steps in 1..30 {
        for fastest in [0.0, 0.05 * CUTOFF, 0.7 * CUTOFF, 40.0 * CUTOFF] {
            let width = ghost_width(fastest, steps);
            let apart = |step: u32| width * (1.0 + 1e-9) - 2.0 * f64::from(step - 1) * fastest;
            assert!(
                apart(steps) > CUTOFF,
                "ghosts of {} cutoffs for {steps} steps of {} cutoffs: two that were no ghosts of each \
                 other touch in step {steps}",
                width / CUTOFF,
                fastest / CUTOFF
            );
            let spare = width - CUTOFF - 2.0 * f64::from(steps - 1) * fastest;
            assert!(
                spare <= 1e-9 * width,
                "ghosts of {} cutoffs for {steps} steps of {} cutoffs are wider than they need be",
                width / CUTOFF,
                fastest / CUTOFF
            );
        }
    }
}

#[test]
fn task_13_1_no_other_number_of_steps_is_cheaper() {
    let mut random = Random::new(131);
    for _ in 0..200 {
        let fastest = CUTOFF * 10_f64.powf(random.between(-3.0, 1.5));
        let density = 10_f64.powf(random.between(-2.0, 1.0)) / (CUTOFF * CUTOFF);
        let height = CUTOFF * 10_f64.powf(random.between(0.3, 3.5));
        let most = 1 + random.between(0.0, 40.0) as u32;
        let found = best_steps(Scenery { fastest, density, height, most });
        assert!((1..=most).contains(&found), "{found} steps, where lists last {most}");
        let cost = |steps: u32| {
            let width = CUTOFF + 2.0 * f64::from(steps - 1) * fastest;
            let pairs = 2.0 * 2.0 / 3.0 * density * width * width * width / height;
            RENEWAL / f64::from(steps) + GHOST * 2.0 * width / height + ACROSS * pairs
        };
        for steps in 1..=most {
            assert!(
                cost(found) <= cost(steps) * (1.0 + 1e-12),
                "{steps} steps are cheaper than {found}: the fastest goes {} cutoffs in a step, there \
                 are {} particles per square cutoff in strips {} cutoffs high",
                fastest / CUTOFF,
                density * CUTOFF * CUTOFF,
                height / CUTOFF
            );
        }
    }
    let scenery = Scenery { fastest: 0.0, density: 0.0, height: 1.0, most: 1 };
    assert_eq!(best_steps(scenery), 1, "where lists last one step");
}

#[test]
fn task_13_1_table_of_widths() {
    let mut table =
        String::from("for how many steps ghosts are chosen, and how wide, in cutoffs\n\n");
    table += "strip  neighbours   the fastest goes so many cutoffs in a step\n";
    let speeds = [0.01, 0.05, 0.1, 1.0, 45.0];
    let columns = speeds.map(|speed| format!("{speed:>14}")).concat();
    table += &format!("     if at random {columns}\n");
    for (height, neighbours) in [(3.0, 0.6), (3.0, 5.0), (100.0, 0.6), (100.0, 5.0), (1e4, 0.6)] {
        table += &format!("{height:>5}  {neighbours:>10} ");
        for speed in speeds {
            let steps = best_steps(Scenery {
                fastest: speed * CUTOFF,
                density: neighbours / (PI * CUTOFF * CUTOFF),
                height: height * CUTOFF,
                most: 20,
            });
            let width = ghost_width(speed * CUTOFF, steps) / CUTOFF;
            table += &format!("{steps:>7}{width:>7.2}");
        }
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

const BELOW: f64 = f64::NEG_INFINITY;
const ABOVE: f64 = f64::INFINITY;

#[test]
fn task_13_2_partners_are_within_the_width() {
    let even = [BELOW, 1.0, 2.0, 3.0, ABOVE];
    let gaps = [BELOW, 1.0, 1.0, 1.5, 1.5, 1.75, ABOVE];
    for (edges, width, expected) in [
        (&even[..], 0.5, vec![vec![1], vec![0, 2], vec![1, 3], vec![2]]),
        // Strips of height 1 lie within a width of 1 of the next but one: their edges are 1 apart.
        (&even[..], 1.0, vec![vec![1, 2], vec![0, 2, 3], vec![0, 1, 3], vec![1, 2]]),
        (&even[..], 9.0, vec![vec![1, 2, 3], vec![0, 2, 3], vec![0, 1, 3], vec![0, 1, 2]]),
        // Strips 1 and 3 are empty.
        (&gaps[..], 0.1, vec![vec![2], vec![], vec![0, 4], vec![], vec![2, 5], vec![4]]),
        (
            &gaps[..],
            0.6,
            vec![vec![2, 4], vec![], vec![0, 4, 5], vec![], vec![0, 2, 5], vec![2, 4]],
        ),
        (&[BELOW, BELOW, ABOVE, ABOVE][..], 5.0, vec![vec![], vec![], vec![]]),
    ] {
        for (rank, expected) in expected.into_iter().enumerate() {
            assert_eq!(
                partners(&strips(edges), rank, width),
                expected,
                "partners of rank {rank}, strips cut at {edges:?}, ghosts {width} wide"
            );
        }
    }
}

#[test]
fn task_13_2_partners_find_each_other() {
    let mut random = Random::new(132);
    for _ in 0..300 {
        let ranks = 1 + random.between(0.0, 8.0) as usize;
        let mut edges: Vec<f64> = (1..ranks).map(|_| random.between(0.0, 1.0)).collect();
        edges.sort_by(f64::total_cmp);
        edges.insert(0, BELOW);
        edges.push(ABOVE);
        let (strips, width) = (Strips { edges }, random.between(0.0, 0.6));
        let all: Vec<Vec<Rank>> = (0..ranks).map(|rank| partners(&strips, rank, width)).collect();
        for (a, b) in (0..ranks).flat_map(|a| (0..ranks).map(move |b| (a, b))) {
            let finds = |a: usize, b: usize| all[a].contains(&(b as Rank));
            assert_eq!(finds(a, b), finds(b, a), "{a} finds {b} and {b} finds {a}: {strips:?}");
        }
        assert!(all.iter().all(|partners| partners.is_sorted()), "in ascending order");
    }
}

#[test]
fn task_13_3_ghosts_are_near_the_strip() {
    let y = [0.5, 1.0, 1.25, 1.5, 1.75, 2.0, 0.75];
    for (strip, width, expected) in [
        (2.0..3.0, 0.5, vec![3, 4, 5]),
        (2.0..ABOVE, 0.25, vec![4, 5]),
        (BELOW..0.5, 0.5, vec![0, 1, 6]),
        (4.0..5.0, 1.0, vec![]),
        (4.0..5.0, 3.0, vec![1, 2, 3, 4, 5]),
    ] {
        assert_eq!(
            choose(&y, &strip, width),
            expected,
            "particles at y = {y:?}, ghosts {width} wide around the strip {strip:?}"
        );
    }
}

#[test]
fn task_13_3_pairs_across_are_within_reach() {
    let mut random = Random::new(133);
    for (own, ghosts, reach) in
        [(0, 5, 1.0), (5, 0, 1.0), (40, 60, 0.3), (80, 30, 0.05), (20, 20, 3.0)]
    {
        let mut axis =
            |n: usize| -> Vec<f64> { (0..n).map(|_| random.between(0.0, 1.0)).collect() };
        let [x, y, ghost_x, ghost_y] = [axis(own), axis(own), axis(ghosts), axis(ghosts)];
        let expected = (0..own).flat_map(|i| (0..ghosts).map(move |j| (i, j))).filter(|&(i, j)| {
            let (dx, dy) = (ghost_x[j] - x[i], ghost_y[j] - y[i]);
            dx * dx + dy * dy <= reach * reach
        });
        let expected: Vec<Pair> = expected.map(|(i, j)| [i as u32, j as u32]).collect();
        let places = |x, y| Positions { x, y, first: 0 };
        let mut found = pairs_across(places(&x, &y), places(&ghost_x, &ghost_y), reach);
        assert!(found.is_sorted_by_key(|pair| pair[0]), "ascending in the own particle");
        found.sort_unstable();
        assert_eq!(found, expected, "{own} own particles and {ghosts} ghosts within {reach}");
    }
    let [row, ghosts] = [[0.0, 1.0], [2.0, 3.0]];
    let row = Positions { x: &row, y: &[0.0; 2], first: 0 };
    let ghosts = Positions { x: &ghosts, y: &[0.0; 2], first: 0 };
    assert_eq!(pairs_across(row, ghosts, 2.0), [[0, 0], [1, 0], [1, 1]], "at reach is within");
}

#[test]
fn task_13_3_the_example_of_the_book() {
    const WIDTH: f64 = 1.2;
    let [dozen, _] = scenes::dozen();
    let strips = strips(&[BELOW, 2.0, 4.0, ABOVE]);
    let of = |rank: usize| -> Vec<&Particle> {
        dozen.iter().filter(|p| strips.owner(p.y) == rank).collect()
    };
    let chosen = |from: usize, to: usize| -> Vec<&Particle> {
        let own = of(from);
        let y: Vec<f64> = own.iter().map(|p| p.y).collect();
        choose(&y, &strips.strip(to), WIDTH).iter().map(|place| own[*place as usize]).collect()
    };
    let across = |rank: usize, other: usize| {
        let (own, ghosts) = (chosen(rank, other), chosen(other, rank));
        let axis = |of: &[&Particle], axis: fn(&Particle) -> f64| -> Vec<f64> {
            of.iter().map(|p| axis(p)).collect()
        };
        let [x, y] = [axis(&own, |p| p.x), axis(&own, |p| p.y)];
        let [ghost_x, ghost_y] = [axis(&ghosts, |p| p.x), axis(&ghosts, |p| p.y)];
        let places = Positions { x: &x, y: &y, first: 0 };
        let pairs = pairs_across(places, Positions { x: &ghost_x, y: &ghost_y, first: 0 }, WIDTH);
        spaced(
            pairs
                .iter()
                .map(|[i, j]| format!("{}-{}", own[*i as usize].id, ghosts[*j as usize].id)),
        )
    };
    let ids = |particles: &[&Particle]| spaced(particles.iter().map(|p| p.id));
    let before = |rank: usize| rank.checked_sub(1);
    let after = |rank: usize| Some(rank + 1).filter(|rank| *rank < 3);
    let with =
        |other: Option<usize>, cell: &dyn Fn(usize) -> String| other.map_or_else(String::new, cell);
    let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
    table.row("own particles", (0..3).map(|rank| ids(&of(rank))));
    for (way, other) in [("before", &before as &dyn Fn(usize) -> Option<usize>), ("after", &after)]
    {
        let sent = |rank| with(other(rank), &|other| ids(&chosen(rank, other)));
        table.row(format!("to the rank {way}"), (0..3).map(sent));
    }
    let ghosts = |rank: usize| {
        let from = [before(rank), after(rank)].into_iter().flatten();
        let all: Vec<&Particle> = from.flat_map(|other| chosen(other, rank)).collect();
        format!("{} ({})", ids(&of(rank)), ids(&all))
    };
    table.row("with ghosts, in ()", (0..3).map(ghosts));
    for (way, other) in [("before", &before as &dyn Fn(usize) -> Option<usize>), ("after", &after)]
    {
        let pairs = |rank| with(other(rank), &|other| across(rank, other));
        table.row(format!("pairs across, to the rank {way}"), (0..3).map(pairs));
    }
    insta::assert_snapshot!(table.to_string());
}

/// The places that rank `from` sends to rank `to`: a different number each way.
fn letter(from: Rank, to: Rank, factor: usize) -> Vec<f64> {
    let len = factor * (from as usize % 3 + to as usize % 2);
    (0..len).map(|k| f64::from(100 * from + to) + k as f64 * 1e-6).collect()
}

/// Every rank exchanges places with the rank before and the rank after it.
fn exchange(world: &SimpleCommunicator, factor: usize, mut meanwhile: impl FnMut()) {
    let (rank, ranks) = (world.rank(), world.size());
    let partners: Vec<Rank> =
        [rank - 1, rank + 1].into_iter().filter(|other| (0..ranks).contains(other)).collect();
    let sent: Vec<_> = partners.iter().map(|to| letter(rank, *to, factor)).collect();
    let expected: Vec<_> = partners.iter().map(|from| letter(*from, rank, factor)).collect();
    let mut received: Vec<_> = expected.iter().map(|places| vec![-1.0; places.len()]).collect();
    let mut worked = 0;
    exchange_places(world, &partners, &sent, &mut received, || {
        worked += 1;
        meanwhile();
    });
    assert_eq!(worked, 1, "the inner particles move once");
    for ((from, received), expected) in partners.iter().zip(&received).zip(&expected) {
        assert_eq!(
            received.len(),
            expected.len(),
            "how many numbers of rank {from} came to {rank}"
        );
        assert!(received == expected, "what rank {from} sent to rank {rank} arrived otherwise");
    }
}

#[test]
fn task_13_4_places_reach_the_partners() {
    on_each("13.4", &[1, 2, 3, 5], |world| {
        [0, 1, 50, 1000].iter().for_each(|n| exchange(world, *n, || ()))
    });
}

#[test]
fn task_13_4_long_lists_do_not_wait_for_each_other() {
    on_each("13.4", &[2, 4], |world| exchange(world, 300_000, || ()));
}

/// Rank 1 begins to exchange only when rank 0 has moved its inner particles.
#[test]
fn task_13_4_inner_particles_do_not_wait_for_ghosts() {
    on_each("13.4", &[2], |world| {
        let other = world.process_at_rank(1 - world.rank());
        if world.rank() == 1 {
            let _: (i32, _) = other.receive_with_tag(7);
            exchange(world, 1000, || ());
        } else {
            exchange(world, 1000, || other.send_with_tag(&1, 7));
        }
    });
}

#[test]
fn task_13_5_particles_and_pairs_cost() {
    for (particles, pairs) in [(0, 0), (1, 0), (0, 1), (7, 3), (1_000_000, 3_000_000)] {
        let expected = (MOVED * particles as f64 + LISTED * pairs as f64).ceil() as u64;
        assert_eq!(load(particles, pairs), expected, "{particles} particles and {pairs} pairs");
    }
}

#[test]
fn task_13_5_rows_share_the_load() {
    for (counts, load, expected) in [
        (vec![1, 1, 2], 100, vec![25, 25, 50]),
        (vec![0, 3, 0, 1], 8, vec![0, 6, 0, 2]),
        (vec![1, 1, 1], 10, vec![3, 3, 3]),
        (vec![2, 1, 4], 10, vec![2, 1, 5]),
        (vec![0, 0], 0, vec![0, 0]),
        (vec![1 << 40, 1 << 40], 1 << 50, vec![1 << 49, 1 << 49]),
    ] {
        assert_eq!(weigh_rows(&counts, load), expected, "a load of {load} in rows of {counts:?}");
    }
}

#[test]
fn task_13_6_one_rank_decides_for_all() {
    on_each("13.6", &[1, 2, 3, 5], |world| {
        let (rank, ranks) = (world.rank(), world.size());
        let width = 3.0 * CUTOFF;
        let ask = |list: bool, moved: f64| must_renew(world, list, moved * CUTOFF, width);
        assert!(!ask(false, 0.0), "no particle has moved");
        for first in 0..ranks {
            assert!(ask(rank == first, 0.0), "the list of rank {first} has expired");
            let moved = if rank == first { 1.01 } else { 0.1 };
            assert!(ask(false, moved), "a particle of rank {first} has gone 1.01 cutoffs");
        }
        assert!(!ask(false, 0.99), "particles have gone 0.99 cutoffs under ghosts of 3");
        assert!(!must_renew(world, false, 0.0, CUTOFF), "ghosts for one step, and none moved");
        assert!(must_renew(world, false, f64::INFINITY, 0.0), "before the first list");
    });
}

#[test]
fn task_13_6_the_official_bytes() {
    for ranks in [1, 2, 3, 5] {
        on_ranks(ranks).official_bytes();
    }
}

#[test]
fn task_13_6_dense_scenes_follow_the_model() {
    for ranks in [1, 2, 3, 5] {
        on_ranks(ranks).follows_the_model(&scenes::dense(), 40);
    }
    on_ranks(3).follows_the_model(&scenes::close_pairs(), 20);
    for scene in scenes::edges().iter().step_by(7) {
        on_ranks(2).follows_the_model(scene, 3);
    }
}

#[test]
fn task_13_6_a_scene_that_lasts_many_lists() {
    let scene = Scene::counter(4000, 3).expect("a scene");
    for ranks in [2, 3] {
        on_ranks(ranks).follows_the_model(&scene, 120);
    }
}

#[test]
fn task_13_6_more_ranks_than_rows() {
    for ranks in [4, 7] {
        on_ranks(ranks).follows_the_model(&scenes::crowd(3), 5);
    }
    let alone = Scene::new(0.3, vec![Particle { x: 0.1, y: 0.3, ..Particle::default() }]);
    on_ranks(3).follows_the_model(&alone.expect("a scene"), 3);
}

#[test]
fn task_13_6_fast_particles() {
    for scene in scenes::fast() {
        for ranks in [2, 5] {
            on_ranks(ranks).follows_the_model(&scene, 20);
        }
    }
}

#[test]
fn task_13_6_particles_that_become_fast() {
    // A pair so close that it flies apart at once, among particles at rest: through several strips
    // before any list expects it.
    let mut particles =
        scenes::lattice_with_jitter(600, 60.0 * CUTOFF, 0.01, 5).particles().to_vec();
    let middle = 30.0 * CUTOFF;
    particles.push(Particle { x: middle, y: middle, ..Particle::default() });
    particles.push(Particle { x: middle, y: middle + 0.02 * CUTOFF, ..Particle::default() });
    let scene = Scene::new(60.0 * CUTOFF, particles).expect("a scene");
    for ranks in [2, 5] {
        on_ranks(ranks).follows_the_model(&scene, 20);
    }
}

#[test]
fn task_13_6_empty_ranks() {
    for y in [0.0, 45.0 * CUTOFF] {
        on_ranks(4).follows_the_model(&scenes::corner(y), 20);
    }
    // Other ranks have rows and no particles, or no rows.
    on_ranks(5).follows_the_model(&scenes::one_row(), 10);
}

#[test]
fn task_13_6_strips_are_cut_anew_when_the_scene_drifts() {
    strips_are_cut_anew(on_ranks(3));
}

fn strips_are_cut_anew(grader: OnRanks) {
    let (grader, scene) = (grader.option("--param", "rebalance=1"), scenes::drifting());
    grader.follows_the_model(&scene, 40);
    let [anew] = grader.counters(&scene, 40, ["times the strips were cut anew"]);
    assert!(anew >= 3.0, "the scene crossed the box and the strips were cut anew {anew} times");
}

#[test]
fn task_13_6_two_meet_across_the_border() {
    // With a skin of 1 c a list lasts until a particle has flown c/2. These two start 2.05 c apart on
    // two ranks, and touch after both have flown 0.525 c.
    let at = |y: f64, vy: f64| Particle { x: 0.05, y, vx: 0.0, vy, id: 0 };
    let scene = Scene::new(0.1, vec![at(0.03, 1.0), at(0.0505, -1.0)]).expect("a scene");
    on_ranks(2).option("--param", "skin=1").follows_the_model(&scene, 40);
}

#[test]
fn task_13_6_a_run_repeats_to_the_bit() {
    let scene = scenes::dense();
    let grader = on_ranks(3);
    let [first, second] = [grader.states(&scene, 60), grader.states(&scene, 60)];
    assert!(first == second, "two runs on three ranks gave different bits");
}

#[test]
fn task_13_6_threads_do_not_show() {
    let scene = Scene::counter(4000, 2).expect("a scene");
    let alone = on_ranks(2).states(&scene, 30);
    for threads in ["1", "3"] {
        let grader = OnRanks::new("13.6", PROGRAM, "strips-threads", 2).option("-t", threads);
        assert!(grader.states(&scene, 30) == alone, "other bits on {threads} threads a rank");
    }
}

#[test]
fn task_13_6_statistics_of_a_dense_box() {
    // A few steps: then particles that came close have parted by what rounding made of them.
    let averages = |ranks: usize| {
        let printed = on_ranks(ranks).run(&scenes::dense(), 4, &["--statistics"]).stdout;
        let words = printed.lines().find(|line| line.starts_with("absmin")).map(String::from);
        let neighbours = printed.lines().find(|line| line.starts_with("neighbours"));
        let neighbours = neighbours.and_then(|line| line.split(',').next()).map(String::from);
        (words.expect("statistics were printed"), neighbours)
    };
    let one = averages(1);
    for ranks in [2, 5] {
        assert_eq!(averages(ranks), one, "statistics of {ranks} ranks");
    }
}

#[test]
fn task_13_6_lists_last_and_only_places_are_sent() {
    let scene = Scene::counter(20_000, 1).expect("a scene");
    let grader = on_ranks(2);
    let names = ["steps per list", "messages per step, busiest rank"];
    let [steps, messages] = grader.counters(&scene, 100, names);
    assert!(steps > 4.0, "a list lasted {steps} steps");
    // One message of places and one word in a step; what a list costs is spread over its steps.
    assert!(messages < 4.0, "{messages} messages in a step on two ranks");
}

#[test]
fn task_13_6_a_killed_rank_ends_the_job() {
    on_ranks(3).ends_when_a_rank_is_killed();
}

#[test]
fn task_13_7_table_of_depths() {
    let mut table =
        String::from("for how many steps ghosts are chosen, and how deep, in cutoffs\n\n");
    table += "strip  particles   the fastest goes so many cutoffs in a step\n";
    let speeds = [0.01, 0.05, 0.1, 1.0, 45.0];
    let columns = speeds.map(|speed| format!("{speed:>15}")).concat();
    table += &format!("                {columns}\n");
    for (height, particles) in [(3.0, 20.0), (35.0, 500.0), (112.0, 5e3), (1118.0, 5e5)] {
        table += &format!("{height:>5}  {particles:>9} ");
        for speed in speeds {
            let fastest = speed * CUTOFF;
            let outlook = Outlook { fastest, height: height * CUTOFF, particles, most: 20 };
            let steps = best_depth(outlook);
            let depth = deep_width(fastest, steps) / CUTOFF;
            table += &format!("{steps:>8}{depth:>7.2}");
        }
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

include!("lab13/epochs.rs");
include!("lab13/deep.rs");
