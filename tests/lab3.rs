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
            => "Four particles at rest: their velocities after one step, and the number of pairs reported to the \
                observers.",
        steps_of_all_pairs = all_pairs::steps
            => "A step of any number of particles on several threads: x, y, vx, vy of each particle, and the number of \
                pair tests reported to the observers.",
        shared_forces = sharing::all_pairs
            => "The threads of a pool, which sum the forces of all pairs: the work of each thread. Every thread must \
                sum forces, and no thread may sum nearly all of them.",
        observer_each = all_pairs::observers
            => "150 particles: the number of observers that were told about the pairs of exactly one particle. Each \
                particle needs its own observer.",
        any_threads = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").bits_on_any_threads(ask)
            => "Runs of `vanilla` on 1 to 17 threads: the state, bit for bit as in `all-pairs`, and the statistics of \
                each step.",
        official_bytes = |_, ask| Runs::new("3.1", VARIANTS, "vanilla").threads(2).official_bytes(ask)
            => "The official scene on two threads: the output of 1,000 steps, byte for byte.",
    }
    task_3_2 {
        sum_table = examples::sums
            => "The statistics of three parts: their sum under a lock, with atomics and in order. Then a sum with \
                atomics, while another thread adds to it.",
        atomic_additions = reductions::one_after_another
            => "Parts that are added to atomic numbers, one after another: dmin, davg, navg and pair tests of the \
                sum.",
        locked_sums = reductions::locked
            => "Parts that several threads add up under a lock: dmin, davg, navg and pair tests of the sum.",
        atomic_sums = reductions::atomic
            => "Parts that several threads add up with atomics: dmin, davg, navg and pair tests of the sum.",
        ordered_sums = reductions::ordered
            => "Parts that are added up block by block, in order: dmin, davg, navg and pair tests of the sum, bit for \
                bit.",
        slow_additions = reductions::slow
            => "Parts that are added up slowly under a lock: the sum, from which no addition may be lost, and the \
                greatest number of additions at the same moment, which is 1.",
        interrupted_additions = reductions::interrupted
            => "An addition with atomics, interrupted by additions of another thread: the sum, from which nothing may \
                be lost.",
        shared_lock = sharing::locked_parts
            => "The threads of a pool, which add parts under a lock: the work of each thread. Every thread must add \
                some parts.",
        shared_blocks = sharing::blocks
            => "The threads of a pool, which sum blocks of parts: the work of each thread. Every thread must sum \
                some blocks, and no thread may sum nearly all.",
    }
    task_3_3 {
        row_table = examples::rows
            => "Some rows of bins and some workers: the rows of each worker, and their number.",
        owners = rows::owners
            => "Any number of rows and of workers: the rows of each worker. Every row has one owner, and the numbers \
                of rows differ by at most one.",
    }
    task_3_4 {
        worker_table = examples::forces_of_workers
            => "Six particles and two workers: the accelerations of each worker's particles, and the pairs that each \
                of its rows reports.",
        own_forces = workers::forces
            => "A worker with any rows: the accelerations of its particles, and the pairs that each of its rows \
                reports.",
    }
    task_3_5 {
        buffer_table = examples::change_buffers
            => "Eight particles and two workers: the particles that stay in their bins, and the particles in the \
                change buffers.",
        leavers = workers::moves
            => "A worker with any rows: the particles that stay in their bins, and the particles in its change \
                buffer.",
    }
    task_3_6 {
        loop_table after "3.4, 3.5" => "Four particles and two workers: the position and velocity of each particle \
                                        after both loops.",
        all_workers after "3.4, 3.5" => "Few workers and many: x, y, vx, vy of each particle after both loops.",
        shared_workers after "3.4, 3.5" => "The threads of a pool, which run both loops over workers: the work of \
                                            each thread. In either loop every thread must do some work, and no \
                                            thread may do nearly all.",
    }
    task_3_7 {
        rebin_table = handover_examples::rebinning_by_one
            => "Four particles in bins and in three change buffers: the bin of each particle before and after \
                rebinning.",
        all_buffers = buffers::by_one
            => "Any number of particles in any number of change buffers: the bins that hold each particle after \
                rebinning.",
        fork_join after "3.3, 3.4, 3.5, 3.6" => "Runs of `fork-join` on 1 to 17 threads: the state, bit for bit as in \
                                                 `all-pairs`, and the statistics of each step.",
    }
    task_3_8 {
        arrival_table = handover_examples::rebinning_by_all
            => "Four particles in bins and in three change buffers, and two workers: the bin of each particle before \
                and after each worker takes its arrivals.",
        own_arrivals = buffers::by_all
            => "Any number of particles in any number of change buffers: the bins of a worker's rows that hold each \
                particle after the worker has taken its arrivals.",
        parallel_rebin after "3.3, 3.4, 3.5, 3.6" => "Runs of `parallel-rebin` on 1 to 17 threads: the state, bit for \
                                                      bit as in `all-pairs`, and the statistics of each step.",
        packed_workers after "3.3, 3.4, 3.5, 3.6" => "A run of `parallel-rebin` whose workers are next to each other \
                                                      in memory: the state, bit for bit as in `all-pairs`.",
    }
    task_3_9 {
        mail_table = handover_examples::mail
            => "Member 1 of three: its particles and its mail, before and after it takes the mail.",
        letters = mail::letters
            => "Any mail from any number of members: the particles that a member has afterwards, their bins, and the \
                letters left in the boxes.",
    }
    task_3_10 {
        barrier_table = moments::barriers
            => "Two members, of which member 1 is late in each part: the parts that both have ended when a member \
                begins a part.",
        rehearsals = barriers::rehearsals
            => "Three members, one of which is delayed in each part: the number of members that have ended the \
                previous part when a part begins. All three must have ended it.",
        three_barriers = barriers::meetings
            => "One member: the number of its parts and of its barriers in few and in many steps.",
    }
    task_3_11 {
        thread_table = moments::threads
            => "Three threads that begin in order and end in reverse order: the number of threads at work after each \
                event, and the panic of the call when one thread panics.",
        gatherings = threads::gatherings
            => "Few threads and many: the number of threads that work at the same time, that have ended when the call \
                returns, and that are new and different; and their numbers.",
        panics = threads::panics
            => "A thread that panics: the panic of the call, which must be the thread's panic.",
        team after "3.3, 3.9, 3.10" => "Runs of `team` on 1 to 17 threads: the state, bit for bit as in `all-pairs`, \
                                        and the statistics of each step.",
        late_member after "3.3, 3.9, 3.10" => "Runs of `team` on four threads, one of which is the last in each part: \
                                               the state, bit for bit as in `all-pairs`.",
        team_memory after "3.3, 3.9, 3.10" => "A long run of `team`: the memory in use, which must not grow with the \
                                               number of steps.",
        team_bytes after "3.3, 3.9, 3.10" => "The official scene and `team` on two threads: the output of 1,000 steps, \
                                              byte for byte.",
    }
    task_3_12 {
        notice_table = handover_examples::notices
            => "A notice: what a thread may read before it is posted, while it is being posted, and afterwards.",
        any_notices = notices::posts
            => "Notices with any numbers: everything that a thread may read while another thread posts them.",
        orderings = notices::orderings
            => "A notice, with the operations of both threads: the numbers that are read. A thread that sees the flag \
                raised must see all numbers. No ordering may be stronger than necessary, and the flag is read once.",
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
