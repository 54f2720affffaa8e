//! Lab 3's graders.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Statistics};
use crossbeam_utils::CachePadded;
use lab3::{
    Barrier, VARIANTS, Worker, in_order, on_threads, pool, rebin_by_one, sum_and_move,
    take_arrivals, under_a_lock, with_atomics,
};
use oracle::scenes::{anywhere, on_edges};
use oracle::yardstick::nanoseconds_each;
use oracle::{Grader, Model, Random, Share, apart, ask, right, scenes, within};
use solution1::Tally;
use solution2::VecBins;
use watched::test;

use self::questions::{parts, statistics};

#[path = "lab3/meeting.rs"]
mod meeting;
#[path = "lab3/questions.rs"]
mod questions;
#[path = "lab3/waiting.rs"]
mod waiting;

fn check_on_all_threads(task: &'static str, variant: &str) {
    Grader::new(task, VARIANTS, variant).seconds(60).bits_on_any_threads();
}

/// Bins of 150 particles at rest on a jittered lattice, nine rows of bins.
fn bins() -> VecBins {
    let scene = scenes::lattice_with_jitter(150, 9.5 * CUTOFF, 0.0, 3);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

#[test]
fn task_3_1_all_pairs_on_several_threads() {
    check_on_all_threads("3.1", "vanilla");
}

#[test]
fn task_3_1_the_threads_of_the_pool_share_the_particles() {
    within("3.1", 60, || meeting::all_pairs(&mut Random::new(310), &mut right));
}

#[test]
fn task_3_1_every_pair_is_counted() {
    within("3.1", 60, || questions::all_pairs(&mut Random::new(31), &mut right));
}

#[test]
fn task_3_1_the_official_bytes() {
    Grader::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes();
}

#[test]
fn task_3_2_a_sum_under_a_lock() {
    within("3.2", 60, || {
        let reduce = |parts: &[Tally]| statistics(&under_a_lock(parts));
        questions::reductions("under a lock", &mut right, reduce);
    });
}

#[test]
fn task_3_2_the_threads_share_the_parts() {
    within("3.2", 60, || meeting::parts(&mut Random::new(320), &mut right));
}

#[test]
fn task_3_2_a_sum_with_atomics() {
    questions::atomics(&mut Random::new(32), &mut right);
    within("3.2", 60, || {
        questions::reductions("with atomics", &mut right, |parts| {
            with_atomics(&parts.iter().map(statistics).collect::<Vec<_>>())
        });
    });
}

#[test]
fn task_3_2_another_thread_between_read_and_write() {
    within("3.2", 10, || waiting::interruptions(&mut right));
}

#[test]
fn task_3_2_a_sum_that_repeats_its_last_digit() {
    within("3.2", 60, || {
        questions::reductions("in order", &mut right, |parts| statistics(&in_order(parts)));
    });
}

#[test]
fn task_3_3_every_row_has_one_owner_and_none_has_much_more() {
    questions::rows(&mut Random::new(33), &mut right);
}

#[test]
fn task_3_4_the_forces_on_own_particles() {
    within("3.4", 60, || questions::forces(&mut Random::new(34), &mut right));
}

#[test]
fn task_3_5_leavers_go_into_the_change_buffer() {
    within("3.5", 60, || questions::moves(&mut Random::new(35), &mut right));
}

#[test]
fn task_3_5_table_of_change_buffers() {
    let mut bins = bins();
    let grid = *bins.grid();
    let columns = grid.columns();
    let mut table = String::from("worker  own rows  left  particle: from row -> to row\n");
    for (number, mut worker) in
        [0..3, 3..6, 6..9].into_iter().map(Worker::<NoStatistics>::new).enumerate()
    {
        let rows = worker.rows.clone();
        let own = &mut bins.bins_mut()[rows.start * columns..rows.end * columns];
        for particle in own.iter_mut().flatten() {
            particle.vy = if particle.id % 30 == 7 { 22.0 } else { 0.0 };
        }
        let rows_before: Vec<_> = own.iter().flatten().map(|p| (p.id, grid.row(p.y))).collect();
        worker.accelerations = vec![Vec2::ZERO; rows_before.len()];
        worker.move_particles(&grid, own);
        worker.changed.sort_by_key(|p| p.id);
        let describe = |p: &Particle| {
            let (_, from) = rows_before.iter().find(|(id, _)| *id == p.id).expect("it was there");
            format!("{}: {from} -> {}", p.id, grid.row(p.y))
        };
        let changed: Vec<_> = worker.changed.iter().map(describe).collect();
        let rows = format!("{rows:?}");
        table += &format!("{number:>6}  {rows:>8}  {:>4}  {}\n", changed.len(), changed.join(", "));
    }
    insta::assert_snapshot!(table);
}

/// On a starter this stops at task 3.6.
fn reach_3_6() {
    sum_and_move::<NoStatistics, Box<Worker<_>>>(&mut [], &mut bins());
}

#[test]
fn task_3_6_the_threads_share_the_workers() {
    reach_3_6();
    within("3.6", 60, || meeting::workers(&mut Random::new(360), &mut right));
}

#[test]
fn task_3_6_every_worker_sums_and_moves() {
    reach_3_6();
    within("3.6", 60, || questions::loops(&mut Random::new(36), &mut right));
}

#[test]
fn task_3_7_the_buffers_are_emptied_into_the_bins() {
    within("3.7", 20, || questions::by_one(&mut Random::new(37), &mut right));
}

#[test]
fn task_3_7_fork_and_join() {
    // Reaches task 3.7 before anything else of the step.
    rebin_by_one(&mut bins(), std::iter::empty());
    check_on_all_threads("3.7", "fork-join");
}

#[test]
fn task_3_8_each_worker_takes_what_lies_in_its_rows() {
    within("3.8", 20, || questions::by_all(&mut Random::new(38), &mut right));
}

#[test]
fn task_3_8_rebinning_by_all() {
    take_arrivals(bins().grid(), 0, &mut [], std::iter::empty());
    check_on_all_threads("3.8", "parallel-rebin");
}

#[test]
fn task_3_8_packed_workers_give_the_same() {
    take_arrivals(bins().grid(), 0, &mut [], std::iter::empty());
    let packed = Grader::new("3.8", VARIANTS, "parallel-rebin").set("padding", 0.0).threads(3);
    packed.bits_of_all_pairs(&scenes::dense(), 20);
}

#[test]
fn task_3_9_the_mail_of_a_member() {
    within("3.9", 60, || questions::mail(&mut Random::new(39), &mut right));
}

#[test]
fn task_3_10_no_member_begins_a_part_too_early() {
    within("3.10", 30, || waiting::rehearsals(8, &mut right));
}

#[test]
fn task_3_10_three_barriers_in_a_step() {
    within("3.10", 20, || waiting::barriers(&mut right));
}

#[test]
fn task_3_11_all_threads_at_the_same_time() {
    within("3.11", 60, || waiting::gatherings(&[0, 1, 5, 257], &mut right));
}

#[test]
fn task_3_11_a_panic_comes_out_with_its_words() {
    within("3.11", 20, || waiting::panics(&mut right));
}

/// On a starter this stops at task 3.11, before the team asks for anything else.
fn team() -> Grader {
    on_threads(1, |_| ());
    Grader::new("3.11", VARIANTS, "team").seconds(60)
}

#[test]
fn task_3_11_the_team() {
    team();
    check_on_all_threads("3.11", "team");
}

#[test]
fn task_3_11_a_late_member_changes_nothing() {
    for late in 1..=4 {
        let grader = team().threads(4).set("late", f64::from(late));
        grader.bits_of_all_pairs(&scenes::all_leave(), 12);
        grader.bits_after_a_run(&scenes::all_leave(), 12);
    }
}

#[test]
fn task_3_11_memory_does_not_grow() {
    let team = team().threads(3);
    apart(|| team.keeps_its_memory());
}

#[test]
fn task_3_11_the_official_bytes() {
    team().threads(2).official_bytes();
}

#[test]
fn task_3_12_who_sees_the_flag_sees_the_numbers() {
    let posted = Statistics { dmin: 0.25, davg: 1.5, navg: 4, pair_tests: 9 };
    for (reading, told) in questions::readings(&posted) {
        let Some(read) = reading.filter(|read| *read != posted) else { continue };
        let both = format!("{read:?} is read, and {posted:?} was posted");
        panic!("task 3.12: the flag was seen, and not all numbers: {both}\n{told}");
    }
}

#[test]
fn task_3_12_what_is_posted_is_read_whole() {
    questions::notices(&mut Random::new(312), &mut right);
}

#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_reductions() {
    const COUNT: usize = 1 << 18;
    let tallies = parts(COUNT);
    let statistics: Vec<_> = tallies.iter().map(statistics).collect();
    println!("threads  one lock  atomics  in order   [ns a part]   different sums in 9 rounds");
    for threads in [1, 2, 4, 8] {
        let pool = pool(threads);
        let mut sums: [HashSet<u64>; 3] = Default::default();
        let davg = |tally: Tally| tally.statistics().expect("it counts").davg.to_bits();
        let times = [
            nanoseconds_each(COUNT, || {
                sums[0].insert(davg(pool.install(|| under_a_lock(&tallies))));
            }),
            nanoseconds_each(COUNT, || {
                sums[1].insert(pool.install(|| with_atomics(&statistics)).davg.to_bits());
            }),
            nanoseconds_each(COUNT, || {
                sums[2].insert(davg(pool.install(|| in_order(&tallies))));
            }),
        ];
        let [lock, atomics, order] = times;
        let sums = sums.map(|sums| sums.len().to_string()).join(", ");
        println!("{threads:>7}  {lock:>8.2}  {atomics:>7.2}  {order:>8.2}                 {sums}");
    }
}

