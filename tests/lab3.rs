use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Simulation, Statistics};
use crossbeam_utils::CachePadded;
use lab3::{
    BLOCK, Barrier, VARIANTS, Vanilla, Worker, in_order, on_threads, pool, rebin_by_one,
    sum_and_move, take_arrivals, take_steps, under_a_lock, with_atomics,
};
use oracle::scenes::{anywhere, on_edges};
use oracle::yardstick::nanoseconds_each;
use oracle::{Grader, Model, Random, ask, right, scenes, within};
use parking_lot::Mutex;
use solution1::Tally;
use solution2::{Grid, VecBins};
use watched::test;

use self::meeting::{MEETING, Moved, OfOne, Slow, Visitor};
use self::waiting::{MEMBERS, Rehearsal, gather, interrupted, rehearse};

#[path = "lab3/meeting.rs"]
mod meeting;
#[path = "lab3/questions.rs"]
mod questions;
#[path = "lab3/waiting.rs"]
mod waiting;

const THREADS: [usize; 5] = [1, 2, 3, 4, 8];

/// All checks of DESIGN for a variant that gives the bits of all pairs.
fn check(task: &'static str, variant: &str, threads: usize) {
    let grader = Grader::new(task, VARIANTS, variant).threads(threads).seconds(60);
    grader.resynchronised(&scenes::dense(), 20);
    grader.bits_of_all_pairs(&scenes::dense(), 20);
    grader.bits_of_all_pairs(&scenes::crowd(2), 4);
    grader.resynchronised_on_each(scenes::edges(), 1);
    grader.resynchronised_on_each((1..=20).map(scenes::crowd).collect(), 2);
    grader.resynchronised(&scenes::close_pairs(), 5);
    grader.bits_of_all_pairs(&scenes::all_leave(), 20);
    for scene in scenes::fast() {
        grader.resynchronised(&scene, 10);
    }
    grader.statistics_of_each_step(&scenes::dense(), 5);
}

fn check_on_all_threads(task: &'static str, variant: &str) {
    for threads in THREADS {
        check(task, variant, threads);
    }
    let grader = Grader::new(task, VARIANTS, variant).seconds(60);
    grader.same_bits_on_threads(&scenes::dense_with_seed(7), 50, &THREADS);
    grader.clone().threads(3).keeps_everyone(&scenes::dense_with_seed(8), 1000);
    // More threads than rows of bins, and more buffers than a loop over a few would read.
    grader.clone().threads(17).bits_of_all_pairs(&scenes::all_leave(), 20);
}

/// Bins of 150 particles at rest on a jittered lattice, nine rows of bins.
fn bins() -> VecBins {
    let scene = scenes::lattice_with_jitter(150, 9.5 * CUTOFF, 0.0, 3);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

/// Only one test at a time may use the meeting.
static IN_USE: Mutex<()> = Mutex::new(());

/// Fails unless exactly `threads` threads of one pool share the work, of which `Visitor` is told.
fn assert_shared(task: &str, doing: &str, threads: usize, work: impl FnOnce() + Send + 'static) {
    let _in_use = IN_USE.lock();
    MEETING.begin(threads);
    within(task, 30, work);
    let [count, of_pool] = MEETING.end(threads);
    assert!(count > 0, "task {task}: the observers were told of nothing");
    assert!(count > 1, "task {task}: one thread alone {doing}, of a pool of {threads}");
    assert!(
        count == threads && of_pool == count,
        "task {task}: {count} threads {doing}, not the {threads} of the pool"
    );
}

#[test]
fn task_3_1_all_pairs_on_several_threads() {
    for threads in [1, 2, 3, 8] {
        check("3.1", "vanilla", threads);
    }
    Grader::new("3.1", VARIANTS, "vanilla").same_bits_on_threads(
        &scenes::dense_with_seed(7),
        20,
        &THREADS,
    );
}

#[test]
fn task_3_1_the_threads_of_the_pool_share_the_particles() {
    for threads in [2, 5] {
        assert_shared("3.1", "summed all forces", threads, move || {
            let mut engine = Vanilla::<Visitor>::new(threads);
            engine.load(&scenes::dense());
            engine.sum_forces();
        });
    }
}

#[test]
fn task_3_1_every_pair_is_counted() {
    within("3.1", 60, || questions::all_pairs(&mut Random::new(31), &mut right));
}

#[test]
fn task_3_1_each_particle_has_an_observer() {
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&scenes::dense());
    engine.sum_forces();
    let alone = Simulation::statistics(&engine).map(|seen| seen.navg);
    assert_eq!(
        alone,
        Some(150),
        "of 150 observers, those that were told of the pairs of one particle; a sum of several depends on \
         which thread comes first"
    );
}

#[test]
fn task_3_1_the_official_bytes() {
    Grader::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes();
}

/// Statistics whose sum depends, in its last digits, on the order in which they are added.
fn parts(count: usize) -> Vec<Tally> {
    let part = |i: usize| {
        let mut tally = Tally::default();
        tally.tested(i as u64);
        tally.seen(CUTOFF * CUTOFF * (0.02 + 0.9 * (i as f64 * 0.618).fract()));
        tally
    };
    (0..count).map(part).collect()
}

