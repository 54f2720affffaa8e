//! Lab 3's graders.

use lab3::{VARIANTS, on_threads, rebin_by_one, sum_and_move, take_arrivals};
use oracle::{Ask, Random, Runs, scenes};

#[path = "lab3/all_pairs.rs"]
mod all_pairs;
#[path = "lab3/barriers.rs"]
mod barriers;
#[path = "lab3/bins.rs"]
mod bins;
#[path = "lab3/buffers.rs"]
mod buffers;
#[path = "lab3/examples.rs"]
mod examples;
#[cfg(test)]
#[path = "lab3/experiments.rs"]
mod experiments;
#[path = "lab3/handover_examples.rs"]
mod handover_examples;
#[path = "lab3/mail.rs"]
mod mail;
#[path = "lab3/moments.rs"]
mod moments;
#[path = "lab3/notices.rs"]
mod notices;
#[path = "lab3/reductions.rs"]
mod reductions;
#[path = "lab3/rows.rs"]
mod rows;
#[path = "lab3/sharing.rs"]
mod sharing;
#[path = "lab3/threads.rs"]
mod threads;
#[path = "lab3/workers.rs"]
mod workers;

oracle::questions! {
    task_3_1 {
        force_table = examples::forces_of_all_pairs
            => "Four particles at rest: their velocities after one step, and how many pairs the observers saw.",
        steps_of_all_pairs = all_pairs::steps
            => "A step of any number of particles on some threads: x, y, vx, vy of each, and the number of pairs that \
                the observers were told of.",
        shared_forces = sharing::all_pairs
            => "All pairs by the threads of a pool: every thread sums forces, and no thread sums nearly all of them.",
        observer_each = all_pairs::observers
            => "150 particles: how many observers were told of the pairs of one particle.",
        any_threads = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").bits_on_any_threads(ask)
            => "Runs of `vanilla` on 1 to 17 threads: the bits of all pairs, and the statistics of each step.",
        official_bytes = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes(ask)
            => "The official scene on two threads: the output of 1,000 steps, byte for byte.",
    }
    task_3_2 {
        sum_table = examples::sums
            => "The statistics of three parts, and their sum under a lock, with atomics and in order; and a sum with \
                atomics while another thread adds to it.",
        atomic_additions = reductions::one_after_another
            => "Parts added to atomic numbers, one after another: dmin, davg, navg and pair tests of the sum.",
        locked_sums = reductions::locked
            => "Parts added up under a lock by several threads: dmin, davg, navg and pair tests of the sum.",
        atomic_sums = reductions::atomic
            => "Parts added up with atomics by several threads: dmin, davg, navg and pair tests of the sum.",
        ordered_sums = reductions::ordered
            => "Parts added up block by block, in order: dmin, davg, navg and pair tests of the sum, to the last bit.",
        slow_additions = reductions::slow
            => "Parts added up under a lock, slowly: no addition is lost.",
        interrupted_additions = reductions::interrupted
            => "An addition with atomics, between whose operations another thread adds something: nothing is lost.",
        shared_lock = sharing::locked_parts
            => "Parts under a lock and the threads of a pool: every thread adds some.",
        shared_blocks = sharing::blocks
            => "Blocks of parts and the threads of a pool: every thread sums some, and no thread sums nearly all.",
    }
    task_3_3 {
        row_table = examples::rows
            => "Some rows of bins among some workers: the rows of each worker, and how many each has.",
        owners = rows::owners
            => "Any number of rows among any number of workers: every row has one owner, and no owner has more than one \
                row more than another.",
    }
    task_3_4 {
        worker_table = examples::forces_of_workers
            => "Six particles and two workers: the accelerations of each worker's particles, and what its rows saw.",
        own_forces = workers::forces
            => "A worker with any rows: the accelerations of its particles, and what each of its rows saw.",
    }
    task_3_5 {
        buffer_table = examples::change_buffers
            => "Eight particles and two workers: the particles that stay in their bins, and those in the change buffers.",
        leavers = workers::moves
            => "A worker with any rows: the particles that stay in their bins, and those in its change buffer.",
    }
    task_3_6 {
        loop_table after "3.4, 3.5" => "Four particles and two workers: where each particle is after both loops, and \
                                        its velocity.",
        all_workers after "3.4, 3.5" => "Few workers and many: x, y, vx, vy of each particle after both loops.",
        shared_workers after "3.4, 3.5" => "Workers and the threads of a pool: in either loop every thread does some of \
                                            the work, and no thread does nearly all.",
    }
    task_3_7 {
        rebin_table = handover_examples::rebinning_by_one
            => "Four particles in three change buffers: what each bin holds before and after rebinning.",
        all_buffers = buffers::by_one
            => "Any number of particles in any number of buffers: the bins that hold each particle after rebinning.",
        fork_join after "3.3, 3.4, 3.5, 3.6" => "Runs of `fork-join` on 1 to 17 threads: the bits of all pairs, and the \
                                                 statistics of each step.",
    }
    task_3_8 {
        arrival_table = handover_examples::rebinning_by_all
            => "Four particles in three change buffers, and two workers: what the bins of each worker hold before and \
                after it takes its arrivals.",
        own_arrivals = buffers::by_all
            => "Any number of particles in any number of buffers: the bins of some rows that hold each particle after \
                a worker has taken its arrivals.",
        parallel_rebin after "3.3, 3.4, 3.5, 3.6" => "Runs of `parallel-rebin` on 1 to 17 threads: the bits of all \
                                                      pairs, and the statistics of each step.",
        packed_workers after "3.3, 3.4, 3.5, 3.6" => "A run of `parallel-rebin` whose workers lie side by side in memory: \
                                                      the bits of all pairs.",
    }
    task_3_9 {
        mail_table = handover_examples::mail
            => "Member 1 of three: its particles and its mail before it takes the mail, and after.",
        letters = mail::letters
            => "Any mail from any number of members: the particles that a member then has, the bins that they are in, \
                and what is left in the boxes.",
    }
    task_3_10 {
        barrier_table = moments::barriers
            => "Two members, of which member 1 does each part late: which parts both have ended when a member begins one.",
        rehearsals = barriers::rehearsals
            => "Three members, of which one holds back in each part: no member begins a part before all have ended the \
                part before.",
        three_barriers = barriers::meetings
            => "One member: its parts in few and many steps, and its barriers.",
    }
    task_3_11 {
        thread_table = moments::threads
            => "Three threads that begin in order and end in reverse: what each does, how many are at work, and what \
                comes out when one panics.",
        gatherings = threads::gatherings
            => "Few threads and many: all are at work at the same time, are new, have the right numbers, and have ended \
                when the call returns.",
        panics = threads::panics
            => "A thread that panics: its panic comes out as it was.",
        team after "3.3, 3.9, 3.10" => "Runs of `team` on 1 to 17 threads: the bits of all pairs, and the statistics of \
                                        each step.",
        late_member after "3.3, 3.9, 3.10" => "Runs of `team` on four threads, one of which does each part last: the bits \
                                               of all pairs.",
        team_memory after "3.3, 3.9, 3.10" => "A long run of `team`: the memory that it holds does not grow with the \
                                               number of steps.",
        team_bytes after "3.3, 3.9, 3.10" => "The official scene and `team` on two threads: the output of 1,000 steps, \
                                              byte for byte.",
    }
    task_3_12 {
        notice_table = handover_examples::notices
            => "What a thread may read before a notice is posted, while it is posted, and after.",
        whole_notices = notices::whole
            => "Notices with any numbers: all that a thread may read while another thread posts them.",
        orderings = notices::orderings
            => "A notice, with the operations of both threads: a thread that sees the flag raised sees all numbers, no \
                ordering is stronger than it needs to be, and the flag is read once.",
    }
}

