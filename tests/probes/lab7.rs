//! What is asked about lab 7: walls, pairs, the order of candidates, loops, boxes; and whole steps of an engine, which
//! are in `lab7_step.rs`.

use hard_discs::Hit;

use self::share::Share;
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
#[path = "../oracle/src/share.rs"]
mod share;
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
            questions::many_takes(random, &mut answers.told());
        }
        "7.5" => questions::stops(random, &mut answers.told()),
        "7.6" => {
            questions::bounces(random, &mut answers.told());
            questions::collisions(random, &mut answers.told());
        }
        "7.7" => {
            questions::windows(random, &mut answers.told());
            questions::cut_steps(random, &mut answers.told());
            step::steps(random, answers);
            questions::long_run("sequential", &mut answers.told());
        }
        "7.8" => {
            search::parts(random, &mut answers.told());
            search::queues(random, &mut answers.told());
            interrupted::parts(&mut answers.told());
        }
        "7.9" => {
            search::loops(random, &mut answers.told());
            search::queued_loops(random, &mut answers.told());
            search::fresh_teams(&mut answers.told());
            search::shared_loops(random, &mut answers.told());
        }
        "7.10" => {
            questions::appends(random, &mut answers.told());
            interrupted::appends_locked(&mut answers.told());
            interrupted::appends_atomic(&mut answers.told());
        }
        "7.11" => search::spans(random, &mut answers.told()),
        "7.12" => {
            search::blocks(random, &mut answers.told());
            search::grids(random, &mut answers.told());
        }
        "7.13" => {
            search::columns(random, &mut answers.told());
            search::far_columns(&mut answers.told());
            search::many_columns(&mut answers.told());
        }
        "7.14" => search::windows(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}