fn statistics(tally: &Tally) -> Statistics {
    tally.statistics().expect("a tally has statistics")
}

/// The sum of some parts in their order.
fn sum<O: Observer>(parts: &[O]) -> O {
    let mut sum = O::default();
    for part in parts {
        sum.merge(part);
    }
    sum
}

/// `what` says which parts were added up, and how.
fn assert_sum(what: &str, found: Statistics, expected: Statistics) {
    assert_eq!(found.navg, expected.navg, "task 3.2, {what}: pairs within the cutoff");
    assert_eq!(found.pair_tests, expected.pair_tests, "task 3.2, {what}: pairs looked at");
    assert_eq!(found.dmin, expected.dmin, "task 3.2, {what}: the least distance");
    let off = (found.davg - expected.davg).abs();
    assert!(
        off <= 1e-12 * expected.davg,
        "task 3.2, {what}: the sum of distances is {}, that of the parts {}",
        found.davg,
        expected.davg
    );
}

#[test]
fn task_3_2_a_sum_under_a_lock() {
    for threads in THREADS {
        let found = within("3.2", 20, move || pool(threads).install(|| under_a_lock(&parts(1000))));
        let what = format!("1000 parts under a lock on {threads} threads");
        assert_sum(&what, statistics(&found), statistics(&sum(&parts(1000))));
    }
}

#[test]
fn task_3_2_no_update_is_lost() {
    let found = within("3.2", 20, || pool(4).install(|| under_a_lock(&vec![Slow(1); 100])));
    let lost = if found.0 < 100 { ": one thread has overwritten what another added" } else { "" };
    assert_eq!(found.0, 100, "task 3.2: parts in the total, of 100{lost}");
}

#[test]
fn task_3_2_the_threads_share_the_parts() {
    // On a starter this stops at its own todo.
    under_a_lock::<Tally>(&[]);
    for threads in [2, 3] {
        let parts = vec![Visitor; 20 * BLOCK];
        assert_shared("3.2, under a lock", "added all parts", threads, {
            let parts = parts.clone();
            move || _ = pool(threads).install(|| under_a_lock(&parts))
        });
        assert_shared("3.2, in order", "summed all blocks", threads, move || {
            _ = pool(threads).install(|| in_order(&parts));
        });
    }
}

#[test]
fn task_3_2_a_sum_with_atomics() {
    questions::atomics(&mut Random::new(32), &mut right);
    for threads in THREADS {
        let found = within("3.2", 20, move || {
            let parts: Vec<_> = parts(1000).iter().map(statistics).collect();
            pool(threads).install(|| with_atomics(&parts))
        });
        let what = format!("1000 parts with atomics on {threads} threads");
        assert_sum(&what, found, statistics(&sum(&parts(1000))));
    }
}

#[test]
fn task_3_2_another_thread_between_read_and_write() {
    for times in [1, 2, 3, 40, 1000] {
        let all = within("3.2", 10, move || interrupted(times));
        let came = format!("of another thread that came between, {times} times");
        let davg = 1.0 + 0.25 * f64::from(times);
        assert_eq!(all.davg, davg, "task 3.2: twice 0.5, and 0.25 {came}");
        // One addition as a whole is interrupted by no one.
        let more = [2, 2 * u64::from(times)];
        let (navg, tests) = (all.navg.wrapping_sub(2), all.pair_tests.wrapping_sub(8));
        assert!(more.contains(&navg), "task 3.2: {} is not twice 1, and 2 {came}", all.navg);
        assert!(more.contains(&tests), "task 3.2: {} is not twice 4, and 2 {came}", all.pair_tests);
        assert_eq!(all.dmin, 0.125, "task 3.2: the least, which another thread found");
    }
}

#[test]
fn task_3_2_a_sum_that_repeats_its_last_digit() {
    for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 1000, 70_000] {
        let parts = parts(count);
        let blocks: Vec<Tally> = parts.chunks(BLOCK).map(sum).collect();
        let expected = statistics(&sum(&blocks));
        for threads in THREADS {
            let found = within("3.2", 20, {
                let parts = parts.clone();
                move || pool(threads).install(|| in_order(&parts))
            });
            let what = format!("{count} parts in blocks of {BLOCK} on {threads} threads");
            assert_sum(&what, statistics(&found), expected);
            assert_eq!(
                statistics(&found).davg.to_bits(),
                expected.davg.to_bits(),
                "task 3.2: the bits of the sum of {count} distances on {threads} threads, {} and \
                 not {}",
                statistics(&found).davg,
                expected.davg
            );
        }
    }
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

/// Three workers that share the nine rows of [`bins`].
fn three_workers<O: Observer>() -> [Box<Worker<O>>; 3] {
    [0..3, 3..6, 6..9].map(|rows| Box::new(Worker::new(rows)))
}

