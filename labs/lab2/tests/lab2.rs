//! Lab 2's graders.

use std::panic::{AssertUnwindSafe, catch_unwind};

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Particle, Scene};
use lab2::{BIN_SIZE, Gather, Grid, SortedBins, VARIANTS, VecBins, forward, take_leavers};
use oracle::{Count, Grader, Random, acceleration_of_pair, apart, ask, right, scenes, within};
use watched::test;

#[path = "lab2/questions.rs"]
mod questions;

/// Calls the function of a task with next to nothing.
///
/// Most tests need the tasks before theirs, too. On a fresh starter a test must stop at its own
/// todo and at no other, so it visits its own function first.
fn visit(task: &str) {
    let grid = Grid::with_bins_along(1.0, 1);
    let particle = Particle::default();
    match task {
        "2.4" => _ = VecBins::new(grid).acceleration(&particle, &mut NoStatistics),
        "2.5" => take_leavers(&grid, 0, &mut Vec::new(), &mut Vec::new()),
        "2.7" => _ = forward(&grid, 0, 0, &mut [0; 4]),
        "2.8" => SortedBins::new(grid, 0..1).sort(),
        "2.9" => _ = Gather::default().acceleration(&particle, [], &mut NoStatistics),
        _ => unreachable!("task {task} needs no visit"),
    }
}

/// A grader of `variant` for task `task`.
fn grader(task: &'static str, variant: &str) -> Grader {
    visit(task);
    Grader::new(task, VARIANTS, variant)
}

/// A particle at rest.
fn at(x: f64, y: f64) -> Particle {
    Particle { x, y, ..Particle::default() }
}

/// Particle number `id` at rest.
fn numbered(id: usize, x: f64, y: f64) -> Particle {
    Particle { id: id as u32, ..at(x, y) }
}

/// 500 pairs within the cutoff, each pair alone somewhere in a box a million cutoffs wide.
fn wide() -> Scene {
    let size = 1e6 * CUTOFF;
    let mut random = Random::new(21);
    let mut particles = Vec::new();
    for _ in 0..500 {
        let (x, y) = (random.between(0.0, 0.99 * size), random.between(0.0, 0.99 * size));
        particles.extend([at(x, y), at(x + 0.6 * CUTOFF, y + 0.5 * CUTOFF)]);
    }
    // Better to stop here than to ask the machine for memory that it does not have.
    let bins = Grid::new(size, CUTOFF, particles.len()).bins();
    assert!(bins <= 8000, "{bins} bins for 1000 particles in a box a million cutoffs wide");
    Scene::new(size, particles).expect("the scene is sound")
}

/// Boxes of one particle, in the middle, on walls and in corners, large and small.
fn loners() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for size in [1e-300, 0.3 * CUTOFF, CUTOFF, 7.7 * CUTOFF, 1e300] {
        for (x, y) in [(0.5, 0.5), (1.0, 1.0), (0.0, 1.0), (1.0, 0.3)] {
            let scene = Scene::new(size, vec![at(x * size, y * size)]);
            scenes.push(scene.expect("the scene is sound"));
        }
    }
    scenes
}

/// Tests of a variant: each asks what stands behind its name.
macro_rules! tests {
    ($task:literal, $variant:literal: $(fn $test:ident = $ask:ident;)*) => {
        $(
            #[test]
            fn $test() {
                $ask(&grader($task, $variant));
            }
        )*
    };
}

fn memory(grader: &Grader) {
    apart(|| grader.keeps_its_memory());
}

fn edges(grader: &Grader) {
    for bin_size in [1.0, 2.0] {
        grader.clone().set(BIN_SIZE, bin_size).resynchronised_on_each(scenes::edges(), 1);
    }
}

/// On scenes that are not blind.
fn steps(grader: &Grader) {
    for bin_size in [1.0, 1.3, 2.0, 3.0] {
        let grader = grader.clone().set(BIN_SIZE, bin_size);
        grader.resynchronised(&scenes::dense(), 20);
        grader.resynchronised(&scenes::close_pairs(), 5);
        for scene in scenes::fast() {
            grader.resynchronised(&scene, 20);
        }
    }
    grader.forces();
}

fn crowds(grader: &Grader) {
    grader.clone().set(BIN_SIZE, 1.0).crowds();
}

fn loners_and_a_wide_box(grader: &Grader) {
    grader.resynchronised_on_each(loners(), 3);
    grader.resynchronised(&wide(), 3);
}

fn official_run(grader: &Grader) {
    grader.resynchronised(&scenes::official(), 1000);
    grader.official_bytes();
}

fn statistics(grader: &Grader) {
    grader.statistics_of_each_step(&scenes::dense(), 10);
    grader.long_statistics();
}

