//! Runs lab 9's hard discs: `cargo run --release -p lab9 --bin lab9-hard -- --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common::hard::drive(lab9::HARD_VARIANTS)
}
