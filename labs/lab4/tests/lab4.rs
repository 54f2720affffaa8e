//! Lab 4's graders.

use common::soft::NoStatistics;
use crossbeam::channel::unbounded;
use crossbeam::queue::SegQueue;
use lab4::{
    Cut, VARIANTS, apply_all, apply_own, claim, move_own, pairs_across, rebuild, receive, take,
    take_own,
};
use oracle::{Ask, Random, Runs, scenes};
use solution2::{Grid, SortedBins};

#[path = "lab4/bins.rs"]
mod bins;
#[cfg(test)]
#[path = "lab4/experiments.rs"]
mod experiments;
#[path = "lab4/fills.rs"]
mod fills;
#[path = "lab4/handover_examples.rs"]
mod handover_examples;
#[path = "lab4/handovers.rs"]
mod handovers;
#[path = "lab4/intruders.rs"]
mod intruders;
#[path = "lab4/lock_examples.rs"]
mod lock_examples;
#[path = "lab4/locks.rs"]
mod locks;
#[path = "lab4/meters.rs"]
mod meters;
#[path = "lab4/moves.rs"]
mod moves;
#[path = "lab4/pair_examples.rs"]
mod pair_examples;
#[path = "lab4/pairs.rs"]
mod pairs;
#[path = "lab4/regions.rs"]
mod regions;

