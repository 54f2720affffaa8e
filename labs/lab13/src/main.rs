//! Runs lab 13: `mpiexec -n 2 target/release/lab13 --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    common_mpi::drive(lab13::VARIANTS)
}
