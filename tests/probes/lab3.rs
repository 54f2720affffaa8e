//! What is asked about lab 3: each function of a thread, with what the others would have done made
//! by the probe.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use common::Vec2;
use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Scene, Simulation, Statistics};
use lab3::{
    Barrier, VARIANTS, Vanilla, Worker, in_order, on_threads, pool, sum_and_move, take_posted,
    take_steps, under_a_lock, with_atomics,
};
use solution1::Tally;
use solution2::{Grid, SortedBins, VecBins};

use self::meeting::{MEETING, Moved, OfOne, Slow, Visitor};
use self::model::Model;
use self::soft::{crowd as anywhere, on_edges};
use self::waiting::{Gathering, gather, interrupted, rehearse};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab3/meeting.rs"]
mod meeting;
#[path = "../oracle/src/model.rs"]
mod model;
#[path = "../lab3/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;
#[path = "../lab3/waiting.rs"]
mod waiting;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "3.1" => {
            questions::all_pairs(random, &mut answers.told());
            all_pairs(random, answers);
        }
        "3.2" => {
            questions::atomics(random, &mut answers.told());
            reductions(random, answers);
        }
        "3.3" => questions::rows(random, &mut answers.told()),
        "3.4" => questions::forces(random, &mut answers.told()),
        "3.5" => questions::moves(random, &mut answers.told()),
        "3.6" => {
            questions::loops(random, &mut answers.told());
            loops(random, answers);
        }
        "3.7" => questions::by_one(random, &mut answers.told()),
        "3.8" => questions::by_all(random, &mut answers.told()),
        "3.9" => questions::mail(random, &mut answers.told()),
        "3.10" => barriers(answers),
        "3.11" => threads(answers),
        "3.12" => questions::notices(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}

fn all_pairs(random: &mut Random, answers: &mut Answers) {
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&soft::spread(random, 150, 10.3 * CUTOFF, 1.0));
    engine.sum_forces();
    let alone = Simulation::statistics(&engine).map_or(0, |seen| seen.navg);
    answers.exact("observers that were told of the pairs of one particle", &[alone as f64]);
    for threads in [2, 5] {
        MEETING.begin(threads);
        let mut engine = Vanilla::<Visitor>::new(threads);
        engine.load(&soft::spread(random, 150, 10.3 * CUTOFF, 1.0));
        engine.sum_forces();
        let question = format!("threads of a pool of {threads} that sum forces, at the same time");
        answers.exact(&question, &came(threads));
    }
}

/// How many threads came to the meeting, and how many of them from a pool of `threads`.
fn came(threads: usize) -> [f64; 2] {
    MEETING.end(threads).map(|count| count as f64)
}

fn reductions(random: &mut Random, answers: &mut Answers) {
    let of = |tally: &Tally| tally.statistics().expect("a tally has statistics");
    for count in [0, 1, 64, 1000, 5000] {
        let parts: Vec<Tally> = (0..count)
            .map(|_| {
                let mut tally = Tally::default();
                tally.tested(random.below(9) as u64);
                tally.seen((CUTOFF * random.between(0.01, 1.0)).powi(2));
                tally
            })
            .collect();
        let statistics: Vec<Statistics> = parts.iter().map(of).collect();
        for threads in [1, 2, 3, 8] {
            let pool = pool(threads);
            let name = format!("dmin, davg, navg, pairs of {count} parts on {threads} threads");
            let found = pool.install(|| under_a_lock(&parts));
            answers.close(&format!("{name}, under a lock"), &soft::numbers(of(&found)));
            let found = pool.install(|| with_atomics(&statistics));
            answers.close(&format!("{name}, with atomics"), &soft::numbers(found));
            let found = pool.install(|| in_order(&parts));
            answers.exact(&format!("{name}, in order"), &soft::numbers(of(&found)));
        }
    }
    for threads in [2, 3] {
        let parts = vec![Visitor; 1000];
        MEETING.begin(threads);
        pool(threads).install(|| under_a_lock(&parts));
        let question = format!("threads of a pool of {threads} that add parts, under a lock");
        answers.exact(&question, &came(threads));
        MEETING.begin(threads);
        pool(threads).install(|| in_order(&parts));
        let question = format!("threads of a pool of {threads} that sum blocks, in order");
        answers.exact(&question, &came(threads));
    }
    let found = pool(4).install(|| under_a_lock(&vec![Slow(1); 100]));
    answers.exact("100 parts of one under a lock, with slow additions", &[found.0 as f64]);
    for times in [1, 3, 40] {
        let question =
            format!("the sum added twice while another thread comes between {times} times");
        answers.close(&question, &[interrupted(times).davg]);
    }
    let question = "dmin, davg, navg, pairs added twice while another thread comes between";
    answers.close(question, &soft::numbers(interrupted(1)));
}

