//! Runs lab 12: `cargo run --release -p lab12 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(solution12::VARIANTS)
}
