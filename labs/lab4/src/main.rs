//! Runs lab 4: `cargo run --release -p lab4 -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::soft::drive(lab4::VARIANTS)
}
