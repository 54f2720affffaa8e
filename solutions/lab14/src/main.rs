//! Runs lab 14: `cargo run --release -p lab14 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(solution14::VARIANTS)
}