oracle::questions! {
    task_4_1 {
        region_table = regions::table
            => "Some bins in some regions: (1) the number of bins in each region, (2) the lock of each region, (3) \
                the region of each of five bins.",
        sizes = regions::sizes
            => "Any number of bins in any number of regions: the number of bins in each region.",
        places = regions::places
            => "Any bin in regions of any size: (1) the bin's region, (2) the bin's index in this region.",
        lock_numbers = regions::numbers
            => "Any number of regions: the number of the lock of each region.",
    }
    task_4_2 {
        meter_table = meters::table
            => "A meter that takes free locks, and locks that another thread holds. After each lock: (1) the locks \
                taken, (2) the locks waited for, (3) the time waited.",
        free_locks = meters::free
            => "A free lock that is taken many times, by a new meter and by a meter that has waited before: (1) the \
                locks taken, (2) the locks waited for, (3) the number of times that the meter reads the clock, which \
                must be 0.",
        held_locks = meters::held
            => "Two locks that another thread holds: (1) the locks taken, (2) the locks waited for, (3) the time of \
                both waits together.",
    }
    task_4_3 {
        lock_table after "4.1, 4.2" = lock_examples::table
            => "Changes of bins: (1) the locks that each change takes, (2) the most locks that the change holds at \
                once. Then two threads that need the same two locks: the locks and the particles after each event.",
        one_by_one after "4.1, 4.2" = locks::one_by_one
            => "132 changes, one after another: (1) the locks that the changes take, (2) the bin of each particle.",
        large_numbers after "4.1, 4.2" = locks::large_numbers
            => "A particle and bins with large numbers: (1) the locks that a change takes, (2) the particles in the \
                old and the new bin.",
        many_threads after "4.1, 4.2" = locks::many_threads
            => "Changes by several threads at the same time: (1) the locks that the changes take, (2) the bin of each \
                particle.",
        another_between after "4.1, 4.2" = intruders::same_bins
            => "A change, during which another thread makes a second change between the two requests for locks: the \
                bin of each particle.",
        other_regions after "4.1, 4.2" = intruders::other_regions
            => "A thread that holds a lock: whether another thread can change bins in other regions at this time, as \
                it must.",
    }
    task_4_4 {
        move_table = moves::table
            => "Five particles in four rows of bins: (1) the position of each particle after a move, (2) the changes \
                of bins that are reported.",
        any_moves = moves::moves
            => "Any number of particles: (1) x, y, vx, vy of each particle after a move, (2) the changes of bins that \
                are reported.",
        global_lock after "4.1, 4.2, 4.3" => "Runs of `global-lock` on 1 to 17 threads: the state, which must have \
                                              the same bits as in `all-pairs`, and the statistics of each step.",
        region_locks after "4.1, 4.2, 4.3" => "Runs of `region-locks` on 1 to 17 threads: the state, which must have \
                                               the same bits as in `all-pairs`, and the statistics of each step.",
        bin_locks after "4.1, 4.2, 4.3" => "Runs of `bin-locks` on 1 to 17 threads: the state, which must have the \
                                            same bits as in `all-pairs`, and the statistics of each step.",
    }
    task_4_5 {
        rebuild_table after "4.1" = fills::table
            => "Five particles and four bins in two regions: the particles in each bin before and after one thread \
                rebuilds the bins.",
        any_rebuilds after "4.1" = fills::by_one
            => "Any number of particles, and bins that contain particles of the previous step: the bins that contain \
                each particle after one thread has rebuilt the bins.",
        serial_rebuild after "4.1, 4.4" => "Runs of `serial-rebuild` on 1 to 17 threads: the state, which must have \
                                            the same bits as in `all-pairs`, and the statistics of each step.",
    }
    task_4_6 {
        buffer_table after "4.1" = handover_examples::buffers
            => "Three changes in three buffers: the particles in each bin (1) before the changes, (2) after one \
                thread has made all changes, (3) after each owner has made its own changes.",
        by_one after "4.1" = handovers::by_one
            => "Any set of changes in any number of buffers: (1) the bins that contain each particle after one thread \
                has made the changes, (2) the number of locks that this thread takes, which must be 0.",
        by_owners after "4.1" = handovers::by_owners
            => "Any set of changes in any number of buffers: the bins that contain each particle after the owners have \
                made the changes.",
        buffers_by_one after "4.1, 4.4" => "Runs of `buffers-by-one` on 1 to 17 threads: the state, which must have \
                                            the same bits as in `all-pairs`, and the statistics of each step.",
        buffers_by_all after "4.1, 4.4" => "Runs of `buffers-by-all` on 1 to 17 threads: the state, which must have \
                                            the same bits as in `all-pairs`, and the statistics of each step.",
    }
    task_4_7 {
        queue_table after "4.1, 4.6" = handover_examples::queues
            => "Three changes: (1) the number of times that each change is in the queue of each owner, (2) the \
                particles in each bin after the owners have emptied their queues.",
        any_queues after "4.1, 4.6" = handovers::queues
            => "Any number of changes: (1) the owners that receive each change through their queues, (2) the bins that \
                contain each particle.",
        queues after "4.1, 4.4, 4.6" => "Runs of `queues` on 1 to 17 threads: the state, which must have the same \
                                         bits as in `all-pairs`, and the statistics of each step.",
    }
    task_4_8 {
        channel_table after "4.1, 4.6" = handover_examples::channels
            => "Three changes: (1) the number of times that each change is in the channel of each owner, (2) the \
                particles in each bin after the owners have received the changes.",
        any_channels after "4.1, 4.6" = handovers::channels
            => "Any number of changes: (1) the owners that receive each change through their channels, (2) the bins \
                that contain each particle.",
        channels after "4.1, 4.4, 4.6" => "Runs of `channels` on 1 to 17 threads: the state, which must have the same \
                                           bits as in `all-pairs`, and the statistics of each step.",
    }
    task_4_9 {
        owner_table after "4.1" = fills::owners_table
            => "Five particles and two owners: (1) the particles in each bin before and after the owners claim their \
                particles, (2) the particles that owners of rows take.",
        any_claims after "4.1" = fills::by_owners
            => "Any number of particles, and bins that contain particles of the previous step: the bins that contain \
                each particle after the owners have claimed their particles.",
        owned_rows = fills::owned_rows
            => "Any number of particles, and an owner of some rows: the particles that the owner takes.",
        owners after "4.1, 4.4" => "Runs of `owners` on 1 to 17 threads: the state, which must have the same bits as \
                                    in `all-pairs`, and the statistics of each step.",
        owner_computes => "Runs of `owner-computes` on 1 to 17 threads: the state, which must have the same bits as \
                           in `all-pairs`, and the statistics of each step.",
        owner_memory => "A long run of `owner-computes`: the memory in use, which must not grow with the number of \
                         steps.",
    }
    task_4_10 {
        pair_table = pair_examples::within
            => "Four particles in two rows of bins: (1) their accelerations, (2) the number of pair tests.",
        strips = pairs::within
            => "Any number of particles in some rows: (1) their accelerations, (2) the number of pair tests.",
    }
    task_4_11 {
        across_table = pair_examples::across
            => "A cut with two particles below it, and two in the first row above it: (1) the accelerations of the \
                lower particles, (2) the accelerations of the upper particles, which are stored separately, (3) the \
                number of pair tests.",
        cuts = pairs::across
            => "A cut with any number of particles on each side: (1) the accelerations of the lower particles, (2) \
                the accelerations of the upper particles, which are stored separately, (3) the number of pair tests.",
        owner_two_way after "4.9, 4.10" => "Runs of `owner-two-way` on 1 to 15 threads: the state after each step, the \
                                            forces, and the statistics.",
        owner_lists => "Runs of `owner-lists` on 1 to 15 threads: the state after each step, the forces, and the \
                        statistics.",
    }
}

/// Returns a grid of one bin.
fn one_bin() -> Grid {
    Grid::with_bins_along(1.0, 1)
}

/// Asks for the bits of all pairs from a variant, on any number of threads.
fn ask_bits(ask: &mut impl Ask, task: &'static str, variant: &str) {
    Runs::new(task, VARIANTS, variant).bits_on_any_threads(ask);
}