/// Pair tests per particle of the first step of the official scene.
fn pair_tests(grader: &Grader, n: u64) -> f64 {
    grader.clone().set(BIN_SIZE, 1.0).statistics().run(move |_, engine| {
        engine.load_official(n, 1).expect("the official scene is sound");
        engine.step();
        engine.statistics().expect("statistics were asked for").pair_tests as f64 / n as f64
    })
}

fn pair_tests_do_not_grow(grader: &Grader) {
    for n in [1000, 8000, 64000] {
        let tests = pair_tests(grader, n);
        let found = format!(
            "{}: the observer was told of {tests:.1} pairs per particle at n = {n}",
            grader.name()
        );
        assert!(tests >= 0.1, "{found}: less than are within the cutoff");
        assert!(
            tests <= 4.0,
            "{found}; with bins of one cutoff there should be no more than 4, however many particles"
        );
    }
}

#[test]
fn task_2_1_bins_are_as_wide_as_asked_for() {
    questions::grids(&mut Random::new(22), &mut right);
}

#[test]
fn task_2_1_every_position_has_a_bin() {
    questions::columns(&mut Random::new(23), &mut right);
}

#[test]
fn task_2_2_bins_next_to_a_bin() {
    questions::near(&mut Random::new(24), &mut right);
}

#[test]
fn task_2_3_each_particle_is_in_its_bin() {
    questions::refills(&mut Random::new(25), &mut right);
}

#[test]
fn task_2_4_a_neighbour_is_felt_from_every_bin_around() {
    visit("2.4");
    let side = 1.02 * CUTOFF;
    let mut bins = VecBins::new(Grid::with_bins_along(5.0 * side, 5));
    for (column, row) in (0..9).map(|k| (k % 3 - 1, k / 3 - 1)) {
        let position = |far: f64| {
            let along = |step: i32| (2.5 + far * f64::from(step)) * side;
            (along(column), along(row))
        };
        let ((x, y), (mut to_x, to_y)) = (position(0.4), position(0.6));
        if (column, row) == (0, 0) {
            to_x += 0.1 * side;
        }
        let (p, q) = (numbered(0, x, y), numbered(1, to_x, to_y));
        bins.refill(&[p, q]);
        let found = bins.acceleration(&p, &mut NoStatistics);
        let expected = acceleration_of_pair(q.x - p.x, q.y - p.y);
        let words = match (found - expected).norm_squared().sqrt() {
            off if off <= 1e-12 * expected.norm_squared().sqrt() => continue,
            _ if found == Vec2::ZERO => "is not felt at all".into(),
            _ => format!("accelerates by {found:?}, not by {expected:?}"),
        };
        panic!("particle 0 in bin (2, 2): particle 1 in bin ({}, {}) {words}", 2 + column, 2 + row);
    }
}

#[test]
fn task_2_4_each_particle_of_nine_bins_once() {
    questions::nine_bins(&mut Random::new(26), &mut right);
}

tests! { "2.4", "rebuild":
    fn task_2_4_rebuild_pairs_over_every_edge = edges;
    fn task_2_4_rebuild_steps = steps;
    fn task_2_4_rebuild_crowds = crowds;
    fn task_2_4_rebuild_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_4_rebuild_the_official_run = official_run;
    fn task_2_4_rebuild_statistics = statistics;
    fn task_2_4_rebuild_memory_does_not_grow = memory;
    fn task_2_4_rebuild_pair_tests_do_not_grow = pair_tests_do_not_grow;
}

#[test]
fn task_2_5_leavers_are_taken_out_and_the_rest_stay() {
    within("2.5", 20, || questions::leavers(&mut Random::new(33), &mut right));
}

tests! { "2.5", "incremental":
    fn task_2_5_incremental_pairs_over_every_edge = edges;
    fn task_2_5_incremental_steps = steps;
    fn task_2_5_incremental_crowds = crowds;
    fn task_2_5_incremental_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_5_incremental_the_official_run = official_run;
    fn task_2_5_incremental_statistics = statistics;
    fn task_2_5_incremental_memory_does_not_grow = memory;
}

#[test]
fn task_2_5_incremental_keeps_every_particle_for_1000_steps() {
    for bin_size in [1.0, 2.0] {
        let grader = grader("2.5", "incremental").set(BIN_SIZE, bin_size);
        // The forces first: they soon show particles that are there twice, before the doubles fill the memory.
        grader.resynchronised(&scenes::dense_with_seed(2), 1000);
        grader.keeps_everyone(&scenes::dense(), 1000);
    }
}

#[test]
fn task_2_6_lists_hold_what_was_inserted() {
    questions::lists(&mut Random::new(34), &mut right);
}

