//! What is asked about lab 3: each function of a thread, with what the others would have done made
//! by the probe.

use lab3::{in_order, under_a_lock, with_atomics};

use self::model::Model;
use self::questions::statistics;
use self::share::Share;
use self::soft::{crowd as anywhere, on_edges};
use crate::{Answers, Random};

#[path = "../oracle/src/ask.rs"]
mod ask;
#[path = "../lab3/meeting.rs"]
mod meeting;
#[path = "../oracle/src/model.rs"]
mod model;
#[path = "../lab3/questions.rs"]
mod questions;
#[path = "../oracle/src/share.rs"]
mod share;
#[path = "soft.rs"]
mod soft;
#[path = "../lab3/waiting.rs"]
mod waiting;

/// Asks everything about a task.
pub fn ask(task: &str, random: &mut Random, answers: &mut Answers) {
    match task {
        "3.1" => {
            questions::all_pairs(random, &mut answers.told());
            meeting::all_pairs(random, &mut answers.told());
        }
        "3.2" => {
            questions::atomics(random, &mut answers.told());
            let told = &mut answers.told();
            questions::reductions("under a lock", told, |parts| statistics(&under_a_lock(parts)));
            questions::reductions("in order", told, |parts| statistics(&in_order(parts)));
            questions::reductions("with atomics", told, |parts| {
                with_atomics(&parts.iter().map(statistics).collect::<Vec<_>>())
            });
            meeting::parts(random, told);
            waiting::interruptions(told);
        }
        "3.3" => questions::rows(random, &mut answers.told()),
        "3.4" => questions::forces(random, &mut answers.told()),
        "3.5" => questions::moves(random, &mut answers.told()),
        "3.6" => {
            questions::loops(random, &mut answers.told());
            meeting::workers(random, &mut answers.told());
        }
        "3.7" => questions::by_one(random, &mut answers.told()),
        "3.8" => questions::by_all(random, &mut answers.told()),
        "3.9" => questions::mail(random, &mut answers.told()),
        "3.10" => {
            waiting::barriers(&mut answers.told());
            waiting::rehearsals(4 + random.below(9), &mut answers.told());
        }
        "3.11" => {
            let counts = [1, 2, 3 + random.below(8), 12 + random.below(40)];
            waiting::gatherings(&counts, &mut answers.told());
            waiting::panics(&mut answers.told());
        }
        "3.12" => questions::notices(random, &mut answers.told()),
        _ => panic!("there is no task {task}"),
    }
}
