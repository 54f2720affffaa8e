//! Runs lab 7: `cargo run --release -p lab7 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::hard::drive(lab7::VARIANTS)
}
