//! Lab 7's graders.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Output, Stdio};

use common::hard::{RandomScene, Scene};
use hard_discs::{
    Candidate, Collect, Deal, Entry, Find, Found, Grid, Hit, LockedCount, Loops, Planned, Schedule,
    SharedCount, Slots, Span, Square, Survey, Team, Which, Window, Workers,
};
use lab7::{
    Lab7, VARIANTS, append_atomic, append_locked, block_of, choose_windows, inner, nested, outer,
    partners,
};
use oracle::hard::{self, self as model, Event, Grader, What, difference, scenes};
use oracle::{Random, Share, apart, ask, right, within};
use watched::test;

#[path = "lab7/interrupted.rs"]
mod interrupted;
#[path = "lab7/questions.rs"]
mod questions;
#[path = "lab7/search.rs"]
mod search;

/// The pairs that collide by the oracle's formula.
fn pairs_of(scene: &Scene) -> BTreeSet<(u32, u32)> {
    let pair = |event: Event| match event.what {
        What::Disc(other) => Some((event.disc as u32, other as u32)),
        _ => None,
    };
    let events = hard::possible(scene.discs(), scene.side(), scene.radius());
    events.into_iter().filter_map(pair).collect()
}

/// Lets a finder find the pairs of a scene, in `windows` windows, and compares them.
fn finds_all_pairs(name: &str, finder: &mut dyn Find, scene: &Scene) {
    let (square, discs) = (Square::of(scene), scene.discs());
    let windows = finder.windows(discs, square);
    let free = vec![true; discs.len()];
    let mut found = Vec::new();
    for k in 0..windows {
        let mut part = Found::default();
        part.clear(1);
        finder.find(discs, &free, square, Window::part(k, windows), &mut part);
        found.extend(part.lists.concat());
    }
    let expected = pairs_of(scene);
    let mut seen = BTreeSet::new();
    for candidate in found {
        let Hit::Pair(a, b) = candidate.hit else { panic!("{name}: {candidate:?} is no pair") };
        assert!(a < b, "{name}: the lower disc of a pair comes first, and {a} came before {b}");
        assert!(seen.insert((a, b)), "{name}: discs {a} and {b} were found twice");
        assert!(expected.contains(&(a, b)), "{name}: discs {a} and {b} do not collide");
    }
    if let Some((a, b)) = expected.difference(&seen).next() {
        let (p, q) = (discs[*a as usize], discs[*b as usize]);
        panic!("{name}: discs {a} and {b} collide but were not found: {p:?} and {q:?}");
    }
}

#[test]
fn task_7_1_walls_near_and_far() {
    questions::walls(&mut Random::new(71), &mut right);
}

#[test]
fn task_7_2_discs_that_meet() {
    questions::meetings(&mut Random::new(72), &mut right);
}

#[test]
fn task_7_2_discs_in_contact_or_nearly() {
    questions::contacts(&mut Random::new(720), &mut right);
}

#[test]
fn task_7_3_the_order_of_candidates() {
    questions::orders(&mut Random::new(73), &mut right);
}

#[test]
fn task_7_4_a_disc_is_taken_once() {
    questions::single_takes(&mut Random::new(74), &mut right);
}

#[test]
fn task_7_4_takes_the_earliest_first() {
    questions::takes(&mut Random::new(740), &mut right);
    within("7.4", 60, || questions::many_takes(&mut Random::new(7400), &mut right));
}

#[test]
fn task_7_5_waits_where_its_path_leaves() {
    questions::stops(&mut Random::new(75), &mut right);
}

#[test]
fn task_7_6_walls_turn_what_they_must() {
    questions::bounces(&mut Random::new(76), &mut right);
}

#[test]
fn task_7_6_discs_exchange_what_lies_along_the_line_between() {
    questions::collisions(&mut Random::new(760), &mut right);
}

#[test]
fn task_7_7_a_window_takes_its_own_walls() {
    questions::windows(&mut Random::new(77), &mut right);
    questions::cut_steps(&mut Random::new(770), &mut right);
}

fn sequential() -> Grader {
    Grader::new("7.7", VARIANTS, "sequential")
}

#[test]
fn task_7_7_one_step_of_a_hundred_lattices() {
    for seed in 0..100 {
        sequential().resynchronised(&format!("lattice {seed}"), &scenes::lattice(seed), 1);
    }
}

#[test]
fn task_7_7_a_step_begins_with_nothing_taken() {
    // One disc between two walls, and two that meet in the middle of a wide square.
    for (name, scene) in [
        ("a disc alone", scenes::of(10.0, 1.0, &[(4.0, 5.0, 3.0, 0.5)])),
        (
            "two discs far from walls",
            scenes::of(1000.0, 1.0, &[(495.0, 500.0, 3.0, 0.5), (505.0, 500.5, -3.0, 0.5)]),
        ),
    ] {
        sequential().resynchronised(name, &scene, 8);
    }
}