// Each function of a task below calls the task's own code first, so that an unsolved starter stops
// at this task's `todo!`.

fn reach_3_6() {
    sum_and_move::<common::soft::NoStatistics, Box<lab3::Worker<_>>>(&mut [], &mut bins::of_150());
}

fn loop_table(_: &mut Random, ask: &mut impl Ask) {
    reach_3_6();
    examples::both_loops(ask);
}

fn all_workers(random: &mut Random, ask: &mut impl Ask) {
    reach_3_6();
    workers::loops(random, ask);
}

fn shared_workers(random: &mut Random, ask: &mut impl Ask) {
    reach_3_6();
    sharing::workers(random, ask);
}

fn fork_join(_: &mut Random, ask: &mut impl Ask) {
    rebin_by_one(&mut bins::of_150(), std::iter::empty());
    Runs::new("3.7", VARIANTS, "fork-join").bits_on_any_threads(ask);
}

/// Returns runs of the variant `parallel-rebin`.
fn rebinning_by_all() -> Runs {
    take_arrivals(bins::of_150().grid(), 0, &mut [], std::iter::empty());
    Runs::new("3.8", VARIANTS, "parallel-rebin")
}

fn parallel_rebin(_: &mut Random, ask: &mut impl Ask) {
    rebinning_by_all().bits_on_any_threads(ask);
}

fn packed_workers(_: &mut Random, ask: &mut impl Ask) {
    let packed = rebinning_by_all().set("padding", 0.0).threads(3);
    packed.bits_of_all_pairs(ask, &scenes::dense(), 20);
}

/// Returns runs of the variant `team`.
fn of_a_team() -> Runs {
    on_threads(1, |_| ());
    Runs::new("3.11", VARIANTS, "team")
}

fn team(_: &mut Random, ask: &mut impl Ask) {
    of_a_team().bits_on_any_threads(ask);
}

fn late_member(_: &mut Random, ask: &mut impl Ask) {
    for late in 1..=4 {
        let runs = of_a_team().threads(4).set("late", f64::from(late));
        runs.bits_of_all_pairs(ask, &scenes::all_leave(), 12);
        runs.bits_after_a_run(ask, &scenes::all_leave(), 12);
    }
}

fn team_memory(_: &mut Random, ask: &mut impl Ask) {
    of_a_team().threads(3).keeps_its_memory(ask);
}

fn team_bytes(_: &mut Random, ask: &mut impl Ask) {
    of_a_team().threads(2).official_bytes(ask);
}