// ANCHOR: false_sharing
/// Each thread counts to `COUNT` in a counter of its own.
fn count<C: AsRef<AtomicU64> + Sync>(counters: &[C]) {
    thread::scope(|scope| {
        for counter in counters {
            scope.spawn(|| {
                for _ in 0..COUNT {
                    counter.as_ref().fetch_add(1, Ordering::Relaxed);
                }
            });
        }
    });
}
// ANCHOR_END: false_sharing

const COUNT: usize = 5_000_000;

struct Packed(AtomicU64);
struct Padded(CachePadded<AtomicU64>);

impl AsRef<AtomicU64> for Packed {
    fn as_ref(&self) -> &AtomicU64 {
        &self.0
    }
}

impl AsRef<AtomicU64> for Padded {
    fn as_ref(&self) -> &AtomicU64 {
        &self.0
    }
}

#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_false_sharing() {
    println!("threads  packed  padded   [ns a count]");
    for threads in [1, 2] {
        let packed: Vec<_> = (0..threads).map(|_| Packed(AtomicU64::new(0))).collect();
        let padded: Vec<_> =
            (0..threads).map(|_| Padded(CachePadded::new(AtomicU64::new(0)))).collect();
        let times = [
            nanoseconds_each(COUNT, || count(&packed)),
            nanoseconds_each(COUNT, || count(&padded)),
        ];
        println!("{threads:>7}  {:>6.2}  {:>6.2}", times[0], times[1]);
    }
}

/// What it costs to start threads and wait for their end, and to let threads that stay meet at a barrier.
#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_threads() {
    const TIMES: usize = 10_000;
    println!("threads  started and joined  at a barrier   [us]");
    for threads in [1, 2, 4] {
        let team = |part: &(dyn Fn() + Sync)| {
            thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(part))));
        };
        let started = nanoseconds_each(TIMES, || (0..TIMES).for_each(|_| team(&|| ())));
        let barrier = Barrier::new(threads);
        let met = nanoseconds_each(TIMES, || team(&|| (0..TIMES).for_each(|_| barrier.wait())));
        println!("{threads:>7}  {:>18.2}  {:>12.2}", started / 1e3, met / 1e3);
    }
}