#[test]
fn task_7_7_twenty_steps_of_twenty_scenes() {
    for seed in 0..20 {
        let scene = scenes::random(400, 0.3, 2.0, 1000 + seed);
        sequential().resynchronised(&format!("crowded {seed}"), &scene, 20);
    }
}

#[test]
fn task_7_7_crafted_scenes() {
    for (name, scene) in scenes::all() {
        sequential().resynchronised(name, &scene, 10);
    }
}

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab7"), option_env!("CARGO_BIN_EXE_solution7")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

/// Runs the lab's program on an input, with a gigabyte of memory: enough for any list of n, and
/// for no list of n² here.
fn program(input: &str, arguments: &[&str]) -> Output {
    let (input, arguments) = (input.to_owned(), arguments.join(" "));
    within("7.7", 60, move || {
        let limit = if cfg!(target_os = "linux") { "ulimit -v 1000000; " } else { "" };
        let line = format!("{limit}exec '{PROGRAM}' {arguments}");
        let mut shell = Command::new("sh");
        shell.args(["-c", &line]).stdin(Stdio::piped());
        shell.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut running = shell.spawn().expect("a shell starts");
        let mut stdin = running.stdin.take().expect("its input is piped");
        // A program that refuses the head need not read the rest.
        let _ = stdin.write_all(input.as_bytes());
        drop(stdin);
        running.wait_with_output().expect("it ends")
    })
}

#[test]
fn task_7_7_a_bad_input_gets_one_line() {
    let good = "3 10 1 2 perf\n0 2 2 1 0\n1 5 5 0 1\n2 8 8 -1 -1\n";
    sequential().run(&scenes::of(10.0, 1.0, &[(2.0, 2.0, 1.0, 0.0)]), 1);
    let fine = program(good, &["-t", "1"]);
    assert!(fine.status.success(), "{}", String::from_utf8_lossy(&fine.stderr));
    // What else is refused, the kit's own tests ask.
    for (what, input, line) in [
        ("nothing", String::new(), 1),
        ("a truncated list", good.replace("2 8 8 -1 -1\n", ""), 3),
        ("no number", good.replace("5 5 0 1", "5 5 nan 1"), 3),
        ("a count above the list's", good.replace("3 10", "2000000000 10"), 4),
        ("a radius of zero", good.replace("10 1 2", "10 0 2"), 1),
    ] {
        let output = program(&input, &["-t", "1"]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success(), "{what} is taken as an input");
        assert!(output.stdout.is_empty(), "{what}: discs are written all the same");
        assert_eq!(said.lines().count(), 1, "{what} gets one line, not:\n{said}");
        assert!(said.contains(&format!("line {line}: ")), "{what} in line {line}, it says: {said}");
    }
}

