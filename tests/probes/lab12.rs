//! What is asked about lab 12: each task's own functions. Whole engines need several of them.

use lab12::Composition;

use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab12/questions.rs"]
mod questions;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "12.1" => {
            questions::steps(random, &mut answers.told());
            compositions(answers);
        }
        "12.2" => questions::runge_kutta(random, &mut answers.told()),
        "12.3" => {
            questions::crossings(random, &mut answers.told());
            questions::faint_crossings(&mut answers.told());
        }
        "12.4" => questions::falls(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}

fn compositions(answers: &mut Answers) {
    for (name, composition) in
        [("velocity Verlet", Composition::velocity_verlet()), ("PEFRL", Composition::pefrl())]
    {
        answers.close(&format!("the drifts of {name}"), &composition.drifts);
        answers.close(&format!("the kicks of {name}"), &composition.kicks);
    }
}
