//! Tests from inside: of functions that all ranks call together.

use std::env;
use std::process::exit;

use super::{Ended, Job};
use crate::watchdog::{TEST, WATCH};

/// How long a part of a test may take.
const SECONDS: u64 = 20;

/// Has this very test run on each number of ranks of `counts`, in turn; each rank comes here in its turn,
/// does `part` and ends. What a test does before, all ranks do as well. Returns the last job.
///
/// # Panics
/// A job failed or did not end, as for [`Job::succeed`], or this is no `watched::test`.
pub fn on_each(task: &str, counts: &[usize], part: impl FnOnce()) -> Ended {
    if env::var_os(WATCH).is_some() {
        part();
        exit(0);
    }
    let this = env::current_exe().expect("a program knows its own path");
    let job = |ranks: &usize| {
        let job = Job::new(task, &this, *ranks).args([
            "--exact",
            &TEST.with_borrow(String::clone),
            "--nocapture",
        ]);
        let ended = job.within(SECONDS).succeed();
        assert!(
            !ended.stdout.contains(" 0 passed"),
            "'{}' is no name of a test",
            &TEST.with_borrow(String::clone)
        );
        ended
    };
    counts.iter().map(job).reduce(|_, last| last).expect("there are some ranks")
}
