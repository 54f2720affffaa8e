//! Runs part of a test in a separate process.

use std::env;
use std::process::{Command, exit};

use crate::watchdog::TEST;

/// Name of the variable that marks a process as the separate process of a test.
const APART: &str = "CUTOFF_APART";

/// Runs the current test again in a separate process, which executes `part` and ends. A stack
/// overflow in the process does not end other tests.
///
/// # Panics
/// If the process fails, or the test is not a `watched::test`.
pub fn apart(part: impl FnOnce()) {
    if env::var_os(APART).is_some() {
        part();
        exit(0);
    }
    let this = env::current_exe().expect("a program knows its own path");
    let ended = Command::new(this)
        .args(["--exact", &TEST.with_borrow(String::clone), "--nocapture"])
        .env(APART, "")
        .output();
    let ended = ended.expect("the program starts");
    let message = String::from_utf8_lossy(&ended.stderr);
    let deep = message.contains("has overflowed its stack");
    assert!(
        !deep,
        "the stack overflowed: a function calls itself once for each step of a long path. Use a loop"
    );
    assert!(ended.status.success(), "{message}");
}