/// One step of `discs` discs of the report's kind in a gigabyte.
fn fits_into_memory(variant: &str, discs: &str) {
    let input = format!("{discs} 20000 1 1 perf\n");
    let output = program(&input, &["-t", "1", "--json", "--variant", variant]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn task_7_7_memory_grows_with_the_discs_not_with_their_pairs() {
    apart(|| questions::long_run("sequential", &mut right));
    sequential().run(&scenes::of(10.0, 1.0, &[(2.0, 2.0, 1.0, 0.0)]), 1);
    // Room for 72 million candidates of 16 bytes would be over a gigabyte.
    fits_into_memory("sequential", "12000");
}

/// Three steps of each of forty scenes, from thin to crowded, small and wide.
fn follows_unseen_scenes(task: &'static str, variant: &str) {
    for seed in 0..40 {
        let mut random = Random::new(1000 + seed);
        let (n, fraction) = (60 + random.below(140), random.between(0.01, 0.4));
        let scene = scenes::random(n, fraction, 20.0, seed);
        let scene = scenes::scaled(&scene, random.between(0.5, 20.0));
        let grader = Grader::new(task, VARIANTS, variant).with_threads(2);
        grader.resynchronised(&format!("unseen {seed}"), &scene, 3);
    }
}

#[test]
fn task_7_7_three_steps_of_unseen_scenes() {
    follows_unseen_scenes("7.7", "sequential");
}

#[test]
fn task_7_7_list_of_collisions() {
    let scene = RandomScene::new(12, 40.0, 2.0, 7).with_speeds(2.0, 12.0).draw().unwrap();
    let config = VARIANTS[0].config();
    let mut simulation = (VARIANTS[0].build)(&config).unwrap();
    simulation.load(&scene);
    let mut discs = scene.discs().to_vec();
    let mut table = String::from("step  disc       x        y       vx       vy  pairs walls\n");
    for t in 1..=3 {
        simulation.step();
        simulation.read(0, &mut discs);
        for (i, d) in discs.iter().enumerate() {
            table += &format!(
                "{t:<5} {i:<4} {:>8.4} {:>8.4} {:>8.4} {:>8.4} {:>5} {:>5}\n",
                d.x, d.y, d.vx, d.vy, d.pair_collisions, d.wall_collisions
            );
        }
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_7_11_the_box_of_a_window() {
    search::spans(&mut Random::new(711), &mut right);
}

#[test]
fn task_7_12_blocks_of_boxes() {
    search::blocks(&mut Random::new(712), &mut right);
}

#[test]
fn task_7_12_the_grid_finds_every_pair() {
    let corner = Span { low: 1.0, high: 2.0 };
    assert_eq!(block_of(corner, corner, 16.0), 0, "the block of a box in the lower left corner");
    for (name, scene) in scenes::all() {
        for deal in [Deal::Discs(3), Deal::Blocks] {
            let workers = Workers::new(3).expect("three threads start");
            let grid = &mut Grid::<Lab7>::new(workers, deal);
            finds_all_pairs(&format!("grid by {deal:?}, {name}"), grid, &scene);
        }
    }
}

#[test]
fn task_7_12_every_pair_of_the_grid_once() {
    search::grids(&mut Random::new(7120), &mut right);
}

#[test]
fn task_7_13_boxes_that_share_a_column() {
    search::columns(&mut Random::new(713), &mut right);
    search::far_columns(&mut right);
    within("7.13", 60, || search::many_columns(&mut right));
}

#[test]
fn task_7_13_cells_find_every_pair() {
    assert_eq!(partners(&[Entry::new(0, 0, 0, true)], 0), 1..1, "the partners of an only entry");
    for (name, scene) in scenes::all() {
        for windows in [1, 2, 7, 64] {
            let mut finder = Planned::<Lab7>::new(Workers::One, Some(windows));
            finds_all_pairs(&format!("{windows} windows, {name}"), &mut finder, &scene);
        }
    }
}

#[test]
fn task_7_14_no_other_number_of_windows_costs_less() {
    search::windows(&mut Random::new(714), &mut right);
}

fn one_disc() -> Scene {
    scenes::of(10.0, 1.0, &[(5.0, 5.0, 0.0, 0.0)])
}

/// Stops at the todo of task 7.14 before a whole engine can stop elsewhere.
fn visit_windows() {
    let (scene, square) = (one_disc(), Square::of(&one_disc()));
    choose_windows(&Survey::of(scene.discs(), square), square, 1.0);
}

#[test]
fn task_7_14_three_steps_of_unseen_scenes() {
    visit_windows();
    follows_unseen_scenes("7.14", "planned");
}

#[test]
fn task_7_14_memory_grows_with_the_discs_not_with_their_pairs() {
    visit_windows();
    apart(|| questions::long_run("planned", &mut right));
    // A byte for each pair would be over a gigabyte; the report's programs crash at this N.
    fits_into_memory("planned", "50000");
}

/// A variant on these numbers of threads has after `steps` steps the bits of `sequential`.
fn bits_of_sequential(
    variant: &str,
    threads: &[usize],
    (name, scene): (&str, &Scene),
    steps: usize,
) {
    let grader = |variant: &str| Grader::new("7.14", VARIANTS, variant);
    let expected = grader("sequential").run(scene, steps);
    for &threads in threads {
        let found = grader(variant).with_threads(threads).run(scene, steps);
        if let Some(wrong) = difference(&expected, &found) {
            panic!("{variant}, {threads} threads, scene {name}: {wrong}");
        }
    }
}

#[test]
fn task_7_14_every_variant_gives_the_same_bits() {
    visit_windows();
    for (name, scene) in scenes::all() {
        for variant in VARIANTS {
            // A fresh team for each inner loop takes its time.
            let slow = variant.name.starts_with("nested") && scene.len() > 100;
            let threads = if slow { &[1, 2][..] } else { &[1, 2, 3, 4, 8] };
            bits_of_sequential(variant.name, threads, (name, &scene), 6);
        }
    }
}

/// Discs that are the denser the further down they are, so that strips have rows of unequal number.
fn uneven(n: usize) -> Scene {
    let mut random = Random::new(716);
    let discs: Vec<_> = (0..n)
        .map(|_| {
            let (x, up) = (random.between(1.0, 999.0), random.between(0.0, 1.0));
            let mut speed = || random.between(-30.0, 30.0);
            (x, 1.0 + 998.0 * up * up * up, speed(), speed())
        })
        .collect();
    scenes::of(1000.0, 1.0, &discs)
}

#[test]
fn task_7_14_many_discs_on_any_number_of_threads() {
    visit_windows();
    // Enough discs for many strips, and for loops in several pieces.
    for (name, scene) in [
        ("dense", scenes::random(9000, 0.6, 3.0, 9)),
        ("sparse", scenes::random(9000, 0.001, 1.0, 10)),
        ("fast", scenes::fast(9000, 11)),
        ("uneven", uneven(9000)),
        ("one disc", one_disc()),
    ] {
        for variant in ["cells", "planned"] {
            bits_of_sequential(variant, &[1, 2, 3, 8], (name, &scene), 2);
        }
    }
}

// The tests of the ways to share out a loop.
include!("lab7/schedules.rs");
