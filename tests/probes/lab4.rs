//! What is asked about lab 4: the functions one at a time, and those that lock by several threads.

use std::sync::Arc;

use common_threads::{Lock, LockOrder, Watch};
use lab4::{Meter, Regions, change_bin};

use self::locked::{BINS, changes, filled, sent_by_four, two_waits};
use self::model::acceleration_of_pair;
use self::soft::on_edges;
use crate::{Answers, Random, truth};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab4/locked.rs"]
mod locked;
#[path = "../oracle/src/model.rs"]
mod model;
#[path = "../lab4/questions.rs"]
mod questions;
#[path = "soft.rs"]
mod soft;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "4.1" => {
            questions::regions(random, &mut answers.told());
            numbers(answers);
        }
        "4.2" => meters(answers),
        "4.3" => two_locks(random, answers),
        "4.4" => questions::moves(random, &mut answers.told()),
        "4.5" => questions::rebuilds(random, &mut answers.told()),
        "4.6" => {
            questions::by_one(random, &mut answers.told());
            questions::by_owners(random, &mut answers.told());
        }
        "4.7" => questions::queues(random, &mut answers.told()),
        "4.8" => questions::channels(random, &mut answers.told()),
        "4.9" => {
            questions::claims(random, &mut answers.told());
            questions::owners(random, &mut answers.told());
        }
        "4.10" => questions::within_rows(random, &mut answers.told()),
        "4.11" => questions::across(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}

fn numbers(answers: &mut Answers) {
    let numbers = locked::numbers(&mut Regions::new(100, 7)).into_iter().map(|lock| lock as f64);
    answers.exact("the numbers of the locks of 7 regions", &numbers.collect::<Vec<f64>>());
}

fn meters(answers: &mut Answers) {
    let lock = Lock::new(0, 5.0);
    let mut meter = Meter::default();
    for _ in 0..300 {
        *meter.lock(&lock) += 1.0;
    }
    let waited = meter.waiting.as_secs_f64();
    let told = [*lock.lock(), meter.locks as f64, meter.contended as f64, waited];
    answers.exact("a free lock, 300 times: what it guards, locks, waits, time waited", &told);
    let (meter, waited, requests) = two_waits();
    let measured = meter.waiting > waited / 2 && meter.waiting <= waited;
    let told = [meter.locks as f64, meter.contended as f64, truth(measured)];
    answers.exact("two locks that another holds: locks, waits, whether both were timed", &told);
    let spins = truth(requests > 6);
    answers.exact(
        "two locks that another holds: whether they are asked for again and again",
        &[spins],
    );
}

/// What each bin holds, in the order of numbers, with -1 after each bin.
fn contents(regions: &mut Regions) -> Vec<f64> {
    let mut all = Vec::new();
    for bins in regions.parts_mut() {
        for bin in bins.iter_mut() {
            bin.sort_unstable();
            all.extend(bin.iter().map(|particle| f64::from(*particle)));
            all.push(-1.0);
        }
    }
    all
}

fn two_locks(random: &mut Random, answers: &mut Answers) {
    for each in [1, 3, 12] {
        let name = format!("12 bins, {each} in a region");
        // One thread, and whether its locks could be in the way of another's.
        let mut regions = filled(BINS, each);
        let order = Arc::new(LockOrder::default());
        let watch: Arc<dyn Watch> = order.clone();
        regions.watch(&watch);
        let mut meter = Meter::default();
        for change in changes(random).into_iter().flatten() {
            change_bin(&regions, &mut meter, change);
        }
        let counts = [meter.locks as f64, meter.contended as f64, order.most_held() as f64];
        answers.exact(&format!("{name}: locks taken, waited for, most at once"), &counts);
        answers.exact(&format!("{name}: particles in each bin"), &contents(&mut regions));
        let (mut regions, locks) = sent_by_four(each, 25);
        answers.exact(&format!("{name}, 4 threads: locks taken"), &[locks as f64]);
        answers
            .exact(&format!("{name}, 4 threads: particles in each bin"), &contents(&mut regions));
    }
    answers.exact(
        "two threads in two bins, one between the other's requests",
        &contents(&mut locked::changed_by_two()),
    );
}