#[test]
fn task_2_7_table_of_forward_bins() {
    let mut table = String::from("bins along  row  column  forward bins\n");
    for along in 1..=3 {
        let grid = Grid::with_bins_along(1.0, along);
        for (row, column) in (0..along * along).map(|bin| (bin / along, bin % along)) {
            let mut bins = [0; 4];
            let count = forward(&grid, row, column, &mut bins);
            bins[..count].sort_unstable();
            let words = bins[..count].iter().map(|b| format!(" {b}")).collect::<String>();
            let words = if count == 0 { " none".into() } else { words };
            table += &format!("{along:>10}  {row:>3}  {column:>6} {words}\n");
        }
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_2_7_forward_bins_of_any_grid() {
    questions::forwards(&mut Random::new(27), &mut right);
}

#[test]
fn task_2_7_each_pair_is_looked_at_once() {
    visit("2.7");
    questions::looks(&mut Random::new(28), &mut right);
}

tests! { "2.7", "linked-list":
    fn task_2_7_linked_list_pairs_over_every_edge = edges;
    fn task_2_7_linked_list_steps = steps;
    fn task_2_7_linked_list_memory_does_not_grow = memory;
    fn task_2_7_linked_list_crowds = crowds;
    fn task_2_7_linked_list_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_7_linked_list_the_official_run = official_run;
    fn task_2_7_linked_list_statistics = statistics;
}

#[test]
fn task_2_8_five_particles_in_three_bins() {
    visit("2.8");
    let mut bins = SortedBins::new(Grid::with_bins_along(1.0, 3), 0..1);
    let particles = [2, 0, 2, 1, 0].into_iter().enumerate();
    let particles = particles.map(|(id, bin)| numbered(id, (f64::from(bin) + 0.5) / 3.0, 0.1));
    let said = "particles 0 to 4 in bins 2, 0, 2, 1, 0: bins end at 2, 3 and 5";
    // An overflow alone would not say what it means.
    let sorted = catch_unwind(AssertUnwindSafe(|| bins.refill(particles)));
    assert!(
        sorted.is_ok(),
        "{said}, so indices 1, 2 and 4 are the first to be filled; one that is not there was asked for"
    );
    let found: Vec<_> = bins.particles().iter().map(|p| p.id).collect();
    assert_eq!(found, [1, 4, 3, 0, 2], "{said}; the particles in memory, in their order in each");
    let found = [0, 1, 2].map(|column| bins.span(0, column..column + 1));
    assert_eq!(found, [0..2, 2..3, 3..5], "{said}; their indices when all is done");
}

#[test]
fn task_2_8_particles_lie_in_the_order_of_their_bins() {
    questions::sorts(&mut Random::new(29), &mut right);
}

#[test]
fn task_2_9_every_sum_starts_from_nothing() {
    let (p, q) = (numbered(0, 0.5, 0.5), numbered(1, 0.5 + 0.6 * CUTOFF, 0.5));
    let push = acceleration_of_pair(q.x - p.x, q.y - p.y);
    let mut gather = Gather::default();
    for call in 1..=3 {
        let found = gather.acceleration(&p, [&[p, q][..]], &mut NoStatistics);
        let times = found.x / push.x;
        let grows = (times - call as f64).abs() < 1e-9;
        let why = if grows { ": what was found before is still in the list" } else { "" };
        assert!(
            (times - 1.0).abs() < 1e-12,
            "call {call} for a particle with one neighbour gives {times:.3} times its push{why}"
        );
    }
}

#[test]
fn task_2_9_the_order_of_memory_does_not_matter() {
    questions::sums(&mut Random::new(30), &mut right);
}

tests! { "2.9", "sorted":
    fn task_2_9_sorted_pairs_over_every_edge = edges;
    fn task_2_9_sorted_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_9_sorted_the_official_run = official_run;
    fn task_2_9_sorted_statistics = statistics;
    fn task_2_9_sorted_memory_does_not_grow = memory;
    fn task_2_9_sorted_pair_tests_do_not_grow = pair_tests_do_not_grow;
}

#[test]
fn task_2_9_sorted_steps() {
    steps(&grader("2.9", "sorted"));
    grader("2.9", "sorted").keeps_everyone(&scenes::dense(), 1000);
}

#[test]
fn task_2_9_sorted_crowds() {
    grader("2.9", "sorted").crowds();
}

#[test]
fn task_2_9_sorted_the_bits_of_all_pairs() {
    for bin_size in [1.0, 1.7, 3.0] {
        let grader = grader("2.9", "sorted").set(BIN_SIZE, bin_size);
        for seed in 1..=5 {
            grader.bits_of_all_pairs(&scenes::dense_with_seed(seed), 100);
            grader.bits_of_all_pairs(&scenes::crowd(seed), 10);
        }
        grader.bits_of_all_pairs(&scenes::close_pairs(), 20);
    }
}

#[test]
fn task_2_9_sorted_the_bits_of_other_official_scenes() {
    for (n, seed) in [(1, 1), (2, 9), (300, 7), (777, 5), (1500, 2)] {
        let scene = Scene::official(n, seed).expect("the official scene is sound");
        grader("2.9", "sorted").bits_of_all_pairs(&scene, 200);
    }
}
