//! Runs lab 3: `cargo run --release -p lab3 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab3::VARIANTS)
}
