//! Runs lab 9: `cargo run --release -p lab9 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab9::VARIANTS)
}
