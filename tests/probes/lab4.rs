//! What is asked about lab 4: the functions one at a time, and those that lock by several threads.

use self::model::acceleration_of_pair;
use self::soft::on_edges;
use crate::{Answers, Random};

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
            locked::numbers(random, &mut answers.told());
        }
        "4.2" => locked::meters(random, &mut answers.told()),
        "4.3" => {
            locked::one_by_one(random, &mut answers.told());
            locked::many_threads(random, &mut answers.told());
            locked::another_between(random, &mut answers.told());
            locked::elsewhere(&mut answers.told());
        }
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
