//! Runs the loops of lab 10 alone: `cargo run --release -p lab10 --bin lab10-alone -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab10::ALONE)
}