/// Filled bins, one cutoff wide or more, at least eight rows of them.
fn bins(random: &mut Random) -> VecBins {
    let scene = soft::spread(random, 150, 9.5 * CUTOFF, 1.0);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    bins.refill(scene.particles());
    bins
}

fn loops(random: &mut Random, answers: &mut Answers) {
    fn workers<O: Observer>(bins: &VecBins, count: usize) -> Vec<Box<Worker<O>>> {
        let rows = bins.grid().rows();
        let cut = |worker| worker * rows / count;
        (0..count).map(|k| Box::new(Worker::new(cut(k)..cut(k + 1)))).collect()
    }
    for threads in [2, 5] {
        let mut bins = bins(random);
        let mut visitors = workers::<Visitor>(&bins, threads);
        MEETING.begin(threads);
        pool(threads).install(|| sum_and_move(&mut visitors, &mut bins));
        let question = format!("threads of a pool of {threads} that sum forces, at the same time");
        answers.exact(&question, &came(threads));
        let mut workers: Vec<Moved> =
            workers(&bins, threads).into_iter().map(|worker| Moved(*worker)).collect();
        MEETING.begin(threads);
        pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        let question = format!("threads of a pool of {threads} that move, at the same time");
        answers.exact(&question, &came(threads));
    }
}

fn barriers(answers: &mut Answers) {
    let (barrier, steps) = (Barrier::new(1), 1000);
    take_steps(steps, |_| (), &barrier);
    let more = barrier.meetings().saturating_sub(3 * steps);
    answers.exact("barriers in 1000 steps of one member, beyond 3000", &[more as f64]);
    let found = rehearse(8);
    let question = "how often the others do not wait at the barrier for a member held back";
    answers.exact(question, &[found.alone as f64]);
    for (turn, before) in found.before.iter().enumerate() {
        let part = ["forces", "moves", "arrivals"][turn % 3];
        let name = format!("step {}, {part}", turn / 3 + 1);
        let counts = [found.begun[turn] as f64, found.ended[turn] as f64];
        answers.exact(&format!("{name}: how many of 3 members began and ended it"), &counts);
        let question = format!(
            "{name}: how many members had ended the part before when members 0, 1, 2 began"
        );
        answers.exact(&question, &before.map(|count| count as f64));
    }
}

fn threads(answers: &mut Answers) {
    for threads in [1, 2, 5, 11] {
        let Gathering { most, ended, numbers, different } = gather(threads);
        let told = [most, ended, different].map(|count| count as f64);
        let question = format!(
            "{threads} threads: at the same time, ended when it returned, and different ones"
        );
        answers.exact(&question, &told);
        let numbers: Vec<f64> = numbers.into_iter().map(|number| number as f64).collect();
        answers.exact(&format!("{threads} threads: their numbers"), &numbers);
    }
    let work = |number| {
        if number == 1 {
            resume_unwind(Box::new(17_u8));
        }
    };
    let ended = catch_unwind(AssertUnwindSafe(|| on_threads(3, work)));
    let told = ended.map_or_else(|panic| panic.downcast_ref::<u8>().map_or(1, |n| *n), |()| 0);
    answers.exact("a panic in one of 3 threads: 17 if it comes out as it was", &[f64::from(told)]);
}
