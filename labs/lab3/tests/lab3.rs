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
            => "Four particles at rest: (1) their velocities after one step, (2) the number of pairs reported to the \
                observers.",
        steps_of_all_pairs = all_pairs::steps
            => "A step of any number of particles on several threads: (1) x, y, vx, vy of each particle, (2) the \
                number of pair tests reported to the observers.",
        shared_forces = sharing::all_pairs
            => "A pool of threads that sums the forces of all pairs: the share of the work that each thread did. \
                Every thread must sum forces, and no thread may sum nearly all of them.",
        observer_each = all_pairs::observers
            => "150 particles: the number of observers that received the pair tests of exactly one particle. Each \
                particle needs its own observer.",
        any_threads = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").bits_on_any_threads(ask)
            => "Runs of `vanilla` on 1 to 17 threads: the state, which must have the same bits as in `all-pairs`, and \
                the statistics of each step.",
        official_bytes = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes(ask)
            => "The official scene on two threads: the output of 1,000 steps, byte for byte.",
    }
    task_3_2 {
        sum_table = examples::sums
            => "The statistics of three parts: their sum (1) under a lock, (2) with atomics, (3) in order, and (4) \
                with atomics while another thread adds to the sum.",
        atomic_additions = reductions::one_after_another
            => "Parts that one thread adds to atomic numbers, one after another: dmin, davg, navg and pair tests of \
                the sum.",
        locked_sums = reductions::locked
            => "Parts that several threads add under a lock: dmin, davg, navg and pair tests of the sum.",
        atomic_sums = reductions::atomic
            => "Parts that several threads add with atomics: dmin, davg, navg and pair tests of the sum.",
        ordered_sums = reductions::ordered
            => "Parts that are added block by block, in order: dmin, davg, navg and pair tests of the sum, bit for \
                bit.",
        slow_additions = reductions::slow
            => "Parts that are added slowly under a lock: (1) the sum, in which no addition may be missing, (2) the \
                greatest number of additions at the same moment, which must be 1.",
        interrupted_additions = reductions::interrupted
            => "One thread adds with atomics, and a second thread interrupts it with its own additions: the sum, in \
                which no addition may be missing.",
        shared_lock = sharing::locked_parts
            => "A pool of threads that adds parts under a lock: the share of the work that each thread did. Every \
                thread must add some parts.",
        shared_blocks = sharing::blocks
            => "A pool of threads that sums blocks of parts: the share of the work that each thread did. Every thread \
                must sum some blocks, and no thread may sum nearly all of them.",
    }
    task_3_3 {
        row_table = examples::rows
            => "Some rows of bins and some workers: the rows of each worker, and the number of these rows.",
        owners = rows::owners
            => "Any number of rows and of workers: the rows of each worker. Every row must have exactly one owner, \
                and the numbers of rows of two workers may differ by at most one.",
    }
    task_3_4 {
        worker_table = examples::forces_of_workers
            => "Six particles and two workers: (1) the accelerations of each worker's particles, (2) the pairs that \
                each row of a worker reports.",
        own_forces = workers::forces
            => "A worker with any rows: (1) the accelerations of its particles, (2) the pairs that each of its rows \
                reports.",
    }
    task_3_5 {
        buffer_table = examples::change_buffers
            => "Eight particles and two workers: (1) the particles that stay in their bins, (2) the particles in the \
                change buffers.",
        leavers = workers::moves
            => "A worker with any rows: (1) the particles that stay in their bins, (2) the particles in its change \
                buffer.",
    }
    task_3_6 {
        loop_table after "3.4, 3.5" => "Four particles and two workers: the position and velocity of each particle \
                                        after both loops.",
        all_workers after "3.4, 3.5" => "Few workers and many workers: x, y, vx, vy of each particle after both \
                                         loops.",
        shared_workers after "3.4, 3.5" => "A pool of threads that runs both loops, each of which is a loop over \
                                            the workers: the share of the work that each thread did. In each \
                                            loop, every thread must do some work, and no thread may do nearly \
                                            all of it.",
    }
    task_3_7 {
        rebin_table = handover_examples::rebinning_by_one
            => "Four particles in bins and in three change buffers: the bin of each particle before and after \
                rebinning.",
        all_buffers = buffers::by_one
            => "Any number of particles in any number of change buffers: the bins that contain each particle after \
                rebinning.",
        fork_join after "3.3, 3.4, 3.5, 3.6" => "Runs of `fork-join` on 1 to 17 threads: the state, which must have \
                                                 the same bits as in `all-pairs`, and the statistics of each step.",
    }
    task_3_8 {
        arrival_table = handover_examples::rebinning_by_all
            => "Four particles in bins and in three change buffers, and two workers that take their arrivals in \
                turn, first one worker and then the other: the bin of each particle before and after each worker has \
                taken its arrivals.",
        own_arrivals = buffers::by_all
            => "Any number of particles in any number of change buffers, from which a worker takes its arrivals: \
                for each particle, which bins of the worker's rows contain it afterwards.",
        parallel_rebin after "3.3, 3.4, 3.5, 3.6" => "Runs of `parallel-rebin` on 1 to 17 threads: the state, which \
                                                      must have the same bits as in `all-pairs`, and the statistics \
                                                      of each step.",
        packed_workers after "3.3, 3.4, 3.5, 3.6" => "A run of `parallel-rebin` in which the workers are next to each \
                                                      other in memory: the state, which must have the same bits as in \
                                                      `all-pairs`.",
    }
    task_3_9 {
        mail_table = handover_examples::mail
            => "Member 1 of three: its particles and its mailboxes, before and after it takes the mail.",
        letters = mail::letters
            => "Mail to a member from any number of members: (1) the particles that the member has afterwards, (2) \
                their bins, (3) the number of letters left in the boxes.",
    }
    task_3_10 {
        barrier_table = moments::barriers
            => "Two members, and member 1 is late in each part. Whenever a member begins its next part: the parts \
                that both members have finished.",
        rehearsals = barriers::rehearsals
            => "Three members, one of which is delayed in each part. Whenever a part begins: the number of members \
                that have finished the previous part. It must be 3.",
        three_barriers = barriers::meetings
            => "One member, in few and in many steps: (1) the number of its parts, (2) the number of its barriers.",
    }
    task_3_11 {
        thread_table = moments::threads
            => "Three threads that begin in order and end in reverse order: the number of threads at work after each \
                event. Then one thread panics: the panic of the call.",
        gatherings = threads::gatherings
            => "Few threads and many threads: (1) the most threads that work at the same time, (2) the threads that \
                have finished when the call returns, (3) the different new threads, (4) the numbers that the threads \
                get.",
        panics = threads::panics
            => "A thread that panics: the panic of the call. It must be the same as the thread's panic.",
        team after "3.3, 3.9, 3.10" => "Runs of `team` on 1 to 17 threads: the state, which must have the same bits \
                                        as in `all-pairs`, and the statistics of each step.",
        late_member after "3.3, 3.9, 3.10" => "Runs of `team` on four threads. In each part, one of them is made to \
                                               finish last: the state, which must have the same bits as in \
                                               `all-pairs`.",
        team_memory after "3.3, 3.9, 3.10" => "A long run of `team`: the memory in use, which must not grow with the \
                                               number of steps.",
        team_bytes after "3.3, 3.9, 3.10" => "The official scene and `team` on two threads: the output of 1,000 steps, \
                                              byte for byte.",
    }
    task_3_12 {
        notice_table = handover_examples::notices
            => "A notice: the numbers that a thread may read before, during and after the posting.",
        any_notices = notices::posts
            => "Notices with any numbers: all results that a thread may read while another thread posts a notice.",
        orderings = notices::orderings
            => "A notice, with the operations of both threads: the numbers that the reading thread gets. A thread \
                that sees the raised flag must also see all numbers. No ordering may be stronger than necessary, and \
                the flag must be read only once.",
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
