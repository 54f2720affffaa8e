//! Runs lab 11: `cargo run --release -p lab11 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab11::VARIANTS)
}
