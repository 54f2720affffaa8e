//! Tests of functions that all ranks call together. The tests run on the ranks themselves.

use std::env;
use std::process::exit;

use super::{Ended, Job};
use crate::watchdog::{TEST, WATCH};

/// Time limit in seconds of a part of a test.
const SECONDS: u64 = 20;

/// Runs the current test again on each number of ranks of `counts`, in turn. Each rank executes the
/// code before this call, then `part`, and ends. Returns the last job.
///
/// # Panics
/// If a job fails or does not end, as for [`Job::succeed`], or the test is not a `watched::test`.
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
            "'{}' is not the name of a test",
            &TEST.with_borrow(String::clone)
        );
        ended
    };
    counts.iter().map(job).reduce(|_, last| last).expect("there are some ranks")
}
