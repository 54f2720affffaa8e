//! Runs lab 2: `cargo run --release -p lab2 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab2::VARIANTS)
}
