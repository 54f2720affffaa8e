use std::panic::{AssertUnwindSafe, catch_unwind};

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Scene, official_size};
use lab2::{
    BIN_SIZE, BinLists, Gather, Grid, SortedBins, VARIANTS, VecBins, forward, take_leavers,
};
use oracle::{Grader, Model, Random, acceleration_of_pair, scenes};
use solution1::Tally;
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

/// Fails where an answer is not the right one.
fn same(question: &str, found: Vec<usize>, expected: Vec<usize>) {
    assert_eq!(found, expected, "{question}");
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

/// `n` particles anywhere in a box of side `size`, numbered.
fn spread(n: usize, size: f64, seed: u64) -> Vec<Particle> {
    let mut random = Random::new(seed);
    let mut place = |id| numbered(id, random.between(0.0, size), random.between(0.0, size));
    (0..n).map(&mut place).collect()
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

fn momentum(grader: &Grader) {
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
fn task_2_1_table_of_grids() {
    let mut table = String::from("side of the box  particles  bins along a wall\n");
    for (side, n) in
        [(0.3, 1), (1.5, 20), (2.55, 200), (9.99, 100), (10.3, 150), (30.55, 1000), (1e6, 10_000)]
    {
        let grid = Grid::new(side * CUTOFF, CUTOFF, n);
        table += &format!("{:>13} c  {n:>9}  {:>17}\n", format!("{side}"), grid.rows());
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_2_1_bins_are_as_wide_as_asked_for() {
    let mut random = Random::new(22);
    for round in 0..10_000 {
        let (side, least) =
            (random.between(1.0, 300.0) * CUTOFF, random.between(1.0, 3.0) * CUTOFF);
        // A wall that a whole number of the least bins fills is where rounding bites.
        let side = if round % 2 == 0 { (side / least).ceil() * least } else { side };
        let grid = Grid::new(side, least, 1_000_000);
        if grid.rows() > 1 {
            let found = grid.bin_side();
            assert!(
                found >= least * (1.0 + 1e-10),
                "{} bins along a wall of {side} have sides of {found}, less than {least} and a margin \
                 for rounding",
                grid.rows()
            );
        }
        let narrower = side / (grid.rows() + 1) as f64;
        assert!(
            narrower <= least * (1.0 + 1e-8),
            "{} bins along a wall of {side}: one more would still be {narrower} wide, and {least} \
             is enough",
            grid.rows()
        );
    }
}

#[test]
fn task_2_1_memory_grows_with_the_particles_and_not_with_the_box() {
    for n in [1, 2, 100, 10_000, 1_000_000] {
        for side in [1e6 * CUTOFF, 1e30, 1e300, f64::MAX] {
            let bins = Grid::new(side, CUTOFF, n).bins();
            let found = format!("{bins} bins in rows and columns for {n} particles, box {side:e}");
            assert!(bins <= 8 * n, "{found}: more than 8 for each particle");
            assert!(bins >= n, "{found}: less than one for each particle, though there is room");
        }
    }
    let n = 100_000;
    let official = Grid::new(official_size(n), CUTOFF, n);
    assert_eq!(official.rows(), 707, "bins along a wall of the official box for {n} particles");
}

#[test]
fn task_2_1_every_place_has_a_bin() {
    let mut random = Random::new(23);
    let mut sizes = vec![1e-300, 0.3 * CUTOFF, CUTOFF, 3.0 * CUTOFF, 1.0, 1e9, 1e300];
    sizes.extend((0..1000).map(|_| random.between(CUTOFF, 300.0 * CUTOFF)));
    for size in sizes {
        let grid = Grid::new(size, CUTOFF, 1_000_000);
        assert!(grid.columns() > 0, "a box of {size:?} has no bin: even the smallest needs one");
        let (last, side) = (grid.columns() - 1, grid.bin_side());
        let below = [size, size.next_down(), size.next_down().next_down()];
        for x in below {
            let column = grid.column(x);
            assert_eq!(column, last, "x = {x:?} in a box of {size:?}: its column, of 0 to {last}");
        }
        assert_eq!(grid.column(0.0), 0, "x = 0 in a box of {size:?}");
        for _ in 0..20 {
            let x = random.between(0.0, size);
            let column = grid.column(x);
            let (left, right) = (column as f64 * side, (column + 1) as f64 * side);
            let slack = 1e-9 * side;
            assert!(
                column <= last && (left - slack..=right + slack).contains(&x),
                "x = {x} in a box of {size}: column {column} is from {left} to {right}"
            );
            assert_eq!(grid.row(x), column, "rows are counted like columns");
        }
    }
}

#[test]
fn task_2_1_columns_have_numbers_of_any_size() {
    for along in [300, 70_000, 1_000_000] {
        let grid = Grid::with_bins_along(1.0, along);
        for expected in [0, 255, 256, along - 1, 65_535.min(along - 2), 65_536.min(along - 3)] {
            let x = (expected as f64 + 0.5) / along as f64;
            assert_eq!(grid.column(x), expected, "the column of x = {x} in a row of {along} bins");
        }
    }
}

#[test]
fn task_2_1_no_pair_within_the_cutoff_is_two_bins_apart() {
    let mut random = Random::new(24);
    for _ in 0..200 {
        let size = random.between(3.0, 200.0) * CUTOFF;
        // Boxes that a whole number of bins fills exactly are where rounding bites.
        let size =
            if random.bits().is_multiple_of(2) { (size / CUTOFF).floor() * CUTOFF } else { size };
        let grid = Grid::new(size, CUTOFF, 1_000_000);
        for edge in 0..grid.columns() {
            let mut x = edge as f64 * grid.bin_side();
            for _ in 0..4 {
                x = x.next_down();
            }
            for _ in 0..8 {
                let to = (x + CUTOFF).min(size);
                let (from, to) = (grid.column(x.max(0.0)), grid.column(to));
                assert!(
                    to <= from + 1,
                    "a box of {size:?}: x = {x:?} is in column {from}, and a cutoff further is column \
                     {to}, beyond the next one: bins are a hair too narrow"
                );
                x = x.next_up();
            }
        }
    }
}

#[test]
fn task_2_2_bins_next_to_a_bin() {
    for (along, index, expected) in [
        (1, 0, 0..1),
        (2, 0, 0..2),
        (2, 1, 0..2),
        (3, 1, 0..3),
        (7, 0, 0..2),
        (7, 1, 0..3),
        (7, 3, 2..5),
        (7, 5, 4..7),
        (7, 6, 5..7),
    ] {
        let near = Grid::with_bins_along(1.0, along).near(index);
        assert_eq!(near, expected, "of {along} rows, those next to row {index}");
    }
}

#[test]
fn task_2_3_each_particle_is_in_its_bin() {
    let grid = Grid::with_bins_along(1.0, 7);
    let mut bins = VecBins::new(grid);
    let particles = spread(500, 1.0, 25);
    bins.refill(&particles);
    for (bin, inside) in bins.bins().iter().enumerate() {
        for p in inside {
            let expected = (p.y * 7.0) as usize * 7 + (p.x * 7.0) as usize;
            assert_eq!(
                bin, expected,
                "particle {} at ({}, {}), in 7 rows of 7 bins: bin number",
                p.id, p.x, p.y
            );
        }
    }
    let count = bins.particles().count();
    assert_eq!(count, 500, "particles in the bins");
    bins.put(numbered(500, 1.0, 1.0));
    assert_eq!(bins.bins()[48].last().map(|p| p.id), Some(500), "one more, in the last corner");
}

#[test]
fn task_2_3_a_bin_takes_any_number() {
    let mut bins = VecBins::new(Grid::with_bins_along(1.0, 3));
    for count in [1, 2, 3, 4, 5, 6, 9, 17, 1000, 0, 2] {
        let crowd: Vec<_> = (0..count).map(|id| numbered(id, 0.5, 0.5)).collect();
        bins.refill(&crowd);
        let inside = bins.bins()[4].len();
        assert_eq!(inside, count, "particles in the middle bin after a refill with {count}");
    }
}

#[test]
fn task_2_3_no_particle_is_left_over_or_left_out_in_1000_refills() {
    let mut bins = VecBins::new(Grid::with_bins_along(1.0, 3));
    for step in 1..=1000 {
        let particles = spread(40, 1.0, step);
        bins.refill(&particles);
        let mut found: Vec<Particle> = bins.particles().copied().collect();
        found.sort_by_key(|p| p.id);
        if let Some(p) = particles.iter().find(|p| !found.contains(p)) {
            panic!("refill {step}: particle {} at ({}, {}) is in no bin", p.id, p.x, p.y);
        }
        if let Some(p) = found.iter().find(|p| !particles.contains(p)) {
            panic!("refill {step}: a particle {} at ({}, {}) is left over", p.id, p.x, p.y);
        }
        assert_eq!(found.len(), 40, "refill {step}: particles in the bins");
    }
}

#[test]
fn task_2_4_a_neighbour_is_felt_from_every_bin_around() {
    visit("2.4");
    let side = 1.02 * CUTOFF;
    let mut bins = VecBins::new(Grid::with_bins_along(5.0 * side, 5));
    for (column, row) in (0..9).map(|k| (k % 3 - 1, k / 3 - 1)) {
        let place = |far: f64| {
            let along = |step: i32| (2.5 + far * f64::from(step)) * side;
            (along(column), along(row))
        };
        let ((x, y), (mut to_x, to_y)) = (place(0.4), place(0.6));
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
fn task_2_4_each_neighbour_counts_once() {
    visit("2.4");
    let size = 6.2 * CUTOFF;
    let particles = spread(120, size, 26);
    let mut bins = VecBins::new(Grid::new(size, CUTOFF, 120));
    bins.refill(&particles);
    for p in &particles {
        let found = bins.acceleration(p, &mut NoStatistics);
        let (mut expected, mut scale) = (Vec2::ZERO, 0.0);
        for q in particles.iter().filter(|q| q.id != p.id) {
            let a = acceleration_of_pair(q.x - p.x, q.y - p.y);
            expected += a;
            scale += a.norm_squared().sqrt();
        }
        assert!(
            (found - expected).norm_squared().sqrt() <= 1e-12 * scale,
            "particle {} at ({}, {}) is accelerated by ({}, {}); each neighbour once makes ({}, {})",
            p.id,
            p.x,
            p.y,
            found.x,
            found.y,
            expected.x,
            expected.y
        );
    }
}

#[test]
fn task_2_4_every_look_is_counted() {
    visit("2.4");
    let size = 6.2 * CUTOFF;
    let particles = spread(120, size, 26);
    let mut bins = VecBins::new(Grid::new(size, CUTOFF, 120));
    bins.refill(&particles);
    for p in &particles {
        let mut tally = Tally::default();
        bins.acceleration(p, &mut tally);
        let next_to = |a: &Particle| {
            let grid = bins.grid();
            grid.row(a.y).abs_diff(grid.row(p.y)) <= 1
                && grid.column(a.x).abs_diff(grid.column(p.x)) <= 1
        };
        let around = particles.iter().filter(|a| next_to(a)).count();
        let told = tally.statistics().map_or(0, |s| s.pair_tests) as usize;
        assert!(
            told == around || told + 1 == around,
            "particle {} has {around} particles in its bins, itself among them; the observer was \
             told that {told} were looked at, in reach or not",
            p.id
        );
    }
}

#[test]
fn task_2_4_bins_further_away_are_not_looked_at() {
    visit("2.4");
    let mut bins = VecBins::new(Grid::with_bins_along(7.0 * CUTOFF, 7));
    let middle = numbered(0, 3.5 * CUTOFF, 3.5 * CUTOFF);
    for (bin, inside) in bins.bins_mut().iter_mut().enumerate() {
        let far = (bin / 7).abs_diff(3).max((bin % 7).abs_diff(3)) > 1;
        // Whoever computes with a place that is no number gets none.
        inside.extend(far.then(|| numbered(bin, f64::NAN, f64::NAN)));
    }
    let found = bins.acceleration(&middle, &mut NoStatistics);
    assert_eq!(
        found,
        Vec2::ZERO,
        "the force of particles two bins away or more, which are not looked at"
    );
}

tests! { "2.4", "rebuild":
    fn task_2_4_rebuild_pairs_over_every_edge = edges;
    fn task_2_4_rebuild_steps = steps;
    fn task_2_4_rebuild_crowds = crowds;
    fn task_2_4_rebuild_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_4_rebuild_the_official_run = official_run;
    fn task_2_4_rebuild_statistics = statistics;
    fn task_2_4_rebuild_pair_tests_do_not_grow = pair_tests_do_not_grow;
}

#[test]
fn task_2_5_leavers_are_taken_out_and_the_rest_stay() {
    questions::leavers(&mut Random::new(33), &mut same);
}

tests! { "2.5", "incremental":
    fn task_2_5_incremental_pairs_over_every_edge = edges;
    fn task_2_5_incremental_steps = steps;
    fn task_2_5_incremental_crowds = crowds;
    fn task_2_5_incremental_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_5_incremental_the_official_run = official_run;
    fn task_2_5_incremental_statistics = statistics;
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
    questions::lists(&mut Random::new(34), &mut same);
}

#[test]
fn task_2_6_the_last_in_is_the_first_out() {
    let mut lists = BinLists::new(2, 5);
    for particle in [3, 0, 4, 1] {
        lists.insert(1, particle);
    }
    assert_eq!(lists.bin(0).count(), 0, "the list of bin 0 is empty");
    let order: Vec<_> = lists.bin(1).take(9).collect();
    assert_eq!(order, [1, 4, 0, 3], "each was put at the head: the order of the list");
    let after: Vec<_> = lists.after(4).take(9).collect();
    assert_eq!(after, [0, 3], "those after particle 4");
}

#[test]
fn task_2_6_particles_have_numbers_of_any_size() {
    let mut lists = BinLists::new(1, 70_000);
    for particle in [3, 69_999, 300, 65_536] {
        lists.insert(0, particle);
    }
    let order: Vec<_> = lists.bin(0).take(9).collect();
    assert_eq!(order, [65_536, 300, 69_999, 3], "the list of a bin of 70,000 particles' box");
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

tests! { "2.7", "linked-list":
    fn task_2_7_linked_list_pairs_over_every_edge = edges;
    fn task_2_7_linked_list_steps = steps;
    fn task_2_7_linked_list_keeps_the_momentum = momentum;
    fn task_2_7_linked_list_crowds = crowds;
    fn task_2_7_linked_list_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_7_linked_list_the_official_run = official_run;
    fn task_2_7_linked_list_statistics = statistics;
}

#[test]
fn task_2_7_linked_list_looks_at_a_pair_once() {
    let [once, twice] =
        ["linked-list", "rebuild"].map(|variant| pair_tests(&grader("2.7", variant), 8000));
    // Nine bins hold the particle itself, and every other pair twice.
    let expected = (twice - 1.0) / 2.0;
    assert!(
        (once - expected).abs() < 1e-9,
        "{once:.3} pair tests per particle; {twice:.3} with nine bins make {expected:.3} with five"
    );
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
        "{said}, so places 1, 2 and 4 are the first to be filled; one that is not there was asked for"
    );
    let found: Vec<_> = bins.particles().iter().map(|p| p.id).collect();
    assert_eq!(found, [1, 4, 3, 0, 2], "{said}; the particles in memory, in their order in each");
    let found = [0, 1, 2].map(|column| bins.span(0, column..column + 1));
    assert_eq!(found, [0..2, 2..3, 3..5], "{said}; their places when all is done");
}

#[test]
fn task_2_8_particles_lie_in_the_order_of_their_bins() {
    let grid = Grid::with_bins_along(1.0, 6);
    let mut bins = SortedBins::new(grid, 0..6);
    for n in [0, 1, 300, 20, 301] {
        let particles = spread(n, 1.0, 27 + n as u64);
        bins.refill(particles.iter().copied());
        let mut expected: Vec<(usize, u32)> =
            particles.iter().map(|p| (grid.bin(p), p.id)).collect();
        expected.sort_unstable();
        let found: Vec<_> = bins.particles().iter().map(|p| (grid.bin(p), p.id)).collect();
        assert_eq!(found.len(), expected.len(), "particles in the bins, of {n}");
        let differs = (0..found.len()).find(|&k| found[k] != expected[k]);
        if let Some(k) = differs {
            let ((bin, id), (right_bin, right)) = (found[k], expected[k]);
            panic!(
                "{n} particles: place {k} in memory holds particle {id} of bin {bin}, not particle \
                 {right} of bin {right_bin}: bins ascend, and within a bin ids do"
            );
        }
        for (row, column) in (0..36).map(|bin| (bin / 6, bin % 6)) {
            let inside: Vec<_> = bins.bin(row, column).iter().map(|p| p.id).collect();
            let bin = row * 6 + column;
            let wanted: Vec<_> =
                expected.iter().filter(|(at, _)| *at == bin).map(|(_, id)| *id).collect();
            assert_eq!(
                inside, wanted,
                "the particles of row {row}, column {column}, in their order"
            );
        }
    }
}

#[test]
fn task_2_8_many_particles() {
    let grid = Grid::with_bins_along(1.0, 2);
    let mut bins = SortedBins::new(grid, 0..2);
    let particles = spread(70_000, 1.0, 26);
    bins.refill(particles.iter().copied());
    for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let is_here = |p: &&Particle| (grid.row(p.y), grid.column(p.x)) == (row, column);
        let expected = particles.iter().filter(is_here).count();
        let found = bins.bin(row, column).iter().filter(is_here).count();
        assert_eq!(found, expected, "of 70,000 particles, those in row {row}, column {column}");
    }
}

#[test]
fn task_2_8_some_rows_of_a_grid() {
    visit("2.8");
    let grid = Grid::with_bins_along(1.0, 10);
    let mut bins = SortedBins::new(grid, 3..7);
    let particles = spread(400, 1.0, 28);
    let inside = particles.iter().filter(|p| (3..7).contains(&grid.row(p.y)));
    bins.refill(inside.clone().copied());
    assert_eq!(bins.particles().len(), inside.clone().count(), "particles in rows 3 to 6");
    for row in 3..7 {
        let found = bins.places(row..row + 1).len();
        let expected = inside.clone().filter(|p| grid.row(p.y) == row).count();
        assert_eq!(found, expected, "particles in row {row} of the rows 3 to 6");
    }
    for p in bins.particles() {
        let column = grid.column(p.x);
        assert!(
            bins.bin(grid.row(p.y), column).contains(p),
            "particle {} is not in row {}, column {column}, where it belongs",
            p.id,
            grid.row(p.y)
        );
    }
}

#[test]
fn task_2_8_sorting_again_follows_the_particles() {
    let grid = Grid::with_bins_along(1.0, 5);
    let mut bins = SortedBins::new(grid, 0..5);
    bins.refill(spread(200, 1.0, 29));
    for step in 1..=100 {
        let mut random = Random::new(step);
        for p in bins.particles_mut() {
            p.x = (p.x + random.between(-0.1, 0.1)).clamp(0.0, 1.0);
            p.y = (p.y + random.between(-0.1, 0.1)).clamp(0.0, 1.0);
        }
        bins.sort();
        let mut seen = [false; 200];
        let mut last = 0;
        for p in bins.particles() {
            assert!(!seen[p.id as usize], "step {step}: particle {} is there twice", p.id);
            seen[p.id as usize] = true;
            let bin = grid.bin(p);
            assert!(bin >= last, "step {step}: particle {} of bin {bin} after bin {last}", p.id);
            last = bin;
        }
        let lost = seen.iter().position(|seen| !seen);
        assert_eq!(lost, None, "step {step}: this particle is lost");
    }
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
    let mut random = Random::new(30);
    let mut gather = Gather::default();
    for seed in 0..200 {
        // Now and then more than 255, all within the cutoff.
        let (n, side) = if seed % 40 == 39 { (400, 0.7 * CUTOFF) } else { (30, 1.5 * CUTOFF) };
        let mut crowd = spread(n, side, 1000 + seed);
        // Ids of any size, also such as differ in their upper bits only.
        let apart = [1, 1 << 8, 1 << 16, u32::MAX / n as u32][(seed / 10 % 4) as usize];
        crowd.iter_mut().for_each(|p| p.id *= apart);
        let p = crowd[(seed % 30) as usize];
        let mut expected = Vec2::ZERO;
        for q in &crowd {
            expected += acceleration_of_pair(q.x - p.x, q.y - p.y);
        }
        for last in (1..crowd.len()).rev() {
            crowd.swap(last, (random.bits() % (last as u64 + 1)) as usize);
        }
        let (some, rest) = crowd.split_at(random.below(n + 1));
        let found = gather.acceleration(&p, [some, rest], &mut NoStatistics);
        let bits = |a: Vec2| (a.x.to_bits(), a.y.to_bits());
        let near = (found - expected).norm_squared() <= 1e-18 * expected.norm_squared();
        let how = if near { ", in the last digits: another order" } else { "" };
        assert!(
            bits(found) == bits(expected),
            "crowd {seed}, particle {}: ({:?}, {:?}) is not the sum in ascending id, ({:?}, {:?}){how}",
            p.id,
            found.x,
            found.y,
            expected.x,
            expected.y
        );
    }
}

#[test]
fn task_2_9_a_particle_alone_is_not_accelerated() {
    let p = numbered(3, 0.5, 0.5);
    let mut gather = Gather::default();
    let crowd = spread(20, CUTOFF, 31);
    gather.acceleration(&crowd[0], [&crowd[..]], &mut NoStatistics);
    for candidates in [&[][..], &[p], &[p, numbered(1, 0.5 + 1.001 * CUTOFF, 0.5)]] {
        let a = gather.acceleration(&p, [candidates], &mut NoStatistics);
        assert_eq!(a, Vec2::ZERO, "no particle is within the cutoff of particle 3");
    }
}

#[test]
fn task_2_9_every_candidate_is_counted() {
    let crowd = spread(50, 4.0 * CUTOFF, 32);
    let mut tally = Tally::default();
    Gather::default().acceleration(&crowd[7], [&crowd[..20], &[], &crowd[20..]], &mut tally);
    let told = tally.statistics().map_or(0, |s| s.pair_tests);
    assert_eq!(told, 50, "candidates that the observer was told of, in reach or not");
}

tests! { "2.9", "sorted":
    fn task_2_9_sorted_pairs_over_every_edge = edges;
    fn task_2_9_sorted_boxes_of_one_particle_and_a_wide_one = loners_and_a_wide_box;
    fn task_2_9_sorted_the_official_run = official_run;
    fn task_2_9_sorted_statistics = statistics;
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

#[test]
fn task_2_9_rows_summed_one_by_one_give_the_same_bits() {
    visit("2.9");
    let scene = scenes::dense();
    let mut model = Model::new(&scene);
    model.step();
    let grid = Grid::new(scene.size(), CUTOFF, scene.len());
    // As a process would: a row at a time, with the row before and the row after as ghosts.
    for row in 0..grid.rows() {
        let mut bins = SortedBins::new(grid, grid.near(row));
        let near = scene.particles().iter().filter(|p| grid.near(row).contains(&grid.row(p.y)));
        bins.refill(near.copied());
        let own = bins.places(row..row + 1);
        let mut found = vec![Vec2::ZERO; own.len()];
        bins.gather_rows(row..row + 1, &mut found, &mut Gather::default(), &mut NoStatistics);
        for (p, a) in bins.particles()[own].iter().zip(&found) {
            let expected = model.accelerations[p.id as usize];
            assert_eq!(*a, expected, "row {row}, particle {}: summed with its ghost rows", p.id);
        }
    }
}
