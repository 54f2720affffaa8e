//! Runs lab 1: `cargo run --release -p lab1 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab1::VARIANTS)
}
