//! What is asked about lab 7: walls, pairs, the order of candidates, loops, boxes; and whole steps of an engine, which
//! are in `lab7_step.rs`.

use hard_discs::{Hit, SharedCount};
use lab7::next_part;

use self::interrupted::{
    appended_between_critical_sections, appended_between_load_and_store, between_load_and_store,
};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "hard.rs"]
mod hard;
#[path = "../lab7/interrupted.rs"]
mod interrupted;
#[path = "../oracle/src/hard/model.rs"]
mod model;
#[path = "../lab7/questions.rs"]
mod questions;
#[path = "../lab7/search.rs"]
mod search;
#[path = "lab7_step.rs"]
mod step;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "7.1" => questions::walls(random, &mut answers.told()),
        "7.2" => {
            questions::meetings(random, &mut answers.told());
            questions::contacts(random, &mut answers.told());
        }
        "7.3" => questions::orders(random, &mut answers.told()),
        "7.4" => {
            questions::single_takes(random, &mut answers.told());
            questions::takes(random, &mut answers.told());
        }
        "7.5" => questions::stops(random, &mut answers.told()),
        "7.6" => {
            questions::bounces(random, &mut answers.told());
            questions::collisions(random, &mut answers.told());
        }
        "7.7" => {
            questions::windows(random, &mut answers.told());
            step::steps(random, answers);
        }
        "7.8" => {
            search::parts(random, &mut answers.told());
            search::queues(random, &mut answers.told());
            many_workers(random, answers);
        }
        "7.9" => {
            search::loops(random, &mut answers.told());
            search::queued_loops(random, &mut answers.told());
        }
        "7.10" => {
            questions::appends(random, &mut answers.told());
            interrupted_appends(answers);
        }
        "7.11" => search::spans(random, &mut answers.told()),
        "7.12" => {
            search::blocks(random, &mut answers.told());
            search::grids(random, &mut answers.told());
        }
        "7.13" => search::columns(random, &mut answers.told()),
        "7.14" => search::windows(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}

/// How often each iteration is handed out when another worker comes between, and by four workers.
fn many_workers(random: &mut Random, answers: &mut Answers) {
    let mut times = [0.0; 100];
    between_load_and_store().into_iter().flatten().for_each(|k| times[k] += 1.0);
    let question = "how often each of 100 is handed out if another worker comes between";
    answers.exact(question, &times);
    let n = 20_000 + random.below(1000);
    let next = SharedCount::default();
    let mut times = vec![0.0; n];
    std::thread::scope(|scope| {
        let work = || std::iter::from_fn(|| next_part(&next, n, 3)).take(n).collect::<Vec<_>>();
        let workers: Vec<_> = (0..4).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            worker.join().expect("it ends").into_iter().flatten().for_each(|k| times[k] += 1.0);
        }
    });
    let wrong = times.iter().filter(|times| **times != 1.0).count();
    let question = format!("of {n} iterations for four workers, lost or handed out twice");
    answers.exact(&question, &[wrong as f64]);
}

/// What a list holds that two workers append to.
fn interrupted_appends(answers: &mut Answers) {
    for (when, discs) in [
        ("when the lock is free", appended_between_critical_sections()),
        ("between two operations", appended_between_load_and_store()),
    ] {
        let discs: Vec<_> = discs.into_iter().map(f64::from).collect();
        answers.exact(&format!("discs 1 and 2 appended, 3 by another worker {when}"), &discs);
    }
}
