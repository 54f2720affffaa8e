//! Runs lab 10: `cargo run --release -p lab10 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab10::VARIANTS)
}
