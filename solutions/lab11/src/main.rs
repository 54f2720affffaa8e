//! Runs lab 11: `cargo run --release -p lab11 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(solution11::VARIANTS)
}
