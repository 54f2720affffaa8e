//! Runs lab 4: `cargo run --release -p lab4 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(solution4::VARIANTS)
}
