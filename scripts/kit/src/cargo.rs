//! Cargo at work, seen.

use std::env;
use std::fs::{File, TryLockError};
use std::io;
use std::process::{Command, Output, Stdio};

use crate::progress::can_draw;

/// Runs cargo to its end and returns what it printed. On a terminal it shows its bar while something is compiled:
/// the first build of anything takes minutes. What it complains of it says itself, and nothing else.
pub fn run_visibly(cargo: &mut Command) -> io::Result<Output> {
    if is_locked() {
        eprintln!(
            "Waiting for another cargo, such as an editor's, to end its build in this folder."
        );
    }
    let when = if can_draw(&io::stderr()) { "always" } else { "never" };
    cargo.env("CARGO_TERM_QUIET", "true");
    cargo.env("CARGO_TERM_PROGRESS_WHEN", when).env("CARGO_TERM_PROGRESS_WIDTH", "80");
    cargo.stderr(Stdio::inherit()).output()
}

/// Whether somebody holds the lock of the folder that this program was built in. Cargo waits for it in silence, because it is
/// told to be quiet.
fn is_locked() -> bool {
    let lock = env::current_exe().ok().map(|program| program.with_file_name(".cargo-lock"));
    let lock = lock.and_then(|lock| File::open(lock).ok());
    lock.is_some_and(|lock| matches!(lock.try_lock(), Err(TryLockError::WouldBlock)))
}
