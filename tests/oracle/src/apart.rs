//! A part of a test in a process of its own.

use std::env;
use std::process::{Command, exit};

use crate::watchdog::TEST;

/// Says to a test that it is such a process.
const APART: &str = "CUTOFF_APART";

/// Has this very test run once more as a process of its own, which does `part` and ends. If its stack overflows,
/// that ends no other test.
///
/// # Panics
/// The process did not end well, or this is no `watched::test`.
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
    let ended = ended.expect("it starts");
    let said = String::from_utf8_lossy(&ended.stderr);
    let deep = said.contains("has overflowed its stack");
    assert!(
        !deep,
        "no stack is left: a function calls itself, and again, for each step of a long way"
    );
    assert!(ended.status.success(), "{said}");
}
