//! What is asked about lab 11: each decision of the engine by itself.

use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab11/questions.rs"]
mod questions;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    let told = &mut answers.told();
    match task {
        "11.1" => questions::flights(random, told),
        "11.2" => questions::approaches(random, told),
        "11.3" => {
            questions::roots(random, told);
            questions::long_chain(told);
            questions::joins(random, told);
            questions::many_joins(told);
        }
        "11.4" => questions::margins(random, told),
        "11.5" => questions::walls(random, told),
        "11.6" => questions::lengths(random, told),
        _ => panic!("there is no task {task}"),
    }
}
