//! Runs Cargo with visible progress.

use std::env;
use std::fs::{File, TryLockError};
use std::io;
use std::process::{Command, Output, Stdio};

use crate::progress::can_draw;

/// Runs Cargo to its end and returns its output.
///
/// On a terminal, Cargo shows its progress bar while it compiles, because the first build takes
/// minutes. Its error messages go to stderr, and it prints nothing else there.
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

/// Whether the build directory of this program is locked. Cargo would wait for the lock without a
/// message, because it runs in quiet mode.
fn is_locked() -> bool {
    let lock = env::current_exe().ok().map(|program| program.with_file_name(".cargo-lock"));
    let lock = lock.and_then(|lock| File::open(lock).ok());
    lock.is_some_and(|lock| matches!(lock.try_lock(), Err(TryLockError::WouldBlock)))
}