// Each function of a task below calls the task's own code first, so that an unsolved starter stops
// at this task's `todo!`.

fn global_lock(_: &mut Random, ask: &mut impl Ask) {
    move_own(&one_bin(), &mut [], &[], |_| ());
    ask_bits(ask, "4.4", "global-lock");
}

fn region_locks(_: &mut Random, ask: &mut impl Ask) {
    move_own(&one_bin(), &mut [], &[], |_| ());
    ask_bits(ask, "4.4", "region-locks");
}

fn bin_locks(_: &mut Random, ask: &mut impl Ask) {
    move_own(&one_bin(), &mut [], &[], |_| ());
    ask_bits(ask, "4.4", "bin-locks");
}

fn serial_rebuild(_: &mut Random, ask: &mut impl Ask) {
    rebuild(&mut bins::filled(1, 1), &one_bin(), &[]);
    ask_bits(ask, "4.5", "serial-rebuild");
    let fresh = Runs::new("4.5", VARIANTS, "serial-rebuild").threads(2).set("fresh", 1.0);
    fresh.bits_of_all_pairs(ask, &scenes::all_leave(), 20);
}

fn buffers_by_one(_: &mut Random, ask: &mut impl Ask) {
    apply_all(&mut bins::filled(1, 1), std::iter::empty());
    ask_bits(ask, "4.6", "buffers-by-one");
}

fn buffers_by_all(_: &mut Random, ask: &mut impl Ask) {
    apply_own(Cut { bins_each: 1 }, 0, &mut [], std::iter::empty());
    ask_bits(ask, "4.6", "buffers-by-all");
}

fn queues(_: &mut Random, ask: &mut impl Ask) {
    take(Cut { bins_each: 1 }, 0, &mut [], &SegQueue::new());
    ask_bits(ask, "4.7", "queues");
}

fn channels(_: &mut Random, ask: &mut impl Ask) {
    let (sender, receiver) = unbounded();
    // Even a millisecond of waiting adds up to minutes.
    oracle::within("4.8", 10, move || {
        for _ in 0..100_000 {
            receive(Cut { bins_each: 1 }, 0, &mut [], &receiver);
        }
    });
    drop(sender);
    ask_bits(ask, "4.8", "channels");
}

fn owners(_: &mut Random, ask: &mut impl Ask) {
    claim(Cut { bins_each: 1 }, 0, &mut [], &one_bin(), &[]);
    ask_bits(ask, "4.9", "owners");
}

fn reach_4_9b() {
    take_own(&mut SortedBins::new(one_bin(), 0..1), std::iter::empty());
}

fn owner_computes(_: &mut Random, ask: &mut impl Ask) {
    reach_4_9b();
    ask_bits(ask, "4.9", "owner-computes");
}

fn owner_memory(_: &mut Random, ask: &mut impl Ask) {
    reach_4_9b();
    Runs::new("4.9", VARIANTS, "owner-computes").threads(3).keeps_its_memory(ask);
}

fn reach_4_11() {
    let grid = Grid::with_bins_along(1.0, 2);
    let [lower, upper] = [0..1, 1..2].map(|rows| SortedBins::new(grid, rows));
    pairs_across(&lower, &upper, &mut [], &mut [], &mut NoStatistics);
}

/// Asks a variant with two-way forces for its steps, on any number of threads.
fn ask_two_way(ask: &mut impl Ask, variant: &str) {
    for threads in [1, 2, 3, 4, 8, 15] {
        let runs = Runs::new("4.11", VARIANTS, variant).threads(threads);
        for bin_size in [1.0, 2.0, 3.0] {
            let runs = runs.clone().set("bin-size", bin_size);
            runs.resynchronised(ask, &scenes::dense(), 20);
            runs.resynchronised_on_each(ask, scenes::edges(), 1);
            runs.resynchronised_on_each(ask, (1..=20).map(scenes::crowd).collect(), 2);
        }
        runs.forces(ask);
        runs.statistics_of_each_step(ask, &scenes::dense(), 5);
        runs.same_bits_on_threads(ask, &scenes::dense_with_seed(7), 20, &[threads]);
    }
    Runs::new("4.11", VARIANTS, variant).threads(2).free_run(ask);
    let runs = Runs::new("4.11", VARIANTS, variant).threads(3);
    runs.keeps_everyone(ask, &scenes::dense_with_seed(8), 1000);
}

fn owner_two_way(_: &mut Random, ask: &mut impl Ask) {
    reach_4_11();
    ask_two_way(ask, "owner-two-way");
}

fn owner_lists(_: &mut Random, ask: &mut impl Ask) {
    reach_4_11();
    ask_two_way(ask, "owner-lists");
    let fresh = Runs::new("4.11", VARIANTS, "owner-lists").threads(2).set("fresh", 1.0);
    fresh.resynchronised(ask, &scenes::dense(), 20);
}