#[test]
fn task_3_5_table_of_change_buffers() {
    let mut bins = bins();
    let grid = *bins.grid();
    let columns = grid.columns();
    let mut table = String::from("worker  own rows  left  particle: from row -> to row\n");
    for (number, worker) in three_workers::<NoStatistics>().iter_mut().enumerate() {
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
    assert_shared("3.6", "summed all forces", 3, || {
        let mut bins = bins();
        let mut workers = three_workers::<Visitor>();
        pool(3).install(|| sum_and_move(&mut workers, &mut bins));
    });
}

#[test]
fn task_3_6_the_threads_share_the_moves() {
    reach_3_6();
    assert_shared("3.6", "moved all particles", 3, || {
        let mut bins = bins();
        let mut workers = [0..3, 3..6, 6..9].map(|rows| Moved(Worker::new(rows)));
        pool(3).install(|| sum_and_move(&mut workers, &mut bins));
    });
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
fn task_3_8_table_of_arrivals() {
    let scene = scenes::dense();
    let grid = Grid::of_scene(&scene, 1.0);
    let columns = grid.columns();
    let changed: Vec<_> = scene.particles().iter().filter(|p| p.id % 12 == 7).copied().collect();
    let buffers: Vec<&[Particle]> = changed.chunks(changed.len().div_ceil(3)).collect();
    let mut table = String::new();
    for (number, buffer) in buffers.iter().enumerate() {
        let ids: Vec<_> = buffer.iter().map(|p| p.id.to_string()).collect();
        table += &format!("buffer {number}: {}\n", ids.join(" "));
    }
    table += "\nworker  own rows  takes  particle: row\n";
    for (number, rows) in [0..3, 3..6, 6..grid.rows()].into_iter().enumerate() {
        let mut own = vec![Vec::new(); rows.len() * columns];
        take_arrivals(&grid, rows.start * columns, &mut own, buffers.iter().copied());
        let mut taken: Vec<_> = own.iter().flatten().map(|p| (p.id, grid.row(p.y))).collect();
        taken.sort_unstable();
        let listed: Vec<_> = taken.iter().map(|(id, row)| format!("{id}: {row}")).collect();
        let rows = format!("{rows:?}");
        table += &format!("{number:>6}  {rows:>8}  {:>5}  {}\n", taken.len(), listed.join(", "));
    }
    insta::assert_snapshot!(table);
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
    let Rehearsal { begun, before, .. } = within("3.10", 20, || rehearse(6));
    let parts = ["forces", "moves", "arrivals"];
    for (turn, before) in before.iter().enumerate() {
        for (member, before) in before.iter().enumerate() {
            assert_eq!(
                *before,
                MEMBERS,
                "task 3.10: a barrier is missing: member {member} begins the {} of step {} when only so \
                 many of 3 members have ended the {}",
                parts[turn % 3],
                turn / 3,
                parts[(turn + 2) % 3]
            );
        }
    }
    let begun: usize = begun.iter().sum();
    assert_eq!(begun, 6 * 3 * 3, "parts begun by three members in six steps of three parts");
}

#[test]
fn task_3_10_three_barriers_in_a_step() {
    for steps in [0_u64, 1, 3, 70_000] {
        let (parts, meetings) = within("3.10", 20, move || {
            let (barrier, mut parts) = (Barrier::new(1), 0);
            take_steps(steps, |_| parts += 1, &barrier);
            (parts, barrier.meetings())
        });
        assert_eq!(parts, 3 * steps, "parts that a member does in {steps} steps");
        // Behind the last part of all nobody waits for anything.
        let enough = (3 * steps).saturating_sub(1)..=3 * steps;
        assert!(
            enough.contains(&meetings),
            "{meetings} barriers in {steps} steps: {enough:?} are enough, one after each part"
        );
    }
}

#[test]
fn task_3_11_all_threads_at_the_same_time() {
    for threads in [0, 1, 5, 257] {
        let found = within("3.11", 60, move || gather(threads));
        assert_eq!(found.most, threads, "threads at work at the same time, of {threads}");
        assert_eq!(
            found.ended, threads,
            "of {threads} threads, those that had ended when it returned"
        );
        assert_eq!(found.different, threads, "new threads, all different");
        let numbers: Vec<usize> = (0..threads).collect();
        assert_eq!(found.numbers, numbers, "the numbers that {threads} threads were given");
    }
}

#[test]
fn task_3_11_a_panic_comes_out_with_its_words() {
    on_threads(1, |_| ());
    let words = within("3.11", 20, || {
        let work = |number| {
            if number == 1 {
                resume_unwind(Box::new("the words of thread 1"));
            }
        };
        let ended = catch_unwind(AssertUnwindSafe(|| on_threads(3, work)));
        ended.map_err(|panic| panic.downcast_ref::<&str>().map(ToString::to_string))
    });
    let expected = Err(Some("the words of thread 1".to_owned()));
    assert_eq!(words, expected, "what comes of a panic in thread 1 of 3, Ok if nothing does");
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
